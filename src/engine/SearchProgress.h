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

#ifndef OMPL_MFA_ENGINE_SEARCH_PROGRESS_
#define OMPL_MFA_ENGINE_SEARCH_PROGRESS_

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>

#include "engine/PartKind.h"

namespace ompl_mfa::engine
{
    /** \brief Progress values of a search, which other threads may read while it runs. */
    class SearchProgress
    {
    public:
        /** \brief Cost of the path that would be returned now; infinity before there is one. */
        std::atomic<double> bestCost{std::numeric_limits<double>::infinity()};
        std::atomic<std::uint64_t> iterations{0};   ///< firefly generations
        std::atomic<std::uint64_t> evaluations{0};  ///< path evaluations

        void reset()
        {
            bestCost = std::numeric_limits<double>::infinity();
            iterations = 0;
            evaluations = 0;
            for (auto &spent : spent_)
            {
                spent = 0.0;
            }
        }

        /** \brief Adds \e seconds to the time of \e part. Called by the searching thread only. */
        void addTime(PartKind part, double seconds)
        {
            auto &spent = spent_[static_cast<std::size_t>(part)];
            spent.store(spent.load(std::memory_order_relaxed) + seconds, std::memory_order_relaxed);
        }

        /** \brief Total time of all parts, in s. */
        double time() const
        {
            double sum = 0.0;
            for (const auto &spent : spent_)
            {
                sum += spent.load(std::memory_order_relaxed);
            }
            return sum;
        }

        /** \brief The fraction of time() used by \e part, in [0, 1]; 0 before any turn. */
        double share(PartKind part) const
        {
            const double sum = time();
            return sum > 0.0 ? spent_[static_cast<std::size_t>(part)].load(std::memory_order_relaxed) / sum : 0.0;
        }

    private:
        std::array<std::atomic<double>, PART_NAMES.size()> spent_{};
    };
}  // namespace ompl_mfa::engine

#endif
