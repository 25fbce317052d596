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

#include "report/ResultsReader.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "benchmark/CampaignLog.h"
#include "campaign/RunJournal.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "ompl_mfa/benchmark/ResultsDatabase.h"

namespace ompl_mfa::report
{
    namespace
    {
        benchmark::RunRecord recordOf(const std::string &planner, unsigned int run, double time, double cost)
        {
            benchmark::RunRecord record;
            record.planner = planner;
            record.run = run;
            record.seed = 100 + run;
            record.termination = benchmark::RunTermination::Returned;
            record.properties = {{"solved BOOLEAN", "1"},
                                 {"approximate solution BOOLEAN", "0"},
                                 {"correct solution BOOLEAN", "1"},
                                 {"time REAL", "1"},
                                 {"path cost REAL", std::to_string(cost)},
                                 {"time to first solution REAL", std::to_string(time)},
                                 {"run INTEGER", std::to_string(run)},
                                 {"seed INTEGER", std::to_string(100 + run)}};
            record.setup = "Optimization Objective: Path Length @0x1\nProperties of benchmarked planners:\nnone\n";
            record.progressNames = {"iterations INTEGER", "best cost REAL"};
            record.progress = {{0.125, {"1", "inf"}}, {0.25, {"2", std::to_string(cost + 1)}}, {1.0, {"3", "nan"}}};
            return record;
        }

        class ResultsReaderTest : public testing::Test
        {
        protected:
            ResultsReaderTest()
              : folder_(std::filesystem::path(testing::TempDir()) / ("results_" + std::to_string(getpid())))
            {
                std::filesystem::create_directories(folder_);
            }

            ~ResultsReaderTest() override
            {
                std::filesystem::remove_all(folder_);
            }

            std::string path(const std::string &name) const
            {
                return (folder_ / name).string();
            }

            /* Writes a journal of the planners A and B with the runs \e first and the next one. */
            void writeJournal(const std::string &file, const std::string &campaign, unsigned int first,
                              const std::string &experiment = "e", std::uint64_t seed = 7) const
            {
                benchmark::BenchmarkLog head;
                head.version = "1.5.2";
                head.experiment = experiment;
                head.cpu = "Model name:   Some CPU\n";
                head.seed = seed;
                head.timeLimit = 1.0;
                head.runCount = 4;
                head.planners.resize(2);
                head.planners[0].name = "geometric_A";
                head.planners[1].name = "geometric_B";
                campaign::JournalHeader header;
                header.campaign = campaign;
                header.start = "2026-01-02 03:04:05";
                header.description = benchmark::toJson(head);
                campaign::RunJournal journal(file, header);
                for (unsigned int run = first; run < first + 2; ++run)
                {
                    journal.append(benchmark::toJson(recordOf("geometric_A", run, 0.2, 10.0 + run)), 0.0);
                    journal.append(benchmark::toJson(recordOf("geometric_B", run, 0.1, 20.0 + run)), 0.0);
                }
            }

            std::string errorOf(const std::vector<std::string> &files) const
            {
                try
                {
                    readResults(files);
                }
                catch (const InputError &error)
                {
                    return error.what();
                }
                return "";
            }

            std::filesystem::path folder_;
        };
    }  // namespace

    TEST_F(ResultsReaderTest, ReadsJournalsAndLogsBesideThem)
    {
        writeJournal(path("e.log.journal"), "c", 0);
        std::ofstream(path("e.log")) << "OMPL version 1.5.2\n";
        for (const std::string file : {"e.log", "e.log.journal"})
        {
            const std::vector<Experiment> experiments = readResults({path(file)});
            ASSERT_EQ(experiments.size(), 1U);
            const Experiment &experiment = experiments.front();
            EXPECT_EQ(experiment.name, "e");
            EXPECT_EQ(experiment.cpu, "Some CPU");
            EXPECT_EQ(experiment.objective, "Path Length");
            EXPECT_EQ(experiment.files, std::vector<std::string>{path("e.log.journal")});
            ASSERT_EQ(experiment.planners.size(), 2U);
            EXPECT_EQ(experiment.planners[0].name, "A");
            const RunResult &run = experiment.planners[0].runs[1];
            EXPECT_EQ(run.seed, "101");
            EXPECT_EQ(run.firstSolution, 0.2);
            EXPECT_EQ(run.finalCost, 11.0);
            EXPECT_EQ(run.timeTo(12.0), 0.25);
            EXPECT_EQ(run.timeTo(11.0), 1.0);
        }
    }

