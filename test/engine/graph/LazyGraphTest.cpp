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

#include "engine/graph/LazyGraph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::graph
{
    namespace
    {
        constexpr double ANY = std::numeric_limits<double>::infinity();
        constexpr std::uint64_t PLENTY = 1000000;

        double value(const ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }

        /* The cost of a motion is an arbitrary function of its ends; so are the costs of the first and the last
           state. */
        class AnyCost : public ob::OptimizationObjective
        {
        public:
            using Function = std::function<double(double from, double to)>;
            using EndFunction = std::function<double(double value)>;

            AnyCost(const ob::SpaceInformationPtr &si, Function cost, EndFunction initial, EndFunction terminal)
              : OptimizationObjective(si)
              , cost_(std::move(cost))
              , initial_(std::move(initial))
              , terminal_(std::move(terminal))
            {
            }

            ob::Cost stateCost(const ob::State *) const override
            {
                return identityCost();
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(cost_(value(from), value(to)));
            }

            ob::Cost initialCost(const ob::State *state) const override
            {
                return initial_ ? ob::Cost(initial_(value(state))) : identityCost();
            }

            ob::Cost terminalCost(const ob::State *state) const override
            {
                return terminal_ ? ob::Cost(terminal_(value(state))) : identityCost();
            }

        private:
            Function cost_;
            EndFunction initial_;
            EndFunction terminal_;
        };

        class LazyGraphTest : public ::testing::Test
        {
        protected:
            /* The best path has this cost, whether any path is requested or one better than \e bound. */
            void expectBest(double cost, double bound)
            {
                for (const double asked : {ANY, bound})
                {
                    ASSERT_TRUE(graph_->search(asked, PLENTY, path_));
                    EXPECT_EQ(evaluator_->cost(path_).value(), cost);
                }
                EXPECT_FALSE(graph_->search(cost, PLENTY, path_));
            }

            void make(const AnyCost::Function &cost, const AnyCost::EndFunction &initial = {},
                      const AnyCost::EndFunction &terminal = {})
            {
                evaluator_ = std::make_unique<path::PathEvaluator>(
                    problem_.si, std::make_shared<AnyCost>(problem_.si, cost, initial, terminal));
                graph_ = std::make_unique<LazyGraph>(*evaluator_);
            }

            std::size_t add(double value)
            {
                ob::ScopedState<> state(problem_.si->getStateSpace());
                state[0] = value;
                return graph_->addVertex(state.get(), false);
            }

            double wall_{-10.0};  ///< no state within 1 of it is valid
            test::CountingProblem problem_{test::realVectorSpace(1, 0.0, 1000.0), [this](const ob::State *state)
                                           { return std::abs(value(state) - wall_) > 1.0; }};
            std::unique_ptr<path::PathEvaluator> evaluator_;
            std::unique_ptr<LazyGraph> graph_;
            path::Waypoints path_{problem_.si->getStateSpace()};
        };

        /* Layers of four vertices, each joined to all of the next; the value of a vertex is ten times its layer plus
           its index there. Costs have both signs, so that the best path may begin or end with expensive motions. */
        TEST_F(LazyGraphTest, FindsTheBestPathThroughLayersWhereMotionsMayEarnSomething)
        {
            constexpr std::size_t LAYERS = 5;
            constexpr std::size_t WIDTH = 4;
            for (unsigned int seed = 1; seed <= 50; ++seed)
            {
                ompl::RNG rng(seed);
                std::array<std::array<double, WIDTH>, 10 * LAYERS> table{};
                for (auto &row : table)
                {
                    std::generate(row.begin(), row.end(), [&rng] { return rng.uniformReal(-10.0, 8.0); });
                }
                const auto cost = [&table](double from, double to)
                { return table[static_cast<std::size_t>(from)][static_cast<std::size_t>(to) % 10]; };
                make(cost);
                std::vector<std::vector<std::size_t>> layers{{add(0.0)}};
                graph_->setStart(0);
                for (std::size_t k = 1; k <= LAYERS; ++k)
                {
                    layers.emplace_back();
                    for (std::size_t i = 0; i < (k < LAYERS ? WIDTH : 1); ++i)
                    {
                        layers.back().push_back(add(static_cast<double>(10 * k + i)));
                    }
                    for (const std::size_t from : layers[k - 1])
                    {
                        for (const std::size_t to : layers[k])
                        {
                            ASSERT_TRUE(graph_->addEdge(from, to, false));
                        }
                    }
                }
                graph_->setGoal(layers.back().front());
                // the best costs-to-go, layer by layer from the goal
                std::vector<double> toGo{0.0};
                for (std::size_t k = LAYERS; k-- > 0;)
                {
                    std::vector<double> before;
                    for (const std::size_t from : layers[k])
                    {
                        double best = ANY;
                        for (std::size_t i = 0; i < layers[k + 1].size(); ++i)
                        {
                            best = std::min(
                                best,
                                cost(value(graph_->state(from)), value(graph_->state(layers[k + 1][i]))) + toGo[i]);
                        }
                        before.push_back(best);
                    }
                    toGo = before;
                }
                for (const double bound : {ANY, toGo[0] + 1e-6})
                {
                    ASSERT_TRUE(graph_->search(bound, PLENTY, path_)) << "seed " << seed;
                    EXPECT_NEAR(evaluator_->cost(path_).value(), toGo[0], 1e-9) << "seed " << seed;
                }
                EXPECT_FALSE(graph_->search(toGo[0] - 1e-6, PLENTY, path_));
            }
        }

        TEST_F(LazyGraphTest, EndsWhereEveryTurnOfACycleWouldEarnMore)
        {
            make([](double, double) { return -1.0; });
            std::vector<std::size_t> vertices;
            for (int i = 0; i < 10; ++i)
            {
                vertices.push_back(add(i));
            }
            for (const std::size_t from : vertices)
            {
                for (std::size_t to = from + 1; to < vertices.size(); ++to)
                {
                    graph_->addEdge(from, to, true);
                }
            }
            graph_->setStart(vertices.front());
            graph_->setGoal(vertices.back());
            ASSERT_TRUE(graph_->search(ANY, PLENTY, path_));
            EXPECT_EQ(value(path_.front()), 0.0);
            EXPECT_EQ(value(path_.back()), 9.0);
            graph_->search(-1e6, PLENTY, path_);
        }

        /* Stages between goal and start, each with a direct motion of cost 0 and a detour that is expensive at first
           and has a negative cost in all: in best-first order the last stage improves 2^8 times. */
        TEST_F(LazyGraphTest, CostsToGoAreThoseOfPathsHoweverOftenNegativeMotionsImproveThem)
        {
            constexpr int STAGES = 8;
            // the value of a stage's vertex is twice its number, that of its detour one less
            const auto detour = [](double value) { return std::exp2(STAGES - value / 2.0); };
            make(
                [&detour](double from, double to)
                {
                    if (static_cast<int>(to) % 2 != 0)
                    {
                        return -1.5 * detour(from);
                    }
                    return static_cast<int>(from) % 2 != 0 ? detour(from + 1.0) : 0.0;
                });
            std::vector<std::size_t> vertices;
            for (int v = 0; v <= 2 * STAGES; ++v)
            {
                vertices.push_back(add(v));
            }
            double best = 0.0;
            for (std::size_t v = 2; v < vertices.size(); v += 2)
            {
                graph_->addEdge(v, v - 2, false);
                graph_->addEdge(v, v - 1, false);
                graph_->addEdge(v - 1, v - 2, false);
                best -= 0.5 * detour(static_cast<double>(v));
            }
            graph_->setStart(vertices.back());
            graph_->setGoal(vertices.front());
            ASSERT_TRUE(graph_->search(best + 0.25, PLENTY, path_));
            EXPECT_EQ(evaluator_->cost(path_).value(), best);
            EXPECT_FALSE(graph_->search(best, PLENTY, path_));
            EXPECT_TRUE(graph_->exhausted());
        }

        /* The nearer goal has a terminal cost of 100. */
        TEST_F(LazyGraphTest, GoesOnThroughAGoalToABetterOne)
        {
            make([](double from, double to) { return std::abs(to - from); }, {},
                 [](double v) { return v == 2.0 ? 100.0 : 0.0; });
            for (const double v : {0.0, 2.0, 10.0})
            {
                add(v);
            }
            graph_->setStart(0);
            graph_->setGoal(1);
            graph_->setGoal(2);
            graph_->addEdge(0, 1, true);
            graph_->addEdge(1, 2, true);
            expectBest(10.0, 50.0);
            EXPECT_TRUE(graph_->exhausted());
        }

        /* The nearer start has an initial cost of 100. */
        TEST_F(LazyGraphTest, GoesThroughAStartThatIsDearToBeginAt)
        {
            make([](double from, double to) { return std::abs(to - from); },
                 [](double v) { return v == 8.0 ? 100.0 : 0.0; });
            for (const double v : {0.0, 8.0, 10.0})
            {
                add(v);
            }
            graph_->setStart(0);
            graph_->setStart(1);
            graph_->setGoal(2);
            graph_->addEdge(0, 1, true);
            graph_->addEdge(1, 2, true);
            expectBest(10.0, 50.0);
        }

        TEST_F(LazyGraphTest, AddsNoEdgeOnceTheSearchIsToStop)
        {
            int costs = 0;
            make(
                [&costs](double, double)
                {
                    ++costs;
                    return 1.0;
                });
            const std::size_t from = add(1.0);
            const std::size_t to = add(2.0);
            EXPECT_TRUE(graph_->addEdge(from, to, false));
            evaluator_->setStopCondition([] { return true; });
            EXPECT_FALSE(graph_->addEdge(from, to, false));
            EXPECT_EQ(costs, 1);
        }

        /* Steps of 10: the screened states of the straight motion miss the wall at 60, those of its full check do not;
           the motion from 45 to 95 steps over it. */
        TEST_F(LazyGraphTest, ChecksMotionsOfThePathInFullAndTakesAnotherWhereOneFails)
        {
            wall_ = 60.0;
            make([](double, double) { return 1.0; });
            for (const double v : {0.0, 45.0, 95.0, 200.0})
            {
                add(v);
            }
            graph_->setStart(0);
            graph_->setGoal(3);
            for (const auto &[from, to] : {std::pair{0, 3}, {0, 1}, {1, 2}, {2, 3}})
            {
                ASSERT_TRUE(graph_->addEdge(from, to, false));
            }
            ASSERT_TRUE(evaluator_->screenMotion(graph_->state(0), graph_->state(3), 3));
            ASSERT_TRUE(graph_->search(ANY, PLENTY, path_));
            EXPECT_TRUE(evaluator_->checkPath(path_));
            EXPECT_EQ(path_.size(), 4U);
        }

        /* The detour by 120 is cheaper: its first motion passes the screening, its second has the wall in its middle.
         */
        /* 0 - 20 - 40 with a wall at 30, and the way round over 500. */
        class ChangedGraphTest : public LazyGraphTest
        {
        protected:
            ChangedGraphTest()
            {
                wall_ = 30.0;
                make([](double from, double to) { return std::abs(to - from); });
                for (const double v : {0.0, 20.0, 40.0, 500.0})
                {
                    add(v);
                }
                setEnds();
                graph_->addEdge(0, 1, true);
                graph_->addEdge(1, 2, true);
                // these motions jump over the wall
                graph_->addEdge(0, 3, false);
                graph_->addEdge(3, 2, false);
            }

            void setEnds()
            {
                graph_->setStart(0);
                graph_->setGoal(2);
            }
        };

        TEST_F(ChangedGraphTest, WhatWasInvalidIsCheckedAgainOnceItsValidityIsForgotten)
        {
            EXPECT_FALSE(graph_->search(100.0, PLENTY, path_));
            wall_ = -10.0;
            EXPECT_FALSE(graph_->search(100.0, PLENTY, path_));
            graph_->forgetValidity();
            EXPECT_FALSE(graph_->isValid(0));
            ASSERT_TRUE(graph_->search(100.0, PLENTY, path_));
            EXPECT_EQ(graph_->cost(), 40.0);
            EXPECT_TRUE(graph_->isValid(1));
            EXPECT_TRUE(graph_->validEdges().size() >= 4);
        }

        TEST_F(ChangedGraphTest, WhatWasValidIsCheckedAgainOnceItsValidityIsForgotten)
        {
            wall_ = -10.0;
            ASSERT_TRUE(graph_->search(100.0, PLENTY, path_));
            wall_ = 20.0;
            graph_->forgetValidity();
            EXPECT_TRUE(graph_->validEdges().empty());
            EXPECT_FALSE(graph_->search(100.0, PLENTY, path_));
            EXPECT_FALSE(graph_->isValid(1));
        }

        TEST_F(ChangedGraphTest, InvalidEdgesThatWereRemovedComeBack)
        {
            EXPECT_FALSE(graph_->search(100.0, PLENTY, path_));
            const std::size_t edges = graph_->edges();
            ASSERT_TRUE(graph_->retain({true, true, true, false}));
            EXPECT_EQ(graph_->edges(), edges - 4) << "both directions from 20 to 40, and those over 500";
            ASSERT_TRUE(graph_->retain({true, true, true}));
            wall_ = -10.0;
            graph_->forgetValidity();
            EXPECT_EQ(graph_->edges(), edges - 2);
            ASSERT_TRUE(graph_->search(100.0, PLENTY, path_));
            EXPECT_EQ(graph_->cost(), 40.0);
            // one check serves both directions
            EXPECT_EQ(graph_->validEdges().size(), 4U);
        }

        TEST_F(ChangedGraphTest, InvalidEdgesOfRemovedVerticesDoNot)
        {
            wall_ = 20.0;
            EXPECT_FALSE(graph_->search(100.0, PLENTY, path_));
            ASSERT_TRUE(graph_->retain({true, false, true, true}));
            ASSERT_EQ(graph_->size(), 3U);
            const std::size_t edges = graph_->edges();
            wall_ = -10.0;
            graph_->forgetValidity();
            EXPECT_EQ(graph_->edges(), edges);
        }

        TEST_F(ChangedGraphTest, AnotherGraphTakesAllButTheEnds)
        {
            wall_ = -10.0;
            ASSERT_TRUE(graph_->search(100.0, PLENTY, path_));
            LazyGraph earlier(*evaluator_);
            earlier.take(*graph_);
            EXPECT_EQ(graph_->size(), 0U);
            EXPECT_EQ(graph_->edges(), 0U);
            graph_->take(earlier);
            ASSERT_EQ(graph_->size(), 4U);
            EXPECT_TRUE(graph_->starts().empty());
            EXPECT_TRUE(graph_->goals().empty());
            EXPECT_FALSE(graph_->isEnd(0));
            EXPECT_FALSE(graph_->search(ANY, PLENTY, path_));
            setEnds();
            problem_.forget();
            ASSERT_TRUE(graph_->search(100.0, PLENTY, path_));
            EXPECT_EQ(graph_->cost(), 40.0);
            EXPECT_EQ(problem_.motions, 0U) << "all of it is known";
        }

        TEST_F(LazyGraphTest, ChecksNoMotionBesideThePath)
        {
            wall_ = 510.0;
            make([](double from, double to) { return from == 520.0 && to == 900.0 ? 5.0 : 1.0; });
            for (const double v : {520.0, 120.0, 900.0})
            {
                add(v);
            }
            graph_->setStart(0);
            graph_->setGoal(2);
            for (const auto &[from, to] : {std::pair{0, 1}, {1, 2}, {0, 2}})
            {
                ASSERT_TRUE(graph_->addEdge(from, to, false));
            }
            ASSERT_TRUE(evaluator_->screenMotion(graph_->state(0), graph_->state(1), 3));
            ASSERT_TRUE(graph_->search(ANY, PLENTY, path_));
            EXPECT_EQ(path_.size(), 2U);
            EXPECT_EQ(problem_.motions, 1U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::graph
