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

/* Starts, goals, termination conditions and the statuses that MFA returns for them. */

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Exception.h>

#include "planner/DistanceGoal.h"
#include "planner/PatchGoal.h"
#include "planner/PlanningProblem.h"
#include "planner/QueriesFixture.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        INSTANTIATE_TEST_SUITE_P(Planner, Queries,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Queries, OneStartAndOneGoal)
        {
            expectExact(solve());
        }

        TEST_P(Queries, OfSeveralStartsTheBestIsTaken)
        {
            problem_->pdef->addStartState(problem_->state({5.0, 1.0}));  // invalid: skipped
            problem_->pdef->addStartState(problem_->state({8.0, 1.0}));
            expectExact(solve(test::afterCalls(4000)));
            EXPECT_EQ(test::coordinate(path().getState(0), 0), 8.0);
            EXPECT_NEAR(planner_->bestCost(), 1.0, 1e-9);
        }

        TEST_P(Queries, OfSeveralGoalsTheBestIsTaken)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({9.0, 1.0}));
            goals->addState(problem_->state({5.0, 1.0}));  // invalid: skipped
            goals->addState(problem_->state({1.0, 3.0}));
            problem_->pdef->setGoal(goals);
            expectExact(solve(test::afterCalls(4000)));
            EXPECT_NEAR(planner_->bestCost(), 2.0, 1e-9);
        }

        TEST_P(Queries, ASampleableRegionIsReached)
        {
            class Square : public ob::GoalSampleableRegion
            {
            public:
                using GoalSampleableRegion::GoalSampleableRegion;

                void sampleGoal(ob::State *state) const override
                {
                    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    values[0] = rng_.uniformReal(8.0, 9.0);
                    values[1] = rng_.uniformReal(0.0, 9.0);
                }

                unsigned int maxSampleCount() const override
                {
                    return std::numeric_limits<unsigned int>::max();
                }

                double distanceGoal(const ob::State *state) const override
                {
                    return std::max(0.0, 8.0 - test::coordinate(state, 0));
                }

            private:
                mutable ompl::RNG rng_;
            };
            problem_->pdef->setGoal(std::make_shared<Square>(problem_->si));
            expectExact(solve(test::afterCalls(8000)));
        }

        TEST_P(Queries, ARegionThatOnlyKnowsADistanceIsReached)
        {
            problem_->pdef->setGoal(
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.4));
            expectExact(solve());
        }

        TEST_P(Queries, LazyGoalsMayArriveWhileItPlans)
        {
            // the first goal is behind the wall; a far better one arrives once that was reached
            std::atomic<bool> reached{false};
            std::atomic<bool> done{false};
            int made = 0;
            const auto goals = std::make_shared<ob::GoalLazySamples>(
                problem_->si,
                [&](const ob::GoalLazySamples *, ob::State *state)
                {
                    while (made == 1 && !reached && !done)
                    {
                        std::this_thread::sleep_for(std::chrono::milliseconds(1));
                    }
                    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    values[0] = made == 0 ? 9.0 : 2.0;
                    values[1] = 1.0;
                    return ++made <= 2;
                });
            problem_->pdef->setGoal(goals);
            problem_->pdef->setIntermediateSolutionCallback(
                [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost) { reached = true; });
            const auto near = ob::PlannerTerminationCondition([this] { return planner_->bestCost() < 1.5; });
            expectExact(solve(ob::plannerOrTerminationCondition(near, ob::timedPlannerTerminationCondition(60.0))));
            EXPECT_NEAR(planner_->bestCost(), 1.0, 1e-9);
            done = true;
            goals->stopSampling();
        }

        TEST_P(Queries, WaitsForTheFirstLazyGoal)
        {
            std::atomic<int> made{0};
            const auto goals = std::make_shared<ob::GoalLazySamples>(
                problem_->si,
                [&made](const ob::GoalLazySamples *, ob::State *state)
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(50));
                    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    values[0] = 9.0;
                    values[1] = 1.0;
                    return ++made < 2;
                });
            problem_->pdef->setGoal(goals);
            expectExact(solve());
            goals->stopSampling();
        }

        TEST_P(Queries, LazyGoalsThatNeverComeEndInATimeout)
        {
            std::atomic<bool> done{false};
            const auto goals =
                std::make_shared<ob::GoalLazySamples>(problem_->si,
                                                      [&done](const ob::GoalLazySamples *, ob::State *)
                                                      {
                                                          while (!done)
                                                          {
                                                              std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                                          }
                                                          return false;
                                                      });
            problem_->pdef->setGoal(goals);
            EXPECT_EQ(solve(ob::timedPlannerTerminationCondition(0.05)), ob::PlannerStatus::TIMEOUT);
            done = true;
            goals->stopSampling();
        }

        TEST_P(Queries, AStartInCollisionOrOutsideTheBoundsIsInvalid)
        {
            for (const auto &start : {std::vector<double>{5.0, 1.0}, std::vector<double>{-1.0, 1.0}})
            {
                problem_->pdef->clearStartStates();
                problem_->pdef->addStartState(problem_->state(start));
                EXPECT_EQ(solve(), ob::PlannerStatus::INVALID_START);
                EXPECT_FALSE(problem_->pdef->hasSolution());
            }
        }

        TEST_P(Queries, AGoalInCollisionOrOutsideTheBoundsIsInvalid)
        {
            for (const auto &goal : {std::vector<double>{5.0, 1.0}, std::vector<double>{11.0, 1.0}})
            {
                problem_->pdef->setGoalState(problem_->state(goal));
                EXPECT_EQ(solve(ob::timedPlannerTerminationCondition(0.05)), ob::PlannerStatus::INVALID_GOAL);
                EXPECT_FALSE(problem_->pdef->hasSolution());
            }
        }

        TEST_P(Queries, AGoalWithoutADistanceIsNotRecognized)
        {
            class Anywhere : public ob::Goal
            {
            public:
                using Goal::Goal;

                bool isSatisfied(const ob::State *state) const override
                {
                    return test::coordinate(state, 0) > 8.0;
                }
            };
            problem_->pdef->setGoal(std::make_shared<Anywhere>(problem_->si));
            EXPECT_EQ(solve(), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
            EXPECT_FALSE(problem_->pdef->hasSolution());
        }

        TEST_P(Queries, WithoutStartOrGoalOmplsOwnExceptionIsThrown)
        {
            problem_->pdef->clearStartStates();
            EXPECT_THROW(solve(), ompl::Exception);
            problem_->pdef->addStartState(problem_->state({1.0, 1.0}));
            problem_->pdef->setGoal(nullptr);
            EXPECT_THROW(solve(), ompl::Exception);
            EXPECT_THROW(test::makePlanner(problem_->si, GetParam())->solve(0.1), ompl::Exception);
        }

        TEST_P(Queries, AnUnreachableGoalIsApproachedByAValidPathAndItsTrueDistanceIsTold)
        {
            problem_ = test::closedProblem();
            ASSERT_EQ(solve(test::afterCalls(5000)), ob::PlannerStatus::APPROXIMATE_SOLUTION);
            const auto &pdef = *problem_->pdef;
            EXPECT_TRUE(pdef.hasApproximateSolution());
            EXPECT_FALSE(pdef.hasExactSolution());
            EXPECT_TRUE(path().check());
            EXPECT_TRUE(problem_->si->equalStates(path().getState(0), pdef.getStartState(0)));
            EXPECT_EQ(pdef.getSolutionDifference(), pdef.getGoal()->as<ob::GoalRegion>()->distanceGoal(pathEnd()));
            // the wall ends the straight path 4.5 before the goal; slices allow nothing worse
            EXPECT_LT(pdef.getSolutionDifference(), 4.5 + 0.2);
        }

        TEST_P(Queries, AnExactSolutionLeavesNoApproximateOneBeforeIt)
        {
            expectExact(solve());
            EXPECT_EQ(problem_->pdef->getSolutionDifference(), 0.0);
            EXPECT_FALSE(problem_->pdef->hasApproximateSolution());
        }

        TEST_P(Queries, StartEqualToGoalIsSolvedAtOnce)
        {
            problem_->pdef->setGoalState(problem_->state({1.0, 1.0}));
            expectExact(solve(test::afterCalls(1000)));
            EXPECT_EQ(planner_->bestCost(), 0.0);
        }

        TEST_P(Queries, AStraightMotionThatMeetsTheObjectivesBoundEndsTheSearch)
        {
            problem_ = test::freeProblem();
            const auto status = solve(test::afterCalls(1000000));
            expectExact(status);
            EXPECT_DOUBLE_EQ(planner_->bestCost(), 8.0);
            EXPECT_EQ(path().getStateCount(), 2U);
            EXPECT_LT(problem_->counted.motions, 10U);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
