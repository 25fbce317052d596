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

#ifndef OMPL_MFA_BENCHMARK_POSITION_TASK_SPACE_
#define OMPL_MFA_BENCHMARK_POSITION_TASK_SPACE_

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/geometric/planners/rrt/TSRRT.h>
#include <ompl/util/RandomNumbers.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief Task space for TSRRT: the position in R^n, SE2, SE3, Dubins and Reeds-Shepp spaces. */
    class OMPL_MFA_EXPORT PositionTaskSpace : public ompl::geometric::TaskSpaceConfig
    {
    public:
        /** \brief Throws ompl::Exception if the space of \e si has no position. */
        explicit PositionTaskSpace(const ompl::base::SpaceInformationPtr &si);

        int getDimension() const override;

        void project(const ompl::base::State *state, Eigen::Ref<Eigen::VectorXd> position) const override;

        void sample(Eigen::Ref<Eigen::VectorXd> position) const override;

        /** \brief A state at \e position with a new random orientation; TSRRT interpolates towards it. */
        bool lift(const Eigen::Ref<Eigen::VectorXd> &position, const ompl::base::State *seed,
                  ompl::base::State *state) const override;

    private:
        const ompl::base::StateSpace *space_;
        ompl::base::RealVectorBounds bounds_;
        ompl::base::StateSamplerPtr sampler_;
        mutable ompl::RNG rng_;
    };
}  // namespace ompl_mfa::benchmark

#endif
