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

#include "ompl_mfa/benchmark/Campaign.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include "benchmark/CampaignLog.h"
#include "benchmark/CampaignMerge.h"
#include "benchmark/InputErrorOf.h"
#include "benchmark/PlanarProblem.h"
#include "benchmark/TestPlanners.h"
#include "campaign/Campaign.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace ompl_mfa::test;
using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::benchmark
{
    namespace
    {
        template <class T>
        ob::PlannerAllocator planner(const std::string &name)
        {
            return [name](const ob::SpaceInformationPtr &si)
            {
                const auto made = std::make_shared<T>(si);
                made->setName(name);
                return made;
            };
        }

        CampaignPlanner entry(const std::string &name, const ob::PlannerAllocator &allocator)
        {
            return {name, [](std::size_t) { return planarProblem(); }, allocator};
        }

        CampaignDescription peacefulDescription()
        {
            CampaignDescription description;
            description.name = "disc";
            description.planners = {entry("RRTConnect", planner<og::RRTConnect>("RRTConnect")),
                                    entry("RRTstar", planner<og::RRTstar>("RRTstar"))};
            description.settings.timeLimit = 0.1;
            description.runCount = 3;
            return description;
        }

        /* A planner that takes time and solves nothing. */
        ob::PlannerAllocator slowPlanner(const std::string &name, int milliseconds)
        {
            return testPlanner(name,
                               [milliseconds](const ob::PlannerTerminationCondition &)
                               {
                                   std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
                                   return ob::PlannerStatus::TIMEOUT;
                               });
        }

        CampaignDescription slowDescription()
        {
            CampaignDescription description;
            description.name = "slow";
            description.planners = {entry("A", slowPlanner("A", 50)), entry("B", slowPlanner("B", 50))};
            description.settings.timeLimit = 5.0;
            description.runCount = 10;
            return description;
        }

        /* A separate folder for each test. */
        class CampaignTest : public testing::Test
        {
        protected:
            void SetUp() override
            {
                folder_ = std::filesystem::path(testing::TempDir()) / ("campaign_" + std::to_string(getpid()));
                std::filesystem::create_directories(folder_);
                options_.log = folder_ / "test.log";
            }

            void TearDown() override
            {
                std::filesystem::remove_all(folder_);
            }

            std::string logText() const
            {
                std::ifstream in(options_.log);
                std::stringstream text;
                text << in.rdbuf();
                return text.str();
            }

            /* The log made of the runs in the journal: the expected content of the log file. */
            BenchmarkLog logOnDisk() const
            {
                BenchmarkLog log = assembleLog(readCampaignRuns(Campaign::journalFile(options_.log)));
                std::ostringstream text;
                writeBenchmarkLog(text, log);
                EXPECT_EQ(logText(), text.str());
                return log;
            }

            std::size_t journalRuns() const
            {
                std::ifstream in(Campaign::journalFile(options_.log));
                std::string line;
                std::size_t lines = 0;
                while (std::getline(in, line) && !in.eof())
                {
                    ++lines;
                }
                return lines == 0 ? 0 : lines - 1;
            }

            /* Runs \e campaign in another process and waits until \e runs of its runs are in the journal. */
            pid_t startElsewhere(const Campaign &campaign, std::size_t runs) const
            {
                const pid_t pid = fork();
                if (pid == 0)
                {
                    const CampaignResult result = campaign.run(options_);
                    _exit(result.interruptedBy);
                }
                while (journalRuns() < runs)
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(2));
                }
                return pid;
            }

            std::filesystem::path folder_;
            CampaignOptions options_;
        };

        std::string value(const LogProperties &run, const std::string &property)
        {
            const auto found = run.find(property);
            return found == run.end() ? "" : found->second;
        }
    }  // namespace

    TEST_F(CampaignTest, LogsEveryRunOfEveryPlanner)
    {
        const Campaign campaign(peacefulDescription());
        campaign.validate();
        const CampaignResult result = campaign.run(options_);
        EXPECT_EQ(result.interruptedBy, 0);
        EXPECT_EQ(result.missing, 0u);
        const BenchmarkLog log = logOnDisk();
        ASSERT_EQ(log.planners.size(), 2u);
        EXPECT_EQ(log.planners[0].name, "geometric_RRTConnect");
        EXPECT_EQ(log.planners[1].name, "geometric_RRTstar");
        EXPECT_EQ(log.properties.at("base_seed INTEGER"), "1");
        EXPECT_FALSE(log.version.empty());
        for (const PlannerLog &planned : log.planners)
        {
            ASSERT_EQ(planned.runs.size(), 3u);
            ASSERT_EQ(planned.progress.size(), 3u);
            for (unsigned int run = 0; run < 3; ++run)
            {
                EXPECT_EQ(value(planned.runs[run], "run INTEGER"), std::to_string(run));
                EXPECT_EQ(value(planned.runs[run], "seed INTEGER"), std::to_string(runSeed(1, run)));
                EXPECT_EQ(value(planned.runs[run], "solved BOOLEAN"), "1");
                EXPECT_FALSE(planned.progress[run].empty());
            }
        }
        EXPECT_EQ(logText().find("-nan"), std::string::npos);
    }

    TEST_F(CampaignTest, NoProgressPropertyIsARunProperty)
    {
        CampaignDescription description = peacefulDescription();
        description.planners.push_back(entry("PRM", planner<og::PRM>("PRM")));
        const Campaign campaign(description);
        const BenchmarkLog log = campaign.run(options_).log;
        std::set<std::string> progress;
        for (const PlannerLog &planned : log.planners)
        {
            progress.insert(planned.progressNames.begin(), planned.progressNames.end());
        }
        EXPECT_GE(progress.size(), 3u);
        for (const PlannerLog &planned : log.planners)
        {
            for (const LogProperties &run : planned.runs)
            {
                for (const auto &property : run)
                {
                    EXPECT_EQ(progress.count(property.first), 0u) << property.first;
                }
            }
        }
        EXPECT_FALSE(value(log.planners[1].runs[0], "final iterations INTEGER").empty());
    }

    TEST_F(CampaignTest, SurvivesItsPlanners)
    {
        CampaignDescription description;
        description.name = "hostile";
        description.planners = {entry("Crashing", crashingPlanner()),
                                entry("Aborting", abortingPlanner()),
                                entry("Hanging", hangingPlanner()),
                                entry("Allocating", allocatingPlanner()),
                                entry("Throwing", throwingPlanner()),
                                entry("Exiting", exitingPlanner()),
                                entry("RRTConnect", planner<og::RRTConnect>("RRTConnect"))};
        description.settings.timeLimit = 0.2;
        description.settings.memoryLimit = 60.0;
        description.runCount = 2;
        options_.grace = 0.3;
        const Campaign campaign(description);
        campaign.validate();
        // How much memory a process fills in 0.5 s on a busy machine varies, so it gets more time.
        options_.jobs = 2;
        const CampaignResult result = campaign.run(options_);
        EXPECT_EQ(result.missing, 0u);

        const BenchmarkLog log = logOnDisk();
        ASSERT_EQ(log.planners.size(), 7u);
        struct Expected
        {
            int status;
            RunTermination termination;
            std::string signal;
        };
        const std::map<std::string, Expected> expected = {
            {"geometric_Crashing", {ob::PlannerStatus::CRASH, RunTermination::Signal, std::to_string(SIGSEGV)}},
            {"geometric_Aborting", {ob::PlannerStatus::CRASH, RunTermination::Signal, std::to_string(SIGABRT)}},
            {"geometric_Hanging", {ob::PlannerStatus::TIMEOUT, RunTermination::TimeLimit, std::to_string(SIGKILL)}},
            {"geometric_Throwing", {ob::PlannerStatus::CRASH, RunTermination::Exception, ""}},
            {"geometric_Exiting", {ob::PlannerStatus::CRASH, RunTermination::Exited, ""}},
            {"geometric_RRTConnect", {ob::PlannerStatus::EXACT_SOLUTION, RunTermination::Returned, ""}}};
        for (const PlannerLog &planned : log.planners)
        {
            ASSERT_EQ(planned.runs.size(), 2u) << planned.name;
            for (const LogProperties &run : planned.runs)
            {
                if (planned.name == "geometric_Allocating")
                {
                    const int termination = std::stoi(value(run, "termination ENUM"));
                    EXPECT_TRUE(termination == static_cast<int>(RunTermination::MemoryLimit) ||
                                termination == static_cast<int>(RunTermination::TimeLimit));
                    EXPECT_EQ(value(run, "solved BOOLEAN"), "0");
                    continue;
                }
                const Expected &wanted = expected.at(planned.name);
                EXPECT_EQ(value(run, "status ENUM"), std::to_string(wanted.status)) << planned.name;
                EXPECT_EQ(value(run, "termination ENUM"), std::to_string(static_cast<int>(wanted.termination)))
                    << planned.name;
                EXPECT_EQ(value(run, "signal INTEGER"), wanted.signal) << planned.name;
            }
        }
        // Results known when the process was killed are kept.
        EXPECT_EQ(std::stod(value(log.planners[2].runs[0], "final best cost REAL")), 7.0);
        EXPECT_EQ(logText().find("-nan"), std::string::npos);
    }

    TEST_F(CampaignTest, MemoryWithoutEndIsStoppedAtItsLimit)
    {
        CampaignDescription description = peacefulDescription();
        description.planners = {entry("Allocating", allocatingPlanner())};
        description.settings.timeLimit = 60.0;
        description.settings.memoryLimit = 60.0;
        description.runCount = 1;
        const CampaignResult result = Campaign(description).run(options_);
        const LogProperties &run = result.log.planners.at(0).runs.at(0);
        EXPECT_EQ(value(run, "termination ENUM"), std::to_string(static_cast<int>(RunTermination::MemoryLimit)));
        EXPECT_EQ(value(run, "status ENUM"), std::to_string(static_cast<int>(ob::PlannerStatus::ABORT)));
    }

    TEST_F(CampaignTest, ResumesAfterBeingKilled)
    {
        const Campaign campaign(slowDescription());
        const pid_t pid = startElsewhere(campaign, 4);
        kill(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
        EXPECT_FALSE(std::filesystem::exists(options_.log));

        EXPECT_NE(inputErrorOf([&] { campaign.run(options_); }).find("--resume continues it"), std::string::npos);
        options_.resume = true;
        // A second campaign on the same journal would mix its runs into this one.
        const std::size_t before = journalRuns();
        EXPECT_GE(before, 4u);
        EXPECT_LT(before, 20u);
        std::ostringstream progress;
        options_.progress = &progress;
        const CampaignResult result = campaign.run(options_);
        EXPECT_EQ(result.missing, 0u);
        const std::string text = progress.str();
        EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), 20 - before);
        const BenchmarkLog log = logOnDisk();
        for (const PlannerLog &planned : log.planners)
        {
            ASSERT_EQ(planned.runs.size(), 10u);
            for (unsigned int run = 0; run < 10; ++run)
            {
                EXPECT_EQ(value(planned.runs[run], "run INTEGER"), std::to_string(run));
            }
        }
        // All runs are there: none is repeated.
        progress.str("");
        campaign.run(options_);
        EXPECT_EQ(progress.str(), "");
    }

    TEST_F(CampaignTest, EndsCleanlyOnCtrlC)
    {
        const Campaign campaign(slowDescription());
        const pid_t pid = startElsewhere(campaign, 3);
        kill(pid, SIGINT);
        int status = 0;
        waitpid(pid, &status, 0);
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), SIGINT);
        const BenchmarkLog log = logOnDisk();
        ASSERT_EQ(log.planners.size(), 2u);
        EXPECT_EQ(log.planners[0].runs.size() + log.planners[1].runs.size(), journalRuns());
        EXPECT_GE(journalRuns(), 3u);

        options_.resume = true;
        EXPECT_EQ(campaign.run(options_).missing, 0u);
        EXPECT_EQ(logOnDisk().planners[1].runs.size(), 10u);
    }

    TEST_F(CampaignTest, OnlyResumesItself)
    {
        CampaignDescription description = peacefulDescription();
        Campaign(description).run(options_);
        options_.resume = true;
        description.seed = 2;
        EXPECT_NE(inputErrorOf([&] { Campaign(description).run(options_); }).find("of another campaign"),
                  std::string::npos);
        description.seed = 1;
        description.settings.timeLimit = 0.2;
        EXPECT_NE(inputErrorOf([&] { Campaign(description).run(options_); }).find("of another campaign"),
                  std::string::npos);
        options_.resume = false;
        EXPECT_NE(inputErrorOf([&] { Campaign(description).run(options_); }).find("--overwrite"), std::string::npos);
        options_.overwrite = true;
        EXPECT_EQ(Campaign(description).run(options_).missing, 0u);
        // A finished campaign is run again.
        options_.overwrite = false;
        EXPECT_EQ(Campaign(description).run(options_).missing, 0u);
    }

    TEST_F(CampaignTest, SameSeedAndIterationLimitGiveEqualCostsWhateverTheJobs)
    {
        CampaignDescription description = peacefulDescription();
        description.planners = {entry("RRTstar", planner<og::RRTstar>("RRTstar"))};
        description.settings.timeLimit = 60.0;
        description.settings.iterationLimit = 300;
        description.runCount = 4;
        const auto costs = [this](const CampaignDescription &described, unsigned int jobs)
        {
            options_.jobs = jobs;
            options_.overwrite = true;
            std::vector<std::string> values;
            const CampaignResult result = Campaign(described).run(options_);
            for (const LogProperties &run : result.log.planners[0].runs)
            {
                values.push_back(value(run, "path cost REAL") + " " + value(run, "simplified path cost REAL") + " " +
                                 value(run, "collision checks INTEGER"));
            }
            return values;
        };
        const auto first = costs(description, 1);
        EXPECT_EQ(first, costs(description, 3));
        EXPECT_EQ(std::set<std::string>(first.begin(), first.end()).size(), 4u);
        description.seed = 2;
        EXPECT_NE(first, costs(description, 1));
    }

    TEST_F(CampaignTest, ShardsMakeTheWholeCampaign)
    {
        CampaignDescription description = peacefulDescription();
        description.settings.timeLimit = 60.0;
        description.settings.iterationLimit = 200;
        const Campaign campaign(description);
        const BenchmarkLog whole = campaign.run(options_).log;
        std::vector<std::string> parts;
        options_.shards = 3;
        for (unsigned int shard = 1; shard <= 3; ++shard)
        {
            options_.shard = shard;
            options_.log = folder_ / ("part" + std::to_string(shard) + ".log");
            EXPECT_EQ(campaign.run(options_).log.properties.at("shard TEXT"), std::to_string(shard) + "/3");
            parts.push_back(options_.log.string());
        }
        options_.log = folder_ / "merged.log";
        const BenchmarkLog merged = mergeCampaign(parts, options_.log, false);
        EXPECT_EQ(logOnDisk().planners.size(), merged.planners.size());
        EXPECT_EQ(merged.properties, whole.properties);
        ASSERT_EQ(merged.planners.size(), whole.planners.size());
        for (std::size_t i = 0; i < whole.planners.size(); ++i)
        {
            ASSERT_EQ(merged.planners[i].runs.size(), 3u);
            for (std::size_t run = 0; run < 3; ++run)
            {
                for (const char *property :
                     {"run INTEGER", "seed INTEGER", "path cost REAL", "collision checks INTEGER"})
                {
                    EXPECT_EQ(value(merged.planners[i].runs[run], property),
                              value(whole.planners[i].runs[run], property));
                }
            }
        }
    }

    TEST_F(CampaignTest, GoesOnFromWhatWasMerged)
    {
        const Campaign campaign(peacefulDescription());
        options_.shards = 2;
        options_.log = folder_ / "part1.log";
        campaign.run(options_);
        const std::string part = options_.log.string();
        options_ = CampaignOptions();
        options_.log = folder_ / "merged.log";
        EXPECT_EQ(mergeCampaign({part}, options_.log, true).planners[0].runs.size(), 2u);
        options_.resume = true;
        std::ostringstream progress;
        options_.progress = &progress;
        EXPECT_EQ(campaign.run(options_).missing, 0u);
        EXPECT_EQ(progress.str().rfind("4/6  ", 0), 0u) << progress.str();
        EXPECT_EQ(logOnDisk().planners[1].runs.size(), 3u);
    }

    TEST(Campaign, SharesOutEachPlannerEvenly)
    {
        CampaignDescription description = peacefulDescription();
        for (const char *name : {"C", "D"})
        {
            description.planners.push_back(entry(name, slowPlanner(name, 1)));
        }
        description.runCount = 8;
        const auto order = Campaign(description).runs();
        for (unsigned int shards = 1; shards <= 40; ++shards)
        {
            std::set<std::pair<std::size_t, unsigned int>> all;
            std::size_t total = 0;
            for (unsigned int shard = 1; shard <= shards; ++shard)
            {
                std::vector<std::pair<std::size_t, unsigned int>> runs;
                for (const std::size_t index : campaign::shareOf(order.size(), shard, shards))
                {
                    runs.push_back(order[index]);
                }
                total += runs.size();
                all.insert(runs.begin(), runs.end());
                EXPECT_LE(runs.size(), 32 / shards + 1);
                if (shards == 4)
                {
                    for (std::size_t which = 0; which < 4; ++which)
                    {
                        EXPECT_EQ(std::count_if(runs.begin(), runs.end(),
                                                [which](const auto &r) { return r.first == which; }),
                                  2);
                    }
                }
            }
            EXPECT_EQ(total, 32u);
            EXPECT_EQ(all.size(), 32u);
        }
    }

    TEST(Campaign, RefusesWhatCannotBeRun)
    {
        CampaignDescription description = peacefulDescription();
        description.planners[1].name = "RRTConnect";
        EXPECT_NE(inputErrorOf([&] { Campaign campaign(description); }).find("two planners have the name RRTConnect"),
                  std::string::npos);
        description = peacefulDescription();
        description.runCount = 0;
        EXPECT_NE(inputErrorOf([&] { Campaign campaign(description); }), "");
        description.planners.clear();
        EXPECT_NE(inputErrorOf([&] { Campaign campaign(description); }), "");

        description = peacefulDescription();
        description.planners[0].makeProblem = [](std::size_t) -> og::SimpleSetupPtr
        { throw InputError("x.cfg:3: start collides"); };
        EXPECT_EQ(inputErrorOf([&] { Campaign(description).validate(); }), "x.cfg:3: start collides");
    }

    TEST_F(CampaignTest, MakesTheFolderOfItsLogOrSaysWhyNot)
    {
        CampaignDescription description = peacefulDescription();
        description.runCount = 1;
        options_.log = folder_ / "new" / "folder" / "x.log";
        Campaign(description).run(options_);
        EXPECT_TRUE(std::filesystem::exists(options_.log));
        options_.log = "/proc/nowhere/x.log";
        EXPECT_NE(inputErrorOf([&] { Campaign(description).run(options_); }).find("/proc/nowhere"), std::string::npos);
        options_.log = folder_;
        EXPECT_NE(inputErrorOf([&] { Campaign(description).run(options_); }).find("not a regular file"),
                  std::string::npos);
        EXPECT_FALSE(std::filesystem::exists(Campaign::journalFile(folder_))) << "no run was made";
    }

    TEST_F(CampaignTest, SavesPaths)
    {
        CampaignDescription description = peacefulDescription();
        description.savePaths = SavePaths::All;
        Campaign(description).run(options_);
        EXPECT_TRUE(std::filesystem::exists(folder_ / "test.geometric_RRTstar.2.path"));
        EXPECT_TRUE(std::filesystem::exists(folder_ / "test.geometric_RRTConnect.0.path"));

        description.savePaths = SavePaths::Shortest;
        options_.log = folder_ / "best.log";
        Campaign(description).run(options_);
        std::ifstream in(folder_ / "best.geometric_RRTstar.path");
        double x = 0.0;
        double y = 0.0;
        in >> x >> y;
        EXPECT_EQ(x, 1.0);
        EXPECT_EQ(y, 5.0);
    }
}  // namespace ompl_mfa::benchmark
