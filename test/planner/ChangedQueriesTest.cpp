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

/* Starts, goals, worlds and bounds that change between two calls of MFA's solve(). */

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Exception.h>

#include "planner/DistanceGoal.h"
#include "planner/PatchGoal.h"
#include "planner/PlanningProblem.h"
#include "planner/QueriesFixture.h"

namespace ompl_mfa::planner
{
    namespace
    {
        /* Goals and starts that change between two calls of solve(), in place or with a new problem definition. */
        class ChangedQueries : public Queries
        {
        protected:
            ChangedQueries()
            {
                planner_ = problem_->planner(GetParam());
            }

            /* Solves again and expects a path to the present goal. */
            void expectExactAgain(double x, double y)
            {
                problem_->pdef->clearSolutionPaths();
                expectExact(planner_->solve(test::untilExact(problem_->pdef)));
                if (::testing::Test::HasFatalFailure())
                {
                    return;
                }
                EXPECT_EQ(test::coordinate(pathEnd(), 0), x);
                EXPECT_EQ(test::coordinate(pathEnd(), 1), y);
            }

            void solveOnce()
            {
                ASSERT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            }
        };

        INSTANTIATE_TEST_SUITE_P(Planner, ChangedQueries,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(ChangedQueries, ListedGoalsMayBeClearedAndFilledAgain)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({9.0, 1.0}));
            problem_->pdef->setGoal(goals);
            solveOnce();
            goals->clear();
            goals->addState(problem_->state({9.0, 9.0}));
            expectExactAgain(9.0, 9.0);
        }

