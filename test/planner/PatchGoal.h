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

#ifndef OMPL_MFA_TEST_PLANNER_PATCH_GOAL_
#define OMPL_MFA_TEST_PLANNER_PATCH_GOAL_

#include <algorithm>
#include <array>
#include <cmath>

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/RandomNumbers.h>

#include "planner/PlanningProblem.h"

namespace ompl_mfa::test
{
    /** \brief A square of R^2 around a center that can be sampled a limited number of times. */
    class PatchGoal : public ompl::base::GoalSampleableRegion
    {
    public:
        PatchGoal(const ompl::base::SpaceInformationPtr &si, const std::array<double, 2> &middle, double width,
                  unsigned int samples)
          : GoalSampleableRegion(si)
          , center(middle)
          , side(width)
          , samples_(samples)
        {
            setThreshold(1e-9);
        }

        void sampleGoal(ompl::base::State *state) const override
        {
            double *values = state->as<ompl::base::RealVectorStateSpace::StateType>()->values;
            for (std::size_t i = 0; i < 2; ++i)
            {
                values[i] = center[i] + side * rng_.uniformReal(-0.5, 0.5);
            }
        }

        unsigned int maxSampleCount() const override
        {
            return samples_;
        }

        double distanceGoal(const ompl::base::State *state) const override
        {
            const double dx = std::abs(coordinate(state, 0) - center[0]) - 0.5 * side;
            const double dy = std::abs(coordinate(state, 1) - center[1]) - 0.5 * side;
            return std::max({0.0, dx, dy});
        }

        std::array<double, 2> center;
        double side;

    private:
        unsigned int samples_;
        mutable ompl::RNG rng_;
    };
}  // namespace ompl_mfa::test

#endif
