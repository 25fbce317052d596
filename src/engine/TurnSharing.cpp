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

#include "engine/TurnSharing.h"

#include <algorithm>
#include <limits>

namespace ompl_mfa::engine
{
    namespace
    {
        /* Factor by which the weight of a past turn decays with each later turn of any part. */
        constexpr double MEMORY = 0.9;
        /* The share of the time that is distributed by gain, in addition to the floors. */
        constexpr double PAYOFF = 0.4;
    }  // namespace

    std::size_t TurnSharing::add(const Share &share)
    {
        Part part;
        part.share = share.weight;
        part.floor = share.floor;
        part.pass = share.delay;
        parts_.push_back(part);
        return parts_.size() - 1;
    }

    std::optional<std::size_t> TurnSharing::next(const std::vector<Readiness> &readiness)
    {
        std::optional<std::size_t> best = leastWorked(readiness, Readiness::Ready);
        if (!best)
        {
            best = leastWorked(readiness, Readiness::Waiting);
        }
        if (!best)
        {
            return best;
        }
        // an idle part does not make up for missed turns later
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            if (readiness[i] == Readiness::Idle)
            {
                parts_[i].pass = std::max(parts_[i].pass, parts_[*best].pass);
            }
        }
        return best;
    }

    std::optional<std::size_t> TurnSharing::leastWorked(const std::vector<Readiness> &readiness, Readiness wanted) const
    {
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            if (readiness[i] == wanted && (!best || parts_[i].pass < parts_[*best].pass))
            {
                best = i;
            }
        }
        return best;
    }

    double TurnSharing::share(std::size_t part) const
    {
        double sum = 0.0;
        for (const Part &p : parts_)
        {
            sum += p.share;
        }
        return parts_[part].share / sum;
    }

    void TurnSharing::record(std::size_t part, double work, const std::vector<double> &gains)
    {
        parts_[part].pass += work / share(part);
        for (std::size_t i = 0; i < parts_.size(); ++i)
        {
            parts_[i].gain = MEMORY * parts_[i].gain + gains[i];
            parts_[i].work *= MEMORY;
        }
        parts_[part].work += work;
        adapt();
    }

    void TurnSharing::adapt()
    {
        double sum = 0.0;
        for (const Part &p : parts_)
        {
            sum += p.work > 0.0 ? p.gain / p.work : 0.0;
        }
        if (sum <= 0.0)
        {
            return;
        }
        for (Part &p : parts_)
        {
            p.share = p.floor + (p.work > 0.0 ? PAYOFF * p.gain / p.work : 0.0) / sum;
        }
    }
}  // namespace ompl_mfa::engine
