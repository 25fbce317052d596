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

#include "drive/Route.h"

#include <algorithm>

#include <ompl/base/ScopedState.h>

namespace ompl_mfa::drive
{
    Route::Route(const ompl::geometric::PathGeometric &path)
      : path_(path)
      , ends_{0.0}
    {
        for (std::size_t i = 1; i < path_.getStateCount(); ++i)
        {
            const auto last = static_cast<unsigned int>(i);
            ends_.push_back(ends_.back() +
                            path_.getSpaceInformation()->distance(path_.getState(last - 1), path_.getState(last)));
        }
    }

    std::size_t Route::motionAt(double distance) const
    {
        const auto after = std::upper_bound(ends_.begin(), ends_.end(), distance);
        return static_cast<std::size_t>(after - ends_.begin()) - 1;
    }

    void Route::stateAt(double distance, ompl::base::State *state) const
    {
        const auto &space = path_.getSpaceInformation()->getStateSpace();
        const std::size_t motion = motionAt(distance);
        const auto first = static_cast<unsigned int>(motion);
        if (motion + 1 >= ends_.size())
        {
            space->copyState(state, path_.getState(static_cast<unsigned int>(ends_.size()) - 1));
            return;
        }
        const double share = (distance - ends_[motion]) / (ends_[motion + 1] - ends_[motion]);
        space->interpolate(path_.getState(first), path_.getState(first + 1), share, state);
    }

    double Route::endOfMotion() const
    {
        return ends_[std::min(motionAt(driven_) + 1, ends_.size() - 1)];
    }

    ompl::geometric::PathGeometric Route::rest() const
    {
        ompl::geometric::PathGeometric rest(path_.getSpaceInformation());
        ompl::base::ScopedState<> state(path_.getSpaceInformation());
        stateAt(driven_, state.get());
        rest.append(state.get());
        for (std::size_t i = motionAt(driven_) + 1; i < ends_.size(); ++i)
        {
            rest.append(path_.getState(static_cast<unsigned int>(i)));
        }
        return rest;
    }
}  // namespace ompl_mfa::drive
