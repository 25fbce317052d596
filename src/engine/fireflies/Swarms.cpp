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
#include <utility>

#include "path/PathDeformation.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Maximum number of start-goal pairs with a swarm of their own. */
        constexpr std::size_t MAX_SWARMS = 8;
        /* Work of the guides before the first turn of a swarm. */
        constexpr std::uint64_t FIRST_GUIDES = 50000;
        /* Generations in a window. */
        constexpr unsigned int WINDOW_GENERATIONS = 15;
        /* One window in this many has its slices across the path, not across the straight motion. */
        constexpr std::size_t CURVED_WINDOWS = 3;
    }  // namespace

    Swarms::Swarms(const SearchContext &context, const Options &options)
      : context_(context)
      , options_(options)
      , windowRandom_(streamSeed(context.seed, Stream::Windows))
      , firefly_{path::Waypoints(context.chart->space()), std::nullopt, Proposal::Stage::Raw, PartKind::Fireflies}
    {
    }

    bool Swarms::any() const
    {
        return context_.hasEnds() && (laid_ == 0 || !straight_.empty() || window_);
    }

    Swarm *Swarms::active()
    {
        // none yet if the stop condition left no time to make one
        if (mustChoose())
        {
            choose();
        }
        return active_;
    }

    bool Swarms::waitForGuides() const
    {
        return options_.guided && !context_.incumbent.hasFinitePath() && context_.evaluator().checks() < FIRST_GUIDES;
    }

    bool Swarms::flyInWindow() const
    {
        return window_ && active_ == &window_->swarm();
    }

    const WindowSwarm *Swarms::window() const
    {
        return flyInWindow() ? window_.get() : nullptr;
    }

    WindowSwarm *Swarms::window()
    {
        return flyInWindow() ? window_.get() : nullptr;
    }

    void Swarms::choose()
    {
        active_ = nullptr;
        if (std::exchange(windowServed_, false))
        {
            window_.reset();
        }
        layStraight();
        const bool windows = context_.incumbent.hasPath() && options_.windows;
        if (windows && (straight_.size() < 2 || chosen_++ % 2 == 0))
        {
            if (!window_ || window_->exhausted())
            {
                openWindow();
            }
            if (window_)
            {
                active_ = &window_->swarm();
            }
        }
        if (active_ == nullptr && !straight_.empty())
        {
            active_ = straight_[context_.progress.iterations / (2UL * context_.settings.generations) % straight_.size()]
                          .get();
        }
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
        }
    }

    /* Opens a window on a segment of the best path, drawn uniformly; windows with slices across the path alternate
       between it and the alternatives. */
    void Swarms::openWindow()
    {
        const Alternatives &alternatives = context_.alternatives;
        const bool curved = windows_ % CURVED_WINDOWS == CURVED_WINDOWS - 1;
        const std::size_t axis = curved ? windows_ / CURVED_WINDOWS % (alternatives.size() + 1) : 0;
        WindowSwarm::Window window{axis == 0 ? context_.incumbent.path() : alternatives[axis - 1], 0, 0,
                                   context_.incumbent.cost()};
        const auto vertices = static_cast<unsigned int>(window.path.size());
        // a single motion can only be replaced if it is the whole path
        window.first = vertices > 2 ? windowRandom_.index(vertices - 2) : 0;
        const auto nearest = std::min<std::size_t>(window.first + 2, vertices - 1);
        window.last = nearest + windowRandom_.index(static_cast<unsigned int>(vertices - nearest));
        FireflyOptimizer::Settings settings = options_.fireflies;
        settings.generations = std::min(settings.generations, WINDOW_GENERATIONS);
        ++windows_;
        window_ =
            WindowSwarm::open(std::move(window), curved ? WindowSwarm::Frame::Curved : WindowSwarm::Frame::Straight,
                              (context_.settings.slices + 1) / 2, context_.chart, context_.evaluator(), settings,
                              streamSeed(context_.seed, Stream::WindowSwarm, windows_));
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

    /* Once the window has found something, the next window waits until that is tightened and compared. */
    void Swarms::endGeneration(Findings &findings)
    {
        if (!flyInWindow() || !pursueWindow(findings))
        {
            choose();
        }
    }

    /* Proposes what the fireflies of the window found as a replacement for its segment, to be compared after
       tightening. Returns whether the window is finished. */
    bool Swarms::pursueWindow(Findings &findings)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        if (window_->found().empty() || evaluator.stopped())
        {
            return false;
        }
        // a path that can be deformed into the present segment would only be tightened to that
        if (!context_.settings.tightening || !path::seemDeformable(evaluator, window_->found(), window_->segment()))
        {
            findings.detours.push_back(window_->detour(PartKind::Fireflies));
        }
        windowServed_ = true;
        return true;
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
        if (active_ == nullptr)
        {
            return paths;
        }
        path::Waypoints path(context_.chart->space());
        for (const unsigned int i : active_->fireflies().order())
        {
            active_->pathOf(i, path);
            paths.push_back(window() != nullptr ? window()->pathWith(path) : path);
        }
        return paths;
    }

    void Swarms::explain(SearchGraph &graph) const
    {
        path::Waypoints path(context_.chart->space());
        const auto add = [&](const Swarm &swarm, const WindowSwarm *window)
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
                graph.addPath(window != nullptr ? window->pathWith(path) : path);
            }
        };
        for (const auto &swarm : straight_)
        {
            add(*swarm, nullptr);
        }
        if (window_)
        {
            add(window_->swarm(), window_.get());
        }
    }
}  // namespace ompl_mfa::engine::fireflies
