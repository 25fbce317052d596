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

/* A world that changes between two solves. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "planner/BoxWorld.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        const test::Box BLOCK{4.5, 5.5, 2.0, 6.0};

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

            test::BoxWorld world_;
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
            planner_->setStrictness(1);  // the path that is returned is the best one, and is checked once
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
                test::BoxWorld world;
                // corridors
                world.boxes = test::corridors();
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
            test::BoxWorld world;
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
                test::BoxWorld world;
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

        TEST(ChangedWorlds, ThePapersAlgorithmReportsValidPathsOnly)
        {
            for (std::uint32_t seed = 1; seed <= 2; ++seed)
            {
                test::BoxWorld world;
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

    }  // namespace
}  // namespace ompl_mfa::planner
