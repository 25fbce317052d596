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
#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa::engine::guides
{
    namespace
    {
        Eigen::VectorXd point(Eigen::Index dimension, double x)
        {
            return Eigen::VectorXd::Constant(dimension, x);
        }

        TEST(HyperspheroidCache, KeepsThoseOfAThousandGoals)
        {
            constexpr std::size_t GOALS = 1000;
            HyperspheroidCache cache(16);
            ASSERT_GE(cache.capacity(), GOALS);
            std::vector<ompl::ProlateHyperspheroidPtr> first;
            for (int turn = 0; turn < 3; ++turn)
            {
                for (std::size_t j = 0; j < GOALS; ++j)
                {
                    const auto kept = cache.of(j, point(16, -1.0), point(16, static_cast<double>(j)));
                    EXPECT_DOUBLE_EQ(kept->getMinTransverseDiameter(), 4.0 * (static_cast<double>(j) + 1.0));
                    if (turn == 0)
                    {
                        first.push_back(kept);
                    }
                    EXPECT_EQ(kept, first[j]);
                }
            }
            EXPECT_EQ(cache.size(), GOALS);
        }

        TEST(HyperspheroidCache, IsBoundedHoweverManyPairsThereAre)
        {
            for (const Eigen::Index dimension : {2, 16, 100})
            {
                HyperspheroidCache cache(dimension);
                for (std::size_t j = 0; j < std::min<std::size_t>(2 * cache.capacity(), 6000); ++j)
                {
                    cache.of(j, point(dimension, -1.0), point(dimension, static_cast<double>(j)));
                }
                EXPECT_LE(cache.size(), cache.capacity());
                // two matrices of d^2 numbers each
                EXPECT_LE(cache.capacity() * static_cast<std::size_t>(2 * dimension * dimension), 1000000U);
            }
        }

        TEST(HyperspheroidCache, IsThatOfTheFociWhateverTheNumberOfThePairWasBefore)
        {
            HyperspheroidCache cache(2);
            EXPECT_DOUBLE_EQ(cache.of(0, point(2, 0.0), Eigen::Vector2d(3.0, 4.0))->getMinTransverseDiameter(), 5.0);
            EXPECT_DOUBLE_EQ(cache.of(0, point(2, 0.0), Eigen::Vector2d(6.0, 8.0))->getMinTransverseDiameter(), 10.0);
            EXPECT_EQ(cache.size(), 1U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::guides
