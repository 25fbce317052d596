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

#include "ompl_mfa/benchmark/ResultsDatabase.h"

#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        BenchmarkLog someLog(const std::string &campaign)
        {
            BenchmarkLog log;
            log.version = "1.5.2";
            log.experiment = "two words";
            log.properties = {{"campaign TEXT", campaign}, {"base-seed INTEGER", "7"}};
            log.host = "host";
            log.start = "2026-01-02 03:04:05";
            log.runCount = 2;
            log.enums = {{"status", {"Unknown", "Invalid start"}}};
            PlannerLog planner;
            planner.name = "geometric_A";
            planner.common = {{"range", "0"}};
            planner.runs = {{{"time REAL", "0.5"}, {"path cost REAL", "1.25"}, {"solved BOOLEAN", "1"}},
                            {{"time REAL", "1"}, {"path cost REAL", "inf"}}};
            planner.progressNames = {"best cost REAL"};
            planner.progress = {{{0.1, {"2"}}, {0.1, {"3"}}, {0.2, {"nan"}}}, {}};
            log.planners = {planner};
            return log;
        }

        class ResultsDatabaseTest : public testing::Test
        {
        protected:
            ResultsDatabaseTest()
              : folder_(std::filesystem::path(testing::TempDir()) / ("database_" + std::to_string(getpid())))
              , file_(folder_ / "results.db")
            {
                std::filesystem::create_directories(folder_);
            }

            ~ResultsDatabaseTest() override
            {
                std::filesystem::remove_all(folder_);
            }

            /* The values of all rows, separated by '|', rows by ';'. */
            std::string query(const std::string &sql) const
            {
                std::string text;
                sqlite3 *database = nullptr;
                sqlite3_open(file_.c_str(), &database);
                const auto addRow = [](void *rows, int count, char **values, char **)
                {
                    for (int i = 0; i < count; ++i)
                    {
                        *static_cast<std::string *>(rows) +=
                            std::string(values[i] == nullptr ? "NULL" : values[i]) + (i + 1 < count ? "|" : ";");
                    }
                    return 0;
                };
                EXPECT_EQ(sqlite3_exec(database, sql.c_str(), addRow, &text, nullptr), SQLITE_OK)
                    << sqlite3_errmsg(database);
                sqlite3_close(database);
                return text;
            }

            std::string errorOf(const std::filesystem::path &file) const
            {
                try
                {
                    addToDatabase(file, someLog("a"));
                }
                catch (const InputError &error)
                {
                    return error.what();
                }
                return "";
            }

            std::filesystem::path folder_;
            std::filesystem::path file_;
        };
    }  // namespace

    TEST_F(ResultsDatabaseTest, HoldsRunsAndProgress)
    {
        addToDatabase(file_, someLog("a"));
        EXPECT_EQ(query("SELECT name, version, campaign, base_seed, runcount FROM experiments"),
                  "two_words|OMPL 1.5.2|a|7|2;");
        EXPECT_EQ(query("SELECT time, path_cost, solved FROM runs"), "0.5|1.25|1;1.0|NULL|NULL;");
        EXPECT_EQ(query("SELECT runid, time, best_cost FROM progress"), "1|0.1|2.0;1|0.2|NULL;");
        EXPECT_EQ(query("SELECT value, description FROM enums"), "0|Unknown;1|Invalid start;");
        EXPECT_EQ(query("SELECT name, settings FROM plannerConfigs"), "geometric_A|range = 0\n;;");
    }

    TEST_F(ResultsDatabaseTest, CampaignsAreAddedAndPlannersShared)
    {
        addToDatabase(file_, someLog("a"));
        BenchmarkLog other = someLog("b");
        other.planners[0].runs[0]["new column INTEGER"] = "3";
        addToDatabase(file_, other);
        EXPECT_EQ(query("SELECT id, campaign FROM experiments"), "1|a;2|b;");
        EXPECT_EQ(query("SELECT experimentid, plannerid, new_column FROM runs"), "1|1|NULL;1|1|NULL;2|1|3;2|1|NULL;");
    }

    TEST_F(ResultsDatabaseTest, AnEarlierPartOfACampaignIsReplaced)
    {
        BenchmarkLog part = someLog("a");
        part.planners[0].runs.pop_back();
        part.planners[0].progress.pop_back();
        addToDatabase(file_, part);
        addToDatabase(file_, someLog("b"));
        addToDatabase(file_, someLog("a"));
        EXPECT_EQ(query("SELECT campaign, count(*) FROM experiments GROUP BY 1"), "a|1;b|1;");
        EXPECT_EQ(query("SELECT campaign, count(*) FROM runs JOIN experiments e ON e.id = experimentid GROUP BY 1"),
                  "a|2;b|2;");
        EXPECT_EQ(query("SELECT count(*) FROM progress WHERE runid NOT IN (SELECT id FROM runs)"), "0;");
    }

    TEST_F(ResultsDatabaseTest, NamesThatSqlWouldMisreadAreColumns)
    {
        BenchmarkLog log = someLog("a");
        log.planners[0].runs[0]["order by \"x\"; drop table runs INTEGER"] = "3";
        addToDatabase(file_, log);
        EXPECT_EQ(query("SELECT \"order_by_\"\"x\"\";_drop_table_runs\" FROM runs"), "3;NULL;");
    }

    TEST_F(ResultsDatabaseTest, ErrorsNameTheFileAndLoseNothing)
    {
        EXPECT_EQ(errorOf(folder_ / "none" / "results.db"),
                  (folder_ / "none" / "results.db").string() +
                      ": cannot be written as a database of results: unable to open database file");
        std::ofstream(file_) << "This is not a database, but a text of some length.\n";
        EXPECT_NE(errorOf(file_).find("file is not a database"), std::string::npos) << errorOf(file_);
        EXPECT_THROW(prepareDatabase(file_), InputError);
    }

    TEST_F(ResultsDatabaseTest, WhatCannotBeWrittenWholeIsNotWritten)
    {
        addToDatabase(file_, someLog("a"));
        BenchmarkLog broken = someLog("b");
        broken.planners[0].runs[0]["bad )type"] = "3";
        EXPECT_THROW(addToDatabase(file_, broken), InputError);
        EXPECT_EQ(query("SELECT campaign FROM experiments"), "a;");
        EXPECT_EQ(query("SELECT count(*) FROM runs"), "2;");
    }
}  // namespace ompl_mfa::benchmark
