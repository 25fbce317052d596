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

/* A world that changes between two solves, and queries that change in the same world. */

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/util/RandomNumbers.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        struct Box
        {
            double left, right, bottom, top;

            bool contains(double x, double y) const
            {
                return x > left && x < right && y > bottom && y < top;
            }
        };

        /* The square [0, 10]^2 with boxes that the tests add and remove. */
        struct BoxWorld
        {
            std::vector<Box> boxes;
            test::PlanningProblem problem{
                test::realVectorSpace(2, 0.0, 10.0),
                [this](const ob::State *s)
                {
                    return std::none_of(boxes.begin(), boxes.end(),
                                        [s](const Box &box)
                                        { return box.contains(test::coordinate(s, 0), test::coordinate(s, 1)); });
                },
                {1.0, 5.0},
                {9.0, 5.0}};

            og::PathGeometric &path() const
            {
                return problem.path();
            }

            /* Whether the reported solution is valid now, from the present start to the present goal, and of the
               reported cost. */
            void expectSolution(const MFA &planner, const std::string &what = "") const
            {
                ASSERT_TRUE(problem.pdef->hasExactSolution()) << what;
                EXPECT_TRUE(path().check()) << what;
                EXPECT_TRUE(problem.si->isValid(path().getState(0))) << what;
                EXPECT_TRUE(problem.si->equalStates(path().getState(0), problem.pdef->getStartState(0))) << what;
                EXPECT_TRUE(problem.pdef->getGoal()->isSatisfied(path().getState(path().getStateCount() - 1))) << what;
                EXPECT_NEAR(path().length(), planner.bestCost(), 1e-9) << what;
                EXPECT_EQ(problem.reportedCost(), planner.bestCost()) << what;
            }

            void moveStart(const std::vector<double> &to) const
            {
                problem.pdef->clearStartStates();
                problem.pdef->addStartState(problem.state(to));
            }
        };

        const Box BLOCK{4.5, 5.5, 2.0, 6.0};

        class ChangingWorld : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            ob::PlannerStatus solve(std::uint64_t calls)
            {
                world_.problem.pdef->clearSolutionPaths();
                return planner_->solve(test::afterCalls(calls));
            }

            ob::PlannerStatus solveAny()
            {
                world_.problem.pdef->clearSolutionPaths();
                return planner_->solve(test::untilExact(world_.problem.pdef));
            }

            bool isPaper() const
            {
                return GetParam() == test::PlannerVariant::Paper;
            }

            BoxWorld world_;
            std::shared_ptr<MFA> planner_ = world_.problem.planner(GetParam());
        };

        INSTANTIATE_TEST_SUITE_P(Planner, ChangingWorld,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(ChangingWorld, NoCostIsReportedBeforeTheNextSolve)
        {
            world_.boxes = {BLOCK};
            solve(5000);
            ASSERT_LT(planner_->bestCost(), NEVER);
            planner_->validityChanged();
            EXPECT_EQ(planner_->bestCost(), NEVER);
            EXPECT_EQ(planner_->getPlannerProgressProperties().at("best cost REAL")(), "inf");
            EXPECT_TRUE(planner_->getSwarmPaths().empty());
            ob::PlannerData data(world_.problem.si);
            planner_->getPlannerData(data);
            EXPECT_EQ(data.numEdges(), 0U);
        }

        TEST_P(ChangingWorld, AfterAWallWasAddedThePathIsValidAndItsCostThatOfTheDetour)
        {
            solveAny();
            EXPECT_NEAR(planner_->bestCost(), 8.0, 1e-9);
            world_.boxes = {BLOCK};
            planner_->validityChanged();
            EXPECT_EQ(solveAny(), ob::PlannerStatus::EXACT_SOLUTION);
            world_.expectSolution(*planner_);
            EXPECT_EQ(solve(30000), ob::PlannerStatus::EXACT_SOLUTION);
            world_.expectSolution(*planner_);
            const double optimum = 2.0 * std::hypot(3.5, 1.0) + 1.0;
            EXPECT_GE(planner_->bestCost(), optimum - 0.05);
            EXPECT_LT(planner_->bestCost(), (isPaper() ? 1.1 : 1.002) * optimum);
        }

        TEST_P(ChangingWorld, AfterAWallWasRemovedTheStraightMotionIsFound)
        {
            world_.boxes = {BLOCK};
            solve(5000);
            world_.boxes.clear();
            planner_->validityChanged();
            EXPECT_EQ(solve(100), ob::PlannerStatus::EXACT_SOLUTION);
            world_.expectSolution(*planner_);
            EXPECT_NEAR(planner_->bestCost(), 8.0, 1e-9);
        }

        TEST_P(ChangingWorld, APathThatStaysValidIsAtHandAfterOneCheck)
        {
            world_.boxes = {BLOCK};
            solve(8000);
            const double before = planner_->bestCost();
            ASSERT_LT(before, NEVER);
            world_.boxes.push_back({0.0, 1.0, 0.0, 1.0});
            planner_->validityChanged();
            world_.problem.counted.forget();
            solveAny();
            world_.expectSolution(*planner_);
            EXPECT_LE(planner_->bestCost(), before + 1e-9);
            // the straight motion and the path: about 800 states each in this space
            EXPECT_LT(world_.problem.counted.states, 2500U);
        }

        TEST_P(ChangingWorld, AGoalThatBecomesInvalidIsRefusedAndUsedAgainLater)
        {
            world_.boxes = {BLOCK};
            solve(8000);
            world_.boxes.push_back({8.5, 9.5, 4.5, 5.5});
            planner_->validityChanged();
            EXPECT_EQ(solve(2000), ob::PlannerStatus::INVALID_GOAL);
            EXPECT_FALSE(world_.problem.pdef->hasSolution());
            EXPECT_EQ(planner_->bestCost(), NEVER);
            world_.boxes.pop_back();
            planner_->validityChanged();
            world_.problem.counted.forget();
            EXPECT_EQ(solveAny(), ob::PlannerStatus::EXACT_SOLUTION);
            world_.expectSolution(*planner_);
            EXPECT_LT(world_.problem.counted.states, 2500U) << "the path is still known";
        }

        TEST_P(ChangingWorld, AStartThatBecomesInvalidIsRefused)
        {
            solve(100);
            world_.boxes = {{0.5, 1.5, 4.5, 5.5}};
            planner_->validityChanged();
            EXPECT_EQ(solve(2000), ob::PlannerStatus::INVALID_START);
            EXPECT_EQ(planner_->bestCost(), NEVER);
            world_.moveStart({2.0, 5.0});
            EXPECT_EQ(solveAny(), ob::PlannerStatus::EXACT_SOLUTION);
            world_.expectSolution(*planner_);
        }

        TEST_P(ChangingWorld, WithoutAWayNothingIsReported)
        {
            world_.boxes = {BLOCK};
            solve(8000);
            world_.boxes.push_back({4.5, 5.5, -1.0, 11.0});
            planner_->validityChanged();
            EXPECT_NE(solve(8000), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_FALSE(world_.problem.pdef->hasExactSolution());
            EXPECT_EQ(planner_->bestCost(), NEVER);
            world_.boxes.pop_back();
            planner_->validityChanged();
            EXPECT_EQ(solveAny(), ob::PlannerStatus::EXACT_SOLUTION);
            world_.expectSolution(*planner_);
        }

        TEST_P(ChangingWorld, PlannerDataAreValidNow)
        {
            world_.boxes = {BLOCK};
            solve(20000);
            world_.boxes = {{2.5, 3.0, -1.0, 7.0}, {7.0, 7.5, 3.0, 11.0}};
            planner_->validityChanged();
            solve(3000);
            ob::PlannerData data(world_.problem.si);
            planner_->getPlannerData(data);
            ASSERT_GT(data.numVertices(), 1U);
            std::vector<unsigned int> next;
            for (unsigned int v = 0; v < data.numVertices(); ++v)
            {
                const ob::State *state = data.getVertex(v).getState();
                EXPECT_TRUE(world_.problem.si->isValid(state)) << v;
                data.getEdges(v, next);
                for (const unsigned int to : next)
                {
                    EXPECT_TRUE(world_.problem.si->checkMotion(state, data.getVertex(to).getState())) << v;
                }
            }
        }

        TEST_P(ChangingWorld, ClearForgetsTheEarlierSearch)
        {
            world_.boxes = {BLOCK};
            solve(3000);
            const double first = planner_->bestCost();
            planner_->validityChanged();
            planner_->clear();
            solve(3000);
            EXPECT_EQ(planner_->bestCost(), first) << "the same seed, the same run";
        }

        TEST(ChangedWorlds, ABlockedPathIsRepairedWithFewChecks)
        {
            double repaired = 0.0;
            double anew = 0.0;
            for (std::uint32_t seed = 1; seed <= 10; ++seed)
            {
                BoxWorld world;
                // corridors
                world.boxes = {
                    {2.0, 2.5, 1.0, 11.0}, {4.0, 4.5, -1.0, 9.0}, {6.0, 6.5, 1.0, 11.0}, {7.5, 8.0, -1.0, 9.0}};
                const auto planner = world.problem.planner(test::PlannerVariant::Default, seed);
                // without a population there is only the best path
                test::set(*planner, "fireflies", seed % 2 == 0 ? "1" : "0");
                planner->solve(test::afterCalls(20000));
                ASSERT_LT(planner->bestCost(), NEVER);
                world.problem.pdef->clearSolutionPaths();
                // a box in the way, between two walls
                world.boxes.push_back({5.0, 5.3, 3.5, 7.5});
                planner->validityChanged();
                world.problem.counted.forget();
                planner->solve(test::untilExact(world.problem.pdef));
                world.expectSolution(*planner, "seed " + std::to_string(seed));
                repaired += static_cast<double>(world.problem.counted.states);
                world.problem.pdef->clearSolutionPaths();
                const auto other = world.problem.planner(test::PlannerVariant::Default, seed);
                world.problem.counted.forget();
                other->solve(test::untilExact(world.problem.pdef));
                anew += static_cast<double>(world.problem.counted.states);
            }
            EXPECT_LT(repaired, 0.4 * anew);
            RecordProperty("checks_repaired", std::to_string(repaired / 10));
            RecordProperty("checks_anew", std::to_string(anew / 10));
        }

        TEST(ChangedWorlds, AnotherHomotopyClassIsUsedWhenItOpens)
        {
            BoxWorld world;
            world.boxes = {{4.5, 5.5, -1.0, 3.0}, {4.5, 5.5, 3.0, 9.0}, {4.5, 5.5, 2.9, 3.1}};
            const auto planner = world.problem.planner(test::PlannerVariant::Default);
            planner->solve(test::afterCalls(30000));
            const double over = 2.0 * std::hypot(3.5, 4.0) + 1.0;
            EXPECT_NEAR(planner->bestCost(), over, 0.01 * over);
            // a door from y = 3.5 to y = 4.5
            world.boxes = {{4.5, 5.5, -1.0, 3.5}, {4.5, 5.5, 4.5, 9.0}};
            planner->validityChanged();
            world.problem.pdef->clearSolutionPaths();
            planner->solve(test::afterCalls(60000));
            world.expectSolution(*planner);
            EXPECT_LT(planner->bestCost(), 1.01 * (2.0 * std::hypot(3.5, 0.5) + 1.0));
        }

        /* Costs that depend on the world. */
        class Exposure : public ob::StateCostIntegralObjective
        {
        public:
            Exposure(const ob::SpaceInformationPtr &si, const double &price)
              : StateCostIntegralObjective(si, true)
              , price_(price)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(test::coordinate(state, 1) < 5.0 ? price_ : 1.0);
            }

        private:
            const double &price_;
        };

        TEST(ChangedWorlds, CostsThatDependOnTheWorldAreComputedAgain)
        {
            for (const bool roadmapOnly : {false, true})
            {
                BoxWorld world;
                world.boxes = {{4.5, 5.5, 3.0, 8.0}};
                double price = 1.0;
                world.problem.pdef->setOptimizationObjective(std::make_shared<Exposure>(world.problem.si, price));
                const auto planner = world.problem.planner(test::PlannerVariant::Default);
                if (roadmapOnly)
                {
                    test::set(*planner, "guide", "roadmap");
                    test::set(*planner, "fireflies", "0");
                    test::set(*planner, "tightening", "0");
                }
                planner->solve(test::afterCalls(20000));
                EXPECT_LT(planner->bestCost(), 9.5) << "below the box";
                price = 3.0;
                planner->validityChanged();
                world.problem.pdef->clearSolutionPaths();
                planner->solve(test::afterCalls(40000));
                ASSERT_TRUE(world.problem.pdef->hasExactSolution());
                EXPECT_NEAR(world.path().cost(world.problem.pdef->getOptimizationObjective()).value(),
                            planner->bestCost(), 1e-6);
                EXPECT_NEAR(planner->bestCost(), 2.0 * std::hypot(3.5, 3.0) + 1.0, roadmapOnly ? 1.5 : 0.2)
                    << "above it";
            }
        }

        struct Figures
        {
            std::size_t solved{0};
            std::size_t compared{0};
            double worst{1.0};
            double sum{0.0};  ///< of costs relative to a new search's
        };

        /* One random world and 12 changes of it, some with another start or goal; each result is compared with that
           of a new planner. */
        void changeAtRandom(std::uint32_t seed, test::PlannerVariant variant, Figures &figures)
        {
            ompl::RNG rng(seed);
            BoxWorld world;
            const auto addBox = [&]
            {
                const double x = rng.uniformReal(0.0, 10.0);
                const double y = rng.uniformReal(0.0, 10.0);
                world.boxes.push_back({x - rng.uniformReal(0.1, 1.0), x + 0.5, y - rng.uniformReal(0.1, 2.0),
                                       y + rng.uniformReal(0.1, 2.0)});
            };
            for (int i = 0; i < 8; ++i)
            {
                addBox();
            }
            const auto planner = world.problem.planner(variant, seed);
            planner->solve(test::afterCalls(3000));
            for (int change = 0; change < 12; ++change)
            {
                const std::string what = "seed " + std::to_string(seed) + ", change " + std::to_string(change);
                const int kind = rng.uniformInt(0, 4);
                if (kind <= 2)
                {
                    addBox();
                    world.boxes.erase(world.boxes.begin() +
                                      rng.uniformInt(0, static_cast<int>(world.boxes.size()) - (kind == 0 ? 2 : 1)));
                    planner->validityChanged();
                }
                else if (kind == 3 && world.problem.pdef->hasExactSolution())
                {
                    og::PathGeometric driven(world.path());
                    driven.interpolate(20);
                    ob::ScopedState<> start(world.problem.si->getStateSpace(), driven.getState(3));
                    world.problem.pdef->clearStartStates();
                    world.problem.pdef->addStartState(start);
                    planner->clearQuery();
                }
                else
                {
                    world.problem.pdef->setGoalState(
                        world.problem.state({rng.uniformReal(6.0, 10.0), rng.uniformReal(0.0, 10.0)}));
                    planner->clearQuery();
                }
                world.problem.pdef->clearSolutionPaths();
                const auto calls = static_cast<std::uint64_t>(rng.uniformInt(1, 6000));
                const ob::PlannerStatus status = planner->solve(test::afterCalls(calls));
                EXPECT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, planner->bestCost() < NEVER) << what;
                if (status == ob::PlannerStatus::EXACT_SOLUTION)
                {
                    world.expectSolution(*planner, what);
                    ++figures.solved;
                }
                else if (world.problem.pdef->hasSolution())
                {
                    EXPECT_TRUE(world.path().check()) << what;
                }
                if (change % 4 != 3)
                {
                    continue;
                }
                const ob::PlannerStatus::StatusType longer = planner->solve(test::afterCalls(20000));
                const double cost = planner->bestCost();
                if (longer == ob::PlannerStatus::EXACT_SOLUTION)
                {
                    world.expectSolution(*planner, what);
                }
                world.problem.pdef->clearSolutionPaths();
                const auto other = world.problem.planner(variant, seed);
                const ob::PlannerStatus::StatusType anew = other->solve(test::afterCalls(20000 + calls));
                EXPECT_EQ(longer, anew) << what;
                if (anew == ob::PlannerStatus::EXACT_SOLUTION && longer == anew)
                {
                    ++figures.compared;
                    figures.worst = std::max(figures.worst, cost / other->bestCost());
                    figures.sum += cost / other->bestCost();
                }
                world.problem.pdef->clearSolutionPaths();
                planner->solve(test::afterCalls(2));
            }
        }

        TEST(ChangedWorlds, ResultsAreThoseOfANewSearch)
        {
            Figures figures;
            for (std::uint32_t seed = 1; seed <= 40; ++seed)
            {
                changeAtRandom(seed, test::PlannerVariant::Default, figures);
            }
            EXPECT_GT(figures.solved, 300U);
            EXPECT_GT(figures.compared, 80U);
            // neither search has converged
            EXPECT_LT(figures.sum / static_cast<double>(figures.compared), 1.003);
            EXPECT_LT(figures.worst, 1.1);
        }

        TEST(ChangedWorlds, ThePapersAlgorithmReportsValidPathsOnly)
        {
            for (std::uint32_t seed = 1; seed <= 2; ++seed)
            {
                BoxWorld world;
                world.boxes = {BLOCK};
                const auto planner = world.problem.planner(test::PlannerVariant::Paper, seed);
                for (int change = 0; change < 6; ++change)
                {
                    world.boxes = {{4.5, 5.5, 2.0 + change % 3, 6.0 + change % 3}};
                    planner->validityChanged();
                    world.problem.pdef->clearSolutionPaths();
                    planner->solve(test::untilExact(world.problem.pdef));
                    world.expectSolution(*planner);
                }
            }
        }

        TEST(OtherQueries, AStartThatMovesAlongThePathKeepsTheRestOfIt)
        {
            BoxWorld world;
            world.boxes = {{2.0, 2.5, 1.0, 11.0}, {4.0, 4.5, -1.0, 9.0}, {6.0, 6.5, 1.0, 11.0}, {7.5, 8.0, -1.0, 9.0}};
            const auto planner = world.problem.planner(test::PlannerVariant::Default);
            planner->solve(test::afterCalls(30000));
            double cost = planner->bestCost();
            for (int step = 0; step < 8; ++step)
            {
                og::PathGeometric driven(world.path());
                driven.interpolate(static_cast<unsigned int>(driven.length() / 0.1));
                const double gone = driven.length() / (driven.getStateCount() - 1.0) * 10.0;
                ob::ScopedState<> start(world.problem.si->getStateSpace(), driven.getState(10));
                world.problem.pdef->clearStartStates();
                world.problem.pdef->addStartState(start);
                world.problem.pdef->clearSolutionPaths();
                planner->clearQuery();
                EXPECT_EQ(planner->bestCost(), NEVER);
                world.problem.counted.forget();
                planner->solve(test::untilExact(world.problem.pdef));
                world.expectSolution(*planner, "step " + std::to_string(step));
                EXPECT_LT(planner->bestCost(), cost - gone + 0.02) << step;
                EXPECT_LT(world.problem.counted.states, 6000U) << step;
                cost = planner->bestCost();
            }
        }

        TEST(OtherQueries, AnotherGoalUsesTheRoadmap)
        {
            double kept = 0.0;
            double anew = 0.0;
            for (std::uint32_t seed = 1; seed <= 10; ++seed)
            {
                BoxWorld world;
                world.boxes = {
                    {2.0, 2.5, 1.0, 11.0}, {4.0, 4.5, -1.0, 9.0}, {6.0, 6.5, 1.0, 11.0}, {7.5, 8.0, -1.0, 9.0}};
                const auto planner = world.problem.planner(test::PlannerVariant::Default, seed);
                planner->solve(test::afterCalls(30000));
                world.problem.pdef->clearSolutionPaths();
                world.problem.pdef->setGoalState(world.problem.state({7.0, 9.5}));
                planner->clearQuery();
                world.problem.counted.forget();
                planner->solve(test::untilExact(world.problem.pdef));
                world.expectSolution(*planner);
                kept += static_cast<double>(world.problem.counted.states);
                world.problem.pdef->clearSolutionPaths();
                const auto other = world.problem.planner(test::PlannerVariant::Default, seed);
                world.problem.counted.forget();
                other->solve(test::untilExact(world.problem.pdef));
                anew += static_cast<double>(world.problem.counted.states);
            }
            EXPECT_LT(kept, 0.4 * anew);
            RecordProperty("checks_kept", std::to_string(kept / 10));
            RecordProperty("checks_anew", std::to_string(anew / 10));
        }

        TEST(OtherQueries, SeededRunsRepeat)
        {
            std::vector<double> costs;
            for (int run = 0; run < 2; ++run)
            {
                BoxWorld world;
                world.boxes = {BLOCK, {7.0, 8.0, 4.0, 9.0}};
                const auto planner = world.problem.planner(test::PlannerVariant::Default);
                for (int k = 0; k < 4; ++k)
                {
                    planner->solve(test::afterCalls(3000));
                    costs.push_back(planner->bestCost());
                    world.problem.pdef->setGoalState(world.problem.state({9.0, 2.0 * k}));
                    world.boxes[0].top = 7.0 + 0.1 * k;
                    planner->validityChanged();
                }
            }
            for (std::size_t k = 0; k < 4; ++k)
            {
                EXPECT_EQ(costs[k], costs[k + 4]) << k;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
