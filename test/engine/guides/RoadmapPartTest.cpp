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

#include "engine/guides/RoadmapPart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "engine/SearchProblem.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        constexpr double ANY = std::numeric_limits<double>::infinity();

        /* A roadmap for the wall of PlanningProblem.h, with its query. */
        class RoadmapPartTest : public ::testing::Test
        {
        protected:
            RoadmapPartTest()
            {
                EXPECT_EQ(search_.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            test::SearchProblem search_{problem_->pdef};
            path::PathEvaluator &evaluator_ = search_.evaluator();
            const Query &query_ = search_.context.query;
            path::Waypoints path_{problem_->si->getStateSpace()};
        };

        TEST_F(RoadmapPartTest, FindsValidPathsAndBetterOnesAsItGrows)
        {
            RoadmapPart roadmap(search_.context, false);
            double best = std::numeric_limits<double>::infinity();
            int found = 0;
            for (int turn = 0; turn < 400 && found < 4; ++turn)
            {
                if (!roadmap.search(best, 5000, path_))
                {
                    continue;
                }
                ++found;
                EXPECT_TRUE(evaluator_.checkPath(path_));
                EXPECT_TRUE(problem_->si->equalStates(path_.front(), query_.starts()[0]));
                EXPECT_TRUE(problem_->si->equalStates(path_.back(), query_.goals()[0]));
                best = std::min(best, evaluator_.cost(path_).value());
            }
            EXPECT_EQ(found, 4);
        }

        TEST_F(RoadmapPartTest, StopsWithTheCondition)
        {
            RoadmapPart roadmap(search_.context, false);
            evaluator_.setStopCondition([] { return true; });
            EXPECT_FALSE(roadmap.search(ANY, 1000000, path_));
        }

        TEST_F(RoadmapPartTest, TheSeedDecidesThePath)
        {
            const auto firstCost = [this](std::uint_fast32_t seed)
            {
                test::SearchProblem search(problem_->pdef, seed);
                search.begin();
                RoadmapPart roadmap(search.context, false);
                while (!roadmap.search(ANY, 5000, path_))
                {
                }
                return search.evaluator().cost(path_).value();
            };
            EXPECT_EQ(firstCost(5), firstCost(5));
            EXPECT_NE(firstCost(5), firstCost(6));
        }

        TEST_F(RoadmapPartTest, ExplainsItsStatesAndTheMotionsThatItFoundValid)
        {
            RoadmapPart roadmap(search_.context, false);
            while (!roadmap.search(ANY, 5000, path_))
            {
            }
            SearchGraph graph(problem_->si->getStateSpace());
            graph.states.append(query_.starts()[0]);
            roadmap.explain(graph);
            EXPECT_GT(graph.states.size(), 50U);
            ASSERT_EQ(graph.starts.size(), 1U);
            ASSERT_EQ(graph.goals.size(), 1U);
            EXPECT_TRUE(problem_->si->equalStates(graph.states[graph.starts[0]], query_.starts()[0]));
            EXPECT_TRUE(problem_->si->equalStates(graph.states[graph.goals[0]], query_.goals()[0]));
            for (std::size_t v = 0; v < graph.states.size(); ++v)
            {
                EXPECT_TRUE(problem_->si->isValid(graph.states[v]));
            }
            for (const auto &[from, to] : graph.edges)
            {
                EXPECT_TRUE(problem_->si->checkMotion(graph.states[from], graph.states[to]));
            }
            for (std::size_t i = 1; i < path_.size(); ++i)
            {
                bool known = false;
                for (const auto &[from, to] : graph.edges)
                {
                    known = known || (problem_->si->equalStates(graph.states[from], path_[i - 1]) &&
                                      problem_->si->equalStates(graph.states[to], path_[i]));
                }
                EXPECT_TRUE(known) << i;
            }
        }

        /* The roadmap after so many turns with a bound that falls with its paths. */
        struct Growth
        {
            std::size_t largest{0};
            double best{std::numeric_limits<double>::infinity()};
            int improvements{0};
        };

        class RoadmapGrowthTest : public RoadmapPartTest
        {
        protected:
            std::size_t size(const RoadmapPart &roadmap) const
            {
                SearchGraph graph(problem_->si->getStateSpace());
                roadmap.explain(graph);
                return graph.states.size();
            }

            Growth grow(RoadmapPart &roadmap, int turns)
            {
                Growth growth;
                for (int turn = 0; turn < turns; ++turn)
                {
                    if (roadmap.search(growth.best, 5000, path_))
                    {
                        EXPECT_TRUE(evaluator_.checkPath(path_));
                        const double cost = evaluator_.cost(path_).value();
                        growth.improvements += cost < growth.best ? 1 : 0;
                        growth.best = std::min(growth.best, cost);
                    }
                    if (turn % 4 == 0)
                    {
                        growth.largest = std::max(growth.largest, size(roadmap));
                    }
                }
                return growth;
            }
        };

        /* 600 states already have 10000 edges, as k is at least 16. */
        TEST_F(RoadmapGrowthTest, StaysWithinItsCapacityWhileThePathImproves)
        {
            RoadmapPart roadmap(search_.context, false, 10000);
            const Growth first = grow(roadmap, 200);
            EXPECT_LT(first.largest, 700U);
            EXPECT_LT(first.best, 1.05 * test::wallOptimum());
            const Growth later = grow(roadmap, 800);
            // the capacity grows with the logarithm of the number of roadmaps
            EXPECT_LT(later.largest, 1100U);
            EXPECT_LT(std::min(first.best, later.best), 1.02 * test::wallOptimum());
        }

        /* States drawn before there was a bound; few are of use once it is near the optimum. */
        TEST_F(RoadmapGrowthTest, LosesWhatNoBetterPathCanLeadThrough)
        {
            RoadmapPart roadmap(search_.context, false);
            while (size(roadmap) < 1500)
            {
                roadmap.search(ANY, 5000, path_);
            }
            const double bound = test::wallOptimum() / 1.15;
            for (int turn = 0; turn < 200; ++turn)
            {
                roadmap.search(bound, 5000, path_);
            }
            SearchGraph graph(problem_->si->getStateSpace());
            roadmap.explain(graph);
            const auto &space = *problem_->si->getStateSpace();
            int beyond = 0;
            for (std::size_t v = 0; v < graph.states.size(); ++v)
            {
                if (space.distance(query_.starts()[0], graph.states[v]) +
                        space.distance(graph.states[v], query_.goals()[0]) >
                    1.15 * bound)
                {
                    ++beyond;
                }
            }
            EXPECT_LT(4 * beyond, static_cast<int>(graph.states.size()) + 4);
        }

        /* States of no use to one goal are kept for another: the informed sets of all pairs count. */
        TEST_F(RoadmapGrowthTest, KeepsWhatAnotherGoalNeeds)
        {
            const auto space = problem_->si->getStateSpace();
            problem_->pdef->clearStartStates();
            problem_->pdef->addStartState(problem_->state({1.0, 5.0}));
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({1.0, 9.5}));
            goals->addState(problem_->state({1.0, 0.5}));
            problem_->pdef->setGoal(goals);
            test::SearchProblem search(problem_->pdef);
            ASSERT_EQ(search.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            ASSERT_EQ(search.goals().size(), 2U);
            RoadmapPart roadmap(search.context, false);
            while (size(roadmap) < 1000)
            {
                roadmap.search(ANY, 5000, path_);
            }
            for (int turn = 0; turn < 200; ++turn)
            {
                roadmap.search(4.6, 5000, path_);
            }
            SearchGraph graph(space);
            roadmap.explain(graph);
            std::vector<int> around(2, 0);
            for (std::size_t v = 0; v < graph.states.size(); ++v)
            {
                for (std::size_t j = 0; j < 2; ++j)
                {
                    around[j] += space->distance(search.starts()[0], graph.states[v]) +
                                             space->distance(graph.states[v], search.goals()[j]) <
                                         4.6
                                     ? 1
                                     : 0;
                }
            }
            EXPECT_GT(around[0], 20);
            EXPECT_GT(around[1], 20);
        }

        /* Motions across the middle of the square below the wall's gap have infinite cost. */
        class Forbidding : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const bool crosses = (test::coordinate(from, 0) < 5.0) != (test::coordinate(to, 0) < 5.0);
                const bool low = std::min(test::coordinate(from, 1), test::coordinate(to, 1)) < 8.0;
                return crosses && low ? infiniteCost() : PathLengthOptimizationObjective::motionCost(from, to);
            }
        };

        /* A roadmap that has found a path, and the same part of another search, which inherits it. */
        class InheritedRoadmapTest : public RoadmapPartTest
        {
        protected:
            InheritedRoadmapTest()
            {
                while (!earlier_.search(ANY, 5000, path_))
                {
                }
                earlier_.explain(before_);
            }

            /* Checks of states until the heir finds a path that is valid now. */
            std::uint64_t checksForAPath(const Heritage &heritage)
            {
                test::SearchProblem search(problem_->pdef, 6);
                EXPECT_EQ(search.begin(), ob::PlannerStatus::EXACT_SOLUTION);
                RoadmapPart heir(search.context, true);
                heir.inherit(earlier_, heritage);
                SearchGraph graph(problem_->si->getStateSpace());
                heir.explain(graph);
                known_ = graph.edges.size();
                problem_->counted.forget();
                while (!heir.search(ANY, 5000, path_))
                {
                }
                const std::uint64_t checks = problem_->counted.states;
                EXPECT_TRUE(evaluator_.checkPath(path_));
                EXPECT_TRUE(problem_->si->equalStates(path_.front(), search.starts()[0]));
                EXPECT_TRUE(problem_->si->equalStates(path_.back(), search.goals()[0]));
                SearchGraph after(problem_->si->getStateSpace());
                heir.explain(after);
                EXPECT_EQ(after.starts.size(), 1U);
                EXPECT_EQ(after.goals.size(), 1U);
                for (std::size_t v = 0; v < after.states.size(); ++v)
                {
                    EXPECT_TRUE(problem_->si->isValid(after.states[v]));
                }
                states_ = after.states.size();
                return checks;
            }

            RoadmapPart earlier_{search_.context, false};
            SearchGraph before_{problem_->si->getStateSpace()};
            std::size_t known_{0};   ///< valid motions that the heir knows from the beginning
            std::size_t states_{0};  ///< valid states that it knows in the end
        };

        TEST_F(InheritedRoadmapTest, TheSameQueryNeedsNoCheck)
        {
            EXPECT_EQ(checksForAPath({true, true, true}), 0U);
            EXPECT_EQ(known_, before_.edges.size());
            EXPECT_EQ(states_, before_.states.size()) << "start and goal are its vertices already";
        }

        TEST_F(InheritedRoadmapTest, AnotherStartNeedsItsOwnMotionOnly)
        {
            problem_->pdef->clearStartStates();
            problem_->pdef->addStartState(problem_->state({1.0, 2.0}));
            EXPECT_LT(checksForAPath({true, true, true}), 300U);
            EXPECT_EQ(states_, before_.states.size() + 1);
        }

        TEST_F(InheritedRoadmapTest, WithoutValidityAllIsCheckedAgain)
        {
            EXPECT_GT(checksForAPath({true, false, true}), 50U);
            EXPECT_EQ(known_, 0U);
            EXPECT_LE(states_, before_.states.size());
        }

        TEST_F(InheritedRoadmapTest, WithoutCostsItsStatesAreAddedAgain)
        {
            checksForAPath({true, true, false});
            EXPECT_EQ(known_, 0U);
            EXPECT_GE(states_, before_.states.size());
        }

        TEST_F(InheritedRoadmapTest, OfAnotherSpaceItIsIgnored)
        {
            EXPECT_GT(checksForAPath({false, true, true}), 300U);
        }

        TEST_F(RoadmapPartTest, GoesOnFromAPathOfInfiniteCostToAFiniteOne)
        {
            test::SearchProblem search(problem_->pdef, 5, {}, std::make_shared<Forbidding>(problem_->si));
            search.begin();
            path::PathEvaluator &evaluator = search.evaluator();
            RoadmapPart roadmap(search.context, false);
            double bound = std::numeric_limits<double>::infinity();
            double cost = bound;
            for (int turn = 0; turn < 400 && !std::isfinite(cost); ++turn)
            {
                if (!roadmap.search(bound, 5000, path_))
                {
                    continue;
                }
                cost = evaluator.cost(path_).value();
                bound = std::numeric_limits<double>::max();
            }
            EXPECT_TRUE(std::isfinite(cost));
            // also for a caller who keeps requesting any path
            RoadmapPart another(search.context, false);
            cost = std::numeric_limits<double>::infinity();
            for (int turn = 0; turn < 400 && !std::isfinite(cost); ++turn)
            {
                if (another.search(ANY, 5000, path_))
                {
                    cost = evaluator.cost(path_).value();
                }
            }
            EXPECT_TRUE(std::isfinite(cost));
        }
    }  // namespace
}  // namespace ompl_mfa::engine::guides
