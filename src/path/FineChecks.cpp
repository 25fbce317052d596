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

#include "path/FineChecks.h"

#include <algorithm>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    bool hasDiscreteMotionChecks(const ob::SpaceInformation &si)
    {
        const ob::MotionValidator *const validator = si.getMotionValidator().get();
        return dynamic_cast<const ob::DiscreteMotionValidator *>(validator) != nullptr ||
               dynamic_cast<const ob::DubinsMotionValidator *>(validator) != nullptr ||
               dynamic_cast<const ob::ReedsSheppMotionValidator *>(validator) != nullptr;
    }

    bool isValidAt(const ob::SpaceInformation &si, const std::vector<ob::State *> &path, unsigned int factor)
    {
        if (!hasDiscreteMotionChecks(si))
        {
            return true;
        }
        const ob::StateSpacePtr &space = si.getStateSpace();
        ob::ScopedState<> between(space);
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const unsigned int segments = factor * std::max(1U, space->validSegmentCount(path[i - 1], path[i]));
            for (unsigned int j = 1; j < segments; ++j)
            {
                space->interpolate(path[i - 1], path[i], static_cast<double>(j) / segments, between.get());
                if (!si.isValid(between.get()))
                {
                    return false;
                }
            }
        }
        return true;
    }
}  // namespace ompl_mfa::path
