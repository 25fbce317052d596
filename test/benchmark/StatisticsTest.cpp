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

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include "benchmark/PlanarProblem.h"
#include "benchmark/TestPlanners.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "ompl_mfa/benchmark/ResultsDatabase.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace ompl_mfa::test;

namespace ompl_mfa::benchmark
{
    namespace
    {
        template <class T>
        CampaignPlanner entry(const std::string &name)
        {
            return {name, [](std::size_t) { return planarProblem(); },
                    [](const ob::SpaceInformationPtr &si) { return std::make_shared<T>(si); }};
        }

        CampaignPlanner hostile(const std::string &name, const ob::PlannerAllocator &allocator)
        {
            return {name, [](std::size_t) { return planarProblem(); }, allocator};
        }

        int shell(const std::string &command)
        {
            return std::system(command.c_str());  // NOLINT(bugprone-command-processor): the test's own files
        }

        std::string textOf(const std::filesystem::path &file)
        {
            std::ifstream in(file);
            std::stringstream text;
            text << in.rdbuf();
            return text.str();
        }

        /* Runs OMPL's own log reader on our logs, and SQL on its database. */
        class StatisticsTest : public testing::Test
        {
        protected:
            static void SetUpTestSuite()
            {
                installed_ = shell("command -v ompl_benchmark_statistics >/dev/null 2>&1") == 0;
                if (!installed_)
                {
                    return;
                }
                folder_ = std::filesystem::path(testing::TempDir()) / ("statistics_" + std::to_string(getpid()));
                std::filesystem::create_directories(folder_);
                makeLog(0.1, 3, "disc");
                makeLog(0.05, 1, "other");
                const std::string files = (folder_ / "disc.log").string() + " " + (folder_ / "other.log").string();
                status_ = shell("ompl_benchmark_statistics " + files + " -d " + (folder_ / "out.db").string() + " >" +
                                (folder_ / "stdout").string() + " 2>" + (folder_ / "stderr").string());
            }

            static void TearDownTestSuite()
            {
                if (installed_)
                {
                    std::filesystem::remove_all(folder_);
                }
            }

            void SetUp() override
            {
                if (!installed_)
                {
                    GTEST_SKIP() << "ompl_benchmark_statistics is not installed (Debian: ompl-demos)";
                }
            }

            static void makeLog(double timeLimit, unsigned int runs, const std::string &name)
            {
                CampaignDescription description;
                description.name = name;
                description.planners = {entry<og::RRTstar>("RRTstar"),          entry<og::RRTConnect>("RRTConnect"),
                                        entry<og::PRMstar>("PRMstar"),          entry<og::BITstar>("BITstar"),
                                        hostile("Crashing", crashingPlanner()), hostile("Hanging", hangingPlanner())};
                description.settings.timeLimit = timeLimit;
                description.settings.progressInterval = 0.001;
                description.runCount = runs;
                description.seed = 3;
                CampaignOptions options;
                options.log = folder_ / (name + ".log");
                options.grace = 0.3;
                options.overwrite = true;
                addToDatabase(folder_ / "own.db", Campaign(description).run(options).log);
            }

            /* The result of a query, columns separated by '|', rows by line breaks. */
            static std::string query(const std::string &sql)
            {
                const std::filesystem::path script = folder_ / "query.py";
                std::ofstream(script) << "import sqlite3, sys\n"
                                         "for row in sqlite3.connect(sys.argv[1]).execute(sys.argv[2]):\n"
                                         "    print('|'.join(str(value) for value in row))\n";
                shell("python3 " + script.string() + " " + (folder_ / "out.db").string() + " \"" + sql + "\" >" +
                      (folder_ / "answer").string() + " 2>&1");
                return textOf(folder_ / "answer");
            }

            static bool installed_;
            static int status_;
            static std::filesystem::path folder_;
        };

        bool StatisticsTest::installed_ = false;
        int StatisticsTest::status_ = -1;
        std::filesystem::path StatisticsTest::folder_;
    }  // namespace

    TEST_F(StatisticsTest, ReadsTheLogsWithoutAWarning)
    {
        EXPECT_EQ(status_, 0);
        EXPECT_EQ(textOf(folder_ / "stderr"), "");
        std::istringstream out(textOf(folder_ / "stdout"));
        std::string line;
        while (std::getline(out, line))
        {
            // "Matplotlib or Numpy was not found" concerns that program's own plots.
            EXPECT_TRUE(line.rfind("Processing ", 0) == 0 || line.rfind("Parsing data for ", 0) == 0 ||
                        line.rfind("Matplotlib", 0) == 0)
                << line;
        }
    }

