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

#include "engine/GoalDistance.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>

#include "path/ExactType.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* The states to which a goal of one of OMPL's own types measures the distance; none for other goals. */
        std::vector<const ob::State *> measuredStates(const ob::Goal &goal)
        {
            std::vector<const ob::State *> states;
            if (path::isExactly<ob::GoalState>(goal))
            {
                states.push_back(goal.as<ob::GoalState>()->getState());
            }
            else if (path::isExactly<ob::GoalStates, ob::GoalLazySamples>(goal))
            {
                const auto &listed = *goal.as<ob::GoalStates>();
                for (unsigned int i = 0; i < listed.getStateCount(); ++i)
                {
                    states.push_back(listed.getState(i));
                }
            }
            return states;
        }
    }  // namespace

    bool isSatisfied(const ob::Goal &goal, const path::DubinsGuard &guard, const ob::State *state, double *distance)
    {
        const auto ask = [&]
        { return distance != nullptr ? goal.isSatisfied(state, distance) : goal.isSatisfied(state); };
        if (!guard.refusesAny())
        {
            return ask();
        }
        const std::vector<const ob::State *> goals = measuredStates(goal);
        if (std::all_of(goals.begin(), goals.end(), [&](const ob::State *end) { return guard.computes(state, end); }))
        {
            return ask();
        }
        double nearest = std::numeric_limits<double>::infinity();
        for (const ob::State *end : goals)
        {
            nearest = std::min(nearest, guard.distance(state, end));
        }
        if (distance != nullptr)
        {
            *distance = nearest;
        }
        return nearest <= goal.as<ob::GoalRegion>()->getThreshold();
    }
}  // namespace ompl_mfa::engine
