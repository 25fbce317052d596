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

#include "engine/PathPool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "path/PathWalk.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Two paths are nearly the same if the mean distance of their states on the slices is less than
           this fraction of the length. */
        constexpr double DIVERSITY = 0.02;
    }  // namespace

    PathPool::PathPool(std::size_t capacity, path::StateChartPtr chart, const path::PathEvaluator &evaluator)
      : capacity_(capacity)
      , chart_(std::move(chart))
      , evaluator_(evaluator)
    {
    }

    /* The root mean square of the distances of the states on the slices. */
    double PathPool::meanDistance(const path::Waypoints &a, const path::Waypoints &b) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < a.size(); ++k)
        {
            const double distance = chart_->distance(a[k], b[k]);
            sum += distance * distance;
        }
        return std::sqrt(sum / static_cast<double>(a.size()));
    }

    std::size_t PathPool::brightest() const
    {
        const auto first =
            std::min_element(members_.begin(), members_.end(),
                             [this](const Member &a, const Member &b) { return evaluator_.isBetter(a.cost, b.cost); });
        return static_cast<std::size_t>(first - members_.begin());
    }

    std::size_t PathPool::dimmest() const
    {
        const auto last =
            std::max_element(members_.begin(), members_.end(),
                             [this](const Member &a, const Member &b) { return evaluator_.isBetter(a.cost, b.cost); });
        return static_cast<std::size_t>(last - members_.begin());
    }

    void PathPool::add(const path::Waypoints &path, double cost, bool valid, double best)
    {
        if (capacity_ == 0 || path.size() < 3 || evaluator_.isBetter(evaluator_.withSlack(best, SLACK), cost))
        {
            return;
        }
        Member member{path, cost, valid, path::statesAlong(path, SLICES)};
        std::size_t nearest = members_.size();
        double least = DIVERSITY * path.length();
        for (std::size_t i = 0; i < members_.size(); ++i)
        {
            const double distance = meanDistance(member.slices, members_[i].slices);
            if (distance < least)
            {
                least = distance;
                nearest = i;
            }
        }
        if (nearest == members_.size() && members_.size() < capacity_)
        {
            members_.push_back(std::move(member));
            return;
        }
        const std::size_t replaced = nearest < members_.size() ? nearest : dimmest();
        if (evaluator_.isBetter(cost, members_[replaced].cost))
        {
            members_[replaced] = std::move(member);
        }
    }

    void PathPool::prune(double best)
    {
        const double most = evaluator_.withSlack(best, SLACK);
        members_.erase(std::remove_if(members_.begin(), members_.end(),
                                      [&](const Member &member) { return evaluator_.isBetter(most, member.cost); }),
                       members_.end());
    }
}  // namespace ompl_mfa::engine
