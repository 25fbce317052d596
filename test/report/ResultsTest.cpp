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

#include "report/Results.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        RecordedRun solvedRun()
        {
            RecordedRun run;
            run.values = {{"solved", "1"},
                          {"approximate_solution", "0"},
                          {"correct_solution", "1"},
                          {"time", "1.0"},
                          {"time_to_first_solution", "0.15"},
                          {"path_cost", "4"},
                          {"run", "3"},
                          {"seed", "77"}};
            run.progress = {{0.1, NEVER}, {0.2, 9.0}, {0.3, 9.0}, {0.5, 5.0}, {0.8, 4.0}};
            return run;
        }
    }  // namespace

    TEST(ResultsTest, TraceHasEveryImprovement)
    {
        const RunResult run = makeRunResult(solvedRun(), 1.0);
        EXPECT_TRUE(run.solved);
        EXPECT_EQ(run.run, "3");
        EXPECT_EQ(run.seed, "77");
        EXPECT_EQ(run.firstSolution, 0.15);
        EXPECT_EQ(run.finalCost, 4.0);
        const std::vector<std::pair<double, double>> expected{{0.2, 9.0}, {0.5, 5.0}, {0.8, 4.0}};
        EXPECT_EQ(run.trace, expected);
        EXPECT_EQ(run.costAt(0.19), NEVER);
        EXPECT_EQ(run.costAt(0.5), 5.0);
        EXPECT_EQ(run.costAt(2.0), 4.0);
        EXPECT_EQ(run.timeTo(9.0), 0.2);
        EXPECT_EQ(run.timeTo(4.5), 0.8);
        EXPECT_EQ(run.timeTo(3.9), NEVER);
    }

    TEST(ResultsTest, NoSampleIsCheaperThanTheReturnedPath)
    {
        RecordedRun recorded = solvedRun();
        recorded.values["path_cost"] = "6";
        const RunResult run = makeRunResult(recorded, 1.0);
        EXPECT_EQ(run.finalCost, 6.0);
        EXPECT_EQ(run.timeTo(6.0), 0.5);
        EXPECT_EQ(run.timeTo(5.9), NEVER);
    }

    TEST(ResultsTest, ReturnedPathThatIsCheaperCountsFromTheReturnOn)
    {
        RecordedRun recorded = solvedRun();
        recorded.values["path_cost"] = "3.5";
        EXPECT_EQ(makeRunResult(recorded, 1.0).timeTo(3.5), 1.0);
    }

    TEST(ResultsTest, PlannerWithoutBestCostHasItsPathsCostFromItsReturnOn)
    {
        RecordedRun recorded = solvedRun();
        recorded.progress.clear();
        recorded.values.erase("time_to_first_solution");
        recorded.values["time"] = "0.02";
        const RunResult run = makeRunResult(recorded, 1.0);
        EXPECT_EQ(run.firstSolution, 0.02);
        EXPECT_EQ(run.timeTo(4.0), 0.02);
    }

    TEST(ResultsTest, LengthIsTheCostWhereNoOtherIsRecorded)
    {
        RecordedRun recorded = solvedRun();
        recorded.values.erase("path_cost");
        recorded.values.erase("time_to_first_solution");
        EXPECT_EQ(makeRunResult(recorded, 1.0).finalCost, 4.0);
        EXPECT_EQ(makeRunResult(recorded, 1.0).firstSolution, 0.2);
        recorded.progress.clear();
        EXPECT_FALSE(makeRunResult(recorded, 1.0).solved);
        recorded.values["solution_length"] = "4.25";
        EXPECT_EQ(makeRunResult(recorded, 1.0).finalCost, 4.25);
    }

    TEST(ResultsTest, ApproximateInvalidAndUnfinishedRunsAreNotSolved)
    {
        for (const auto &[name, value] : {std::pair<const char *, const char *>{"solved", "0"},
                                          {"solved", ""},
                                          {"approximate_solution", "1"},
                                          {"correct_solution", "0"},
                                          {"termination", "4"},
                                          {"path_cost", "nan"}})
        {
            RecordedRun recorded = solvedRun();
            recorded.values[name] = value;
            if (std::string(name) == "path_cost")
            {
                recorded.progress.clear();
            }
            const RunResult run = makeRunResult(recorded, 1.0);
            EXPECT_FALSE(run.solved) << name << "=" << value;
            EXPECT_EQ(run.firstSolution, NEVER) << name;
            EXPECT_EQ(run.finalCost, NEVER) << name;
            EXPECT_TRUE(run.trace.empty()) << name;
            EXPECT_EQ(run.ended, std::string(name) == "termination") << name;
        }
    }

    TEST(ResultsTest, ImprovementsAfterTheLimitDoNotCount)
    {
        RecordedRun recorded = solvedRun();
        // 1.1 times the limit plus 50 ms: 0.6 s
        const RunResult run = makeRunResult(recorded, 0.5);
        EXPECT_TRUE(run.solved);
        EXPECT_EQ(run.finalCost, 5.0);
        recorded.values["time_to_first_solution"] = "0.7";
        EXPECT_FALSE(makeRunResult(recorded, 0.5).solved);
    }
}  // namespace ompl_mfa::report
