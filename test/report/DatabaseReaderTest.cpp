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

#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"
#include "report/ResultsReader.h"

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        /* What ompl_benchmark_statistics makes of a log of OMPL's own Benchmark, with few columns. */
        const char *const FOREIGN = R"(
            CREATE TABLE experiments (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512), totaltime REAL,
                timelimit REAL, memorylimit REAL, runcount INTEGER, version VARCHAR(128), hostname VARCHAR(1024),
                cpuinfo TEXT, date DATETIME, seed INTEGER, setup TEXT);
            CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512), settings TEXT);
            CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, experimentid INTEGER, plannerid INTEGER,
                approximate_solution BOOLEAN, correct_solution BOOLEAN, solved BOOLEAN, time REAL,
                solution_length REAL);
            CREATE TABLE progress (runid INTEGER, time REAL, best_cost REAL, PRIMARY KEY (runid, time));
            INSERT INTO experiments VALUES (1, 'first', 9, 2.5, 1000, 2, 'OMPL 1.6.0', 'host',
                'processor : 0' || char(10) || 'model name  : Some CPU' || char(10), '2024-01-02 03:04:05', 42,
                'Optimization Objective: Path Length @0x1' || char(10)), (2, 'second', 9, 1, 1000, 1, 'OMPL 1.6.0',
                'host', '', '2024-01-02 03:04:06', 42, '');
            INSERT INTO plannerConfigs VALUES (1, 'geometric_RRTstar', ''), (2, 'geometric_RRT', ''),
                (3, 'geometric_RRT', 'goal_bias = 0.1');
            INSERT INTO runs VALUES (1, 1, 1, 0, 1, 1, 2.5, 7), (2, 1, 1, 1, 0, 1, 2.5, 3),
                (3, 1, 2, 0, 1, 1, 0.125, 9), (4, 1, 3, 0, 1, 1, 0.25, 8), (5, 2, 2, 0, 1, 1, 0.5, 6);
            INSERT INTO progress VALUES (1, 0.5, 8.25), (1, 0.25, NULL), (1, 1.5, 7);)";

        class DatabaseReaderTest : public testing::Test
        {
        protected:
            DatabaseReaderTest()
              : file_(testing::TempDir() + "foreign_" + std::to_string(getpid()) + ".db")
            {
            }

            ~DatabaseReaderTest() override
            {
                std::filesystem::remove(file_);
            }

            void make(const std::string &sql) const
            {
                std::filesystem::remove(file_);
                sqlite3 *database = nullptr;
                sqlite3_open(file_.c_str(), &database);
                EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
                    << sqlite3_errmsg(database);
                sqlite3_close(database);
            }

            std::string errorOf() const
            {
                try
                {
                    readResults({file_});
                }
                catch (const InputError &error)
                {
                    return error.what();
                }
                return "";
            }

            std::string file_;
        };
    }  // namespace

    TEST_F(DatabaseReaderTest, ReadsDatabasesOfOthers)
    {
        make(FOREIGN);
        const std::vector<Experiment> experiments = readResults({file_});
        ASSERT_EQ(experiments.size(), 2U);
        const Experiment &first = experiments[0];
        EXPECT_EQ(first.name, "first");
        EXPECT_EQ(first.version, "OMPL 1.6.0");
        EXPECT_EQ(first.cpu, "Some CPU");
        EXPECT_EQ(first.objective, "Path Length");
        EXPECT_EQ(first.seed, "42");
        EXPECT_EQ(first.timeLimit, 2.5);
        EXPECT_EQ(first.start, "2024-01-02 03:04:05");
        ASSERT_EQ(first.planners.size(), 3U);
        EXPECT_EQ(first.planners[0].name, "RRTstar");
        const RunResult &run = first.planners[0].runs[0];
        EXPECT_EQ(run.firstSolution, 0.5);
        EXPECT_EQ(run.finalCost, 7.0);
        EXPECT_EQ(run.costAt(1.0), 8.25);
        EXPECT_FALSE(first.planners[0].runs[1].solved);
        EXPECT_EQ(first.planners[0].runs[1].finalCost, NEVER);
        EXPECT_EQ(first.planners[1].runs[0].firstSolution, 0.125);
        EXPECT_EQ(first.planners[2].name, "RRT (2)");
        EXPECT_EQ(experiments[1].planners[0].runs[0].finalCost, 6.0);
    }

    TEST_F(DatabaseReaderTest, ProgressIsNotNeeded)
    {
        make(std::string(FOREIGN) + "DROP TABLE progress;");
        const RunResult run = readResults({file_}).front().planners.front().runs.front();
        EXPECT_EQ(run.firstSolution, 2.5);
        EXPECT_EQ(run.finalCost, 7.0);
    }

    TEST_F(DatabaseReaderTest, ErrorsNameTheFile)
    {
        make(std::string(FOREIGN) + "DROP TABLE runs;");
        EXPECT_EQ(errorOf(), file_ + ": has no table runs, as databases of ompl_benchmark_statistics do");
        make(std::string(FOREIGN) + "DELETE FROM runs;");
        EXPECT_EQ(errorOf(), file_ + ": there are no runs");
        std::ofstream(file_, std::ios::trunc) << "SQLite format 3" << '\0' << std::string(2000, 'x');
        EXPECT_EQ(errorOf().rfind(file_ + ": cannot be read as a database of results: ", 0), 0U) << errorOf();
    }

    TEST_F(DatabaseReaderTest, ExperimentsOfOneNameAreJoinedOnlyIfTheyCanBeCompared)
    {
        make(std::string(FOREIGN) +
             "UPDATE experiments SET name = 'same', timelimit = 1; "
             "UPDATE runs SET plannerid = 3 WHERE id = 4; DELETE FROM runs WHERE id = 3;");
        // RRT with other settings in the first experiment has the name of that of the second one
        EXPECT_EQ(errorOf(), "planner RRT of experiment same is in " + file_ + " and again in " + file_ +
                                 ": give only one of them");
        make(std::string(FOREIGN) + "UPDATE experiments SET name = 'same'; DELETE FROM runs WHERE id IN (3, 4);");
        EXPECT_EQ(errorOf(), "experiment same has time limit 2.5 in " + file_ + " and 1 in " + file_ +
                                 ": such runs cannot be compared");
        make(std::string(FOREIGN) +
             "UPDATE experiments SET name = 'same', timelimit = 1; DELETE FROM runs WHERE id IN (3, 4);");
        const std::vector<Experiment> joined = readResults({file_});
        ASSERT_EQ(joined.size(), 1U);
        EXPECT_EQ(joined.front().planners.size(), 2U);
        EXPECT_EQ(joined.front().files, std::vector<std::string>{file_});
    }

    TEST_F(DatabaseReaderTest, MaximisedObjectivesAreAnError)
    {
        make(std::string(FOREIGN) +
             "UPDATE experiments SET setup = 'Optimization Objective: Maximizing Minimum "
             "Clearance @0x1' || char(10) WHERE id = 2;");
        EXPECT_EQ(errorOf(), file_ +
                                 ": experiment second has the objective 'Maximizing Minimum Clearance'; only "
                                 "objectives that are minimised are accepted");
    }

    TEST_F(DatabaseReaderTest, MixedSeedsAreAnError)
    {
        make(std::string(FOREIGN) +
             "ALTER TABLE runs ADD run INTEGER; ALTER TABLE runs ADD seed INTEGER; "
             "UPDATE runs SET run = 0, seed = 5 WHERE id IN (1, 3); "
             "UPDATE runs SET run = 0, seed = 6 WHERE id = 4;");
        EXPECT_EQ(errorOf(), file_ + ": run 0 of experiment first has seed 5 for RRTstar and seed 6 for RRT (2)");
    }
}  // namespace ompl_mfa::report
