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

#include "report/ReportPage.h"

#include <limits>

#include <gtest/gtest.h>

#include "report/EmbeddedTexts.h"
#include "report/ReportFixture.h"

using ompl_mfa::test::experimentOf;

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        Report reportOf(const std::vector<Experiment> &experiments)
        {
            Report report;
            report.title = "A & B";
            report.experiments = experiments;
            for (const Experiment &experiment : experiments)
            {
                report.summaries.push_back(summarize(experiment, NEVER));
            }
            report.comparison = compare(report.summaries);
            report.command = "ompl_mfa report 'a b'";
            return report;
        }

        std::size_t countOf(const std::string &text, const std::string &part)
        {
            std::size_t count = 0;
            for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
            {
                ++count;
            }
            return count;
        }
    }  // namespace

    TEST(ReportPageTest, EverythingIsInThePage)
    {
        Report report = reportOf({experimentOf("first", {{"a", {0.1, 10.0}}, {"b", {0.2, 12.0}}}),
                                  experimentOf("second", {{"a", {0.1, 10.0}}, {"b", {0.2, 12.0}}})});
        report.pictures.push_back({"a picture", "data:image/png;base64,AAAA"});
        const std::string page = reportPage(report);
        EXPECT_NE(page.find("<h1>A &amp; B</h1>"), std::string::npos);
        EXPECT_EQ(countOf(page, "data-plot=\"solved\""), 2U);
        EXPECT_EQ(countOf(page, "data-plot=\"cost\""), 2U);
        EXPECT_EQ(countOf(page, "data-plot=\"runs\""), 2U);
        // first path, 10 %, 5 %, 1 %, 0.1 %
        EXPECT_EQ(countOf(page, "data-plot=\"profile\""), 5U);
        EXPECT_EQ(countOf(page, "class=\"ranks\""), 6U);
        EXPECT_NE(page.find("ompl_mfa report &#39;a b&#39;"), std::string::npos);
        EXPECT_NE(page.find("<img src=\"data:image/png;base64,AAAA\""), std::string::npos);
        EXPECT_NE(page.find(std::string(DYGRAPH_SCRIPT)), std::string::npos);
        EXPECT_EQ(page.find("src=\"http"), std::string::npos);
        EXPECT_EQ(page.find("sourceMappingURL"), std::string::npos);
        EXPECT_EQ(reportPage(report), page);
    }

    TEST(ReportPageTest, OneExperimentIsNotCompared)
    {
        const std::string page = reportPage(reportOf({experimentOf("only", {{"a", {0.1, 10.0}}})}));
        EXPECT_EQ(countOf(page, "data-plot=\"profile\""), 0U);
        EXPECT_EQ(page.find("<svg class=\"ranks\""), std::string::npos);
        EXPECT_EQ(page.find("Speed: median time"), std::string::npos);
        EXPECT_EQ(page.find("class=\"warning\""), std::string::npos);
    }

    TEST(ReportPageTest, TooFewRunsForTheIntervalsAreMentioned)
    {
        const std::string page = reportPage(reportOf({experimentOf("only", {{"a", {0.1, 10.0}}}, 3)}));
        EXPECT_NE(page.find("cover with only 75.0 %"), std::string::npos);
    }

    TEST(ReportPageTest, TextsOfTheProgramAreWhole)
    {
        EXPECT_NE(DYGRAPH_SCRIPT.find("dygraphs"), std::string_view::npos);
        EXPECT_GT(DYGRAPH_SCRIPT.size(), 100000U);
        EXPECT_NE(DYGRAPH_STYLE.find(".dygraph"), std::string_view::npos);
        EXPECT_NE(PAGE_STYLE.find("@media print"), std::string_view::npos);
        EXPECT_EQ(REPORT_SCRIPT.find('\0'), std::string_view::npos);
        EXPECT_EQ(REPORT_SCRIPT.substr(REPORT_SCRIPT.size() - 6), "})();\n");
        EXPECT_NE(SWARM_SCRIPT.find("pageData"), std::string_view::npos);
    }
}  // namespace ompl_mfa::report
