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
#include <utility>

#include <boost/math/constants/constants.hpp>

#include <ompl/tools/config/SelfConfig.h>

#include "engine/TurnMeter.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        /* A raw path of the roadmap is tightened if it costs at most this factor times the best path. */
        constexpr double SLACK = 1.15;
        /* Work of a nearest-neighbour query, in state checks per neighbour. */
        constexpr std::uint64_t NEIGHBOUR_WORK = 4;
        constexpr std::size_t FIRST_BATCH = 50;
        /* The roadmap is pruned when one vertex in this many is useless. */
        constexpr std::size_t USELESS_SHARE = 4;
        /* The capacity is twice the first one after 2^8 - 1 renewals, three times after 2^16 - 1, ... */
        constexpr double RENEWAL_DOUBLINGS = 8.0;
        /* Vertices processed between two evaluations of the stop condition. */
        constexpr std::size_t VERTICES_BETWEEN_STOPS = 16;

        /* Work and time (s) of the trees before the roadmap begins if there is no path yet. */
        constexpr std::uint64_t FIRST_TREES = 14000;
        constexpr double FIRST_TREES_TIME = 0.01;
        /* The same for an inherited roadmap. A search of a large one takes as long as thousands of checks, too. */
        constexpr std::uint64_t FIRST_TREES_AGAIN = 4000;

        constexpr double UNKNOWN = std::numeric_limits<double>::quiet_NaN();
    }  // namespace

    RoadmapPart::RoadmapPart(const SearchContext &context, bool afterTrees, std::size_t capacity)
      : GuidePart(PartKind::Roadmap, context)
      , afterTrees_(afterTrees)
      , chart_(context.chart)
      , evaluator_(context.evaluator())
      , sampler_(chart_, evaluator_.bounds(), streamSeed(context.seed, Stream::Roadmap))
      , graph_(evaluator_)
      , measured_(std::make_shared<const graph::LazyGraph *>(&graph_))
      , nearest_(ompl::tools::SelfConfig::getDefaultNearestNeighbors<std::size_t>(&context.owner))
      , inherited_{path::Waypoints(chart_->space()), {}, false}
      , firstCapacity_(capacity)
      , pruned_(std::numeric_limits<double>::infinity())
      , sample_(chart_->space()->allocState())
    {
        // the structure may be handed over, so it does not depend on this object
        nearest_->setDistanceFunction([chart = chart_, graph = measured_](std::size_t a, std::size_t b)
                                      { return chart->distance((*graph)->state(a), (*graph)->state(b)); });
        renew();
    }

    RoadmapPart::~RoadmapPart()
    {
        chart_->space()->freeState(sample_);
    }

    void RoadmapPart::renew()
    {
        graph_.clear();
        promises_.clear();
        nearest_->clear();
        indexed_ = 0;
        inherited_.ends.clear();
        starts_ = goals_ = endEdges_ = 0;
        batch_ = missing_ = FIRST_BATCH;
        exhausted_ = found_ = false;
        pruned_ = std::numeric_limits<double>::infinity();
    }

    bool RoadmapPart::isFull() const
    {
        const double growth = 1.0 + std::log2(1.0 + static_cast<double>(renewals_)) / RENEWAL_DOUBLINGS;
        return static_cast<double>(graph_.edges() - std::min(endEdges_, graph_.edges())) >=
               growth * static_cast<double>(firstCapacity_);
    }

    std::size_t RoadmapPart::add(const ob::State *state, double lowerBound)
    {
        const std::size_t vertex = graph_.addVertex(state, true);
        promises_.push_back({lowerBound, UNKNOWN, UNKNOWN, 0, 0});
        const auto d = static_cast<double>(chart_->space()->getDimension());
        const double factor = boost::math::constants::e<double>() * (1.0 + 1.0 / d);
        const auto k = static_cast<std::size_t>(std::ceil(factor * std::log(static_cast<double>(vertex + 2))));
        nearest_->nearestK(vertex, k, neighbours_);
        evaluator_.addDistances(neighbourDistances(*chart_->space(), nearest_->size()));
        const bool bothWays = chart_->space()->hasSymmetricDistance() && chart_->space()->hasSymmetricInterpolate();
        for (const std::size_t neighbour : neighbours_)
        {
            if (!graph_.addEdge(neighbour, vertex, bothWays) ||
                (!bothWays && !graph_.addEdge(vertex, neighbour, false)))
            {
                break;
            }
        }
        nearest_->add(vertex);
        ++indexed_;
        evaluator_.addWork(NEIGHBOUR_WORK * neighbours_.size());
        return vertex;
    }

    /* An inherited roadmap may contain the state already, as an end of the earlier query. */
    std::size_t RoadmapPart::addEnd(const ob::State *state)
    {
        const auto known = std::find_if(
            inherited_.ends.begin(), inherited_.ends.end(),
            [&](std::size_t vertex)
            { return !graph_.isEnd(vertex) && chart_->space()->equalStates(graph_.state(vertex), state); });
        return known != inherited_.ends.end() ? *known : add(state, UNKNOWN);
    }

    bool RoadmapPart::addEnds()
    {
        const Query &query = context().query;
        const std::size_t before = graph_.edges();
        for (; starts_ < query.starts().size() && !evaluator_.stopped(); ++starts_)
        {
            graph_.setStart(addEnd(query.starts()[starts_]));
        }
        for (; goals_ < query.goals().size() && !evaluator_.stopped(); ++goals_)
        {
            graph_.setGoal(addEnd(query.goals()[goals_]));
        }
        endEdges_ += graph_.edges() - before;
        return starts_ == query.starts().size() && goals_ == query.goals().size();
    }

    /* The states of an earlier roadmap come first, then new ones. */
    bool RoadmapPart::drawState(double bound, double &lowerBound)
    {
        if (!inherited_.states.empty())
        {
            chart_->space()->copyState(sample_, inherited_.states.back());
            inherited_.states.resize(inherited_.states.size() - 1);
            return true;
        }
        const Query &query = context().query;
        const bool drawn = sampler_.sample(query.starts(), query.goals(), bound, sample_);
        lowerBound = sampler_.lowerBound();
        return drawn;
    }

    void RoadmapPart::addBatch(double bound, std::uint64_t limit)
    {
        while (missing_ > 0 && evaluator_.work() < limit && !evaluator_.stopped())
        {
            if (isFull())
            {
                missing_ = 0;
                return;
            }
            evaluator_.addWork(1);
            double lowerBound = UNKNOWN;
            if (!drawState(bound, lowerBound) || !evaluator_.checkState(sample_))
            {
                continue;
            }
            add(sample_, lowerBound);
            --missing_;
        }
    }

    /* A path is useful if it improves on the roadmap's best one and is not much worse than the best tightened one. */
    double RoadmapPart::searchBound(double bound) const
    {
        const auto &objective = *evaluator_.objective();
        if (!found_)
        {
            return evaluator_.withSlack(bound, SLACK);
        }
        // a path better than one of infinite cost has to beat the worst finite cost
        const double best = objective.isFinite(ob::Cost(best_)) ? best_ : path::worstFiniteCost(objective);
        const double slack = evaluator_.withSlack(bound, SLACK);
        return !std::isinf(bound) && objective.isCostBetterThan(ob::Cost(slack), ob::Cost(best)) ? slack : best;
    }

    /* Whether a path better than the bound may lead through a vertex. The other pairs of start and goal are only
       examined once the pair that it was drawn for is excluded. */
    bool RoadmapPart::isUseful(std::size_t vertex, double bound)
    {
        const Query &query = context().query;
        const path::CostBounds &bounds = evaluator_.bounds();
        const ob::OptimizationObjective &objective = *evaluator_.objective();
        Promise &promise = promises_[vertex];
        if (!std::isnan(promise.lowerBound) && bounds.canBeat(promise.lowerBound, bound))
        {
            return true;
        }
        const auto take = [&objective](double cost, double &best)
        {
            if (std::isnan(best) || objective.isCostBetterThan(ob::Cost(cost), ob::Cost(best)))
            {
                best = cost;
            }
        };
        const ob::State *state = graph_.state(vertex);
        evaluator_.addWork(query.starts().size() + query.goals().size() - promise.starts - promise.goals);
        for (; promise.starts < query.starts().size(); ++promise.starts)
        {
            take(bounds.lowerBoundTo(query.starts()[promise.starts], state), promise.to);
        }
        for (; promise.goals < query.goals().size(); ++promise.goals)
        {
            take(bounds.lowerBoundFrom(state, query.goals()[promise.goals]), promise.from);
        }
        promise.lowerBound = bounds.combine(promise.to, promise.from);
        return bounds.canBeat(promise.lowerBound, bound);
    }

    /* Removes the vertices through which no better path can lead, if there are many. False if interrupted. */
    bool RoadmapPart::prune(double bound)
    {
        if (std::isinf(bound) || bound == pruned_ || !evaluator_.bounds().admissible())
        {
            return true;
        }
        std::vector<bool> kept(graph_.size());
        std::size_t useless = 0;
        for (std::size_t v = 0; v < kept.size(); ++v)
        {
            if (v % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            kept[v] = graph_.isEnd(v) || isUseful(v, bound);
            useless += kept[v] ? 0 : 1;
        }
        pruned_ = bound;
        if (USELESS_SHARE * useless < kept.size() || useless == 0)
        {
            return true;
        }
        if (!graph_.retain(kept))
        {
            pruned_ = std::numeric_limits<double>::infinity();
            return false;
        }
        std::size_t size = 0;
        for (std::size_t v = 0; v < kept.size(); ++v)
        {
            if (kept[v])
            {
                promises_[size++] = promises_[v];
            }
        }
        promises_.resize(size);
        inherited_.ends.clear();
        nearest_->clear();
        indexed_ = 0;
        return true;
    }

    /* Reinserts the remaining vertices into the nearest-neighbour structure, before any vertex is added. False if
       interrupted. */
    bool RoadmapPart::indexVertices()
    {
        for (; indexed_ < graph_.size(); ++indexed_)
        {
            if (indexed_ % VERTICES_BETWEEN_STOPS == 0 && evaluator_.stopped())
            {
                return false;
            }
            nearest_->add(indexed_);
            evaluator_.addWork(NEIGHBOUR_WORK);
        }
        return true;
    }

    /* Before another batch: prunes, or drops the roadmap if there is no room left. False if interrupted. */
    bool RoadmapPart::makeRoom(double bound)
    {
        if (!prune(searchBound(bound)))
        {
            return false;
        }
        if (!isFull())
        {
            missing_ = batch_;
            batch_ += batch_ / 4;
            exhausted_ = false;
            return true;
        }
        renew();
        ++renewals_;
        return true;
    }

    Share RoadmapPart::firstShare() const
    {
        return {0.61, 0.61};
    }

    Share RoadmapPart::improvementShare(double /*seconds*/) const
    {
        const double factor = roadmapFactor(*chart_);
        return {0.20 * factor, 0.32 * factor};
    }

    Readiness RoadmapPart::readiness() const
    {
        if (!context().hasEnds())
        {
            return Readiness::Idle;
        }
        if (!afterTrees_ || context().incumbent.hasFinitePath())
        {
            return Readiness::Ready;
        }
        // if checks are cheap, their number says little about the time
        const bool early = inherited_.any
                               ? evaluator_.work() < FIRST_TREES_AGAIN
                               : evaluator_.work() < FIRST_TREES || context().progress.time() < FIRST_TREES_TIME;
        return early ? Readiness::Waiting : Readiness::Ready;
    }

    bool RoadmapPart::search(double bound, std::uint64_t work, path::Waypoints &path)
    {
        if (!context().hasEnds())
        {
            return false;
        }
        const std::uint64_t limit = evaluator_.work() + work;
        while (evaluator_.work() < limit && !evaluator_.stopped())
        {
            if ((exhausted_ && !makeRoom(bound)) || !indexVertices() || !addEnds())
            {
                return false;
            }
            addBatch(bound, limit);
            if (missing_ > 0)
            {
                return false;
            }
            if (graph_.search(searchBound(bound), limit > evaluator_.work() ? limit - evaluator_.work() : 0, path))
            {
                best_ = graph_.cost();
                found_ = true;
                return true;
            }
            exhausted_ = graph_.exhausted();
        }
        return false;
    }

    void RoadmapPart::inherit(SearchPart &predecessor, const Heritage &heritage)
    {
        auto &earlier = static_cast<RoadmapPart &>(predecessor);
        if (!heritage.states || earlier.graph_.size() == 0)
        {
            return;
        }
        inherited_.any = true;
        batch_ = std::max(FIRST_BATCH, earlier.batch_);
        renewals_ = earlier.renewals_;
        if (!heritage.costs)
        {
            for (std::size_t v = 0; v < earlier.graph_.size(); ++v)
            {
                inherited_.states.append(earlier.graph_.state(v));
            }
            missing_ = inherited_.states.size();
            return;
        }
        inherited_.ends = earlier.graph_.starts();
        const std::vector<std::size_t> goals = earlier.graph_.goals();
        inherited_.ends.insert(inherited_.ends.end(), goals.begin(), goals.end());
        graph_.take(earlier.graph_);
        if (!heritage.validity)
        {
            graph_.forgetValidity();
        }
        nearest_.swap(earlier.nearest_);
        measured_.swap(earlier.measured_);
        *measured_ = &graph_;
        indexed_ = earlier.indexed_;
        // the lower bounds were those of the earlier starts and goals
        promises_.assign(graph_.size(), {UNKNOWN, UNKNOWN, UNKNOWN, 0, 0});
        missing_ = 0;
    }

    void RoadmapPart::explain(SearchGraph &graph) const
    {
        // in an inherited roadmap states need not be checked yet
        std::vector<std::size_t> numbers(graph_.size());
        for (std::size_t v = 0; v < graph_.size(); ++v)
        {
            numbers[v] = graph.states.size();
            if (graph_.isValid(v) || graph_.isEnd(v))
            {
                graph.states.append(graph_.state(v));
            }
        }
        for (const auto &[from, to] : graph_.validEdges())
        {
            graph.edges.emplace_back(numbers[from], numbers[to]);
        }
        for (const std::size_t start : graph_.starts())
        {
            graph.starts.push_back(numbers[start]);
        }
        for (const std::size_t goal : graph_.goals())
        {
            graph.goals.push_back(numbers[goal]);
        }
    }
}  // namespace ompl_mfa::engine::guides