        TEST_P(ChangedQueries, AListedGoalMayGo)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({1.0, 3.0}));
            goals->addState(problem_->state({9.0, 1.0}));
            problem_->pdef->setGoal(goals);
            solveOnce();
            goals->clear();
            goals->addState(problem_->state({9.0, 1.0}));
            expectExactAgain(9.0, 1.0);
        }

        TEST_P(ChangedQueries, AListedGoalThatIsAddedIsRead)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({9.0, 1.0}));
            goals->addState(problem_->state({9.0, 2.0}));
            problem_->pdef->setGoal(goals);
            solveOnce();
            const std::uint64_t evaluations = planner_->evaluations();
            goals->addState(problem_->state({1.0, 3.0}));
            planner_->solve(test::afterCalls(2000));
            EXPECT_EQ(planner_->bestCost(), 2.0);
            EXPECT_GE(planner_->evaluations(), evaluations) << "the search continued";
        }

        TEST_P(ChangedQueries, AGoalStateMayBeSetAnew)
        {
            solveOnce();
            problem_->pdef->getGoal()->as<ob::GoalState>()->setState(problem_->state({9.0, 9.0}));
            expectExactAgain(9.0, 9.0);
        }

        TEST_P(ChangedQueries, AnInvalidGoalStateMayBeReplaced)
        {
            problem_->pdef->setGoalState(problem_->state({5.0, 1.0}));
            EXPECT_EQ(planner_->solve(test::afterCalls(1000)), ob::PlannerStatus::INVALID_GOAL);
            problem_->pdef->getGoal()->as<ob::GoalState>()->setState(problem_->state({9.0, 9.0}));
            expectExactAgain(9.0, 9.0);
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({9.0, 1.0}));
            goals->addState(problem_->state({5.0, 1.0}));
            problem_->pdef->setGoal(goals);
            expectExactAgain(9.0, 1.0);
            goals->clear();
            goals->addState(problem_->state({9.0, 1.0}));
            goals->addState(problem_->state({1.0, 3.0}));
            planner_->solve(test::afterCalls(2000));
            EXPECT_EQ(planner_->bestCost(), 2.0);
        }

        TEST_P(ChangedQueries, LazyGoalsMayBeClearedAndFilledAgain)
        {
            const auto goals = std::make_shared<ob::GoalLazySamples>(
                problem_->si, [](const ob::GoalLazySamples *, ob::State *) { return false; });
            goals->stopSampling();
            goals->addState(problem_->state({9.0, 1.0}).get());
            problem_->pdef->setGoal(goals);
            solveOnce();
            goals->clear();
            goals->addState(problem_->state({9.0, 9.0}).get());
            expectExactAgain(9.0, 9.0);
        }

        TEST_P(ChangedQueries, ASampleableRegionMayMove)
        {
            for (const unsigned int samples : {1U, 3U, std::numeric_limits<unsigned int>::max()})
            {
                const auto region = std::make_shared<test::PatchGoal>(problem_->si, std::array{9.0, 1.0}, 0.5, samples);
                problem_->pdef->setGoal(region);
                problem_->pdef->clearSolutionPaths();
                solveOnce();
                region->center = {9.0, 9.0};
                problem_->pdef->clearSolutionPaths();
                expectExact(planner_->solve(test::untilExact(problem_->pdef)));
            }
        }

        TEST_P(ChangedQueries, ARegionMayShrink)
        {
            const auto region = std::make_shared<test::PatchGoal>(problem_->si, std::array{8.0, 1.0}, 4.0, 1000000);
            problem_->pdef->setGoal(region);
            solveOnce();
            planner_->solve(test::afterCalls(2000));
            region->side = 0.1;
            problem_->pdef->clearSolutionPaths();
            expectExact(planner_->solve(test::untilExact(problem_->pdef)));
            const auto known =
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 2.0);
            problem_->pdef->setGoal(known);
            problem_->pdef->clearSolutionPaths();
            solveOnce();
            known->setThreshold(0.2);
            problem_->pdef->clearSolutionPaths();
            expectExact(planner_->solve(test::untilExact(problem_->pdef)));
        }

        TEST_P(ChangedQueries, ARegionThatGrowsNeedsNoNewSearch)
        {
            const auto region = std::make_shared<test::PatchGoal>(problem_->si, std::array{9.0, 1.0}, 0.5, 1000000);
            problem_->pdef->setGoal(region);
            solveOnce();
            const std::uint64_t evaluations = planner_->evaluations();
            const double cost = planner_->bestCost();
            region->side = 2.0;
            planner_->solve(test::afterCalls(300));
            EXPECT_GE(planner_->evaluations(), evaluations);
            EXPECT_LE(planner_->bestCost(), cost);
        }

        TEST_P(ChangedQueries, AnApproximatePathHasItsDistanceToTheGoalAsItIs)
        {
            problem_ = test::closedProblem();
            planner_ = problem_->planner(GetParam());
            const auto region =
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 2.0);
            problem_->pdef->setGoal(region);
            for (const double threshold : {2.0, 1.0})
            {
                region->setThreshold(threshold);
                problem_->pdef->clearSolutionPaths();
                ASSERT_EQ(planner_->solve(test::afterCalls(20000)), ob::PlannerStatus::APPROXIMATE_SOLUTION);
                double distance = 0.0;
                EXPECT_FALSE(region->isSatisfied(pathEnd(), &distance));
                EXPECT_EQ(problem_->pdef->getSolutionDifference(), distance);
            }
        }

        TEST_P(ChangedQueries, AStartThatTheNextProblemDefinitionLacksIsForgotten)
        {
            const auto goal = problem_->pdef->getGoal();
            solveOnce();
            problem_->pdef->addStartState(problem_->state({8.0, 1.0}));
            planner_->solve(test::afterCalls(2000));
            ASSERT_EQ(planner_->bestCost(), 1.0);
            const auto next = std::make_shared<ob::ProblemDefinition>(problem_->si);
            next->addStartState(problem_->state({1.0, 1.0}));
            next->setGoal(goal);
            problem_->pdef = next;
            planner_->setProblemDefinition(next);
            expectExactAgain(9.0, 1.0);
            EXPECT_EQ(test::coordinate(path().getState(0), 0), 1.0);
        }

        TEST_P(ChangedQueries, AnInvalidStartMayBeReplaced)
        {
            problem_->pdef->addStartState(problem_->state({5.0, 1.0}));
            solveOnce();
            problem_->si->copyState(problem_->pdef->getStartState(1), problem_->state({8.0, 1.0}).get());
            planner_->solve(test::afterCalls(2000));
            EXPECT_EQ(planner_->bestCost(), 1.0);
        }

        TEST_P(ChangedQueries, AThresholdOfTheObjectiveIsReadAsItIs)
        {
            const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si);
            objective->setCostThreshold(ob::Cost(100.0));
            problem_->pdef->setOptimizationObjective(objective);
            solveOnce();
            EXPECT_TRUE(problem_->pdef->hasOptimizedSolution());
            const double cost = planner_->bestCost();
            objective->setCostThreshold(ob::Cost(0.999 * cost));
            planner_->solve(test::afterCalls(100000));
            EXPECT_LE(planner_->bestCost(), 0.999 * cost);
        }

        /* The answers of the validity checker change between two solves, with and without clear(). */
        class ChangedWorlds : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            ChangedWorlds()
              : planner_(problem_.planner(GetParam()))
            {
            }

            void expectValidPath()
            {
                ASSERT_TRUE(problem_.pdef->hasSolution());
                EXPECT_TRUE(problem_.path().check());
            }

            /* Walls between x = 4 and 5 and between 6 and 7 that end at these heights. */
            double first_{-1.0};
            double second_{-1.0};
            test::PlanningProblem problem_{test::realVectorSpace(2, 0.0, 10.0),
                                           [this](const ob::State *s)
                                           {
                                               const double x = test::coordinate(s, 0);
                                               const double y = test::coordinate(s, 1);
                                               return !(x > 4.0 && x < 5.0 && y < first_) &&
                                                      !(x > 6.0 && x < 7.0 && y < second_);
                                           },
                                           {1.0, 1.0},
                                           {9.0, 1.0}};
            std::shared_ptr<MFA> planner_;
        };

        INSTANTIATE_TEST_SUITE_P(Planner, ChangedWorlds,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(ChangedWorlds, ABestPathThatIsNoneAnyMoreIsForgotten)
        {
            for (const double height : {-1.0, 6.0, 8.0})
            {
                first_ = height;
                problem_.pdef->clearSolutionPaths();
                ASSERT_EQ(planner_->solve(test::untilExact(problem_.pdef)), ob::PlannerStatus::EXACT_SOLUTION);
                expectValidPath();
            }
        }

        TEST_P(ChangedWorlds, SoIsAPartOfOne)
        {
            second_ = 11.0;
            ASSERT_EQ(planner_->solve(test::afterCalls(20000)), ob::PlannerStatus::APPROXIMATE_SOLUTION);
            expectValidPath();
            first_ = 11.0;
            problem_.pdef->clearSolutionPaths();
            ASSERT_EQ(planner_->solve(test::afterCalls(20000)), ob::PlannerStatus::APPROXIMATE_SOLUTION);
            expectValidPath();
        }

        TEST_P(ChangedWorlds, AStartThatBecameInvalidIsNone)
        {
            problem_.pdef->addStartState(problem_.state({4.5, 1.0}));
            ASSERT_EQ(planner_->solve(test::afterCalls(2000)), ob::PlannerStatus::EXACT_SOLUTION);
            ASSERT_EQ(planner_->bestCost(), 4.5);
            first_ = 6.0;
            problem_.pdef->clearSolutionPaths();
            ASSERT_EQ(planner_->solve(test::untilExact(problem_.pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            expectValidPath();
            EXPECT_EQ(test::coordinate(problem_.path().getState(0), 0), 1.0);
        }

        TEST_P(ChangedWorlds, AfterClearAllIsAsItIs)
        {
            first_ = second_ = 6.0;
            planner_->solve(test::afterCalls(10000));
            for (const double height : {8.0, -1.0, 3.0, 11.0})
            {
                first_ = height;
                second_ = -1.0;
                planner_->clear();
                problem_.pdef->clearSolutionPaths();
                const auto status = planner_->solve(test::afterCalls(40000));
                if (height > 10.0)
                {
                    EXPECT_EQ(status, ob::PlannerStatus::APPROXIMATE_SOLUTION);
                }
                else
                {
                    EXPECT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION) << height;
                    if (height < 1.0)
                    {
                        EXPECT_EQ(planner_->bestCost(), 8.0);
                    }
                }
                expectValidPath();
            }
        }

        /* Detects a wall exactly, at any resolution. */
        class WallValidator : public ob::MotionValidator
        {
        public:
            using MotionValidator::MotionValidator;

            bool checkMotion(const ob::State *from, const ob::State *to) const override
            {
                const double a = test::coordinate(from, 0) - 5.0;
                const double b = test::coordinate(to, 0) - 5.0;
                if ((a < 0.0) == (b < 0.0))
                {
                    return true;
                }
                const double y = test::coordinate(from, 1);
                return y + (test::coordinate(to, 1) - y) * a / (a - b) > 6.0;
            }

            bool checkMotion(const ob::State *from, const ob::State *to,
                             std::pair<ob::State *, double> &last) const override
            {
                last.second = 0.0;
                return checkMotion(from, to);
            }
        };

        /* Bounds that are infinite or change between two calls. */
        class ChangedBounds : public Queries
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, ChangedBounds,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        /* In an unbounded space neither sampling nor a resolution is defined. */
        TEST_P(ChangedBounds, BoundsWithoutAFiniteExtentAreRefusedByName)
        {
            for (const double bound : {1e200, std::numeric_limits<double>::max(), HUGE_VAL})
            {
                problem_ = std::make_unique<test::PlanningProblem>(
                    test::realVectorSpace(2, -bound, bound), [](const ob::State *) { return true; },
                    std::vector<double>{1.0, 1.0}, std::vector<double>{9.0, 1.0});
                problem_->si->setMotionValidator(std::make_shared<WallValidator>(problem_->si));
                problem_->si->getStateSpace()->setName("endless");
                planner_ = problem_->planner(GetParam());
                for (int i = 0; i < 2; ++i)
                {
                    try
                    {
                        planner_->solve(test::afterCalls(20000));
                        ADD_FAILURE() << "accepted: " << bound << ", solve() " << i;
                    }
                    catch (const ompl::Exception &error)
                    {
                        EXPECT_NE(std::string(error.what()).find("'endless'"), std::string::npos) << error.what();
                    }
                }
            }
        }

        void setSquare(const ob::SpaceInformationPtr &si, double low, double high)
        {
            test::bounded(std::static_pointer_cast<ob::RealVectorStateSpace>(si->getStateSpace()), 2, low, high);
        }

        TEST_P(ChangedBounds, BoundsEnlargedBetweenTwoSolvesAreSearched)
        {
            // the wall leaves a gap above the bounds
            problem_ = test::wallProblem(12.0);
            ASSERT_NE(solve(test::afterCalls(2000)), ob::PlannerStatus::EXACT_SOLUTION);
            setSquare(problem_->si, 0.0, 20.0);
            expectExact(planner_->solve(test::untilExact(problem_->pdef)));
            EXPECT_GE(planner_->bestCost(), test::wallOptimum(12.0) - 1e-9);
            setSquare(problem_->si, -HUGE_VAL, HUGE_VAL);
            EXPECT_THROW(planner_->solve(test::afterCalls(2000)), ompl::Exception);
        }

        TEST_P(ChangedBounds, AGoalBeyondTheBoundsIsReachedOnceTheyAreEnlarged)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({3.0, 15.0}));
            problem_->pdef->setGoal(goals);
            EXPECT_EQ(solve(ob::timedPlannerTerminationCondition(0.05)), ob::PlannerStatus::INVALID_GOAL);
            setSquare(problem_->si, 0.0, 20.0);
            expectExact(planner_->solve(test::untilExact(problem_->pdef)));
        }

        TEST_P(ChangedBounds, APathThatLeavesTheBoundsOfALaterSolveIsForgotten)
        {
            expectExact(solve());
            problem_->pdef->clearSolutionPaths();
            // the gap above the wall, y > 6, is now out of bounds
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(0, 10.0);
            bounds.setHigh(1, 5.0);
            problem_->si->getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(bounds);
            EXPECT_NE(planner_->solve(test::afterCalls(2000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_FALSE(problem_->pdef->hasExactSolution());
            // and now a section of it is not
            problem_->pdef->clearSolutionPaths();
            bounds.setHigh(1, 7.0);
            problem_->si->getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(bounds);
            expectExact(planner_->solve(test::untilExact(problem_->pdef)));
            for (const ob::State *state : path().getStates())
            {
                EXPECT_LE(test::coordinate(state, 1), 7.0);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
