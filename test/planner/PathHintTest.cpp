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

/* Paths that the user gives as hints. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/util/Exception.h>

#include "path/StateChart.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        og::PathGeometric pathOf(const ob::SpaceInformationPtr &si, const std::vector<std::vector<double>> &states)
        {
            og::PathGeometric path(si);
            ob::ScopedState<> state(si->getStateSpace());
            for (const std::vector<double> &values : states)
            {
                state = values;
                path.append(state.get());
            }
            return path;
        }

        /* Seven walls across [0, 10]^2 that leave narrow gaps, alternately at the top and at the bottom. */
        std::unique_ptr<test::PlanningProblem> maze()
        {
            return std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, 0.0, 10.0),
                [](const ob::State *s)
                {
                    const double x = test::coordinate(s, 0);
                    const double y = test::coordinate(s, 1);
                    const double wall = std::round(x / 1.25);
                    if (wall < 1.0 || wall > 7.0 || std::abs(x - 1.25 * wall) > 0.1)
                    {
                        return true;
                    }
                    return static_cast<int>(wall) % 2 == 0 ? y < 0.25 : y > 9.75;
                },
                std::vector<double>{0.5, 5.0}, std::vector<double>{9.5, 5.0});
        }

        /* Through the gaps of the maze; \e gap is the distance of the points from the border. */
        std::vector<std::vector<double>> throughTheMaze(double gap)
        {
            std::vector<std::vector<double>> points{{0.5, 5.0}};
            for (int wall = 1; wall <= 7; ++wall)
            {
                const double y = wall % 2 == 0 ? gap : 10.0 - gap;
                points.push_back({1.25 * wall - 0.3, y});
                points.push_back({1.25 * wall + 0.3, y});
            }
            points.push_back({9.5, 5.0});
            return points;
        }

        double checksUntilAPath(std::uint32_t seed, const std::vector<std::vector<double>> &hint)
        {
            const auto problem = maze();
            const auto planner = problem->planner(test::PlannerVariant::Default, seed);
            if (!hint.empty())
            {
                planner->addPathHint(pathOf(problem->si, hint));
            }
            problem->counted.forget();
            EXPECT_EQ(planner->solve(test::untilExact(problem->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(problem->path().check());
            return static_cast<double>(problem->counted.states);
        }

        TEST(PathHints, MakeTheFirstPathOfAMazeImmediate)
        {
            double without = 0.0;
            double valid = 0.0;
            double colliding = 0.0;
            double moved = 0.0;
            for (std::uint32_t seed = 1; seed <= 5; ++seed)
            {
                without += checksUntilAPath(seed, {}) / 5;
                valid += checksUntilAPath(seed, throughTheMaze(0.12)) / 5;
                // the middles of the walls' ends, not the gaps
                colliding += checksUntilAPath(seed, throughTheMaze(0.6)) / 5;
                std::vector<std::vector<double>> part = throughTheMaze(0.12);
                part.front() = {0.2, 1.0};
                part.back() = {9.0, 8.0};
                moved += checksUntilAPath(seed, part) / 5;
            }
            RecordProperty("checks_without", std::to_string(without));
            RecordProperty("checks_valid", std::to_string(valid));
            RecordProperty("checks_colliding", std::to_string(colliding));
            RecordProperty("checks_other_ends", std::to_string(moved));
            EXPECT_LT(valid, 0.2 * without);
            EXPECT_LT(moved, 0.2 * without);
            EXPECT_LT(colliding, 0.7 * without);
        }

        class HintedProblem : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            void add(const std::vector<std::vector<double>> &points)
            {
                planner_->addPathHint(pathOf(problem_->si, points));
            }

            void expectSolved()
            {
                problem_->pdef->clearSolutionPaths();
                ASSERT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_TRUE(problem_->path().check());
                EXPECT_NEAR(problem_->path().length(), planner_->bestCost(), 1e-9);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::shared_ptr<MFA> planner_ = problem_->planner(GetParam());
        };

        INSTANTIATE_TEST_SUITE_P(Planner, HintedProblem,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(HintedProblem, HintsOfAnyKindLeadToValidPathsOnly)
        {
            const std::vector<std::vector<std::vector<double>>> hints{
                {{1, 1}, {9, 1}},                                          // through the wall
                {{5, 1}},                                                  // one invalid state
                {{2, 2}},                                                  // one valid state
                {{9, 1}, {1, 1}},                                          // backwards
                {{1, 1}, {1, 1}, {3, 8}, {3, 8}, {7, 8}, {9, 1}, {9, 1}},  // repeated states
                {{-30, 4}, {50, 12}},                                      // out of bounds
                {{1, 1}, {5, 8}, {5, 0}, {5, 8}, {9, 1}},                  // into the wall and back
                {{4, 9}, {6, 9}}};
            for (const auto &hint : hints)
            {
                add(hint);
            }
            expectSolved();
            EXPECT_EQ(planner_->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(problem_->path().check());
            for (const auto &hint : hints)
            {
                planner_->clear();
                add(hint);
                expectSolved();
            }
        }

        TEST_P(HintedProblem, InASolvedQueryTheyDoNotMakeThePathWorse)
        {
            planner_->solve(test::afterCalls(20000));
            const double before = planner_->bestCost();
            add({{1, 1}, {3, 8}, {7, 8}, {9, 1}});
            expectSolved();
            EXPECT_LE(planner_->bestCost(), before);
        }

        TEST_P(HintedProblem, WithoutHintsTheRunIsTheSameAfterOnesThatWereCleared)
        {
            planner_->solve(test::afterCalls(3000));
            const double cost = planner_->bestCost();
            planner_->clear();
            add({{1, 1}, {3, 8}, {7, 8}, {9, 1}});
            planner_->clear();
            planner_->solve(test::afterCalls(3000));
            EXPECT_EQ(planner_->bestCost(), cost);
        }

        TEST_P(HintedProblem, OnesThatCannotBeUsedAreRefused)
        {
            EXPECT_THROW(planner_->addPathHint(ob::PathPtr()), ompl::Exception);
            EXPECT_THROW(planner_->addPathHint(og::PathGeometric(problem_->si)), ompl::Exception);
            EXPECT_THROW(add({{1, 1}, {std::nan(""), 2}}), ompl::Exception);
            EXPECT_THROW(add({{1, 1}, {NEVER, 2}}), ompl::Exception);
            for (const auto &space : {test::realVectorSpace(3), test::se2Space(), test::so2Space()})
            {
                const auto other = std::make_shared<ob::SpaceInformation>(space);
                og::PathGeometric path(other);
                path.append(ob::ScopedState<>(space).get());
                EXPECT_THROW(planner_->addPathHint(path), ompl::Exception) << space->getName();
            }
            expectSolved();
        }

        TEST(PathHints, ThroughAWallThatDraftsMayMissAreRepaired)
        {
            test::PlanningProblem problem(
                test::realVectorSpace(2, 0.0, 10.0),
                [](const ob::State *s)
                { return std::abs(test::coordinate(s, 0) - 5.0) > 0.025 || test::coordinate(s, 1) > 9.0; },
                {1.0, 1.0}, {9.0, 1.0});
            problem.si->setStateValidityCheckingResolution(0.001);
            problem.si->setup();
            ompl::RNG rng(3);
            const auto planner = problem.planner(test::PlannerVariant::Default);
            for (int run = 0; run < 10; ++run)
            {
                planner->solve(test::afterCalls(3000));
                ASSERT_LT(planner->bestCost(), NEVER);
                for (int k = 0; k < 10; ++k)
                {
                    const double y = rng.uniformReal(0.0, 5.0);
                    planner->addPathHint(pathOf(
                        problem.si, {{1, 1}, {rng.uniformReal(2, 4.5), y}, {rng.uniformReal(5.5, 8), y}, {9, 1}}));
                }
            }
            planner->solve(test::afterCalls(3000));
            EXPECT_TRUE(problem.path().check());
            EXPECT_GT(planner->bestCost(), 2.0 * std::hypot(4.0, 8.0) - 0.1);
        }

        TEST(PathHints, OfAnotherSpaceInformationAreCopied)
        {
            const auto problem = maze();
            const auto planner = std::make_shared<MFA>(problem->si);
            {
                // neither the space nor the planner is set up yet
                auto space = std::make_shared<ob::RealVectorStateSpace>(2);
                space->setBounds(-100.0, 100.0);
                const auto other = std::make_shared<ob::SpaceInformation>(space);
                og::PathGeometric path(other);
                for (const auto &point : throughTheMaze(0.12))
                {
                    ob::State *state = space->allocState();
                    state->as<ob::RealVectorStateSpace::StateType>()->values[0] = point[0];
                    state->as<ob::RealVectorStateSpace::StateType>()->values[1] = point[1];
                    path.append(state);
                    space->freeState(state);
                }
                planner->addPathHint(std::make_shared<og::PathGeometric>(path));
            }
            planner->setProblemDefinition(problem->pdef);
            problem->counted.forget();
            EXPECT_EQ(planner->solve(test::untilExact(problem->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LT(problem->counted.states, 8000U);
        }

        TEST(PathHints, InThePapersAlgorithmBecomeFirstFireflies)
        {
            const auto iterations = [](bool hinted)
            {
                // a wall with a door that is narrow and off the axis
                test::PlanningProblem problem(test::realVectorSpace(2, 0.0, 10.0),
                                              [](const ob::State *s)
                                              {
                                                  const double y = test::coordinate(s, 1);
                                                  return std::abs(test::coordinate(s, 0) - 5.0) > 0.5 ||
                                                         (y > 7.0 && y < 7.1);
                                              },
                                              {1.0, 1.0}, {9.0, 1.0});
                const auto planner = problem.planner(test::PlannerVariant::Paper);
                if (hinted)
                {
                    planner->addPathHint(pathOf(problem.si, {{1, 1}, {3, 7.05}, {7, 7.05}, {9, 1}}));
                }
                planner->solve(test::untilExact(problem.pdef));
                EXPECT_TRUE(problem.path().check());
                return planner->iterations();
            };
            EXPECT_EQ(iterations(true), 0U) << "valid in the first generation";
            EXPECT_GT(iterations(false), 0U);
        }

        /* A hint may be of no use, but no planner may be misled by it, in any space. */
        class HintsInSpaces : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, HintsInSpaces, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(HintsInSpaces, ValidCollidingAndForeignOnes)
        {
            const auto space = GetParam().make();
            const auto chart = std::make_shared<path::StateChart>(space);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker(
                [chart](const ob::State *state)
                {
                    Eigen::VectorXd positions(chart->positionDimension());
                    chart->positions(state, positions);
                    return positions.size() < 2 || positions.norm() > 2.0;
                });
            si->setup();
            ompl::RNG rng(5);
            for (int run = 0; run < 6; ++run)
            {
                const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
                ob::ScopedState<> start(space);
                ob::ScopedState<> goal(space);
                do
                {
                    chart->sampleUniform(rng, start.get());
                } while (!si->isValid(start.get()));
                do
                {
                    chart->sampleUniform(rng, goal.get());
                } while (!si->isValid(goal.get()));
                pdef->setStartAndGoalStates(start, goal);
                const auto planner = test::makePlanner(si, test::PlannerVariant::Default, 1 + run);
                planner->setProblemDefinition(pdef);
                for (int k = 0; k < 3; ++k)
                {
                    // random states, which collide or not; the first hint begins and ends as it should
                    og::PathGeometric hint(si);
                    ob::ScopedState<> state(space);
                    for (int i = 0; i < 4; ++i)
                    {
                        chart->sampleUniform(rng, state.get());
                        hint.append(k == 0 && i == 0 ? start.get() : k == 0 && i == 3 ? goal.get() : state.get());
                    }
                    planner->addPathHint(hint);
                }
                ASSERT_EQ(planner->solve(test::untilExact(pdef)), ob::PlannerStatus::EXACT_SOLUTION) << run;
                planner->solve(test::afterCalls(2000));
                EXPECT_TRUE(pdef->getSolutionPath()->check()) << run;
                const double cost = planner->bestCost();
                // its own path is a valid hint for another planner
                const auto other = test::makePlanner(si, test::PlannerVariant::Default, 10 + run);
                const auto again = std::make_shared<ob::ProblemDefinition>(si);
                again->setStartAndGoalStates(start, goal);
                other->setProblemDefinition(again);
                other->addPathHint(pdef->getSolutionPath());
                ASSERT_EQ(other->solve(test::untilExact(again)), ob::PlannerStatus::EXACT_SOLUTION) << run;
                EXPECT_TRUE(again->getSolutionPath()->check()) << run;
                EXPECT_LE(other->bestCost(), cost * (1.0 + 1e-9)) << run;
                // the obstacle is still there, and the path still valid
                planner->validityChanged();
                pdef->clearSolutionPaths();
                ASSERT_EQ(planner->solve(test::untilExact(pdef)), ob::PlannerStatus::EXACT_SOLUTION) << run;
                EXPECT_TRUE(pdef->getSolutionPath()->check()) << run;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
