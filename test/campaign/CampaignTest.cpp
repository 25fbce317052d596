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

#include "campaign/Campaign.h"

#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"
#include "ompl_mfa/InputError.h"

using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::campaign
{
    namespace
    {
        /* A separate journal for each test. */
        class CampaignRuns : public testing::Test
        {
        protected:
            CampaignRuns()
            {
                options_.journal = testing::TempDir() + "campaign_runs_" + std::to_string(getpid()) + ".journal";
                header_.campaign = "abc";
                header_.description = {{"what", "numbers"}};
            }

            ~CampaignRuns() override
            {
                std::filesystem::remove(options_.journal);
            }

            /* A task whose run returns the result of \e body. */
            static Task task(int number, const std::function<std::string()> &body)
            {
                Task made;
                made.key = {{"kind", "n"}, {"number", number}};
                made.name = "n" + std::to_string(number);
                made.makeWork = [body]
                {
                    Work work;
                    work.state = makeShared<RunState>();
                    work.body = body;
                    work.report = [](const RunProcess &process)
                    {
                        const bool returned = process.termination() == RunTermination::Returned;
                        return RunReport{{{"text", process.result()}},
                                         describeTermination(process.termination(), process.signal()),
                                         !returned};
                    };
                    return work;
                };
                return made;
            }

            /* Tasks numbered \e first to \e last, whose runs return the id of their parent process. */
            static std::vector<Task> tasks(int first, int last, int milliseconds = 0)
            {
                std::vector<Task> made;
                for (int number = first; number <= last; ++number)
                {
                    made.push_back(task(number,
                                        [milliseconds]
                                        {
                                            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
                                            return std::to_string(getppid());
                                        }));
                }
                return made;
            }

            RunsMade make(const std::vector<Task> &made)
            {
                return makeRuns(header_, made, options_);
            }

            std::vector<Json> records() const
            {
                std::vector<Json> all;
                readJournal(options_.journal, [&all](const Json &record, std::size_t) { all.push_back(record); });
                return all;
            }

            std::vector<int> numbers() const
            {
                std::vector<int> all;
                for (const Json &record : records())
                {
                    all.push_back(record.at("number"));
                }
                return all;
            }

            std::size_t lineCount() const
            {
                std::ifstream in(options_.journal);
                std::size_t lines = 0;
                for (std::string line; std::getline(in, line) && !in.eof();)
                {
                    ++lines;
                }
                return lines;
            }

            /* Runs \e made in another process and waits until some runs are in the journal. */
            pid_t startElsewhere(const std::vector<Task> &made) const
            {
                const pid_t pid = fork();
                if (pid == 0)
                {
                    _exit(makeRuns(header_, made, options_).interruptedBy);
                }
                while (lineCount() < 3)
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(2));
                }
                return pid;
            }

            RunOptions options_;
            JournalHeader header_;
        };
    }  // namespace

    TEST_F(CampaignRuns, KeepsTheRunOfEveryTaskInTheirOrder)
    {
        const RunsMade made = make(tasks(1, 4));
        EXPECT_EQ(made.missing, 0u);
        EXPECT_EQ(made.interruptedBy, 0);
        EXPECT_EQ(made.header.campaign, "abc");
        EXPECT_EQ(made.header.description, (Json{{"what", "numbers"}}));
        EXPECT_FALSE(made.header.start.empty());
        EXPECT_EQ(numbers(), (std::vector<int>{1, 2, 3, 4}));
        double duration = 0.0;
        for (const Json &record : records())
        {
            EXPECT_EQ(record.at("kind"), "n");
            EXPECT_EQ(record.at("text"), std::to_string(getpid()));
            duration += record.at("duration").get<double>();
        }
        EXPECT_DOUBLE_EQ(made.header.duration, duration);
    }

    TEST_F(CampaignRuns, PartsHaveEachRunOnce)
    {
        std::set<int> all;
        for (options_.shard = 1; options_.shard <= 3; ++options_.shard)
        {
            options_.shards = 3;
            options_.overwrite = true;
            const RunsMade made = make(tasks(0, 6));
            EXPECT_EQ(made.header.shard, std::to_string(options_.shard) + "/3");
            EXPECT_EQ(numbers().size(), options_.shard == 1 ? 3u : 2u);
            for (const int number : numbers())
            {
                EXPECT_TRUE(all.insert(number).second) << number;
            }
        }
        EXPECT_EQ(all.size(), 7u);
        EXPECT_EQ(shareOf(7, 2, 3), (std::vector<std::size_t>{1, 4}));
        EXPECT_EQ(shareOf(1, 2, 3), std::vector<std::size_t>());
    }

    TEST_F(CampaignRuns, ResumesWithWhatIsMissing)
    {
        make(tasks(1, 2));
        options_.resume = true;
        std::ostringstream progress;
        options_.progress = &progress;
        EXPECT_EQ(make(tasks(0, 4)).missing, 0u);
        EXPECT_EQ(numbers(), (std::vector<int>{1, 2, 0, 3, 4}));
        EXPECT_EQ(progress.str(), "3/5  n0: returned\n4/5  n3: returned\n5/5  n4: returned\n");
        make(tasks(3, 9));
        EXPECT_EQ(numbers().size(), 10u) << "runs of other tasks stay";
    }

    TEST_F(CampaignRuns, KeepsItsHandsOffOtherJournals)
    {
        make(tasks(1, 3));
        EXPECT_NE(inputErrorOf([&] { make(tasks(1, 4)); }).find("has 3 runs of an interrupted campaign"),
                  std::string::npos);
        EXPECT_EQ(numbers().size(), 3u);
        EXPECT_EQ(make(tasks(1, 3)).missing, 0u) << "a finished campaign is run again";
        header_.campaign = "def";
        EXPECT_NE(inputErrorOf([&] { make(tasks(1, 3)); }).find("--overwrite"), std::string::npos);
        options_.resume = true;
        EXPECT_NE(inputErrorOf([&] { make(tasks(1, 3)); }).find("of another campaign"), std::string::npos);
        header_.campaign = "abc";
        options_.shards = 2;
        EXPECT_NE(inputErrorOf([&] { make(tasks(1, 3)); }).find("of another campaign"), std::string::npos);
        options_.resume = false;
        options_.overwrite = true;
        EXPECT_EQ(make(tasks(1, 3)).header.shard, "1/2");
        EXPECT_EQ(numbers().size(), 2u);

        options_ = RunOptions{options_.journal};
        options_.resume = true;
        std::ofstream(options_.journal) << R"({"campaign":"abc","shard":"","start":"t","description":null})"
                                        << "\n{\"kind\":\"n\",\"duration\":1.0}\n";
        EXPECT_NE(inputErrorOf([&] { make(tasks(1, 3)); }).find(options_.journal.string() + ":2: not a run"),
                  std::string::npos);
        std::ofstream(options_.journal).close();
        EXPECT_EQ(make(tasks(1, 3)).missing, 0u) << "an empty file counts as a new one";
    }

    TEST_F(CampaignRuns, GoOnAfterBeingKilled)
    {
        kill(startElsewhere(tasks(1, 20, 20)), SIGKILL);
        wait(nullptr);
        const std::size_t before = lineCount();
        options_.resume = true;
        EXPECT_EQ(make(tasks(1, 20)).missing, 0u);
        EXPECT_EQ(numbers().size(), 20u);
        EXPECT_EQ(records()[0].at("text") == records()[19].at("text"), false);
        EXPECT_GE(before, 3u);
    }

    TEST_F(CampaignRuns, StopOnSignals)
    {
        for (const int number : {SIGINT, SIGTERM, SIGHUP})
        {
            options_.overwrite = true;
            std::filesystem::remove(options_.journal);
            kill(startElsewhere(tasks(1, 100, 20)), number);
            int status = 0;
            wait(&status);
            ASSERT_TRUE(WIFEXITED(status));
            EXPECT_EQ(WEXITSTATUS(status), number);
            EXPECT_LT(numbers().size(), 100u);
        }
    }

    TEST_F(CampaignRuns, SurviveARunThatCrashes)
    {
        std::vector<Task> made = tasks(1, 3);
        made[1] = task(2,
                       []() -> std::string
                       {
                           signal(SIGSEGV, SIG_DFL);
                           raise(SIGSEGV);
                           return "not reached";
                       });
        std::ostringstream progress;
        options_.progress = &progress;
        options_.terminal = true;
        EXPECT_EQ(make(made).missing, 0u);
        EXPECT_EQ(numbers().size(), 3u);
        EXPECT_NE(progress.str().find("2/3  n2: ended by signal 11 (Segmentation fault)\n"), std::string::npos)
            << progress.str();
        EXPECT_EQ(progress.str().find("1/3  n1: returned\n"), std::string::npos) << "the bar is enough";
    }

    TEST_F(CampaignRuns, EndWhereARunRefusesWhatItIsAskedFor)
    {
        std::vector<Task> made = tasks(1, 3);
        made[1] = task(2, []() -> std::string { throw InputError("x.cfg:3: nonsense"); });
        EXPECT_EQ(inputErrorOf([&] { make(made); }), "x.cfg:3: nonsense");
        EXPECT_EQ(numbers(), std::vector<int>{1});
    }

    TEST_F(CampaignRuns, AreMadeAtTheSameTime)
    {
        options_.jobs = 5;
        const double start = monotonicSeconds();
        make(tasks(1, 5, 300));
        EXPECT_LT(monotonicSeconds() - start, 1.0);
        EXPECT_EQ(numbers().size(), 5u);
        options_.jobs = 0;
        EXPECT_NE(inputErrorOf([&] { make(tasks(1, 5)); }).find("--jobs 0"), std::string::npos);
    }

    TEST_F(CampaignRuns, HaveACoreOfTheirOwnEach)
    {
        cpu_set_t set;
        sched_getaffinity(0, sizeof(set), &set);
        options_.bindToCores = true;
        options_.jobs = static_cast<unsigned int>(CPU_COUNT(&set));
        std::vector<Task> made;
        for (int number = 0; number < CPU_COUNT(&set); ++number)
        {
            made.push_back(task(number,
                                []
                                {
                                    std::this_thread::sleep_for(std::chrono::milliseconds(200));
                                    cpu_set_t mine;
                                    sched_getaffinity(0, sizeof(mine), &mine);
                                    return std::to_string(CPU_COUNT(&mine)) + " " + std::to_string(sched_getcpu());
                                }));
        }
        make(made);
        std::set<std::string> cores;
        for (const Json &record : records())
        {
            const std::string text = record.at("text");
            EXPECT_EQ(text.rfind("1 ", 0), 0u) << text;
            cores.insert(text);
        }
        EXPECT_EQ(cores.size(), options_.jobs);
        ++options_.jobs;
        EXPECT_NE(inputErrorOf([&] { make(made); }).find("the number of cores"), std::string::npos);
    }
}  // namespace ompl_mfa::campaign
