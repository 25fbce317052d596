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

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/ConfigFixture.h"
#include "cli/RunProgram.h"

namespace
{
    /* A campaign of two planners with two runs each. */
    class ReportTest : public ConfigFixture
    {
    protected:
        ReportTest()
        {
            const std::string file = config("start.x = 1\nstart.y = 3\n", "mfa =\nrrtconnect =\n");
            std::string text = readFile(file);
            text.insert(text.find("world ="), "name = two walls\n");
            text.replace(text.find("time_limit = 0.5"), 16, "time_limit = 0.1\nrun_count = 2");
            write("a.cfg", text);
            const ProgramResult result = runProgram("benchmark " + path("a.cfg") + " --output " + path("a.log") +
                                                    " --database " + path("a.db") + " --quiet");
            EXPECT_EQ(result.status, 0) << result.err;
        }
    };

    nlohmann::json tablesOf(const std::string &arguments)
    {
        const ProgramResult result = runProgram("report " + arguments + " --json");
        EXPECT_EQ(result.status, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }

    TEST_F(ReportTest, JournalsLogsAndDatabasesHaveTheSameTables)
    {
        nlohmann::json log = tablesOf(path("a.log"));
        const nlohmann::json journal = tablesOf(path("a.log.journal"));
        EXPECT_EQ(log, journal);
        const nlohmann::json &experiment = journal["experiments"][0];
        EXPECT_EQ(experiment["experiment"], "two_walls");
        EXPECT_EQ(experiment["time_limit"], 0.1);
        EXPECT_EQ(experiment["seed"], "5");
        EXPECT_EQ(experiment["objective"], "Path Length");
        ASSERT_EQ(experiment["planners"].size(), 2U);
        const nlohmann::json &mfa = experiment["planners"][0];
        EXPECT_EQ(mfa["planner"], "MFA");
        EXPECT_EQ(mfa["runs"], 2);
        EXPECT_EQ(mfa["solved"], 2);
        EXPECT_NEAR(mfa["final_cost"]["value"], 9.65, 0.1);
        EXPECT_EQ(experiment["best_cost"], mfa["final_cost"]["lower"]);

        const nlohmann::json database = tablesOf(path("a.db"));
        for (std::size_t i = 0; i < 2; ++i)
        {
            const nlohmann::json &inDatabase = database["experiments"][0]["planners"][i];
            EXPECT_EQ(inDatabase["planner"], experiment["planners"][i]["planner"]);
            EXPECT_EQ(inDatabase["final_cost"], experiment["planners"][i]["final_cost"]);
            EXPECT_EQ(inDatabase["success"], experiment["planners"][i]["success"]);
        }
    }

    TEST_F(ReportTest, PageHasResultsPicturesAndTheCommand)
    {
        write("picture one.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
        const std::string arguments = path("a.log") + " --output " + path("r.html") + " --picture '" +
                                      path("picture one.svg") + "' --title 'A <title>' --reference 'two_walls=9.5'";
        const ProgramResult result = runProgram("report " + arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.out, path("r.html") + ": 4 runs in 1 experiments\n");
        const std::string page = readFile(path("r.html"));
        EXPECT_NE(page.find("<h1>A &lt;title&gt;</h1>"), std::string::npos);
        EXPECT_NE(page.find("<figcaption>picture one</figcaption><img src=\"data:image/svg+xml;base64,"),
                  std::string::npos);
        EXPECT_NE(page.find("--reference two_walls=9.5"), std::string::npos);
        EXPECT_NE(page.find("9.5 (given)"), std::string::npos) << page.substr(page.find("best known cost"), 100);
        EXPECT_NE(page.find("<noscript>"), std::string::npos);
        // the same results yield the same page
        runProgram("report " + arguments);
        EXPECT_EQ(readFile(path("r.html")), page);
    }

    TEST_F(ReportTest, ErrorsAreOneLine)
    {
        write("a.txt", "text\n");
        write("b.log", "OMPL version 1.5.2\n");
        expectBadInput("report " + path("a.txt") + " -o " + path("r.html"), {"a.txt", "unknown kind of file"});
        expectBadInput("report " + path("b.log") + " -o " + path("r.html"), {"b.log.journal", "database"});
        expectBadInput("report " + path("none") + " -o " + path("r.html"), {"none: cannot be read"});
        expectBadInput("report -o " + path("r.html"), {"RESULTS"});
        expectBadInput("report " + path("a.log"), {"--output is required"});
        expectBadInput("report " + path("a.log") + " " + path("a.db") + " -o " + path("r.html"),
                       {"is in", "again in", "give only one of them"});
        expectBadInput("report " + path("a.log") + " -o " + path("no/r.html"), {"--output", "cannot be written"});
        expectBadInput("report " + path("a.log") + " -o " + path("r.html") + " --picture " + path("a.txt"),
                       {"--picture", ".svg or .png"});
        expectBadInput("report " + path("a.log") + " -o " + path("r.html") + " --reference 9", {"EXPERIMENT=COST"});
        expectBadInput("report " + path("a.log") + " -o " + path("r.html") + " --reference 'two_wals=9'",
                       {"two_wals", "two_walls"});
        EXPECT_FALSE(std::filesystem::exists(path("r.html")));
    }
}  // namespace
