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

/* The time is shared in one proportion before the first path and in another afterwards, wherever the path came from. */

#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        /* State costs, so that the straight motion cannot be proven optimal. */
        class Slope : public ob::StateCostIntegralObjective
        {
        public:
            explicit Slope(const ob::SpaceInformationPtr &si)
              : StateCostIntegralObjective(si, true)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(1.0 + test::coordinate(state, 1));
            }
        };

        TEST(Phases, AStraightMotionIsAFirstPath)
        {
            const auto problem = test::freeProblem();
            problem->pdef->setOptimizationObjective(std::make_shared<Slope>(problem->si));
            const auto planner = problem->planner(test::PlannerVariant::Default);
            ASSERT_EQ(planner->solve(test::afterCalls(60000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(planner->shares().at("tightening"), 0.1);
            // without a path the trees get three tenths of the time, afterwards less
            EXPECT_LT(planner->shares().at("trees"), 0.15);
        }

        TEST(Phases, TheStraightMotionToALaterGoalIsAFirstPath)
        {
            // the first goal is behind the wall, the second one in front of it
            const auto problem = test::closedProblem();
            const auto goals = std::make_shared<ob::GoalStates>(problem->si);
            goals->addState(problem->state({9.0, 1.0}));
            problem->pdef->setGoal(goals);
            problem->pdef->setOptimizationObjective(std::make_shared<Slope>(problem->si));
            const auto planner = problem->planner(test::PlannerVariant::Default);
            EXPECT_NE(planner->solve(test::afterCalls(2000)), ob::PlannerStatus::EXACT_SOLUTION);
            goals->addState(problem->state({4.0, 4.0}));
            ASSERT_EQ(planner->solve(test::afterCalls(100000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(planner->shares().at("tightening"), 0.1);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
