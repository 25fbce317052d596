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

#include "report/ReportTables.h"

#include <limits>

#include <gtest/gtest.h>

#include "report/ReportFixture.h"

using ompl_mfa::test::experimentOf;

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();
    }  // namespace

    TEST(ReportTablesTest, JsonHasTheTables)
    {
        const std::vector<Experiment> experiments{experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.2, 12.0}}}),
                                                  experimentOf("f", {{"a", {0.1, 10.0}}, {"b", {0.3, 12.0}}})};
        const std::vector<ExperimentSummary> summaries{summarize(experiments[0], NEVER),
                                                       summarize(experiments[1], 9.0)};
        const nlohmann::json tables = tablesAsJson(experiments, summaries, compare(summaries));
        const nlohmann::json &b = tables["experiments"][0]["planners"][1];
        EXPECT_EQ(b["planner"], "b");
        EXPECT_EQ(b["solved"], 9);
        EXPECT_EQ(b["final_cost"]["value"], 12.0);
        EXPECT_EQ(b["levels"][0]["time"]["value"], 0.2);
        EXPECT_EQ(b["levels"][0]["speed"]["value"], 0.5);
        EXPECT_EQ(b["levels"][0]["best_peer"], "a");
        EXPECT_TRUE(b["levels"][3]["time"]["value"].is_null());
        EXPECT_EQ(b["levels"][3]["speed_is"], "at most");
        EXPECT_EQ(tables["experiments"][1]["best_cost"], 9.0);
        EXPECT_EQ(tables["experiments"][1]["best_cost_is_reference"], true);
        EXPECT_EQ(tables["comparison"]["rankings"][0]["planners"][0]["planner"], "a");
        EXPECT_EQ(tables["comparison"]["profiles"][0]["shares"]["b"][0], 0.0);
    }

    TEST(ReportTablesTest, CellsHaveUnitsBoundsAndPeers)
    {
        const ExperimentSummary summary =
            summarize(experimentOf("e", {{"<a>", {0.1, 10.0}}, {"b", {0.2, 12.0}}}), NEVER);
        const std::string results = resultsTable(summary);
        EXPECT_NE(results.find("&lt;a&gt;"), std::string::npos);
        EXPECT_NE(results.find("<td>9 of 9</td>"), std::string::npos) << results;
        EXPECT_NE(results.find("<td>200 <span class=\"interval\">[200, 200]</span></td>"), std::string::npos)
            << results;
        const std::string ratios = ratiosTable(summary);
        EXPECT_NE(ratios.find("&gt; 10.0 "), std::string::npos) << ratios;
        EXPECT_NE(ratios.find("no other"), std::string::npos) << ratios;
        EXPECT_NE(ratios.find("<td class=\"ahead\">2.00 "), std::string::npos) << ratios;
        const std::string curves = curvesTable(summary);
        EXPECT_NE(curves.find("<td>100 %, 12.000</td>"), std::string::npos) << curves;
        EXPECT_NE(curves.find("<td>0 %, -</td>"), std::string::npos) << curves;
    }

    TEST(ReportTablesTest, CoverageOfFewRunsIsLow)
    {
        EXPECT_NEAR(lowestCoverage(summarize(experimentOf("e", {{"a", {0.1, 10.0}}}, 5), NEVER)), 0.9375, 1e-12);
        EXPECT_GE(lowestCoverage(summarize(experimentOf("e", {{"a", {0.1, 10.0}}, {"b", {0.1, 10.0}}}), NEVER)),
                  CONFIDENCE);
    }
}  // namespace ompl_mfa::report
