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
#include <cmath>

namespace ob = ompl::base;

namespace ompl_mfa::engine::graph
{
    namespace
    {
        constexpr MotionGraph::Index NONE = MotionGraph::NONE;
        constexpr std::uint64_t EDGES_PER_WORK = MotionGraph::EDGES_PER_WORK;
        constexpr std::size_t VERTICES_BETWEEN_STOPS = MotionGraph::VERTICES_BETWEEN_STOPS;
        /* Number of edges found invalid in a forward search after which the cost-to-go may be computed again, if that
           is worth its price. */
        constexpr unsigned int STALE_AFTER = 24;
        /* Screening checks states that are at least this many steps of the resolution apart. */
        constexpr unsigned int SCREENING_STRIDE = 3;
    }  // namespace

    LazyGraph::LazyGraph(path::PathEvaluator &evaluator)
      : evaluator_(evaluator)
      , graph_(evaluator)
      , costsToGo_(graph_, evaluator)
      , queue_(evaluator)
    {
    }

    void LazyGraph::clear()
    {
        graph_.clear();
        begun_ = false;
    }

    void LazyGraph::take(LazyGraph &other)
    {
        graph_.take(other.graph_);
        begun_ = false;
        other.clear();
    }

    void LazyGraph::forgetValidity()
    {
        graph_.forgetValidity();
        begun_ = false;
    }

    std::size_t LazyGraph::addVertex(const ob::State *state, bool valid)
    {
        begun_ = false;
        return graph_.addVertex(state, valid);
    }

    void LazyGraph::setStart(std::size_t vertex)
    {
        graph_.setStart(vertex);
        begun_ = false;
    }

    void LazyGraph::setGoal(std::size_t vertex)
    {
        graph_.setGoal(vertex);
        begun_ = false;
    }

    bool LazyGraph::addEdge(std::size_t from, std::size_t to, bool bothWays)
    {
        if (!graph_.addEdge(from, to, bothWays))
        {
            return false;
        }
        begun_ = false;
        return true;
    }

    bool LazyGraph::retain(const std::vector<bool> &kept)
    {
        if (!graph_.retain(kept))
        {
            return false;
        }
        begun_ = false;
        return true;
    }

    std::vector<std::size_t> LazyGraph::verticesOf(const std::vector<End> &ends)
    {
        std::vector<std::size_t> vertices;
        vertices.reserve(ends.size());
        for (const End &end : ends)
        {
            vertices.push_back(end.vertex);
        }
        return vertices;
    }

    std::vector<std::size_t> LazyGraph::starts() const
    {
        return verticesOf(graph_.starts);
    }

    std::vector<std::size_t> LazyGraph::goals() const
    {
        return verticesOf(graph_.goals);
    }

    std::vector<std::pair<std::size_t, std::size_t>> LazyGraph::validEdges() const
    {
        std::vector<std::pair<std::size_t, std::size_t>> valid;
        for (const Edge &edge : graph_.edges)
        {
            if (graph_.checks[edge.check] == Validity::Valid)
            {
                valid.emplace_back(edge.from, edge.to);
            }
        }
        return valid;
    }

    /* Whether a path can beat \e bound but not \e than. */
    bool LazyGraph::isWorse(double bound, double than) const
    {
        return !std::isinf(than) && (std::isinf(bound) || evaluator_.isBetter(than, bound));
    }

    /* Computes the costs-to-go and lists the edges from the source. False if interrupted. */
    bool LazyGraph::begin(double bound)
    {
        begun_ = false;
        if (!costsToGo_.compute(bound))
        {
            return false;
        }
        forwardWork_ = 0;
        invalid_ = 0;
        queue_.clear();
        for (std::size_t i = 0; i < graph_.starts.size(); ++i)
        {
            const Vertex &vertex = graph_.vertices[graph_.starts[i].vertex];
            if (!vertex.reaches || vertex.validity == Validity::Invalid)
            {
                continue;
            }
            const double key = combine(evaluator_, graph_.starts[i].cost, vertex.costToGo);
            if (!costsToGo_.exact() || canBeat(evaluator_, key, bound))
            {
                queue_.push({key, {static_cast<Index>(i), Step::Begin}});
            }
        }
        begun_ = true;
        return true;
    }

    bool LazyGraph::checkVertex(Index index)
    {
        Vertex &vertex = graph_.vertices[index];
        if (vertex.validity == Validity::Unknown)
        {
            vertex.validity = evaluator_.checkState(graph_.states[index]) ? Validity::Valid : Validity::Invalid;
        }
        return vertex.validity == Validity::Valid;
    }

    /* The state at the end of the motion is checked first: an invalid one rules out all motions to it at once. */
    bool LazyGraph::screenEdge(const Edge &edge)
    {
        return checkVertex(edge.to) &&
               evaluator_.screenMotion(graph_.states[edge.from], graph_.states[edge.to], SCREENING_STRIDE);
    }

    /* Checks the motions of the path to this goal; most screened motions are not on it. */
    LazyGraph::Outcome LazyGraph::confirm(Index goal, std::uint64_t limit)
    {
        for (Index v = goal; graph_.vertices[v].parent != NONE; v = graph_.edges[graph_.vertices[v].parent].from)
        {
            const Edge &edge = graph_.edges[graph_.vertices[v].parent];
            Validity &validity = graph_.checks[edge.check];
            if (validity == Validity::Valid)
            {
                continue;
            }
            if (evaluator_.work() >= limit)
            {
                return Outcome::Stopped;
            }
            const bool valid = evaluator_.checkMotion(graph_.states[edge.from], graph_.states[edge.to]);
            if (evaluator_.interrupted())
            {
                return Outcome::Stopped;
            }
            validity = valid ? Validity::Valid : Validity::Invalid;
            if (!valid)
            {
                return Outcome::Stale;
            }
        }
        return Outcome::Found;
    }

    void LazyGraph::reach(Index index, Index parent, double costToCome, double bound)
    {
        Vertex &vertex = graph_.vertices[index];
        vertex.reached = true;
        vertex.parent = parent;
        vertex.costToCome = costToCome;
        if (vertex.goal != NONE)
        {
            const double key = combine(evaluator_, costToCome, graph_.goals[vertex.goal].cost);
            if (canBeat(evaluator_, key, bound))
            {
                queue_.push({key, {vertex.goal, Step::Finish}});
            }
        }
        for (const Index e : vertex.out)
        {
            const Edge &edge = graph_.edges[e];
            const Vertex &to = graph_.vertices[edge.to];
            if (to.reached || !to.reaches || to.validity == Validity::Invalid ||
                graph_.checks[edge.check] == Validity::Invalid)
            {
                continue;
            }
            const double key = combine(evaluator_, combine(evaluator_, costToCome, edge.cost), to.costToGo);
            if (!costsToGo_.exact() || canBeat(evaluator_, key, bound))
            {
                queue_.push({key, {e, Step::Move}});
            }
        }
    }

    LazyGraph::Outcome LazyGraph::beginAt(const End &start, double bound)
    {
        if (graph_.vertices[start.vertex].reached)
        {
            return Outcome::Passed;
        }
        if (checkVertex(start.vertex))
        {
            reach(start.vertex, NONE, start.cost, bound);
        }
        return Outcome::Passed;
    }

    LazyGraph::Outcome LazyGraph::move(Index index, double bound)
    {
        const Edge &edge = graph_.edges[index];
        if (graph_.vertices[edge.to].reached || graph_.vertices[edge.to].validity == Validity::Invalid)
        {
            return Outcome::Passed;
        }
        Validity &validity = graph_.checks[edge.check];
        if (validity == Validity::Unknown)
        {
            const bool valid = screenEdge(edge);
            if (evaluator_.interrupted())
            {
                return Outcome::Stopped;
            }
            validity = valid ? Validity::Screened : Validity::Invalid;
            invalid_ += valid ? 0 : 1;
        }
        if (validity == Validity::Invalid)
        {
            return Outcome::Blocked;
        }
        reach(edge.to, index, combine(evaluator_, graph_.vertices[edge.from].costToCome, edge.cost), bound);
        return Outcome::Passed;
    }

    LazyGraph::Outcome LazyGraph::take(const Queue::Entry &entry, double bound, std::uint64_t limit)
    {
        switch (entry.item.step)
        {
            case Step::Begin:
                return beginAt(graph_.starts[entry.item.index], bound);
            case Step::Move:
                return move(entry.item.index, bound);
            default:
                return canBeat(evaluator_, entry.key, bound) ? confirm(graph_.goals[entry.item.index].vertex, limit)
                                                             : Outcome::Passed;
        }
    }

    /* Best-first search with a budget of \e limit units of PathEvaluator::work(). */
    LazyGraph::Outcome LazyGraph::forward(double bound, std::uint64_t limit)
    {
        const std::uint64_t before = evaluator_.work() - forwardWork_;
        Outcome outcome = Outcome::Passed;
        for (std::uint64_t handled = 1; outcome == Outcome::Passed; ++handled)
        {
            // if the most promising step cannot beat the bound, none can
            if (queue_.empty() || (costsToGo_.exact() && !canBeat(evaluator_, queue_.top().key, bound)))
            {
                return Outcome::Exhausted;
            }
            if (handled % EDGES_PER_WORK == 0)
            {
                evaluator_.addWork(1);
            }
            if (evaluator_.work() >= limit || (handled % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped()))
            {
                return Outcome::Stopped;
            }
            const Queue::Entry entry = queue_.pop();
            outcome = take(entry, bound, limit);
            forwardWork_ = evaluator_.work() - before;
            if (outcome == Outcome::Blocked)
            {
                outcome =
                    invalid_ >= STALE_AFTER && forwardWork_ >= costsToGo_.work() ? Outcome::Stale : Outcome::Passed;
            }
            // an interrupted step is repeated by the next search, and a path found may be asked for again
            if (outcome == Outcome::Stopped || outcome == Outcome::Found)
            {
                queue_.push(entry);
            }
            if (outcome == Outcome::Found)
            {
                found_ = graph_.goals[entry.item.index].vertex;
                cost_ = entry.key;
            }
        }
        return outcome;
    }

    void LazyGraph::extract(path::Waypoints &path) const
    {
        path.clear();
        Index vertex = found_;
        path.append(graph_.states[vertex]);
        while (graph_.vertices[vertex].parent != NONE)
        {
            vertex = graph_.edges[graph_.vertices[vertex].parent].from;
            path.append(graph_.states[vertex]);
        }
        path.reverse();
    }

    bool LazyGraph::search(double bound, std::uint64_t work, path::Waypoints &path)
    {
        const std::uint64_t limit = evaluator_.work() + work;
        exhausted_ = false;
        while (evaluator_.work() < limit && !evaluator_.stopped())
        {
            if ((!begun_ || isWorse(bound, bound_)) && !begin(bound))
            {
                return false;
            }
            bound_ = bound;
            // in a large graph the backward search may use up the whole budget: the forward search still gets one of
            // its own
            switch (forward(bound, std::max(limit, evaluator_.work() + work / 2)))
            {
                case Outcome::Found:
                    extract(path);
                    return true;
                case Outcome::Exhausted:
                    exhausted_ = true;
                    return false;
                case Outcome::Stale:
                    begun_ = false;
                    break;
                default:
                    return false;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::engine::graph
