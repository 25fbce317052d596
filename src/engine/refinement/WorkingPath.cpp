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

#include "engine/refinement/WorkingPath.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* More vertices cost more than they gain: each has to be moved, and each motion checked. */
        constexpr std::size_t MAX_VERTICES = 48;
        /* First random step of a vertex, as a fraction of the distance to the nearer neighbour. */
        constexpr double FIRST_STEP = 0.25;
    }  // namespace

    WorkingPath::WorkingPath(path::StateChartPtr chart, path::PathEvaluator &evaluator)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , path_(chart_->space())
    {
    }

    void WorkingPath::begin(const path::Waypoints &path)
    {
        path_ = path;
        costs_.clear();
        steps_.clear();
        for (std::size_t i = 0; i < path_.size(); ++i)
        {
            steps_.push_back(firstStep(i));
        }
    }

    bool WorkingPath::full() const
    {
        return path_.size() >= MAX_VERTICES;
    }

    ob::Cost WorkingPath::cost() const
    {
        if (costs_.size() + 1 < path_.size())
        {
            return evaluator_.objective()->infiniteCost();
        }
        return evaluator_.cost(path_, costs_);
    }

    bool WorkingPath::completeCosts()
    {
        while (costs_.size() + 1 < path_.size())
        {
            const std::size_t i = costs_.size();
            ob::Cost cost;
            evaluator_.addWork(1);
            if (!evaluator_.motionCost(path_[i], path_[i + 1], cost))
            {
                return false;
            }
            costs_.push_back(cost);
        }
        return true;
    }

    std::size_t WorkingPath::infiniteMotions() const
    {
        return static_cast<std::size_t>(std::count_if(
            costs_.begin(), costs_.end(), [this](ob::Cost cost) { return !evaluator_.objective()->isFinite(cost); }));
    }

    ob::Cost WorkingPath::cornerCost(std::size_t i) const
    {
        return evaluator_.objective()->combineCosts(costs_[i - 1], costs_[i]);
    }

    double WorkingPath::smallestStep() const
    {
        return 1e-6 * chart_->distance(path_.front(), path_.back()) + 1e-12;
    }

    VertexStep WorkingPath::firstStep(std::size_t i) const
    {
        double spacing = smallestStep();
        if (i > 0 && i + 1 < path_.size())
        {
            spacing = std::max(
                spacing, std::min(chart_->distance(path_[i - 1], path_[i]), chart_->distance(path_[i], path_[i + 1])));
        }
        return VertexStep(VertexSearch(chart_->dimension(),
                                       FIRST_STEP * spacing / std::sqrt(static_cast<double>(chart_->dimension()))));
    }

    void WorkingPath::restartSteps(std::size_t i)
    {
        steps_[i] = firstStep(i);
    }

    void WorkingPath::move(std::size_t i, const ob::State *state, ob::Cost before, ob::Cost after)
    {
        path_.space()->copyState(path_[i], state);
        costs_[i - 1] = before;
        costs_[i] = after;
    }

    void WorkingPath::insert(std::size_t i, const ob::State *state, ob::Cost before, ob::Cost after)
    {
        path_.insert(i, state);
        costs_[i - 1] = before;
        costs_.insert(costs_.begin() + static_cast<std::ptrdiff_t>(i), after);
        steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(i), firstStep(i));
    }

    void WorkingPath::erase(std::size_t first, std::size_t last, ob::Cost joined)
    {
        path_.erase(first, last);
        costs_.erase(costs_.begin() + static_cast<std::ptrdiff_t>(first),
                     costs_.begin() + static_cast<std::ptrdiff_t>(last));
        costs_[first - 1] = joined;
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(first),
                     steps_.begin() + static_cast<std::ptrdiff_t>(last));
    }
}  // namespace ompl_mfa::engine::refinement
