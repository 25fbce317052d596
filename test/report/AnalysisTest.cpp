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

#include "report/Analysis.h"

#include <limits>

#include <gtest/gtest.h>

#include "report/ReportFixture.h"

using ompl_mfa::test::experimentOf;
using ompl_mfa::test::solvedAt;

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();
    }  // namespace

    TEST(AnalysisTest, TimesToQualitiesAreRelativeToTheBestOfAllPlanners)
    {
        Experiment experiment = experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.2, 10.4}}});
        experiment.planners[1].runs[0] = RunResult();
        const ExperimentSummary summary = summarize(experiment, NEVER);
        EXPECT_EQ(summary.bestCost, 10.0);
        EXPECT_FALSE(summary.isReference);
        const PlannerSummary &b = summary.planners[1];
        EXPECT_EQ(b.solved, 8U);
        EXPECT_NEAR(b.success.value, 8.0 / 9.0, 1e-12);
        EXPECT_EQ(b.finalCost.value, 10.4);
        // first path, 10 %, 5 % (10.5), and neither 1 % (10.1) nor 0.1 %
        EXPECT_EQ(b.levels[0].time.value, 0.2);
        EXPECT_EQ(b.levels[2].time.value, 0.2);
        EXPECT_EQ(b.levels[2].reached, 8U);
        EXPECT_EQ(b.levels[3].time.value, NEVER);
        EXPECT_EQ(b.levels[3].reached, 0U);
    }

    TEST(AnalysisTest, ReferenceCountsIfItIsLower)
    {
        const Experiment experiment = experimentOf("e", {{"a", {0.1, 10.0}}});
        const ExperimentSummary lower = summarize(experiment, 9.8);
        EXPECT_EQ(lower.bestCost, 9.8);
        EXPECT_TRUE(lower.isReference);
        EXPECT_EQ(lower.planners[0].levels[3].reached, 0U);
        EXPECT_EQ(summarize(experiment, 10.5).bestCost, 10.0);
    }

    TEST(AnalysisTest, SpeedIsAgainstTheFastestOther)
    {
        const ExperimentSummary summary =
            summarize(experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.4, 10.0}}, {"c", {0.2, 12.0}}}), NEVER);
        const LevelTime &first = summary.planners[0].levels[0];
        EXPECT_EQ(first.peer, "c");
        EXPECT_DOUBLE_EQ(first.speed.value, 2.0);
        EXPECT_EQ(first.bound, 0);
        const LevelTime &close = summary.planners[0].levels[4];
        EXPECT_EQ(close.peer, "b");
        EXPECT_DOUBLE_EQ(close.speed.value, 4.0);
        // c does not get there: less than 0.1 s / 1 s
        const LevelTime &never = summary.planners[2].levels[4];
        EXPECT_EQ(never.peer, "a");
        EXPECT_EQ(never.bound, -1);
        EXPECT_DOUBLE_EQ(never.speed.value, 0.1);
        EXPECT_EQ(never.speed.lower, 0.0);
    }

    TEST(AnalysisTest, SpeedIsALowerBoundIfNoOtherGetsThere)
    {
        const ExperimentSummary summary = summarize(experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.4, 12.0}}}), NEVER);
        const LevelTime &alone = summary.planners[0].levels[3];
        EXPECT_TRUE(alone.isCompared);
        EXPECT_EQ(alone.peer, "");
        EXPECT_EQ(alone.bound, 1);
        EXPECT_DOUBLE_EQ(alone.speed.value, 10.0);
        EXPECT_EQ(alone.speed.upper, NEVER);
    }

    TEST(AnalysisTest, NoSpeedIfNobodyGetsThereOrThereIsNoOther)
    {
        const ExperimentSummary nobody = summarize(experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.4, 12.0}}}), 5.0);
        EXPECT_FALSE(nobody.planners[0].levels[1].isCompared);
        const ExperimentSummary alone = summarize(experimentOf("e", {{"a", {0.1, 10.0}}}), NEVER);
        EXPECT_FALSE(alone.planners[0].levels[0].isCompared);
    }

    TEST(AnalysisTest, CurvesEndAtTheLimitWithTheFinalValues)
    {
        const ExperimentSummary summary =
            summarize(experimentOf("e", {{"a", {0.001, 10.0}}, {"b", {0.5, 11.0}}}), NEVER);
        const auto &curve = summary.planners[1].curve;
        EXPECT_EQ(curve.front().time, 0.001);
        EXPECT_EQ(curve.front().solved.value, 0.0);
        EXPECT_EQ(curve.front().cost.value, NEVER);
        EXPECT_EQ(summary.planners[0].curve.front().solved.value, 1.0);
        EXPECT_EQ(curve.back().time, 1.0);
        EXPECT_EQ(curve.back().solved.value, 1.0);
        EXPECT_EQ(curve.back().cost.value, 11.0);
        for (std::size_t i = 1; i < curve.size(); ++i)
        {
            EXPECT_GT(curve[i].time, curve[i - 1].time);
        }
    }

    TEST(AnalysisTest, CostsThatAreNotPositiveHaveNoPercentages)
    {
        const ExperimentSummary summary = summarize(experimentOf("e", {{"a", {0.1, 0.0}}}), NEVER);
        EXPECT_EQ(summary.planners[0].levels[0].reached, 9U);
        EXPECT_EQ(summary.planners[0].levels[1].reached, 0U);
    }

    TEST(AnalysisTest, ExperimentWithoutAnyPathIsSummarised)
    {
        Experiment experiment = experimentOf("e", {{"a", {0.1, 1.0}}, {"b", {0.1, 1.0}}});
        for (PlannerResults &planner : experiment.planners)
        {
            planner.runs.assign(3, RunResult());
        }
        const ExperimentSummary summary = summarize(experiment, NEVER);
        EXPECT_EQ(summary.bestCost, NEVER);
        EXPECT_EQ(summary.planners[0].levels[1].reached, 0U);
        EXPECT_EQ(summary.planners[0].curve.back().cost.value, NEVER);
    }

    TEST(AnalysisTest, ComparisonIsOfCommonPlanners)
    {
        const std::vector<ExperimentSummary> summaries{
            summarize(experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.2, 11.0}}, {"c", {0.1, 10.0}}}), NEVER),
            summarize(experimentOf("f", {{"b", {0.1, 10.0}}, {"a", {0.4, 10.0}}}), NEVER),
            summarize(experimentOf("g", {{"a", {0.1, 10.0}}, {"b", {0.3, 10.0}}}), NEVER)};
        const Comparison comparison = compare(summaries);
        EXPECT_EQ(comparison.planners, (std::vector<std::string>{"a", "b"}));
        const PerformanceProfile &first = comparison.profiles.front();
        EXPECT_EQ(first.experiments, 3U);
        EXPECT_EQ(first.factors.front(), 1.0);
        EXPECT_NEAR(first.shares[0].front(), 2.0 / 3.0, 1e-12);
        EXPECT_NEAR(first.shares[1].front(), 1.0 / 3.0, 1e-12);
        EXPECT_EQ(first.shares[0].back(), 1.0);
        const Ranking &ranking = comparison.rankings.front();
        EXPECT_EQ(ranking.order, (std::vector<std::size_t>{0, 1}));
        EXPECT_NEAR(ranking.test.meanRanks[0], 4.0 / 3.0, 1e-12);
        EXPECT_EQ(ranking.againstBest[0], 1.0);
        // logarithms: -0.69, 1.39, -1.10, the ranks 1, 3, 2: both sums are 3 of 6
        EXPECT_NEAR(ranking.againstBest[1], 1.0, 1e-12);
        EXPECT_EQ(comparison.rankings.back().measure, "final cost");
    }

    TEST(AnalysisTest, PlannersThatNeverArriveHaveShareZero)
    {
        const std::vector<ExperimentSummary> summaries{
            summarize(experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.2, 20.0}}}), NEVER),
            summarize(experimentOf("f", {{"a", {0.1, 10.0}}, {"b", {0.2, 20.0}}}), 5.0)};
        const PerformanceProfile tenPercent = compare(summaries).profiles.at(1);
        EXPECT_EQ(tenPercent.level, "10 %");
        EXPECT_EQ(tenPercent.experiments, 1U);
        EXPECT_EQ(tenPercent.shares[0].back(), 1.0);
        EXPECT_EQ(tenPercent.shares[1].back(), 0.0);
    }

    TEST(AnalysisTest, NothingToCompareInOneExperimentOrWithoutCommonPlanners)
    {
        const ExperimentSummary first = summarize(experimentOf("e", {{"a", {0.1, 1.0}}, {"b", {0.1, 1.0}}}), NEVER);
        const ExperimentSummary other = summarize(experimentOf("f", {{"a", {0.1, 1.0}}, {"c", {0.1, 1.0}}}), NEVER);
        EXPECT_TRUE(compare({first}).planners.empty());
        EXPECT_TRUE(compare({first, other}).rankings.empty());
    }
}  // namespace ompl_mfa::report