    TEST_F(ResultsReaderTest, ShardsOfACampaignAreJoined)
    {
        writeJournal(path("1.journal"), "c", 0);
        writeJournal(path("2.journal"), "c", 2);
        const std::vector<Experiment> experiments = readResults({path("1.journal"), path("2.journal")});
        ASSERT_EQ(experiments.size(), 1U);
        EXPECT_EQ(experiments.front().planners[0].runs.size(), 4U);
        EXPECT_EQ(experiments.front().files.size(), 2U);
        EXPECT_NE(errorOf({path("1.journal"), path("1.journal")}).find("run 0 of planner geometric_A"),
                  std::string::npos);
    }

    TEST_F(ResultsReaderTest, DatabaseOfACampaignHasTheSameResults)
    {
        writeJournal(path("e.journal"), "c", 0);
        benchmark::addToDatabase(path("e.db"), benchmark::assembleLog(benchmark::readCampaignRuns(path("e.journal"))));
        const Experiment journal = readResults({path("e.journal")}).front();
        const Experiment database = readResults({path("e.db")}).front();
        EXPECT_EQ(database.name, journal.name);
        EXPECT_EQ(database.version, journal.version);
        EXPECT_EQ(database.cpu, journal.cpu);
        EXPECT_EQ(database.objective, journal.objective);
        EXPECT_EQ(database.start, journal.start);
        EXPECT_EQ(database.seed, journal.seed);
        EXPECT_EQ(database.timeLimit, journal.timeLimit);
        ASSERT_EQ(database.planners.size(), journal.planners.size());
        for (std::size_t i = 0; i < journal.planners.size(); ++i)
        {
            EXPECT_EQ(database.planners[i].name, journal.planners[i].name);
            ASSERT_EQ(database.planners[i].runs.size(), journal.planners[i].runs.size());
            for (std::size_t run = 0; run < journal.planners[i].runs.size(); ++run)
            {
                EXPECT_EQ(database.planners[i].runs[run].trace, journal.planners[i].runs[run].trace);
                EXPECT_EQ(database.planners[i].runs[run].seed, journal.planners[i].runs[run].seed);
                EXPECT_EQ(database.planners[i].runs[run].firstSolution, journal.planners[i].runs[run].firstSolution);
            }
        }
    }

    TEST_F(ResultsReaderTest, CampaignsOfDifferentSeedsAreNotMixed)
    {
        writeJournal(path("1.journal"), "c", 0);
        writeJournal(path("2.journal"), "d", 0, "e", 8);
        EXPECT_EQ(errorOf({path("1.journal"), path("2.journal")}), "experiment e has seed 7 in " + path("1.journal") +
                                                                       " and 8 in " + path("2.journal") +
                                                                       ": such runs cannot be compared");
        writeJournal(path("2.journal"), "d", 0, "f", 8);
        EXPECT_EQ(readResults({path("1.journal"), path("2.journal")}).size(), 2U);
    }

    TEST_F(ResultsReaderTest, OtherFilesAreRejected)
    {
        EXPECT_EQ(errorOf({path("none")}), path("none") + ": cannot be read, or is empty");
        EXPECT_EQ(errorOf({folder_.string()}), folder_.string() + ": cannot be read, or is empty");
        std::ofstream(path("a.log")) << "OMPL version 1.5.2\nExperiment a\n";
        EXPECT_EQ(errorOf({path("a.log")}),
                  path("a.log") + ": logs are read from their journals, and there is no " + path("a.log.journal") +
                      "; a database that ompl_benchmark_statistics makes of the log is accepted");
        std::ofstream(path("a.txt")) << "time,cost\n1,2\n";
        EXPECT_NE(errorOf({path("a.txt")}).find("a.txt: unknown kind of file; accepted are"), std::string::npos);
        std::ofstream(path("a.json")) << "{\"a\": 1}\n";
        EXPECT_NE(errorOf({path("a.json")}).find("a.json:1: "), std::string::npos) << errorOf({path("a.json")});
    }

    TEST(ResultsReaderTextTest, ObjectiveAndProcessorOfDescriptions)
    {
        EXPECT_EQ(objectiveIn("a\nOptimization Objective: Path Length @0x12\nb"), "Path Length");
        EXPECT_EQ(objectiveIn("a\nb"), "");
        EXPECT_EQ(processorIn("CPU(s):  2\nModel name:   X 3000\nFlags: a"), "X 3000");
        EXPECT_EQ(processorIn("processor\t: 0\nmodel name\t: Y\n"), "Y");
        EXPECT_EQ(processorIn("one\ntwo\n"), "one two");
        EXPECT_EQ(processorIn("Model name:\n"), "");
        EXPECT_EQ(plainPlannerName("geometric_RRT"), "RRT");
        EXPECT_EQ(plainPlannerName("geometric_"), "geometric_");
        EXPECT_EQ(plainPlannerName("RRT"), "RRT");
    }
}  // namespace ompl_mfa::report
