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

#include "engine/fireflies/Swarms.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "path/PathDeformation.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Maximum number of start-goal pairs with a swarm of their own. */
        constexpr std::size_t MAX_SWARMS = 8;
        /* One in this many of the fireflies of an earlier search is kept. */
        constexpr std::size_t ELITES = 5;
        /* Work of the guides before the first turn of a swarm. */
        constexpr std::uint64_t FIRST_GUIDES = 50000;
    }  // namespace

    Swarms::Swarms(const SearchContext &context, const Options &options)
      : context_(context)
      , options_(options)
      , firefly_{path::Waypoints(context.chart->space()), std::nullopt, Proposal::Stage::Raw, PartKind::Fireflies,
                 false}
    {
    }

    bool Swarms::any() const
    {
        return context_.hasEnds() && (laid_ == 0 || !straight_.empty());
    }

    Swarm *Swarms::active()
    {
        // none yet if the stop condition left no time to make one
        if (active_ == nullptr)
        {
            chooseNext();
        }
        return active_;
    }

    bool Swarms::resting() const
    {
        return options_.pool && context_.incumbent.hasFinitePath() && context_.pool.size() > 0;
    }

    bool Swarms::waitForGuides() const
    {
        return options_.guided && !context_.incumbent.hasFinitePath() && context_.evaluator().checks() < FIRST_GUIDES;
    }

    void Swarms::chooseNext()
    {
        layStraight();
        active_ =
            straight_.empty()
                ? nullptr
                : straight_[context_.progress.iterations / (2UL * context_.settings.generations) % straight_.size()]
                      .get();
    }

    /* Swarms over straight axes are made when the first of them is needed; usually a guide has found a path by then. */
    void Swarms::layStraight()
    {
        while (laid_ < MAX_SWARMS)
        {
            const auto pair = pairs_.next(context_.query);
            if (!pair)
            {
                return;
            }
            if (context_.evaluator().stopped())
            {
                return pairs_.putBack();
            }
            SliceFrame frame = SliceFrame::straight(context_.chart, context_.query.starts()[pair->first],
                                                    context_.query.goals()[pair->second], context_.settings.slices + 1);
            ++laid_;
            if (frame.dimension() == 0)
            {
                continue;
            }
            const auto validPath = [this](const path::Waypoints &path, const Brightness &brightness)
            { keepFirefly(path, brightness.cost); };
            straight_.push_back(std::make_unique<Swarm>(
                std::move(frame), options_.coordinates, context_.evaluator(), options_.fireflies,
                streamSeed(context_.seed, Stream::Swarm, straight_.size()), validPath));
            placeFirst(*straight_.back());
        }
    }

    /* Paths that cross all slices become fireflies, as far as there is room. */
    void Swarms::placeFirst(Swarm &swarm) const
    {
        path::Waypoints onSlices(context_.chart->space());
        unsigned int placed = 0;
        for (const std::vector<path::Waypoints> *paths : {&context_.firstFireflies, &first_})
        {
            for (const path::Waypoints &path : *paths)
            {
                if (placed < options_.fireflies.populationSize && path.size() > 1 &&
                    swarm.frame().crossings(path, onSlices))
                {
                    swarm.inject(onSlices);
                    ++placed;
                }
            }
        }
    }

    void Swarms::inherit(const Swarms &predecessor)
    {
        const std::vector<path::Waypoints> paths = predecessor.currentPaths();
        const std::size_t count = (paths.size() + ELITES - 1) / ELITES;
        first_.assign(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(count));
    }

    bool Swarms::fly(std::uint64_t work)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const std::uint64_t limit = evaluator.work() + work;
        const std::uint64_t before = active_->evaluations();
        const bool completed = active_->step([&] { return evaluator.work() >= limit || evaluator.stopped(); });
        context_.progress.evaluations += active_->evaluations() - before;
        if (completed && active_->fireflies().generation() > 0)
        {
            ++context_.progress.iterations;
        }
        return completed;
    }

    void Swarms::keepFirefly(const path::Waypoints &path, double cost)
    {
        if (!firefly_.path.empty() && !context_.objective().isCostBetterThan(ob::Cost(cost), *firefly_.cost))
        {
            return;
        }
        firefly_.path = path;
        firefly_.cost = ob::Cost(cost);
    }

    std::optional<Proposal> Swarms::takeFirefly()
    {
        if (firefly_.path.empty())
        {
            return std::nullopt;
        }
        Proposal firefly = firefly_;
        firefly_.path.clear();
        return firefly;
    }

    std::vector<path::Waypoints> Swarms::currentPaths() const
    {
        std::vector<path::Waypoints> paths;
        if (resting())
        {
            const PathPool &pool = context_.pool;
            std::vector<std::size_t> order(pool.size());
            std::iota(order.begin(), order.end(), 0);
            std::stable_sort(order.begin(), order.end(),
                             [&](std::size_t a, std::size_t b)
                             { return context_.evaluator().isBetter(pool[a].cost, pool[b].cost); });
            for (const std::size_t i : order)
            {
                paths.push_back(pool[i].path);
            }
            return paths;
        }
        if (active_ == nullptr)
        {
            return paths;
        }
        path::Waypoints path(context_.chart->space());
        for (const unsigned int i : active_->fireflies().order())
        {
            active_->pathOf(i, path);
            paths.push_back(path);
        }
        return paths;
    }

    void Swarms::explain(SearchGraph &graph) const
    {
        path::Waypoints path(context_.chart->space());
        const auto add = [&](const Swarm &swarm)
        {
            const FireflyOptimizer &fireflies = swarm.fireflies();
            for (const unsigned int i : fireflies.order())
            {
                // of the others it is unknown which states are valid
                if (!fireflies.brightness(i).isFeasible())
                {
                    continue;
                }
                swarm.pathOf(i, path);
                graph.addPath(path);
            }
        };
        for (const auto &swarm : straight_)
        {
            add(*swarm);
        }
    }
}  // namespace ompl_mfa::engine::fireflies
