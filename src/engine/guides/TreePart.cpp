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

#include "engine/guides/TreePart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/tools/config/SelfConfig.h>

#include "engine/TurnMeter.h"
#include "path/TreeStep.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        /* Longest motion of a tree, as a fraction of the space's extent; OMPL's default. */
        constexpr double RANGE = 0.2;
        /* The trees begin to improve the first path after this many times the time that it took. */
        constexpr double DELAY = 6.7;
        /* Work of a nearest-neighbour query, in state checks. */
        constexpr std::uint64_t NEIGHBOUR_WORK = 8;
    }  // namespace

    TreePart::TreePart(const SearchContext &context)
      : GuidePart(PartKind::Trees, context)
      , chart_(context.chart)
      , evaluator_(context.evaluator())
      , sampler_(chart_, evaluator_.bounds(), streamSeed(context.seed, Stream::Trees))
      , range_(RANGE * chart_->space()->getMaximumExtent())
      , sample_(chart_->space()->allocState())
      , step_(chart_->space()->allocState())
      , probe_{nullptr, nullptr, 0}
    {
        for (Tree *tree : {&startTree_, &goalTree_})
        {
            tree->nearest.reset(ompl::tools::SelfConfig::getDefaultNearestNeighbors<Vertex *>(&context.owner));
        }
        // distances are measured in the direction of the motions: away from the start, toward the goal
        startTree_.nearest->setDistanceFunction([this](const Vertex *a, const Vertex *b)
                                                { return chart_->distance(a->state, b->state); });
        goalTree_.nearest->setDistanceFunction([this](const Vertex *a, const Vertex *b)
                                               { return chart_->distance(b->state, a->state); });
    }

    TreePart::~TreePart()
    {
        freeVertices(startTree_);
        freeVertices(goalTree_);
        chart_->space()->freeState(sample_);
        chart_->space()->freeState(step_);
    }

    void TreePart::freeVertices(Tree &tree)
    {
        tree.nearest->clear();
        for (const auto &vertex : tree.vertices)
        {
            chart_->space()->freeState(vertex->state);
        }
        tree.vertices.clear();
        tree.offered = 0;
    }

    void TreePart::restart()
    {
        freeVertices(startTree_);
        freeVertices(goalTree_);
        metFromStart_ = metFromGoal_ = nullptr;
        startsTurn_ = true;
    }

    TreePart::Vertex *TreePart::addVertex(Tree &tree, const ob::State *state, const Vertex *parent)
    {
        tree.vertices.push_back(
            std::make_unique<Vertex>(Vertex{chart_->space()->cloneState(state), parent, tree.vertices.size()}));
        tree.nearest->add(tree.vertices.back().get());
        return tree.vertices.back().get();
    }

    void TreePart::addRoots(double bound)
    {
        const Query &query = context().query;
        PairBounds &pairs = sampler_.pairs();
        if (!std::isinf(bound))
        {
            pairs.update(query.starts(), query.goals());
        }
        for (; startTree_.offered < query.starts().size(); ++startTree_.offered)
        {
            if (pairs.startCanBeat(startTree_.offered, bound))
            {
                addVertex(startTree_, query.starts()[startTree_.offered], nullptr);
            }
        }
        for (; goalTree_.offered < query.goals().size(); ++goalTree_.offered)
        {
            if (pairs.goalCanBeat(goalTree_.offered, bound))
            {
                addVertex(goalTree_, query.goals()[goalTree_.offered], nullptr);
            }
        }
    }

    TreePart::Vertex *TreePart::nearest(Tree &tree, const ob::State *state, bool fromStart)
    {
        evaluator_.addWork(NEIGHBOUR_WORK);
        if (chart_->space()->hasSymmetricDistance())
        {
            probe_.state = const_cast<ob::State *>(state);  // the probe is only read
            evaluator_.addDistances(neighbourDistances(*chart_->space(), tree.vertices.size()));
            return tree.nearest->nearest(&probe_);
        }
        // nearest-neighbour structures assume a symmetric distance
        const path::TreeStep grow{*chart_, fromStart};
        evaluator_.addWork(tree.vertices.size());
        evaluator_.addDistances(tree.vertices.size());
        std::size_t best = 0;
        double bestDistance = grow.distance(tree.vertices[0]->state, state);
        for (std::size_t i = 1; i < tree.vertices.size(); ++i)
        {
            const double d = grow.distance(tree.vertices[i]->state, state);
            if (d < bestDistance)
            {
                bestDistance = d;
                best = i;
            }
        }
        return tree.vertices[best].get();
    }

    TreePart::Extension TreePart::extend(Tree &tree, bool fromStart, const ob::State *target, Vertex *&added)
    {
        const path::TreeStep grow{*chart_, fromStart};
        Vertex *near = nearest(tree, target, fromStart);
        const bool reach = grow.toward(near->state, target, grow.distance(near->state, target), range_, step_);
        if (!grow.check(evaluator_, near->state, step_))
        {
            return Extension::Trapped;
        }
        added = addVertex(tree, step_, near);
        return reach ? Extension::Reached : Extension::Advanced;
    }

    void TreePart::join(const Vertex *fromStart, const Vertex *fromGoal, path::Waypoints &path) const
    {
        path.clear();
        for (; fromStart != nullptr; fromStart = fromStart->parent)
        {
            path.append(fromStart->state);
        }
        path.reverse();
        // both trees contain the state at which they met
        for (fromGoal = fromGoal->parent; fromGoal != nullptr; fromGoal = fromGoal->parent)
        {
            path.append(fromGoal->state);
        }
    }

    bool TreePart::iterate(double bound, path::Waypoints &path)
    {
        const Query &query = context().query;
        const bool fromStart = startsTurn_;
        startsTurn_ = !startsTurn_;
        evaluator_.addWork(1);
        if (startTree_.vertices.empty() || goalTree_.vertices.empty() ||
            !sampler_.sample(query.starts(), query.goals(), bound, sample_))
        {
            return false;
        }
        Tree &tree = fromStart ? startTree_ : goalTree_;
        Tree &other = fromStart ? goalTree_ : startTree_;
        Vertex *added = nullptr;
        if (extend(tree, fromStart, sample_, added) == Extension::Trapped)
        {
            return false;
        }
        Vertex *met = nullptr;
        Extension extension = Extension::Advanced;
        while (extension == Extension::Advanced && !evaluator_.interrupted())
        {
            extension = extend(other, !fromStart, added->state, met);
        }
        if (extension != Extension::Reached)
        {
            return false;
        }
        metFromStart_ = fromStart ? added : met;
        metFromGoal_ = fromStart ? met : added;
        join(metFromStart_, metFromGoal_, path);
        return path.size() >= 2;
    }

    Share TreePart::firstShare() const
    {
        return {0.30, 0.30};
    }

    Share TreePart::improvementShare(double seconds) const
    {
        return {0.15, 0.08 + 0.10 * (1.0 - roadmapFactor(*chart_)), DELAY * seconds};
    }

    Readiness TreePart::readiness() const
    {
        return context().hasEnds() ? Readiness::Ready : Readiness::Idle;
    }

    bool TreePart::search(double bound, std::uint64_t work, path::Waypoints &path)
    {
        if (!context().hasEnds())
        {
            return false;
        }
        // not earlier, so that planner data shows the trees that found the path
        if (metFromStart_ != nullptr)
        {
            restart();
        }
        addRoots(bound);
        const std::uint64_t limit = evaluator_.work() + work;
        while (evaluator_.work() < limit && !evaluator_.stopped())
        {
            if (iterate(bound, path))
            {
                return true;
            }
        }
        return false;
    }

    void TreePart::explain(SearchGraph &graph) const
    {
        const auto add = [&graph](const Tree &tree, bool fromStart)
        {
            const std::size_t first = graph.states.size();
            for (const auto &vertex : tree.vertices)
            {
                const std::size_t here = first + vertex->number;
                graph.states.append(vertex->state);
                if (vertex->parent == nullptr)
                {
                    (fromStart ? graph.starts : graph.goals).push_back(here);
                }
                else if (fromStart)
                {
                    graph.edges.emplace_back(first + vertex->parent->number, here);
                }
                else
                {
                    graph.edges.emplace_back(here, first + vertex->parent->number);
                }
            }
            return first;
        };
        const std::size_t firstOfStart = add(startTree_, true);
        const std::size_t firstOfGoal = add(goalTree_, false);
        // both trees contain the meeting state; its motion onward joins them
        if (metFromStart_ != nullptr && metFromGoal_->parent != nullptr)
        {
            graph.edges.emplace_back(firstOfStart + metFromStart_->number, firstOfGoal + metFromGoal_->parent->number);
        }
    }
}  // namespace ompl_mfa::engine::guides