    TEST_F(StatisticsTest, OurDatabaseIsThatOfTheConverter)
    {
        const std::filesystem::path script = folder_ / "compare.py";
        std::ofstream(script) << R"PY(
import sqlite3, sys

def rows(file, table):
    """All rows as dictionaries from columns to values, and the types of the columns."""
    database = sqlite3.connect(file)
    types = {row[1]: row[2] for row in database.execute(f"PRAGMA table_info({table})")
    }
    names = sorted(types)
    return [dict(zip(names, row)) for row in database.execute(
        "SELECT %s FROM %s ORDER BY rowid" % (",".join('"%s"' % name for name in names), table))], types

for table in ("experiments", "plannerConfigs", "enums", "runs", "progress"):
    ours, own_types = rows(sys.argv[1], table)
    theirs, their_types = rows(sys.argv[2], table)
    print(table, own_types == their_types, ours == theirs, len(theirs) > 0)
)PY";
        shell("python3 " + script.string() + " " + (folder_ / "own.db").string() + " " + (folder_ / "out.db").string() +
              " >" + (folder_ / "answer").string() + " 2>&1");
        EXPECT_EQ(textOf(folder_ / "answer"),
                  "experiments True True True\nplannerConfigs True True True\n"
                  "enums True True True\nruns True True True\nprogress True True True\n");
    }

    TEST_F(StatisticsTest, ExperimentsAndPlannersAreAllThere)
    {
        EXPECT_EQ(query("SELECT name, timelimit, memorylimit, runcount, seed, base_seed FROM experiments ORDER BY id"),
                  "disc|0.1|4096.0|3|3|3\nother|0.05|4096.0|1|3|3\n");
        EXPECT_EQ(query("SELECT version LIKE 'OMPL _%' FROM experiments GROUP BY 1"), "1\n");
        EXPECT_EQ(query("SELECT DISTINCT name FROM plannerConfigs ORDER BY name"),
                  "geometric_BITstar\ngeometric_Crashing\ngeometric_Hanging\ngeometric_PRMstar\ngeometric_RRTConnect\n"
                  "geometric_RRTstar\n");
    }

    TEST_F(StatisticsTest, EveryRunIsARow)
    {
        EXPECT_EQ(query("SELECT e.name, p.name, count(*), count(DISTINCT run), count(DISTINCT r.seed) FROM runs r "
                        "JOIN plannerConfigs p ON p.id = r.plannerid JOIN experiments e ON e.id = r.experimentid "
                        "WHERE e.name = 'disc' GROUP BY 1, 2"),
                  "disc|geometric_BITstar|3|3|3\ndisc|geometric_Crashing|3|3|3\ndisc|geometric_Hanging|3|3|3\n"
                  "disc|geometric_PRMstar|3|3|3\ndisc|geometric_RRTConnect|3|3|3\ndisc|geometric_RRTstar|3|3|3\n");
        // The same run of different planners has the same seed.
        EXPECT_EQ(query("SELECT run, count(DISTINCT seed) FROM runs GROUP BY run"), "0|1\n1|1\n2|1\n");
    }

    TEST_F(StatisticsTest, ColumnsHoldWhatTheirNamesSay)
    {
        EXPECT_EQ(
            query("SELECT count(*) FROM runs r JOIN plannerConfigs p ON p.id = r.plannerid WHERE solved = 1 AND NOT "
                  "(path_cost >= 7.9 AND simplified_path_cost <= path_cost + 1e-6 AND minimum_clearance > -0.01 AND "
                  "resampled_smoothness >= 0 AND collision_checks > 0 AND time_to_first_solution <= time AND status "
                  "= 6 AND termination = 0 AND signal IS NULL)"),
            "0\n");
        EXPECT_EQ(query("SELECT count(*) > 6 FROM runs WHERE solved = 1"), "1\n");
        EXPECT_EQ(
            query("SELECT p.name, e1.description, e2.description, signal, solved, path_cost, final_best_cost FROM "
                  "runs r JOIN plannerConfigs p ON p.id = r.plannerid JOIN enums e1 ON e1.name = 'status' AND "
                  "e1.value = r.status JOIN enums e2 ON e2.name = 'termination' AND e2.value = r.termination WHERE "
                  "p.name LIKE '%ing' GROUP BY p.name"),
            "geometric_Crashing|Crash|Signal|11|0|None|None\n"
            "geometric_Hanging|Timeout|Time limit enforced|9|0|None|7.0\n");
    }

    TEST_F(StatisticsTest, NoColumnIsInBothTables)
    {
        EXPECT_EQ(
            query("SELECT r.name FROM pragma_table_info('runs') r JOIN pragma_table_info('progress') p ON p.name = "
                  "r.name"),
            "time\n");
    }

    TEST_F(StatisticsTest, ProgressIsDenseAndFallsInCost)
    {
        // On a busy machine samples are missing while a planner runs; after it returns there is one each millisecond.
        EXPECT_EQ(
            query("SELECT count(*) > 0, min(samples - (0.1 - time) / 0.001) > -3 FROM (SELECT r.time AS time, "
                  "count(*) AS samples FROM progress g JOIN runs r ON r.id = g.runid JOIN experiments e ON e.id = "
                  "r.experimentid JOIN plannerConfigs p ON p.id = r.plannerid WHERE e.name = 'disc' AND p.name LIKE "
                  "'%RRTConnect' GROUP BY r.id)"),
            "1|1\n");
        EXPECT_EQ(
            query("SELECT max(rise) <= 0 FROM (SELECT best_cost - lag(best_cost) OVER (PARTITION BY runid ORDER BY "
                  "time) AS rise FROM progress)"),
            "1\n");
        EXPECT_EQ(
            query("SELECT count(DISTINCT p.name) FROM progress g JOIN runs r ON r.id = g.runid JOIN plannerConfigs p "
                  "ON p.id = r.plannerid WHERE best_cost IS NOT NULL"),
            "4\n");
    }
}  // namespace ompl_mfa::benchmark
