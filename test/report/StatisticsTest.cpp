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

#include "report/Statistics.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();
    }  // namespace

    TEST(StatisticsTest, MedianOfOddEvenAndInfiniteValues)
    {
        EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
        EXPECT_EQ(median({4.0, 1.0, 2.0, 3.0}), 2.5);
        EXPECT_EQ(median({1.0, 2.0, NEVER}), 2.0);
        EXPECT_EQ(median({1.0, 2.0, NEVER, NEVER}), NEVER);
        EXPECT_EQ(median({NEVER, NEVER}), NEVER);
        EXPECT_THROW(median({}), std::invalid_argument);
    }

    TEST(StatisticsTest, IntervalOfTheMedianIsOfOrderStatistics)
    {
        // nine values: from the second to the eighth, 1 - 2 (1 + 9) / 2^9
        const Estimate nine = medianEstimate({9, 8, 7, 6, 5, 4, 3, 2, 1}, 0.95);
        EXPECT_EQ(nine.value, 5.0);
        EXPECT_EQ(nine.lower, 2.0);
        EXPECT_EQ(nine.upper, 8.0);
        EXPECT_NEAR(nine.coverage, 0.9609375, 1e-12);
        // fifteen values: from the fourth to the twelfth, 1 - 2 (1 + 15 + 105 + 455) / 2^15
        const Estimate fifteen = medianEstimate({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}, 0.95);
        EXPECT_EQ(fifteen.lower, 4.0);
        EXPECT_EQ(fifteen.upper, 12.0);
        EXPECT_NEAR(fifteen.coverage, 0.96484375, 1e-12);
    }

    TEST(StatisticsTest, IntervalOfFewValuesIsTheirRange)
    {
        const Estimate five = medianEstimate({1, 2, 3, 4, NEVER}, 0.95);
        EXPECT_EQ(five.lower, 1.0);
        EXPECT_EQ(five.upper, NEVER);
        EXPECT_NEAR(five.coverage, 0.9375, 1e-12);
        EXPECT_EQ(medianEstimate({7}, 0.95).coverage, 0.0);
    }

    TEST(StatisticsTest, ShareHasTheIntervalOfClopperAndPearson)
    {
        // scipy.stats.binomtest(7, 10).proportion_ci(0.95, 'exact')
        const Estimate seven = proportionEstimate(7, 10, 0.95);
        EXPECT_EQ(seven.value, 0.7);
        EXPECT_NEAR(seven.lower, 0.3475471499399921, 1e-9);
        EXPECT_NEAR(seven.upper, 0.9332604888222655, 1e-9);
        const Estimate none = proportionEstimate(0, 9, 0.95);
        EXPECT_EQ(none.lower, 0.0);
        EXPECT_NEAR(none.upper, 0.3362671168799429, 1e-9);
        EXPECT_EQ(proportionEstimate(9, 9, 0.95).upper, 1.0);
        EXPECT_THROW(proportionEstimate(0, 0, 0.95), std::invalid_argument);
        EXPECT_THROW(proportionEstimate(2, 1, 0.95), std::invalid_argument);
    }

    TEST(StatisticsTest, RatioOfMedians)
    {
        // nine values each: 97.5 % of the median is in their range, which covers with 1 - 2 / 2^9
        const std::vector<double> small{1, 2, 3, 4, 5, 6, 7, 8, 9};
        const std::vector<double> large{10, 20, 30, 40, 50, 60, 70, 80, 90};
        const Estimate ratio = medianRatio(large, small, 100.0, 0.95);
        EXPECT_DOUBLE_EQ(ratio.value, 10.0);
        EXPECT_DOUBLE_EQ(ratio.lower, 10.0 / 9.0);
        EXPECT_DOUBLE_EQ(ratio.upper, 90.0);
        EXPECT_NEAR(ratio.coverage, std::pow(1.0 - 1.0 / 256.0, 2), 1e-12);
    }

    TEST(StatisticsTest, RatioOfTimesThatWereNotReachedIsBounded)
    {
        const std::vector<double> reached{1, 2, 3, 4, 5, 6, 7, 8, 9};
        const std::vector<double> never(9, NEVER);
        const Estimate above = medianRatio(never, reached, 20.0, 0.95);
        EXPECT_DOUBLE_EQ(above.value, 4.0);
        EXPECT_DOUBLE_EQ(above.lower, 20.0 / 9.0);
        EXPECT_EQ(above.upper, NEVER);
        const Estimate below = medianRatio(reached, never, 20.0, 0.95);
        EXPECT_DOUBLE_EQ(below.value, 0.25);
        EXPECT_EQ(below.lower, 0.0);
        EXPECT_DOUBLE_EQ(below.upper, 9.0 / 20.0);
    }

    TEST(StatisticsTest, RanksShareTheirMeanWhereValuesAreEqual)
    {
        EXPECT_EQ(ranksOf({0.3, 0.1, 0.2}), (std::vector<double>{3, 1, 2}));
        EXPECT_EQ(ranksOf({5.0, 5.0, 6.0}), (std::vector<double>{1.5, 1.5, 3}));
        EXPECT_EQ(ranksOf({NEVER, 1.0, NEVER, NEVER}), (std::vector<double>{3, 1, 3, 3}));
    }

    TEST(StatisticsTest, FriedmanAgreesWithScipy)
    {
        // scipy.stats.friedmanchisquare, scipy 1.10.1
        const Friedman test = friedman({{1, 2, 3}, {2, 1.5, 4}, {1, 3, 2}, {5, 5, 6}, {0.5, 0.7, 0.9}});
        EXPECT_NEAR(test.meanRanks[0], 1.3, 1e-12);
        EXPECT_NEAR(test.meanRanks[1], 1.9, 1e-12);
        EXPECT_NEAR(test.meanRanks[2], 2.8, 1e-12);
        EXPECT_NEAR(test.statistic, 6.0, 1e-9);
        EXPECT_NEAR(test.pValue, 0.04978706836786384, 1e-9);
        EXPECT_EQ(friedman({{1, 1}, {2, 2}}).pValue, 1.0);
        EXPECT_THROW(friedman({{1, 2}}), std::invalid_argument);
        EXPECT_THROW(friedman({{1}, {2}}), std::invalid_argument);
    }

    TEST(StatisticsTest, CriticalDifferenceAgreesWithScipy)
    {
        // scipy.stats.studentized_range.ppf(0.95, k, inf) / sqrt(2), the q of Demsar's table, times
        // sqrt(k (k + 1) / (6 n)), which is 1 for n = k (k + 1) / 6
        EXPECT_NEAR(criticalDifference(2, 1, 0.05), 1.9599639845400534, 1e-6);
        EXPECT_NEAR(criticalDifference(3, 2, 0.05), 2.343700586378409, 1e-6);
        EXPECT_NEAR(criticalDifference(5, 5, 0.05), 2.7277743708703763, 1e-6);
        EXPECT_NEAR(criticalDifference(10, 14, 0.05), 3.163683577053373 * std::sqrt(110.0 / 84.0), 1e-6);
    }

    TEST(StatisticsTest, SignedRankTestIsExact)
    {
        // scipy.stats.wilcoxon(..., mode='exact'), scipy 1.10.1
        EXPECT_NEAR(signedRankPValue({1.5, -0.5, 2.0, 3.0, -1.0, 4.0, 2.5, 0.25}), 0.078125, 1e-12);
        // two equal differences: both signs are positive with probability 1/4
        EXPECT_NEAR(signedRankPValue({1.0, 1.0}), 0.5, 1e-12);
        EXPECT_NEAR(signedRankPValue({NEVER, NEVER, -NEVER, 0.0}), 1.0, 1e-12);
        EXPECT_EQ(signedRankPValue({0.0, 0.0}), 1.0);
        EXPECT_NEAR(signedRankPValue(std::vector<double>(10, -1.0)), 2.0 / 1024, 1e-12);
    }

    TEST(StatisticsTest, HolmCorrectsAndKeepsTheOrder)
    {
        const std::vector<double> corrected = holmCorrected({0.01, 0.04, 0.03, 0.6});
        EXPECT_NEAR(corrected[0], 0.04, 1e-12);
        EXPECT_NEAR(corrected[1], 0.09, 1e-12);
        EXPECT_NEAR(corrected[2], 0.09, 1e-12);
        EXPECT_NEAR(corrected[3], 0.6, 1e-12);
        EXPECT_NEAR(holmCorrected({0.7, 0.8})[0], 1.0, 1e-12);
    }
}  // namespace ompl_mfa::report
