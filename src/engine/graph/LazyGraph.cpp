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
#include <limits>

namespace ob = ompl::base;

namespace ompl_mfa::engine::graph
{
    namespace
    {
        /* Number of edges found invalid in a forward search after which the cost-to-go may be computed again, if that
           is worth its price. */
        constexpr unsigned int STALE_AFTER = 24;
        /* Edges processed for the price of one state check. */
        constexpr std::uint64_t EDGES_PER_WORK = 2;
        /* Vertices processed between two evaluations of the stop condition. */
        constexpr std::size_t VERTICES_BETWEEN_STOPS = 64;
        /* Edges processed between two evaluations of the stop condition. */
        constexpr std::size_t EDGES_BETWEEN_STOPS = 2048;
        /* Screening checks states that are at least this many steps of the resolution apart. */
        constexpr unsigned int SCREENING_STRIDE = 3;
        /* With negative motion costs, the number of expansions of a vertex after which the best-first backward search
           is continued by sweeps over all edges. */
        constexpr unsigned int MAX_EXPANSIONS = 20;
    }  // namespace

    LazyGraph::LazyGraph(path::PathEvaluator &evaluator)
      : evaluator_(evaluator)
      , states_(evaluator.spaceInformation()->getStateSpace())
    {
    }

    void LazyGraph::clear()
    {
        states_.clear();
        vertices_.clear();
        edges_.clear();
        checks_.clear();
        dropped_.clear();
        starts_.clear();
        goals_.clear();
        acyclic_ = true;
        begun_ = false;
    }

    void LazyGraph::take(LazyGraph &other)
    {
        clear();
        std::swap(states_, other.states_);
        vertices_.swap(other.vertices_);
        edges_.swap(other.edges_);
        checks_.swap(other.checks_);
        dropped_.swap(other.dropped_);
        acyclic_ = other.acyclic_;
        for (Vertex &vertex : vertices_)
        {
            vertex.start = false;
            vertex.goal = NONE;
        }
        other.clear();
    }

    void LazyGraph::forgetValidity()
    {
        for (Vertex &vertex : vertices_)
        {
            vertex.validity = Validity::Unknown;
        }
        const Edge *last = nullptr;
        for (const Edge &edge : dropped_)
        {
            // the two directions of a motion are adjacent
            if (last == nullptr || last->check != edge.check || last->from != edge.to || last->to != edge.from)
            {
                checks_.push_back(Validity::Unknown);
            }
            last = &edge;
            vertices_[edge.from].out.push_back(static_cast<Index>(edges_.size()));
            vertices_[edge.to].in.push_back(static_cast<Index>(edges_.size()));
            edges_.push_back({edge.from, edge.to, static_cast<Index>(checks_.size() - 1), edge.cost});
        }
        dropped_.clear();
        std::fill(checks_.begin(), checks_.end(), Validity::Unknown);
        begun_ = false;
    }

    std::size_t LazyGraph::addVertex(const ob::State *state, bool valid)
    {
        states_.append(state);
        vertices_.emplace_back();
        vertices_.back().validity = valid ? Validity::Valid : Validity::Unknown;
        begun_ = false;
        return vertices_.size() - 1;
    }

    void LazyGraph::setStart(std::size_t vertex)
    {
        vertices_[vertex].start = true;
        starts_.push_back({static_cast<Index>(vertex), evaluator_.objective()->initialCost(states_[vertex]).value()});
        begun_ = false;
    }

    void LazyGraph::setGoal(std::size_t vertex)
    {
        vertices_[vertex].goal = static_cast<Index>(goals_.size());
        goals_.push_back({static_cast<Index>(vertex), evaluator_.objective()->terminalCost(states_[vertex]).value()});
        begun_ = false;
    }

    bool LazyGraph::addEdge(std::size_t from, std::size_t to, bool bothWays)
    {
        ob::Cost cost;
        if (!evaluator_.motionCost(states_[from], states_[to], cost))
        {
            return false;
        }
        // by default an objective is symmetric if the space is, even mechanical work: compute both directions
        ob::Cost reverse = cost;
        if (bothWays && !evaluator_.bounds().certain() && !evaluator_.motionCost(states_[to], states_[from], reverse))
        {
            return false;
        }
        acyclic_ = acyclic_ && from < to && !bothWays;
        begun_ = false;
        const auto add = [&](std::size_t a, std::size_t b, ob::Cost ab)
        {
            const auto edge = static_cast<Index>(edges_.size());
            vertices_[a].out.push_back(edge);
            vertices_[b].in.push_back(edge);
            edges_.push_back(
                {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(checks_.size()), ab.value()});
        };
        add(from, to, cost);
        if (bothWays)
        {
            add(to, from, reverse);
        }
        checks_.push_back(Validity::Unknown);
        return true;
    }

    bool LazyGraph::retain(const std::vector<bool> &kept)
    {
        std::vector<Index> numbers(vertices_.size(), NONE);
        std::vector<Vertex> vertices;
        for (std::size_t v = 0; v < vertices_.size(); ++v)
        {
            if (!kept[v] && !isEnd(v))
            {
                continue;
            }
            numbers[v] = static_cast<Index>(vertices.size());
            vertices.emplace_back();
            vertices.back().goal = vertices_[v].goal;
            vertices.back().start = vertices_[v].start;
            vertices.back().validity = vertices_[v].validity;
        }
        std::deque<Edge> edges;
        std::vector<Validity> checks;
        std::vector<Edge> dropped;
        for (const Edge &edge : dropped_)
        {
            if (numbers[edge.from] != NONE && numbers[edge.to] != NONE)
            {
                dropped.push_back({numbers[edge.from], numbers[edge.to], edge.check, edge.cost});
            }
        }
        // the two directions of a motion are adjacent
        Index check = NONE;
        std::size_t handled = 0;
        for (const Edge &edge : edges_)
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
            if (checks_[edge.check] == Validity::Invalid)
            {
                dropped.push_back({from, to, edge.check, edge.cost});
                continue;
            }
            if (edge.check != check)
            {
                checks.push_back(checks_[edge.check]);
            }
            check = edge.check;
            vertices[from].out.push_back(static_cast<Index>(edges.size()));
            vertices[to].in.push_back(static_cast<Index>(edges.size()));
            edges.push_back({from, to, static_cast<Index>(checks.size() - 1), edge.cost});
        }
        evaluator_.addWork(edges_.size() / EDGES_PER_WORK);
        edges_.swap(edges);
        checks_.swap(checks);
        dropped_.swap(dropped);
        vertices_.swap(vertices);
        for (std::size_t v = 0; v < numbers.size(); ++v)
        {
            if (numbers[v] != NONE && numbers[v] != v)
            {
                states_.space()->copyState(states_[numbers[v]], states_[v]);
            }
        }
        states_.resize(vertices_.size());
        for (std::vector<End> *ends : {&starts_, &goals_})
        {
            for (End &end : *ends)
            {
                end.vertex = numbers[end.vertex];
            }
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
        return verticesOf(starts_);
    }

    std::vector<std::size_t> LazyGraph::goals() const
    {
        return verticesOf(goals_);
    }

    std::vector<std::pair<std::size_t, std::size_t>> LazyGraph::validEdges() const
    {
        std::vector<std::pair<std::size_t, std::size_t>> valid;
        for (const Edge &edge : edges_)
        {
            if (checks_[edge.check] == Validity::Valid)
            {
                valid.emplace_back(edge.from, edge.to);
            }
        }
        return valid;
    }

    bool LazyGraph::better(double a, double b) const
    {
        return evaluator_.objective()->isCostBetterThan(ob::Cost(a), ob::Cost(b));
    }

    double LazyGraph::combine(double a, double b) const
    {
        return evaluator_.objective()->combineCosts(ob::Cost(a), ob::Cost(b)).value();
    }

    bool LazyGraph::canBeat(double cost, double bound) const
    {
        return std::isinf(bound) || better(cost, bound);
    }

    /* Whether a path can beat \e bound but not \e than. */
    bool LazyGraph::isWorse(double bound, double than) const
    {
        return !std::isinf(than) && (std::isinf(bound) || better(than, bound));
    }

    void LazyGraph::push(const QueueEntry &entry)
    {
        queue_.push_back(entry);
        std::push_heap(queue_.begin(), queue_.end(),
                       [this](const QueueEntry &a, const QueueEntry &b) { return better(b.key, a.key); });
    }

    LazyGraph::QueueEntry LazyGraph::pop()
    {
        std::pop_heap(queue_.begin(), queue_.end(),
                      [this](const QueueEntry &a, const QueueEntry &b) { return better(b.key, a.key); });
        const QueueEntry entry = queue_.back();
        queue_.pop_back();
        return entry;
    }

    /* Backward search: the cost-to-go of every vertex from which a goal can be reached by motions not known to be
       invalid, and the edges from the source. False if interrupted. */
    bool LazyGraph::begin(double bound)
    {
        const std::uint64_t before = evaluator_.work();
        begun_ = false;
        if (!seedGoals())
        {
            return false;
        }
        const bool inOrder = acyclic_ && !evaluator_.bounds().monotone();
        if (!(inOrder ? backwardInOrder() : backwardBestFirst(bound)))
        {
            return false;
        }
        backwardWork_ = evaluator_.work() - before;
        forwardWork_ = 0;
        invalid_ = 0;
        queue_.clear();
        for (std::size_t i = 0; i < starts_.size(); ++i)
        {
            const Vertex &vertex = vertices_[starts_[i].vertex];
            if (!vertex.reaches || vertex.validity == Validity::Invalid)
            {
                continue;
            }
            const double key = combine(starts_[i].cost, vertex.costToGo);
            if (!exact_ || canBeat(key, bound))
            {
                push({key, static_cast<Index>(i), Step::Begin});
            }
        }
        begun_ = true;
        return true;
    }

    bool LazyGraph::seedGoals()
    {
        exact_ = true;
        for (std::size_t v = 0; v < vertices_.size(); ++v)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            Vertex &vertex = vertices_[v];
            vertex.reached = false;
            vertex.expansions = 0;
            vertex.next = NONE;
            vertex.reaches = vertex.goal != NONE && vertex.validity != Validity::Invalid;
            if (vertex.reaches)
            {
                vertex.costToGo = goals_[vertex.goal].cost;
            }
        }
        return true;
    }

    bool LazyGraph::backwardInOrder()
    {
        for (std::size_t v = vertices_.size(); v-- > 0;)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            if (!vertices_[v].reaches)
            {
                continue;
            }
            for (const Index e : vertices_[v].in)
            {
                relax(e);
            }
        }
        evaluator_.addWork(1 + edges_.size() / EDGES_PER_WORK);
        return true;
    }

    double LazyGraph::bestInitialCost() const
    {
        double best = evaluator_.objective()->infiniteCost().value();
        for (const End &start : starts_)
        {
            if (better(start.cost, best))
            {
                best = start.cost;
            }
        }
        return best;
    }

    bool LazyGraph::backwardBestFirst(double bound)
    {
        // without negative motion costs, vertices through which no start can beat the bound are pruned
        const bool monotone = evaluator_.bounds().monotone();
        const unsigned int expansions = monotone ? 1 : MAX_EXPANSIONS;
        const double initial = bestInitialCost();
        queue_.clear();
        for (const End &goal : goals_)
        {
            if (vertices_[goal.vertex].reaches)
            {
                push({vertices_[goal.vertex].costToGo, goal.vertex, Step::Finish});
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
            const QueueEntry entry = pop();
            Vertex &vertex = vertices_[entry.index];
            if (better(vertex.costToGo, entry.key))
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
                const Edge &edge = edges_[e];
                if ((!monotone || canBeat(combine(initial, combine(edge.cost, vertex.costToGo)), bound)) && relax(e))
                {
                    push({vertices_[edge.from].costToGo, edge.from, Step::Move});
                }
            }
        }
        evaluator_.addWork(1 + handled / EDGES_PER_WORK);
        return settled || backwardInSweeps();
    }

    /* Bellman-Ford, beginning with the present costs-to-go. */
    bool LazyGraph::backwardInSweeps()
    {
        for (bool changed = true; changed;)
        {
            changed = false;
            for (std::size_t v = 0; v < vertices_.size(); ++v)
            {
                if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
                {
                    return false;
                }
                if (!vertices_[v].reaches)
                {
                    continue;
                }
                for (const Index e : vertices_[v].in)
                {
                    changed = relax(e) || changed;
                }
            }
            evaluator_.addWork(1 + edges_.size() / EDGES_PER_WORK);
            if (changed && improvesInCycles())
            {
                exact_ = false;
                return true;
            }
        }
        return true;
    }

    /* Whether the edges toward the goal form a cycle; they do, now or soon, if there is a negative cycle. */
    bool LazyGraph::improvesInCycles()
    {
        walks_.assign(vertices_.size(), NONE);
        for (Index first = 0; first < vertices_.size(); ++first)
        {
            Index v = first;
            while (walks_[v] == NONE && vertices_[v].reaches && vertices_[v].next != NONE)
            {
                walks_[v] = first;
                v = edges_[vertices_[v].next].to;
            }
            if (walks_[v] == first)
            {
                return true;
            }
        }
        return false;
    }

    /* Makes the edge the first one of its vertex's path to the goal if that is better. */
    bool LazyGraph::relax(Index index)
    {
        const Edge &edge = edges_[index];
        Vertex &vertex = vertices_[edge.from];
        if (checks_[edge.check] == Validity::Invalid || vertex.validity == Validity::Invalid)
        {
            return false;
        }
        const double cost = combine(edge.cost, vertices_[edge.to].costToGo);
        if (vertex.reaches && !better(cost, vertex.costToGo))
        {
            return false;
        }
        vertex.reaches = true;
        vertex.costToGo = cost;
        vertex.next = index;
        return true;
    }

    bool LazyGraph::checkVertex(Index index)
    {
        Vertex &vertex = vertices_[index];
        if (vertex.validity == Validity::Unknown)
        {
            vertex.validity = evaluator_.checkState(states_[index]) ? Validity::Valid : Validity::Invalid;
        }
        return vertex.validity == Validity::Valid;
    }

    /* The state at the end of the motion is checked first: an invalid one rules out all motions to it at once. */
    bool LazyGraph::screenEdge(const Edge &edge)
    {
        return checkVertex(edge.to) && evaluator_.screenMotion(states_[edge.from], states_[edge.to], SCREENING_STRIDE);
    }

    /* Checks the motions of the path to this goal; most screened motions are not on it. */
    LazyGraph::Outcome LazyGraph::confirm(Index goal, std::uint64_t limit)
    {
        for (Index v = goal; vertices_[v].parent != NONE; v = edges_[vertices_[v].parent].from)
        {
            const Edge &edge = edges_[vertices_[v].parent];
            Validity &validity = checks_[edge.check];
            if (validity == Validity::Valid)
            {
                continue;
            }
            if (evaluator_.work() >= limit)
            {
                return Outcome::Stopped;
            }
            const bool valid = evaluator_.checkMotion(states_[edge.from], states_[edge.to]);
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
        Vertex &vertex = vertices_[index];
        vertex.reached = true;
        vertex.parent = parent;
        vertex.costToCome = costToCome;
        if (vertex.goal != NONE)
        {
            const double key = combine(costToCome, goals_[vertex.goal].cost);
            if (canBeat(key, bound))
            {
                push({key, vertex.goal, Step::Finish});
            }
        }
        for (const Index e : vertex.out)
        {
            const Edge &edge = edges_[e];
            const Vertex &to = vertices_[edge.to];
            if (to.reached || !to.reaches || to.validity == Validity::Invalid ||
                checks_[edge.check] == Validity::Invalid)
            {
                continue;
            }
            const double key = combine(combine(costToCome, edge.cost), to.costToGo);
            if (!exact_ || canBeat(key, bound))
            {
                push({key, e, Step::Move});
            }
        }
    }

    LazyGraph::Outcome LazyGraph::beginAt(const End &start, double bound)
    {
        if (vertices_[start.vertex].reached)
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
        const Edge &edge = edges_[index];
        if (vertices_[edge.to].reached || vertices_[edge.to].validity == Validity::Invalid)
        {
            return Outcome::Passed;
        }
        Validity &validity = checks_[edge.check];
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
        reach(edge.to, index, combine(vertices_[edge.from].costToCome, edge.cost), bound);
        return Outcome::Passed;
    }

    LazyGraph::Outcome LazyGraph::take(const QueueEntry &entry, double bound, std::uint64_t limit)
    {
        switch (entry.step)
        {
            case Step::Begin:
                return beginAt(starts_[entry.index], bound);
            case Step::Move:
                return move(entry.index, bound);
            default:
                return canBeat(entry.key, bound) ? confirm(goals_[entry.index].vertex, limit) : Outcome::Passed;
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
            if (queue_.empty() || (exact_ && !canBeat(queue_.front().key, bound)))
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
            const QueueEntry entry = pop();
            outcome = take(entry, bound, limit);
            forwardWork_ = evaluator_.work() - before;
            if (outcome == Outcome::Blocked)
            {
                outcome = invalid_ >= STALE_AFTER && forwardWork_ >= backwardWork_ ? Outcome::Stale : Outcome::Passed;
            }
            // an interrupted step is repeated by the next search, and a path found may be asked for again
            if (outcome == Outcome::Stopped || outcome == Outcome::Found)
            {
                push(entry);
            }
            if (outcome == Outcome::Found)
            {
                found_ = goals_[entry.index].vertex;
                cost_ = entry.key;
            }
        }
        return outcome;
    }

    void LazyGraph::extract(path::Waypoints &path) const
    {
        path.clear();
        Index vertex = found_;
        path.append(states_[vertex]);
        while (vertices_[vertex].parent != NONE)
        {
            vertex = edges_[vertices_[vertex].parent].from;
            path.append(states_[vertex]);
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
