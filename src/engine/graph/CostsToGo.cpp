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

#include "engine/graph/CostsToGo.h"

#include <cstddef>

namespace ompl_mfa::engine::graph
{
    namespace
    {
        constexpr MotionGraph::Index NONE = MotionGraph::NONE;
        constexpr std::uint64_t EDGES_PER_WORK = MotionGraph::EDGES_PER_WORK;
        constexpr std::size_t VERTICES_BETWEEN_STOPS = MotionGraph::VERTICES_BETWEEN_STOPS;
        /* With negative motion costs, the number of expansions of a vertex after which the best-first backward search
           is continued by sweeps over all edges. */
        constexpr unsigned int MAX_EXPANSIONS = 20;
    }  // namespace

    CostsToGo::CostsToGo(MotionGraph &graph, path::PathEvaluator &evaluator)
      : graph_(graph)
      , evaluator_(evaluator)
      , queue_(evaluator)
    {
    }

    bool CostsToGo::compute(double bound)
    {
        const std::uint64_t before = evaluator_.work();
        if (!seedGoals())
        {
            return false;
        }
        const bool inOrder = graph_.acyclic && !evaluator_.bounds().monotone();
        if (!(inOrder ? backwardInOrder() : backwardBestFirst(bound)))
        {
            return false;
        }
        work_ = evaluator_.work() - before;
        return true;
    }

    bool CostsToGo::seedGoals()
    {
        exact_ = true;
        for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            Vertex &vertex = graph_.vertices[v];
            vertex.reached = false;
            vertex.expansions = 0;
            vertex.next = NONE;
            vertex.reaches = vertex.goal != NONE && vertex.validity != Validity::Invalid;
            if (vertex.reaches)
            {
                vertex.costToGo = graph_.goals[vertex.goal].cost;
            }
        }
        return true;
    }

    bool CostsToGo::backwardInOrder()
    {
        for (std::size_t v = graph_.vertices.size(); v-- > 0;)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            if (!graph_.vertices[v].reaches)
            {
                continue;
            }
            for (const Index e : graph_.vertices[v].in)
            {
                relax(e);
            }
        }
        evaluator_.addWork(1 + graph_.edges.size() / EDGES_PER_WORK);
        return true;
    }

    double CostsToGo::bestInitialCost() const
    {
        double best = evaluator_.objective()->infiniteCost().value();
        for (const End &start : graph_.starts)
        {
            if (evaluator_.isBetter(start.cost, best))
            {
                best = start.cost;
            }
        }
        return best;
    }

    bool CostsToGo::backwardBestFirst(double bound)
    {
        // without negative motion costs, vertices through which no start can beat the bound are pruned
        const bool monotone = evaluator_.bounds().monotone();
        const unsigned int expansions = monotone ? 1 : MAX_EXPANSIONS;
        const double initial = bestInitialCost();
        queue_.clear();
        for (const End &goal : graph_.goals)
        {
            if (graph_.vertices[goal.vertex].reaches)
            {
                queue_.push({graph_.vertices[goal.vertex].costToGo, goal.vertex});
            }
        }
        std::uint64_t handled = 0;
        std::uint64_t popped = 0;
        bool settled = true;
        while (!queue_.empty())
        {
            if (++popped % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            const auto entry = queue_.pop();
            Vertex &vertex = graph_.vertices[entry.item];
            if (evaluator_.isBetter(vertex.costToGo, entry.key))
            {
                continue;
            }
            if (vertex.expansions >= expansions)
            {
                settled = settled && monotone;
                continue;
            }
            ++vertex.expansions;
            for (const Index e : vertex.in)
            {
                ++handled;
                const Edge &edge = graph_.edges[e];
                if ((!monotone ||
                     canBeat(evaluator_, combine(evaluator_, initial, combine(evaluator_, edge.cost, vertex.costToGo)),
                             bound)) &&
                    relax(e))
                {
                    queue_.push({graph_.vertices[edge.from].costToGo, edge.from});
                }
            }
        }
        evaluator_.addWork(1 + handled / EDGES_PER_WORK);
        return settled || backwardInSweeps();
    }

    /* Bellman-Ford, beginning with the present costs-to-go. */
    bool CostsToGo::backwardInSweeps()
    {
        for (bool changed = true; changed;)
        {
            changed = false;
            for (std::size_t v = 0; v < graph_.vertices.size(); ++v)
            {
                if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                {
                    return false;
                }
                if (!graph_.vertices[v].reaches)
                {
                    continue;
                }
                for (const Index e : graph_.vertices[v].in)
                {
                    changed = relax(e) || changed;
                }
            }
            evaluator_.addWork(1 + graph_.edges.size() / EDGES_PER_WORK);
            if (changed && improvesInCycles())
            {
                exact_ = false;
                return true;
            }
        }
        return true;
    }

    /* Whether the edges toward the goal form a cycle; they do, now or soon, if there is a negative cycle. */
    bool CostsToGo::improvesInCycles()
    {
        walks_.assign(graph_.vertices.size(), NONE);
        for (Index first = 0; first < graph_.vertices.size(); ++first)
        {
            Index v = first;
            while (walks_[v] == NONE && graph_.vertices[v].reaches && graph_.vertices[v].next != NONE)
            {
                walks_[v] = first;
                v = graph_.edges[graph_.vertices[v].next].to;
            }
            if (walks_[v] == first)
            {
                return true;
            }
        }
        return false;
    }

    /* Makes the edge the first one of its vertex's path to the goal if that is better. */
    bool CostsToGo::relax(Index index)
    {
        const Edge &edge = graph_.edges[index];
        Vertex &vertex = graph_.vertices[edge.from];
        if (graph_.checks[edge.check] == Validity::Invalid || vertex.validity == Validity::Invalid)
        {
            return false;
        }
        const double cost = combine(evaluator_, edge.cost, graph_.vertices[edge.to].costToGo);
        if (vertex.reaches && !evaluator_.isBetter(cost, vertex.costToGo))
        {
            return false;
        }
        vertex.reaches = true;
        vertex.costToGo = cost;
        vertex.next = index;
        return true;
    }
}  // namespace ompl_mfa::engine::graph
