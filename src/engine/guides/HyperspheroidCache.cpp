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

#include "engine/guides/HyperspheroidCache.h"

#include <algorithm>
#include <memory>

namespace ompl_mfa::engine::guides
{
    namespace
    {
        /* Maximum total of stored numbers; a hyperspheroid has two matrices and two foci. */
        constexpr std::size_t NUMBERS = 1000000;
        constexpr std::size_t FEWEST = 16;
        constexpr std::size_t MOST = 4096;

        std::size_t capacityFor(Eigen::Index dimension)
        {
            const auto d = static_cast<std::size_t>(dimension);
            return std::clamp(NUMBERS / (2 * d * (d + 1)), FEWEST, MOST);
        }
    }  // namespace

    HyperspheroidCache::HyperspheroidCache(Eigen::Index dimension)
      : capacity_(capacityFor(dimension))
    {
    }

    const ompl::ProlateHyperspheroidPtr &HyperspheroidCache::of(std::size_t pair, const Eigen::VectorXd &focus1,
                                                                const Eigen::VectorXd &focus2)
    {
        const std::size_t index = pair % capacity_;
        if (index >= slots_.size())
        {
            slots_.resize(index + 1);
        }
        Slot &slot = slots_[index];
        if (slot.hyperspheroid && slot.focus1 == focus1 && slot.focus2 == focus2)
        {
            return slot.hyperspheroid;
        }
        size_ += slot.hyperspheroid ? 0 : 1;
        slot.focus1 = focus1;
        slot.focus2 = focus2;
        slot.hyperspheroid = std::make_shared<ompl::ProlateHyperspheroid>(static_cast<unsigned int>(focus1.size()),
                                                                          focus1.data(), focus2.data());
        return slot.hyperspheroid;
    }
}  // namespace ompl_mfa::engine::guides
