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

#include <array>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa::engine
{
    namespace
    {
        using Ready = std::vector<Readiness>;

        const Ready ALL(3, Readiness::Ready);

        /* Gives so many turns of equal work, with the gain of each part in a turn, and counts the turns of each
           part. */
        std::array<int, 3> turns(TurnSharing &sharing, int count, const std::array<double, 3> &gains,
                                 const Ready &readiness = ALL)
        {
            std::array<int, 3> taken{};
            for (int i = 0; i < count; ++i)
            {
                const std::size_t part = sharing.next(readiness).value();
                ++taken[part];
                std::vector<double> gained(3, 0.0);
                gained[part] = gains[part];
                sharing.record(part, 1.0, gained);
            }
            return taken;
        }

        TEST(TurnSharingTest, WorkFollowsTheShares)
        {
            TurnSharing sharing;
            sharing.add({0.5, 0.1, 0.0});
            sharing.add({0.3, 0.1, 0.0});
            sharing.add({0.2, 0.1, 0.0});
            const auto taken = turns(sharing, 1000, {0.0, 0.0, 0.0});
            EXPECT_NEAR(taken[0], 500, 2);
            EXPECT_NEAR(taken[1], 300, 2);
            EXPECT_NEAR(taken[2], 200, 2);
        }

        TEST(TurnSharingTest, WhatPaysGetsMoreAndNoPartStarves)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            const auto taken = turns(sharing, 1000, {0.0, 0.0, 1.0});
            EXPECT_GT(taken[2], 2 * taken[0]);
            EXPECT_GT(taken[0], 100);
            EXPECT_GT(taken[1], 100);
            EXPECT_GT(sharing.share(2), sharing.share(0));
        }

        TEST(TurnSharingTest, TheSharesFollowWhatPaysOfLate)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            turns(sharing, 200, {1.0, 0.0, 0.0});
            const auto taken = turns(sharing, 500, {0.0, 1.0, 0.0});
            EXPECT_GT(taken[1], 2 * taken[0]);
        }

        TEST(TurnSharingTest, ADelayedPartWaits)
        {
            TurnSharing sharing;
            sharing.add({0.5, 0.1, 0.0});
            sharing.add({0.5, 0.1, 20.0});
            sharing.add({0.5, 0.1, 20.0});
            const auto first = turns(sharing, 6, {0.0, 0.0, 0.0});
            EXPECT_EQ(first[0], 6);
            const auto later = turns(sharing, 300, {0.0, 0.0, 0.0});
            EXPECT_NEAR(later[0], later[1], 10);
        }

        TEST(TurnSharingTest, APartThatCouldNotTakeItsTurnsDoesNotGetThemAllLater)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            turns(sharing, 300, {0.0, 0.0, 0.0}, {Readiness::Ready, Readiness::Ready, Readiness::Idle});
            const auto taken = turns(sharing, 30, {0.0, 0.0, 0.0});
            EXPECT_NEAR(taken[2], 10, 1);
        }

        TEST(TurnSharingTest, APartThatWaitsKeepsItsClaim)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            const auto first =
                turns(sharing, 30, {0.0, 0.0, 0.0}, {Readiness::Ready, Readiness::Ready, Readiness::Waiting});
            EXPECT_EQ(first[2], 0);
            const auto later = turns(sharing, 15, {0.0, 0.0, 0.0});
            EXPECT_EQ(later[2], 15) << "until it has worked as much as each of the others";
        }

        TEST(TurnSharingTest, APartThatWaitsHasTheTurnWhereNoneIsReady)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            EXPECT_EQ(sharing.next({Readiness::Idle, Readiness::Waiting, Readiness::Idle}), 1U);
            EXPECT_EQ(sharing.next({Readiness::Idle, Readiness::Waiting, Readiness::Ready}), 2U);
            EXPECT_EQ(sharing.next(Ready(3, Readiness::Idle)), std::nullopt);
            EXPECT_EQ(TurnSharing().next({}), std::nullopt);
        }

        /* As when one part improves the path of another. */
        TEST(TurnSharingTest, AGainCountsForEachPartThatHasAShareInIt)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            std::array<int, 3> taken{};
            for (int i = 0; i < 1000; ++i)
            {
                const std::size_t part = sharing.next(ALL).value();
                ++taken[part];
                sharing.record(part, 1.0, part == 2 ? std::vector<double>{1.0, 0.0, 1.0} : std::vector<double>(3, 0.0));
            }
            EXPECT_GT(taken[0], 2 * taken[1]);
            EXPECT_GT(taken[2], 2 * taken[1]);
            EXPECT_GT(taken[1], 100);
        }

        TEST(TurnSharingTest, AGainOfAPartThatHasNotWorkedYetLeavesTheSharesAsTheyAre)
        {
            TurnSharing sharing;
            for (int i = 0; i < 3; ++i)
            {
                sharing.add({0.3, 0.1, 0.0});
            }
            sharing.record(0, 1.0, {0.0, 1.0, 0.0});
            for (std::size_t i = 0; i < 3; ++i)
            {
                EXPECT_DOUBLE_EQ(sharing.share(i), 1.0 / 3.0);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine
