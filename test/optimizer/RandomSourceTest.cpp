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

#include "ompl_mfa/optimizer/RandomSource.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

using ompl_mfa::deriveSeed;
using ompl_mfa::mixBits;

namespace ompl_mfa::optimizer
{
    TEST(RandomSource, MixesBitsAsSplitMix64Does)
    {
        // the first two outputs of SplitMix64 for the seed 1234567
        EXPECT_EQ(mixBits(1234567 + 0x9e3779b97f4a7c15ULL), 6457827717110365317ULL);
        EXPECT_EQ(mixBits(1234567 + 2 * 0x9e3779b97f4a7c15ULL), 3203168211198807973ULL);
    }

    TEST(RandomSource, DerivesADifferentSeedForEveryStreamOfNeighbouringRuns)
    {
        std::set<std::uint64_t> seeds;
        std::set<std::uint32_t> lowHalves;
        for (std::uint64_t run = 0; run < 20; ++run)
        {
            for (std::uint64_t stream = 0; stream < 20; ++stream)
            {
                for (std::uint64_t index = 0; index < 20; ++index)
                {
                    seeds.insert(deriveSeed(run, stream, index));
                    lowHalves.insert(static_cast<std::uint32_t>(deriveSeed(run, stream, index)));
                }
            }
        }
        EXPECT_EQ(seeds.size(), 8000U);
        // of 8000 random numbers of 32 bits 0.007 pairs are equal on average
        EXPECT_GE(lowHalves.size(), 7999U);
    }

    TEST(RandomSource, IsTheSameOnEveryPlatform)
    {
        // The C++ standard fixes the 10000th output of a default-seeded mt19937_64 at 9981545732273789042.
        RandomSource random(5489U);
        for (int i = 1; i < 10000; ++i)
        {
            random.uniform();
        }
        EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042ULL >> 11U) / 9007199254740992.0);
    }

    TEST(RandomSource, StaysWithinItsIntervals)
    {
        RandomSource random(1);
        std::vector<int> counts(7, 0);
        double sum = 0.0;
        for (int i = 0; i < 70000; ++i)
        {
            const double value = random.uniform();
            ASSERT_GE(value, 0.0);
            ASSERT_LT(value, 1.0);
            sum += value;
            const unsigned int index = random.index(7);
            ASSERT_LT(index, 7U);
            ++counts[index];
        }
        EXPECT_NEAR(sum / 70000, 0.5, 0.01);
        for (const int count : counts)
        {
            EXPECT_NEAR(count, 10000, 500);
        }
    }
}  // namespace ompl_mfa::optimizer
