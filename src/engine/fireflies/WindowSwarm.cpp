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

#include "engine/fireflies/WindowSwarm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* A new segment may cost more than the present one by this fraction of the whole path's cost, as it is
           tightened afterwards. */
        constexpr double SLACK = 0.15;
        /* One state of a motion in this many is checked first, and the others only if all of those are valid: most
           fireflies collide. */
        constexpr unsigned int STRIDE = 20;
    }  // namespace

    WindowSwarm::WindowSwarm(Window window, path::PathEvaluator &evaluator)
      : window_(std::move(window))
      , evaluator_(evaluator)
      , segment_(window_.path.space())
      , found_(window_.path.space())
    {
        for (std::size_t i = window_.first; i <= window_.last; ++i)
        {
            segment_.append(window_.path[i]);
        }
        cost_ = evaluator_.cost(segment_);
        bound_ = boundOf(cost_);
    }

    /* The slack is a fraction of the whole path's cost, or of the segment's own if the path has infinite cost. A
       segment of infinite cost may be replaced by any of finite cost. */
    double WindowSwarm::boundOf(ob::Cost segment) const
    {
        const double whole = std::isfinite(window_.pathCost) ? window_.pathCost : segment.value();
        const double slack = std::isfinite(whole) ? evaluator_.withSlack(whole, 1.0 + SLACK) - whole : 0.0;
        return std::clamp(segment.value() + slack, std::numeric_limits<double>::lowest(),
                          std::numeric_limits<double>::max());
    }

    std::unique_ptr<WindowSwarm> WindowSwarm::open(Window window, Frame frame, unsigned int slices,
                                                   const path::StateChartPtr &chart, path::PathEvaluator &evaluator,
                                                   const FireflyOptimizer::Settings &settings, std::uint64_t seed)
    {
        std::unique_ptr<WindowSwarm> result(new WindowSwarm(std::move(window), evaluator));
        SliceFrame laid =
            frame == Frame::Straight ? result->straightFrame(chart, slices) : result->curvedFrame(chart, slices);
        if (laid.dimension() == 0)
        {
            return nullptr;
        }
        const auto validSegment = [found = result.get()](const path::Waypoints &segment, const Brightness &brightness)
        { found->take(segment, brightness.cost); };
        result->swarm_ = std::make_unique<Swarm>(std::move(laid), Swarm::Coordinates::Modes, evaluator, settings, seed,
                                                 validSegment);
        result->swarm_->setBound(result->bound_);
        result->swarm_->setStride(STRIDE);
        return result;
    }

    /* The lateral distance that a segment within the slack can reach from an axis of this length: half the minor axis
       of the ellipsoid that contains all such segments. */
    double WindowSwarm::reach(double axis) const
    {
        const double longest = segment_.length() + SLACK * window_.path.length();
        return 0.5 * std::sqrt(std::max(0.0, longest * longest - axis * axis));
    }

    SliceFrame WindowSwarm::straightFrame(const path::StateChartPtr &chart, unsigned int slices) const
    {
        return SliceFrame::straight(chart, segment_.front(), segment_.back(), slices + 1,
                                    reach(chart->distance(segment_.front(), segment_.back())));
    }

    /* An axis through the vertices, with further states on long motions. */
    SliceFrame WindowSwarm::curvedFrame(const path::StateChartPtr &chart, unsigned int slices) const
    {
        const auto &space = chart->space();
        const double length = segment_.length();
        const double spacing = length / (slices + 1);
        path::Waypoints axis(space);
        axis.append(segment_.front());
        for (std::size_t i = 1; i < segment_.size(); ++i)
        {
            const double distance = chart->distance(segment_[i - 1], segment_[i]);
            const auto pieces =
                spacing > 0.0 ? std::max(1U, static_cast<unsigned int>(std::lround(distance / spacing))) : 1U;
            for (unsigned int j = 1; j < pieces; ++j)
            {
                axis.append(segment_[i]);
                auto *state = axis[axis.size() - 1];
                chart->interpolate(segment_[i - 1], segment_[i], static_cast<double>(j) / pieces, state);
                space->enforceBounds(state);
            }
            axis.append(segment_[i]);
        }
        return {chart, std::move(axis), reach(length)};
    }

    bool WindowSwarm::take(const path::Waypoints &segment, double cost)
    {
        if (!found_.empty() && !evaluator_.objective()->isCostBetterThan(ob::Cost(cost), ob::Cost(foundCost_)))
        {
            return false;
        }
        found_ = segment;
        foundCost_ = cost;
        return true;
    }

    bool WindowSwarm::recombine(std::uint64_t work)
    {
        const path::Waypoints none(window_.path.space());
        path::Waypoints spliced(window_.path.space());
        // if the stop condition left the cost unknown, it is no bound
        const bool better =
            !found_.empty() && evaluator_.objective()->isCostBetterThan(ob::Cost(foundCost_), ob::Cost(bound_));
        return swarm_->recombine(none, better ? foundCost_ : bound_, work, spliced) &&
               take(spliced, evaluator_.cost(spliced).value());
    }

    bool WindowSwarm::exhausted() const
    {
        return swarm_->fireflies().generation() >= swarm_->fireflies().settings().generations;
    }

    Detour WindowSwarm::detour(PartKind origin) const
    {
        return {found_, ob::Cost(foundCost_), cost_, window_.path, window_.first, window_.last, origin};
    }

    path::Waypoints WindowSwarm::pathWith(const path::Waypoints &segment) const
    {
        return replaceSegment(window_.path, window_.first, window_.last, segment);
    }
}  // namespace ompl_mfa::engine::fireflies
