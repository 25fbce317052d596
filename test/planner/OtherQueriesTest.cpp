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

/* Queries that change in the same world, and random changes of both. */

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/util/RandomNumbers.h>

#include "planner/BoxWorld.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        TEST(OtherQueries, AStartThatMovesAlongThePathKeepsTheRestOfIt)
        {
            test::BoxWorld world;
            world.boxes = test::corridors();
            const auto planner = world.problem.planner(test::PlannerVariant::Default);
            planner->setStrictness(1);  // the finer checks of the path that is returned are not counted here
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
                test::BoxWorld world;
                world.boxes = test::corridors();
                const auto planner = world.problem.planner(test::PlannerVariant::Default, seed);
                planner->setStrictness(1);
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
                other->setStrictness(1);
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
                test::BoxWorld world;
                world.boxes = {{4.5, 5.5, 2.0, 6.0}, {7.0, 8.0, 4.0, 9.0}};
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
            test::BoxWorld world;
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

        TEST(ChangedWorldsAndQueries, HaveTheResultsOfANewSearch)
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
    }  // namespace
}  // namespace ompl_mfa::planner
