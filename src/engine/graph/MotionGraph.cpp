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

#include "engine/graph/MotionGraph.h"

#include <algorithm>
#include <utility>

#include <ompl/base/Cost.h>

namespace ob = ompl::base;

namespace ompl_mfa::engine::graph
{
    namespace
    {
        /* Edges processed between two evaluations of the stop condition. */
        constexpr std::size_t EDGES_BETWEEN_STOPS = 2048;
    }  // namespace

    MotionGraph::MotionGraph(path::PathEvaluator &evaluator)
      : states(evaluator.spaceInformation()->getStateSpace())
      , evaluator_(evaluator)
    {
    }

    void MotionGraph::clear()
    {
        states.clear();
        vertices.clear();
        edges.clear();
        checks.clear();
        dropped.clear();
        starts.clear();
        goals.clear();
        acyclic = true;
    }

    void MotionGraph::take(MotionGraph &other)
    {
        clear();
        std::swap(states, other.states);
        vertices.swap(other.vertices);
        edges.swap(other.edges);
        checks.swap(other.checks);
        dropped.swap(other.dropped);
        acyclic = other.acyclic;
        for (Vertex &vertex : vertices)
        {
            vertex.start = false;
            vertex.goal = NONE;
        }
        other.clear();
    }

    void MotionGraph::forgetValidity()
    {
        for (Vertex &vertex : vertices)
        {
            vertex.validity = Validity::Unknown;
        }
        const Edge *last = nullptr;
        for (const Edge &edge : dropped)
        {
            // the two directions of a motion are adjacent
            if (last == nullptr || last->check != edge.check || last->from != edge.to || last->to != edge.from)
            {
                checks.push_back(Validity::Unknown);
            }
            last = &edge;
            vertices[edge.from].out.push_back(static_cast<Index>(edges.size()));
            vertices[edge.to].in.push_back(static_cast<Index>(edges.size()));
            edges.push_back({edge.from, edge.to, static_cast<Index>(checks.size() - 1), edge.cost});
        }
        dropped.clear();
        std::fill(checks.begin(), checks.end(), Validity::Unknown);
    }

    std::size_t MotionGraph::addVertex(const ob::State *state, bool valid)
    {
        states.append(state);
        vertices.emplace_back();
        vertices.back().validity = valid ? Validity::Valid : Validity::Unknown;
        return vertices.size() - 1;
    }

    void MotionGraph::setStart(std::size_t vertex)
    {
        vertices[vertex].start = true;
        starts.push_back({static_cast<Index>(vertex), evaluator_.objective()->initialCost(states[vertex]).value()});
    }

    void MotionGraph::setGoal(std::size_t vertex)
    {
        vertices[vertex].goal = static_cast<Index>(goals.size());
        goals.push_back({static_cast<Index>(vertex), evaluator_.objective()->terminalCost(states[vertex]).value()});
    }

    bool MotionGraph::addEdge(std::size_t from, std::size_t to, bool bothWays)
    {
        ob::Cost cost;
        if (!evaluator_.motionCost(states[from], states[to], cost))
        {
            return false;
        }
        // by default an objective is symmetric if the space is, even mechanical work: compute both directions
        ob::Cost reverse = cost;
        if (bothWays && !evaluator_.bounds().certain() && !evaluator_.motionCost(states[to], states[from], reverse))
        {
            return false;
        }
        acyclic = acyclic && from < to && !bothWays;
        const auto add = [&](std::size_t a, std::size_t b, ob::Cost ab)
        {
            const auto edge = static_cast<Index>(edges.size());
            vertices[a].out.push_back(edge);
            vertices[b].in.push_back(edge);
            edges.push_back(
                {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(checks.size()), ab.value()});
        };
        add(from, to, cost);
        if (bothWays)
        {
            add(to, from, reverse);
        }
        checks.push_back(Validity::Unknown);
        return true;
    }

    bool MotionGraph::retain(const std::vector<bool> &kept)
    {
        std::vector<Index> numbers;
        std::vector<Vertex> retained = retainedVertices(kept, numbers);
        if (!retainEdges(numbers, retained))
        {
            return false;
        }
        vertices.swap(retained);
        renumberStates(numbers, vertices.size());
        for (std::vector<End> *ends : {&starts, &goals})
        {
            for (End &end : *ends)
            {
                end.vertex = numbers[end.vertex];
            }
        }
        return true;
    }

    /* The vertices that remain, without edges, and in \e numbers the new index of each vertex, or none. */
    std::vector<MotionGraph::Vertex> MotionGraph::retainedVertices(const std::vector<bool> &kept,
                                                                   std::vector<Index> &numbers) const
    {
        std::vector<Vertex> retained;
        numbers.assign(vertices.size(), NONE);
        for (std::size_t v = 0; v < vertices.size(); ++v)
        {
            if (!kept[v] && !isEnd(v))
            {
                continue;
            }
            numbers[v] = static_cast<Index>(retained.size());
            retained.emplace_back();
            retained.back().goal = vertices[v].goal;
            retained.back().start = vertices[v].start;
            retained.back().validity = vertices[v].validity;
        }
        return retained;
    }

    /* Removes the other edges and adds the remaining ones to their vertices; false, with nothing removed, if
       interrupted. */
    bool MotionGraph::retainEdges(const std::vector<Index> &numbers, std::vector<Vertex> &retained)
    {
        std::deque<Edge> retainedEdges;
        std::vector<Validity> retainedChecks;
        std::vector<Edge> stillDropped;
        for (const Edge &edge : dropped)
        {
            if (numbers[edge.from] != NONE && numbers[edge.to] != NONE)
            {
                stillDropped.push_back({numbers[edge.from], numbers[edge.to], edge.check, edge.cost});
            }
        }
        // the two directions of a motion are adjacent
        Index check = NONE;
        std::size_t handled = 0;
        for (const Edge &edge : edges)
        {
            if (++handled % EDGES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            const Index from = numbers[edge.from];
            const Index to = numbers[edge.to];
            if (from == NONE || to == NONE)
            {
                continue;
            }
            if (checks[edge.check] == Validity::Invalid)
            {
                stillDropped.push_back({from, to, edge.check, edge.cost});
                continue;
            }
            if (edge.check != check)
            {
                retainedChecks.push_back(checks[edge.check]);
            }
            check = edge.check;
            retained[from].out.push_back(static_cast<Index>(retainedEdges.size()));
            retained[to].in.push_back(static_cast<Index>(retainedEdges.size()));
            retainedEdges.push_back({from, to, static_cast<Index>(retainedChecks.size() - 1), edge.cost});
        }
        evaluator_.addWork(edges.size() / EDGES_PER_WORK);
        edges.swap(retainedEdges);
        checks.swap(retainedChecks);
        dropped.swap(stillDropped);
        return true;
    }

    void MotionGraph::renumberStates(const std::vector<Index> &numbers, std::size_t size)
    {
        for (std::size_t v = 0; v < numbers.size(); ++v)
        {
            if (numbers[v] != NONE && numbers[v] != v)
            {
                states.space()->copyState(states[numbers[v]], states[v]);
            }
        }
        states.resize(size);
    }
}  // namespace ompl_mfa::engine::graph
