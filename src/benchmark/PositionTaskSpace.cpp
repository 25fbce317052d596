/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#include "benchmark/PositionTaskSpace.h"

#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/util/Exception.h>

namespace ompl_mfa::benchmark
{
    namespace
    {
        ompl::base::RealVectorBounds positionBounds(const ompl::base::StateSpace *space)
        {
            if (const auto *vectors = dynamic_cast<const ompl::base::RealVectorStateSpace *>(space))
            {
                return vectors->getBounds();
            }
            if (const auto *planar = dynamic_cast<const ompl::base::SE2StateSpace *>(space))
            {
                return planar->getBounds();
            }
            if (const auto *spatial = dynamic_cast<const ompl::base::SE3StateSpace *>(space))
            {
                return spatial->getBounds();
            }
            throw ompl::Exception("the state space '" + space->getName() + "' has no position to explore");
        }
    }  // namespace

    PositionTaskSpace::PositionTaskSpace(const ompl::base::SpaceInformationPtr &si)
      : space_(si->getStateSpace().get())
      , bounds_(positionBounds(space_))
      , sampler_(space_->allocDefaultStateSampler())
    {
    }

    int PositionTaskSpace::getDimension() const
    {
        return static_cast<int>(bounds_.low.size());
    }

    void PositionTaskSpace::project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> position) const
    {
        for (unsigned int i = 0; i < bounds_.low.size(); ++i)
        {
            position[i] = *space_->getValueAddressAtIndex(state, i);
        }
    }

    void PositionTaskSpace::sample(Eigen::Ref<Eigen::VectorXd> position) const
    {
        for (unsigned int i = 0; i < bounds_.low.size(); ++i)
        {
            position[i] = rng_.uniformReal(bounds_.low[i], bounds_.high[i]);
        }
    }

    bool PositionTaskSpace::lift(const Eigen::Ref<Eigen::VectorXd> &position, const ompl::base::State * /*seed*/,
                                 ompl::base::State *state) const
    {
        sampler_->sampleUniform(state);
        for (unsigned int i = 0; i < bounds_.low.size(); ++i)
        {
            *space_->getValueAddressAtIndex(state, i) = position[i];
        }
        return true;
    }
}  // namespace ompl_mfa::benchmark
