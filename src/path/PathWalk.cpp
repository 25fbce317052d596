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

#include "path/PathWalk.h"

#include <algorithm>

namespace ompl_mfa::path
{
    PathWalk::PathWalk(const Waypoints &path)
      : path_(path)
      , motion_(path.space()->distance(path[0], path[1]))
    {
    }

    void PathWalk::stateAt(double distance, ompl::base::State *state)
    {
        while (behind_ + motion_ < distance && next_ + 1 < path_.size())
        {
            behind_ += motion_;
            ++next_;
            motion_ = path_.space()->distance(path_[next_ - 1], path_[next_]);
        }
        const double part = motion_ > 0.0 ? std::clamp((distance - behind_) / motion_, 0.0, 1.0) : 0.0;
        path_.space()->interpolate(path_[next_ - 1], path_[next_], part, state);
        path_.space()->enforceBounds(state);
    }

    Waypoints statesAlong(const Waypoints &path, unsigned int count)
    {
        Waypoints states(path.space());
        states.resize(count);
        PathWalk walk(path);
        const double step = path.length() / (count + 1);
        for (unsigned int k = 0; k < count; ++k)
        {
            walk.stateAt(step * (k + 1), states[k]);
        }
        return states;
    }
}  // namespace ompl_mfa::path
