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

/* MFA with cars whose curves OMPL cannot compute if they are nearly tangent: an assertion of OMPL ends the process. See
   DubinsGuard. */

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        ob::StateSpacePtr carSpace(double radius, bool symmetric)
        {
            return test::ready(test::bounded(std::make_shared<ob::DubinsStateSpace>(radius, symmetric), 2, 0.0, 20.0));
        }

        /* A corridor 6 < x < 14, 1.2 wide, in the square [0, 20]^2: the shortest paths through it are nearly straight.
         */
        bool inCorridorOrBeside(const ob::State *state)
        {
            const auto *pose = state->as<ob::SE2StateSpace::StateType>();
            return pose->getX() < 6.0 || pose->getX() > 14.0 || std::abs(pose->getY() - 10.0) < 0.6;
        }

        /* What a user does with a path. */
        void use(const og::PathGeometric &solution)
        {
            og::PathGeometric path(solution);
            EXPECT_TRUE(path.check());
            const double length = path.length();
            path.interpolate();
            EXPECT_GE(path.length(), length - 1e-4 * length);
            path.check();
        }

        class Cars : public ::testing::TestWithParam<bool>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Cars, ::testing::Bool(),
                                 [](const auto &car) { return car.param ? "Symmetric" : "OneWay"; });

        /* Of such runs an assertion of OMPL 1.5.2 ended 12 in 30 (one-way) and 6 in 10 (symmetric). */
        TEST_P(Cars, PathsThroughACorridorAreTightened)
        {
            for (std::uint32_t seed = 1; seed <= 10; ++seed)
            {
                test::PlanningProblem problem(carSpace(0.5, GetParam()), inCorridorOrBeside, {1.0, 4.0, 0.0},
                                              {19.0, 16.0, 0.0});
                const auto planner = problem.planner(test::PlannerVariant::Default, seed);
                ASSERT_EQ(planner->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION) << seed;
                // 18 across and 12 up, by the corridor
                EXPECT_LT(planner->bestCost(), 25.0) << seed;
                use(problem.path());
            }
        }

        /* A start whose heading is the direction to the goal, as precisely as a user writes it down. */
        TEST_P(Cars, AStartThatHeadsForTheGoalNearlyStraightIsSolved)
        {
            for (const double off : {-4e-7, -2e-7, 2e-7, 4e-7})
            {
                test::PlanningProblem problem(carSpace(0.5, GetParam()), [](const ob::State *) { return true; },
                                              {1.0, 10.0, off}, {19.0, 10.0, 0.0});
                for (const auto engine : {test::PlannerVariant::Default, test::PlannerVariant::Paper})
                {
                    problem.pdef->clearSolutionPaths();
                    const auto planner = problem.planner(engine);
                    ASSERT_EQ(planner->solve(test::afterCalls(engine == test::PlannerVariant::Paper ? 6000 : 3000)),
                              ob::PlannerStatus::EXACT_SOLUTION)
                        << off;
                    if (engine == test::PlannerVariant::Default)
                    {
                        EXPECT_NEAR(planner->bestCost(), 18.0, 1e-3) << off;
                    }
                    use(problem.path());
                }
            }
        }

        /* An approximate solution ends on the straight line to the goal and lacks the last section of it. */
        TEST_P(Cars, AClosedGoalIsApproachedStraight)
        {
            for (const double off : {0.0, -4e-7, 3e-7})
            {
                test::PlanningProblem problem(carSpace(0.5, GetParam()),
                                              [](const ob::State *state)
                                              {
                                                  const auto *pose = state->as<ob::SE2StateSpace::StateType>();
                                                  return pose->getX() < 10.0 || pose->getX() > 11.0;
                                              },
                                              {1.0, 10.0, off}, {19.0, 10.0, 0.0});
                for (const auto engine : {test::PlannerVariant::Default, test::PlannerVariant::Paper})
                {
                    problem.pdef->clearSolutionPaths();
                    const auto status = problem.planner(engine)->solve(test::afterCalls(3000));
                    ASSERT_EQ(status, ob::PlannerStatus::APPROXIMATE_SOLUTION);
                    EXPECT_TRUE(problem.path().check());
                    EXPECT_LT(problem.pdef->getSolutionDifference(), 12.0);
                }
            }
        }

        /* Several motions are checked at once; none of them may be one that OMPL cannot compute. */
        TEST_P(Cars, WithTwoThreadsARunIsTheSame)
        {
            for (std::uint32_t seed = 1; seed <= 4; ++seed)
            {
                double cost[2];
                for (const unsigned int threads : {1U, 2U})
                {
                    test::PlanningProblem problem(carSpace(0.5, GetParam()), inCorridorOrBeside, {1.0, 4.0, 0.0},
                                                  {19.0, 16.0, 0.0});
                    const auto planner = problem.planner(test::PlannerVariant::Default, seed);
                    planner->setThreads(threads);
                    ASSERT_EQ(planner->solve(test::afterCalls(8000)), ob::PlannerStatus::EXACT_SOLUTION) << seed;
                    cost[threads - 1] = planner->bestCost();
                }
                EXPECT_EQ(cost[0], cost[1]) << seed;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
