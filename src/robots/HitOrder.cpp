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

#include "robots/HitOrder.h"

#include <algorithm>
#include <numeric>

namespace ompl_mfa::robots
{
    HitOrder::HitOrder(std::size_t tests)
      : hits_(tests)
    {
        for (std::size_t i = 0; i < ORDERS; ++i)
        {
            orders_[i].resize(tests);
            std::iota(orders_[i].begin(), orders_[i].end(), 0U);
            counts_[i].resize(tests);
        }
    }

    void HitOrder::hit(std::uint32_t test)
    {
        hits_[test].fetch_add(1, std::memory_order_relaxed);
        const std::uint64_t total = total_.fetch_add(1, std::memory_order_relaxed) + 1;
        std::uint64_t threshold = FIRST_SORT;
        for (std::size_t order = 1; order < ORDERS && threshold <= total; ++order, threshold *= 4)
        {
            // Exactly one hit is the one that reaches a threshold.
            if (total == threshold)
            {
                sort(order);
            }
        }
    }

    void HitOrder::sort(std::size_t order)
    {
        // A copy, as other threads go on counting.
        auto &counts = counts_[order];
        for (std::uint32_t test = 0; test < counts.size(); ++test)
        {
            counts[test] = {hits_[test].load(std::memory_order_relaxed), test};
        }
        std::sort(counts.begin(), counts.end(),
                  [](const auto &a, const auto &b)
                  { return a.first > b.first || (a.first == b.first && a.second < b.second); });
        std::transform(counts.begin(), counts.end(), orders_[order].begin(),
                       [](const auto &count) { return count.second; });
        current_.store(order, std::memory_order_release);
    }
}  // namespace ompl_mfa::robots
