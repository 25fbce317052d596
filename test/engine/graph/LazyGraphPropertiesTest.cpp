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

/* LazyGraph against Bellman-Ford, on random graphs. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ompl/util/Console.h>

#include "engine/graph/LazyGraph.h"
#include "engine/graph/RandomGraph.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::graph
{
    namespace
    {
        constexpr std::uint64_t PLENTY = 10000000;

        /* The graph as a LazyGraph, and the expected results from its tables alone. */
        class Case
        {
        public:
            explicit Case(const RandomGraph &graph)
              : graph_(graph)
              , space_(test::realVectorSpace(2, 0.0, 150.0))
              , si_(std::make_shared<ob::SpaceInformation>(space_))
            {
                ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
                si_->setStateValidityChecker([this](const ob::State *state) { return isValid(state); });
                si_->setMotionValidator(std::make_shared<TableMotionValidator>(si_, graph_));
                si_->setup();
                evaluator = std::make_unique<path::PathEvaluator>(si_, std::make_shared<TableObjective>(si_, graph_));
                lazy = std::make_unique<LazyGraph>(*evaluator);
                path = std::make_unique<path::Waypoints>(space_);
                ob::ScopedState<> state(space_);
                for (std::size_t i = 0; i < graph_.size; ++i)
                {
                    state[0] = static_cast<double>(i);
                    state[1] = static_cast<double>(i * i);
                    lazy->addVertex(state.get(), false);
                }
                for (const auto &m : graph_.motions)
                {
                    lazy->addEdge(m.from, m.to, m.bothWays);
                }
                for (const auto s : graph_.starts)
                {
                    lazy->setStart(s);
                }
                for (const auto g : graph_.goals)
                {
                    lazy->setGoal(g);
                }
            }

            bool better(double a, double b) const
            {
                return evaluator->objective()->isCostBetterThan(ob::Cost(a), ob::Cost(b));
            }

            double combine(double a, double b) const
            {
                return evaluator->objective()->combineCosts(ob::Cost(a), ob::Cost(b)).value();
            }

            /* Bellman-Ford over the valid part. False if no goal can be reached. */
            bool solve(double &best) const
            {
                std::vector<double> cost(graph_.size);
                std::vector<bool> reached(graph_.size, false);
                const auto improve = [this](double candidate, double &known, bool reachedBefore)
                {
                    if (reachedBefore && !better(candidate, known))
                    {
                        return false;
                    }
                    known = candidate;
                    return true;
                };
                for (const auto s : graph_.starts)
                {
                    if (graph_.validVertex[s] && improve(graph_.initial[s], cost[s], reached[s]))
                    {
                        reached[s] = true;
                    }
                }
                const auto relax = [&](std::size_t from, std::size_t to)
                {
                    if (reached[from] && graph_.validVertex[to] && graph_.isValid(from, to) &&
                        improve(combine(cost[from], graph_.cost[from][to]), cost[to], reached[to]))
                    {
                        reached[to] = true;
                    }
                };
                for (std::size_t round = 0; round < graph_.size; ++round)
                {
                    for (const auto &m : graph_.motions)
                    {
                        relax(m.from, m.to);
                        if (m.bothWays)
                        {
                            relax(m.to, m.from);
                        }
                    }
                }
                bool found = false;
                for (const auto g : graph_.goals)
                {
                    if (reached[g] && improve(combine(cost[g], graph_.terminal[g]), best, found))
                    {
                        found = true;
                    }
                }
                return found;
            }

            /* The path found begins at a start, ends at a goal and is valid. */
            void expectPath() const
            {
                std::vector<std::size_t> vertices;
                for (std::size_t i = 0; i < path->size(); ++i)
                {
                    vertices.push_back(TableObjective::number((*path)[i]));
                }
                RC_ASSERT(!vertices.empty());
                RC_ASSERT(std::count(graph_.starts.begin(), graph_.starts.end(), vertices.front()) > 0);
                RC_ASSERT(std::count(graph_.goals.begin(), graph_.goals.end(), vertices.back()) > 0);
                RC_ASSERT(graph_.validVertex[vertices.front()]);
                RC_ASSERT(std::set<std::size_t>(vertices.begin(), vertices.end()).size() == vertices.size());
                for (std::size_t i = 1; i < vertices.size(); ++i)
                {
                    RC_ASSERT(graph_.validVertex[vertices[i]] && graph_.isValid(vertices[i - 1], vertices[i]));
                }
            }

            /* The expected result of a search that was not interrupted. */
            void expectAnswer(bool found, double bound) const
            {
                double best = 0.0;
                const bool exists = solve(best) && (std::isinf(bound) || better(best, bound));
                RC_ASSERT(found == exists);
                RC_ASSERT(lazy->exhausted() == !exists);
                if (!found)
                {
                    return;
                }
                expectPath();
                RC_ASSERT(evaluator->cost(*path).value() == best);
            }

            std::unique_ptr<path::PathEvaluator> evaluator;
            std::unique_ptr<LazyGraph> lazy;
            std::unique_ptr<path::Waypoints> path;

        private:
            bool isValid(const ob::State *state) const
            {
                const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                for (std::size_t i = 0; i < graph_.size; ++i)
                {
                    const auto x = static_cast<double>(i);
                    if (values[0] == x && values[1] == x * x)
                    {
                        return graph_.validVertex[i];
                    }
                    for (std::size_t j = 0; j < i; ++j)
                    {
                        const auto y = static_cast<double>(j);
                        if (!graph_.validMiddle[i][j] && std::abs(values[0] - 0.5 * (x + y)) < 1e-6 &&
                            std::abs(values[1] - 0.5 * (x * x + y * y)) < 1e-6)
                        {
                            return false;
                        }
                    }
                }
                return true;
            }

            const RandomGraph &graph_;
            ob::StateSpacePtr space_;
            ob::SpaceInformationPtr si_;
        };

        int draw(int low, int high)
        {
            // whole ranges from the first case on: RapidCheck starts with small ones
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
        }

        bool chance(int percent)
        {
            return draw(0, 99) >= 100 - percent;
        }

        double worst(Algebra algebra)
        {
            return algebra == Algebra::Gain ? -INFINITE : INFINITE;
        }

        std::vector<std::size_t> drawEnds(std::size_t size)
        {
            std::set<std::size_t> ends;
            for (int i = draw(1, 4); i > 0; --i)
            {
                ends.insert(static_cast<std::size_t>(draw(0, static_cast<int>(size) - 1)));
            }
            return {ends.begin(), ends.end()};
        }

        void drawEdges(RandomGraph &graph, bool acyclic)
        {
            const int percent = draw(10, 90);
            for (std::size_t i = 0; i < graph.size; ++i)
            {
                for (std::size_t j = i + 1; j < graph.size; ++j)
                {
                    if (!chance(percent))
                    {
                        continue;
                    }
                    const int direction = acyclic ? 0 : draw(0, 3);
                    graph.validMiddle[i][j] = graph.validMiddle[j][i] = !chance(15);
                    graph.validMotion[i][j] = !chance(20);
                    graph.validMotion[j][i] = direction == 3 ? !chance(20) : static_cast<bool>(graph.validMotion[i][j]);
                    if (direction == 1)
                    {
                        graph.motions.push_back({j, i, false});
                    }
                    else
                    {
                        graph.motions.push_back({i, j, direction == 2});
                    }
                    if (direction == 3)
                    {
                        graph.motions.push_back({j, i, false});
                    }
                }
            }
        }

        /* Costs under which no cycle improves a path: of any sign in graphs without cycles, otherwise not negative but
           for a potential. */
        void drawCosts(RandomGraph &graph, bool acyclic)
        {
            const double sign = graph.algebra == Algebra::Gain ? -1.0 : 1.0;
            const bool negative = graph.algebra != Algebra::Bottleneck && draw(0, 1) == 1;
            std::vector<int> potential(graph.size, 0);
            if (negative)
            {
                std::generate(potential.begin(), potential.end(), [] { return draw(-30, 30); });
            }
            for (std::size_t i = 0; i < graph.size; ++i)
            {
                for (std::size_t j = 0; j < graph.size; ++j)
                {
                    const int cost = draw(negative && acyclic ? -20 : 0, 20) + potential[i] - potential[j];
                    graph.cost[i][j] = chance(10) ? worst(graph.algebra) : sign * cost;
                }
                graph.initial[i] = chance(10) ? worst(graph.algebra) : sign * draw(-40, 40);
                graph.terminal[i] = chance(10) ? worst(graph.algebra) : sign * draw(-40, 40);
            }
        }

        RandomGraph drawGraph(bool negativeCycles = false)
        {
            RandomGraph graph;
            graph.algebra = negativeCycles ? Algebra::Sum : static_cast<Algebra>(draw(0, 2));
            graph.size = static_cast<std::size_t>(draw(1, 12));
            graph.cost.assign(graph.size, std::vector<double>(graph.size, 0.0));
            graph.initial.assign(graph.size, 0.0);
            graph.terminal.assign(graph.size, 0.0);
            graph.validVertex.assign(graph.size, true);
            graph.validMotion.assign(graph.size, std::vector<bool>(graph.size, true));
            graph.validMiddle = graph.validMotion;
            const bool acyclic = !negativeCycles && draw(0, 2) == 0;
            drawEdges(graph, acyclic);
            drawCosts(graph, acyclic);
            for (std::size_t i = 0; i < graph.size; ++i)
            {
                graph.validVertex[i] = !chance(10);
                if (negativeCycles)
                {
                    std::generate(graph.cost[i].begin(), graph.cost[i].end(), [] { return draw(-20, 20); });
                }
            }
            graph.starts = drawEnds(graph.size);
            graph.goals = drawEnds(graph.size);
            return graph;
        }

        RC_GTEST_PROP(LazyGraphProperties, FindsTheBestPathOfTheGraphIfItBeatsTheBound, ())
        {
            const RandomGraph graph = drawGraph();
            RC_LOG() << graph << "\n";
            Case c(graph);
            const double bound = draw(0, 2) == 0 ? INFINITE : draw(-100, 100);
            c.expectAnswer(c.lazy->search(bound, PLENTY, *c.path), bound);
        }

        /* From any path to none: each search is for a path better than the last one. */
        RC_GTEST_PROP(LazyGraphProperties, FindsNothingBetterOnceItIsExhausted, ())
        {
            const RandomGraph graph = drawGraph();
            RC_LOG() << graph << "\n";
            Case c(graph);
            double bound = INFINITE;
            for (int i = 0; i < 3; ++i)
            {
                const bool found = c.lazy->search(bound, PLENTY, *c.path);
                c.expectAnswer(found, bound);
                if (!found)
                {
                    return;
                }
                const double cost = c.evaluator->cost(*c.path).value();
                // after a path of infinite cost the bound is the worst finite cost: an infinite one would mean none
                bound = std::isfinite(cost) ? cost : std::copysign(std::numeric_limits<double>::max(), cost);
            }
            RC_FAIL("a third path of the same graph is better than the best");
        }

        RC_GTEST_PROP(LazyGraphProperties, AnswersOneBoundAfterTheOther, ())
        {
            const RandomGraph graph = drawGraph();
            RC_LOG() << graph << "\n";
            Case c(graph);
            for (int i = 0; i < 6; ++i)
            {
                const double bound = draw(0, 4) == 0 ? INFINITE : draw(-100, 100);
                RC_LOG() << "bound " << bound << "\n";
                c.expectAnswer(c.lazy->search(bound, PLENTY, *c.path), bound);
            }
        }

        /* What is removed is invalid in the tables from then on. */
        RC_GTEST_PROP(LazyGraphProperties, AnswersForWhatIsRetained, ())
        {
            RandomGraph graph = drawGraph();
            Case c(graph);
            c.lazy->search(INFINITE, static_cast<std::uint64_t>(draw(0, 200)), *c.path);
            std::vector<bool> kept(graph.size);
            std::generate(kept.begin(), kept.end(), [] { return !chance(30); });
            c.lazy->retain(kept);
            std::size_t size = 0;
            for (std::size_t v = 0; v < graph.size; ++v)
            {
                if (kept[v] || std::count(graph.starts.begin(), graph.starts.end(), v) > 0 ||
                    std::count(graph.goals.begin(), graph.goals.end(), v) > 0)
                {
                    ++size;
                }
                else
                {
                    graph.validVertex[v] = false;
                }
            }
            RC_LOG() << graph << "\n";
            RC_ASSERT(c.lazy->size() == size);
            const double bound = draw(0, 2) == 0 ? INFINITE : draw(-100, 100);
            c.expectAnswer(c.lazy->search(bound, PLENTY, *c.path), bound);
        }

        RC_GTEST_PROP(LazyGraphProperties, AnswersAlikeHoweverLittleWorkASearchMayDo, ())
        {
            const RandomGraph graph = drawGraph();
            RC_LOG() << graph << "\n";
            Case c(graph);
            const double bound = draw(0, 2) == 0 ? INFINITE : draw(-100, 100);
            const auto work = static_cast<std::uint64_t>(draw(4, 200));
            for (int i = 0; i < 5000; ++i)
            {
                const bool found = c.lazy->search(bound, work, *c.path);
                if (found || c.lazy->exhausted())
                {
                    return c.expectAnswer(found, bound);
                }
            }
            RC_FAIL("no end");
        }

        RC_GTEST_PROP(LazyGraphProperties, AnswersNothingWrongWhenItIsInterrupted, ())
        {
            const RandomGraph graph = drawGraph();
            RC_LOG() << graph << "\n";
            Case c(graph);
            const double bound = draw(0, 2) == 0 ? INFINITE : draw(-100, 100);
            for (int left = draw(0, 30); left >= 0; left -= 5)
            {
                int asked = 0;
                c.evaluator->setStopCondition([&asked, left] { return ++asked > left; });
                const bool found = c.lazy->search(bound, PLENTY, *c.path);
                c.evaluator->setStopCondition({});
                if (found || c.lazy->exhausted())
                {
                    return c.expectAnswer(found, bound);
                }
            }
            c.expectAnswer(c.lazy->search(bound, PLENTY, *c.path), bound);
        }

        /* If a cycle keeps improving a path there is no best one, but every path found must be correct. */
        RC_GTEST_PROP(LazyGraphProperties, EndsWithAPathThatKeepsItsPromiseWhereCyclesMakeItBetter, ())
        {
            const RandomGraph graph = drawGraph(true);
            RC_LOG() << graph << "\n";
            Case c(graph);
            const double bound = draw(0, 2) == 0 ? INFINITE : draw(-100, 100);
            const bool found = c.lazy->search(bound, PLENTY, *c.path);
            RC_ASSERT(found != c.lazy->exhausted());
            double best = 0.0;
            RC_ASSERT(!std::isinf(bound) || found == c.solve(best));
            if (!found)
            {
                return;
            }
            c.expectPath();
            RC_ASSERT(std::isinf(bound) || c.better(c.evaluator->cost(*c.path).value(), bound));
        }
    }  // namespace
}  // namespace ompl_mfa::engine::graph
