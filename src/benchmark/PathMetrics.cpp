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

#include "benchmark/PathMetrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::benchmark
{
    og::PathGeometric resamplePath(const og::PathGeometric &path, double step)
    {
        constexpr double MOST_MOTIONS = 5000.0;
        const ob::SpaceInformationPtr &si = path.getSpaceInformation();
        const ob::StateSpacePtr &space = si->getStateSpace();
        const double length = path.length();
        if (path.getStateCount() < 2 || !(length > 0.0))
        {
            return path;
        }
        const auto motions = static_cast<std::size_t>(std::clamp(std::ceil(length / step), 1.0, MOST_MOTIONS));

        og::PathGeometric resampled(si, path.getState(0));
        ob::ScopedState<> state(space);
        std::size_t segment = 0;
        double passed = 0.0;
        double segmentLength = space->distance(path.getState(0), path.getState(1));
        for (std::size_t i = 1; i < motions; ++i)
        {
            const double target = length * static_cast<double>(i) / static_cast<double>(motions);
            while (passed + segmentLength < target && segment + 2 < path.getStateCount())
            {
                passed += segmentLength;
                ++segment;
                segmentLength = space->distance(path.getState(segment), path.getState(segment + 1));
            }
            const double part = segmentLength > 0.0 ? std::clamp((target - passed) / segmentLength, 0.0, 1.0) : 0.0;
            space->interpolate(path.getState(segment), path.getState(segment + 1), part, state.get());
            space->enforceBounds(state.get());
            resampled.append(state.get());
        }
        resampled.append(path.getState(path.getStateCount() - 1));
        return resampled;
    }

    PathMetrics measurePath(const og::PathGeometric &path)
    {
        const ob::SpaceInformationPtr &si = path.getSpaceInformation();
        og::PathGeometric resampled = resamplePath(path, si->getStateSpace()->getLongestValidSegmentLength());
        PathMetrics metrics;
        metrics.minimumClearance = std::numeric_limits<double>::infinity();
        for (const ob::State *state : resampled.getStates())
        {
            metrics.minimumClearance =
                std::min(metrics.minimumClearance, si->getStateValidityChecker()->clearance(state));
        }
        metrics.smoothness = resampled.smoothness();
        return metrics;
    }
}  // namespace ompl_mfa::benchmark
