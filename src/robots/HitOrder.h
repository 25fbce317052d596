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

#ifndef OMPL_MFA_ROBOTS_HIT_ORDER_
#define OMPL_MFA_ROBOTS_HIT_ORDER_

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ompl_mfa::robots
{
    /** \brief Order in which a number of tests are made: those that found most collisions first.

        Thread-safe without locks, and without allocations after the construction: the order changes only a fixed number
        of times, whenever the number of hits has quadrupled, and each order has its own memory. */
    class HitOrder
    {
    public:
        explicit HitOrder(std::size_t tests);

        /** \brief The order now. It stays valid as long as this object. */
        const std::vector<std::uint32_t> &current() const
        {
            return orders_[current_.load(std::memory_order_acquire)];
        }

        /** \brief Count a collision found by a test. */
        void hit(std::uint32_t test);

    private:
        void sort(std::size_t order);

        static constexpr std::uint64_t FIRST_SORT = 64;
        static constexpr std::size_t ORDERS = 12;

        std::vector<std::atomic<std::uint32_t>> hits_;
        std::atomic<std::uint64_t> total_{0};
        std::atomic<std::size_t> current_{0};
        std::array<std::vector<std::uint32_t>, ORDERS> orders_;
        std::array<std::vector<std::pair<std::uint32_t, std::uint32_t>>, ORDERS> counts_;
    };
}  // namespace ompl_mfa::robots

#endif
