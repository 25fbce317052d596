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

#include "engine/PairBounds.h"

#include <cmath>

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Pairs processed per call: about a millisecond if distances are those of Dubins or Reeds-Shepp curves. */
        constexpr std::size_t PAIRS_AT_ONCE = 1000;
    }  // namespace

    PairBounds::PairBounds(const path::CostBounds &bounds)
      : bounds_(bounds)
    {
    }

    /* NaN, an unknown bound, counts as the best. */
    bool PairBounds::better(double a, double b) const
    {
        if (std::isnan(a) || std::isnan(b))
        {
            return std::isnan(a) && !std::isnan(b);
        }
        return bounds_.objective()->isCostBetterThan(ob::Cost(a), ob::Cost(b));
    }

    void PairBounds::add(const ob::State *start, std::size_t i, const ob::State *goal, std::size_t j)
    {
        const double bound = bounds_.lowerBound(start, goal);
        for (double *best : {&ofStart_[i], &ofGoal_[j], &best_})
        {
            if (better(bound, *best))
            {
                *best = bound;
            }
        }
    }

    void PairBounds::update(const path::Waypoints &starts, const path::Waypoints &goals)
    {
        if (starts.size() < ofStart_.size() || goals.size() < ofGoal_.size())
        {
            ofStart_.clear();
            ofGoal_.clear();
        }
        const double worst = bounds_.objective()->infiniteCost().value();
        if (ofStart_.empty() || ofGoal_.empty())
        {
            best_ = worst;
        }
        std::size_t pairs = 0;
        while (pairs < PAIRS_AT_ONCE && (ofStart_.size() < starts.size() || ofGoal_.size() < goals.size()))
        {
            // the pairs processed so far are all of the first starts with the first goals
            if (ofStart_.size() < starts.size())
            {
                const std::size_t i = ofStart_.size();
                ofStart_.push_back(worst);
                for (std::size_t j = 0; j < ofGoal_.size(); ++j)
                {
                    add(starts[i], i, goals[j], j);
                }
                pairs += 1 + ofGoal_.size();
                continue;
            }
            const std::size_t j = ofGoal_.size();
            ofGoal_.push_back(worst);
            for (std::size_t i = 0; i < ofStart_.size(); ++i)
            {
                add(starts[i], i, goals[j], j);
            }
            pairs += 1 + ofStart_.size();
        }
    }

    bool PairBounds::startCanBeat(std::size_t i, double bound) const
    {
        return i >= ofStart_.size() || bounds_.canBeat(ofStart_[i], bound);
    }

    bool PairBounds::goalCanBeat(std::size_t j, double bound) const
    {
        return j >= ofGoal_.size() || bounds_.canBeat(ofGoal_[j], bound);
    }

    bool PairBounds::isBest(double cost, const path::Waypoints &starts, const path::Waypoints &goals) const
    {
        return bounds_.admissible() && ofStart_.size() == starts.size() && ofGoal_.size() == goals.size() &&
               !better(best_, cost) && !better(cost, best_);
    }
}  // namespace ompl_mfa::engine
