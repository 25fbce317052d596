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

#include "engine/refinement/PathShortcuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/refinement/CoordinateChoice.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    PathShortcuts::PathShortcuts(WorkingPath &path, ompl::RNG &rng)
      : path_(path)
      , chart_(path.chart())
      , evaluator_(path.evaluator())
      , rng_(rng)
      , segment_(chart_->space())
      , ends_(chart_->space())
      , delta_(chart_->dimension())
    {
        ends_.resize(2);
    }

    bool PathShortcuts::shortcut()
    {
        Bridge bridge;
        if (!drawBridge(bridge))
        {
            return false;
        }
        const auto &objective = evaluator_.objective();
        const auto [first, last, fromVertex, toVertex] = bridge;
        ob::Cost old = path_.motionCost(first);
        for (std::size_t k = first + 1; k <= last; ++k)
        {
            old = objective->combineCosts(old, path_.motionCost(k));
        }
        const ob::State *a = ends_[0];
        const ob::State *b = ends_[1];
        ob::Cost head;
        ob::Cost middle;
        ob::Cost tail;
        if (!evaluator_.motionCost(a, b, middle) || (!fromVertex && !evaluator_.motionCost(path_[first], a, head)) ||
            (!toVertex && !evaluator_.motionCost(b, path_[last + 1], tail)))
        {
            return false;
        }
        ob::Cost fresh = fromVertex ? middle : objective->combineCosts(head, middle);
        if (!toVertex)
        {
            fresh = objective->combineCosts(fresh, tail);
        }
        evaluator_.addWork(last - first + 3);
        if (!objective->isCostBetterThan(fresh, old) || !checkBridge(bridge))
        {
            return false;
        }
        path_.erase(first + 1, last + 1, middle);
        if (!toVertex)
        {
            path_.insert(first + 1, b, middle, tail);
        }
        if (!fromVertex)
        {
            path_.insert(first + 1, a, head, middle);
        }
        return true;
    }

    /* Draws the ends, vertices or points on two motions; false if both are on the same one. */
    bool PathShortcuts::drawBridge(Bridge &bridge)
    {
        const auto &space = chart_->space();
        const auto motions = static_cast<int>(path_.size()) - 1;
        int i = rng_.uniformInt(0, motions - 1);
        int j = rng_.uniformInt(0, motions - 1);
        if (i == j)
        {
            return false;
        }
        if (i > j)
        {
            std::swap(i, j);
        }
        bridge.first = static_cast<std::size_t>(i);
        bridge.last = static_cast<std::size_t>(j);
        // half of the shortcuts begin or end at a vertex, so that no new one is added there
        bridge.fromVertex = rng_.uniform01() < 0.5 || path_.full();
        bridge.toVertex = rng_.uniform01() < 0.5 || path_.full();
        const ob::State *from = path_[bridge.first];
        const ob::State *to = path_[bridge.last + 1];
        chart_->interpolate(from, path_[bridge.first + 1], bridge.fromVertex ? 0.0 : rng_.uniform01(), ends_[0]);
        chart_->interpolate(path_[bridge.last], to, bridge.toVertex ? 1.0 : rng_.uniform01(), ends_[1]);
        space->enforceBounds(ends_[0]);
        space->enforceBounds(ends_[1]);
        if (bridge.fromVertex)
        {
            space->copyState(ends_[0], from);
        }
        if (bridge.toVertex)
        {
            space->copyState(ends_[1], to);
        }
        return true;
    }

    /* Whether the motion between the ends is valid and, where they are needed, those that join it to the path. */
    bool PathShortcuts::checkBridge(const Bridge &bridge)
    {
        const ob::State *a = ends_[0];
        const ob::State *b = ends_[1];
        const ob::State *before = path_[bridge.first];
        const ob::State *after = path_[bridge.last + 1];
        if (bridge.fromVertex)
        {
            return bridge.toVertex ? evaluator_.checkStrictly({{a, b}})
                                   : evaluator_.checkStrictly({{a, b}, {b, after}});
        }
        return bridge.toVertex ? evaluator_.checkStrictly({{a, b}, {before, a}})
                               : evaluator_.checkStrictly({{a, b}, {before, a}, {b, after}});
    }

    bool PathShortcuts::partShortcut()
    {
        const auto last = static_cast<int>(path_.size()) - 1;
        if (last < 3 || chart_->dimension() < 2)
        {
            return false;
        }
        const int i = rng_.uniformInt(0, last - 3);
        const int j = rng_.uniformInt(i + 3, last);
        const auto first = static_cast<std::size_t>(i);
        const auto count = static_cast<std::size_t>(j - i);
        Eigen::VectorXd mask;
        if (!selectCoordinates(*chart_, rng_, mask))
        {
            mask.setZero();
            mask[rng_.uniformInt(0, static_cast<int>(mask.size()) - 1)] = 1.0;
        }
        const double part = rng_.uniform01() < 0.5 ? 1.0 : rng_.uniform01();
        double length = 0.0;
        for (std::size_t k = first; k < first + count; ++k)
        {
            length += chart_->distance(path_[k], path_[k + 1]);
        }
        if (!(length > 0.0) || !std::isfinite(length))
        {
            return false;
        }
        segment_.clear();
        segment_.append(path_[first]);
        double behind = 0.0;
        for (std::size_t k = 1; k < count; ++k)
        {
            behind += chart_->distance(path_[first + k - 1], path_[first + k]);
            chart_->interpolate(path_[first], path_[first + count], std::min(1.0, behind / length), ends_[1]);
            chart_->space()->enforceBounds(ends_[1]);
            chart_->difference(path_[first + k], ends_[1], delta_);
            delta_ = part * delta_.cwiseProduct(mask);
            chart_->displace(path_[first + k], delta_, ends_[0]);
            segment_.append(ends_[0]);
        }
        segment_.append(path_[first + count]);
        return replaceSegment(first);
    }

    /* Replaces the vertices from \e first on by those of segment_ if that is better and valid. */
    bool PathShortcuts::replaceSegment(std::size_t first)
    {
        const auto &objective = evaluator_.objective();
        const std::size_t motions = segment_.size() - 1;
        segmentCosts_.resize(motions);
        evaluator_.addWork(motions);
        ob::Cost old = path_.motionCost(first);
        ob::Cost fresh;
        for (std::size_t k = 0; k < motions; ++k)
        {
            if (!evaluator_.motionCost(segment_[k], segment_[k + 1], segmentCosts_[k]))
            {
                return false;
            }
            fresh = k == 0 ? segmentCosts_[k] : objective->combineCosts(fresh, segmentCosts_[k]);
            old = k == 0 ? old : objective->combineCosts(old, path_.motionCost(first + k));
        }
        if (!objective->isCostBetterThan(fresh, old) || !evaluator_.checkStrictly(segment_))
        {
            return false;
        }
        for (std::size_t k = 1; k < motions; ++k)
        {
            path_.move(first + k, segment_[k], segmentCosts_[k - 1], segmentCosts_[k]);
        }
        return true;
    }
}  // namespace ompl_mfa::engine::refinement
