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

#include "benchmark/CampaignMerge.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"

using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::benchmark
{
    namespace
    {
        const unsigned int RUNS = 4;

        BenchmarkLog smallHead()
        {
            BenchmarkLog head;
            head.version = "1.5.2";
            head.experiment = "two words";
            head.properties = {{"base_seed INTEGER", "7"}};
            head.host = "here";
            head.setup = "limits\n";
            head.cpu = "one core\n";
            head.seed = 18446744073709551615u;
            head.timeLimit = 0.1;
            head.memoryLimit = 100.0;
            head.runCount = RUNS;
            head.enums = {{"status", {"Unknown status", "Crash"}}, {"termination", {"Returned", "Signal"}}};
            head.planners.resize(2);
            head.planners[0].name = "geometric_B";
            head.planners[1].name = "geometric_A";
            return head;
        }

        RunRecord smallRecord(const std::string &planner, unsigned int run)
        {
            RunRecord record;
            record.planner = planner;
            record.run = run;
            record.termination = RunTermination::Returned;
            record.properties = {{"run INTEGER", std::to_string(run)}, {"time REAL", "0.5"}};
            record.progressNames = {"best cost REAL"};
            record.progress = {{0.001, {"inf"}}, {0.002, {"3.5"}}};
            record.duration = 0.5;
            return record;
        }

        /* The runs that \e keep selects, in reverse order. */
        CampaignRuns runsOf(const BenchmarkLog &head, const std::function<bool(unsigned int)> &keep)
        {
            CampaignRuns runs;
            runs.header = {"abc", "", "2026-01-02 03:04:05", toJson(head), 0.0};
            for (const PlannerLog &planner : head.planners)
            {
                for (unsigned int run = RUNS; run-- > 0;)
                {
                    if (keep(run))
                    {
                        runs.records.push_back(smallRecord(planner.name, run));
                        runs.header.duration += 0.5;
                    }
                }
            }
            return runs;
        }

        bool isEven(unsigned int run)
        {
            return run % 2 == 0;
        }

        bool isOdd(unsigned int run)
        {
            return run % 2 == 1;
        }

        bool isAny(unsigned int)
        {
            return true;
        }

        std::string mergeError(const CampaignRuns &a, const CampaignRuns &b)
        {
            return inputErrorOf([&] { mergeRuns({a, b}, {"a.log", "b.log"}); });
        }

        /* The error message when one field in the header of a part is changed. */
        std::string errorWhere(const std::function<void(BenchmarkLog &)> &change)
        {
            BenchmarkLog head = smallHead();
            change(head);
            return mergeError(runsOf(smallHead(), isEven), runsOf(head, isOdd));
        }

        class MergeCampaign : public testing::Test
        {
        protected:
            MergeCampaign()
              : folder_(testing::TempDir() + "merge_" + std::to_string(getpid()))
            {
                std::filesystem::create_directories(folder_);
            }

            ~MergeCampaign() override
            {
                std::filesystem::remove_all(folder_);
            }

            std::string file(const std::string &name) const
            {
                return (folder_ / name).string();
            }

            void write(const std::string &name, const CampaignRuns &runs) const
            {
                campaign::RunJournal journal(file(name), runs.header);
                for (const RunRecord &record : runs.records)
                {
                    journal.append(toJson(record), record.duration);
                }
            }

            std::string errorOf(const std::vector<std::string> &parts) const
            {
                return inputErrorOf([&] { mergeCampaign(parts, file("merged.log"), false); });
            }

            std::filesystem::path folder_;
        };
    }  // namespace

    TEST(CampaignLog, HeadsComeBackFromTheHeaderOfAJournal)
    {
        const BenchmarkLog head = smallHead();
        const BenchmarkLog back = logHeadFrom(campaign::parseJson(campaign::jsonLine(toJson(head))));
        EXPECT_EQ(toJson(back), toJson(head));
        EXPECT_EQ(back.seed, head.seed);
        EXPECT_EQ(back.timeLimit, 0.1);
        EXPECT_EQ(back.enums[1].names, head.enums[1].names);
        EXPECT_EQ(back.planners[0].name, "geometric_B");
        EXPECT_THROW(logHeadFrom(campaign::Json::object()), std::invalid_argument);
    }

    TEST(MergeRuns, JoinsPartsInTheOrderOfTheRuns)
    {
        CampaignRuns even = runsOf(smallHead(), isEven);
        BenchmarkLog there = smallHead();
        there.host = "there";
        there.cpu = "two cores\n";
        CampaignRuns odd = runsOf(there, isOdd);
        even.header.shard = "1/2";
        odd.header.shard = "2/2";
        even.header.start = "2026-01-01 00:00:00";
        const CampaignRuns merged = mergeRuns({odd, even}, {"odd", "even"});
        EXPECT_EQ(merged.header.campaign, "abc");
        EXPECT_EQ(merged.header.duration, 4.0);
        const BenchmarkLog log = assembleLog(merged);
        EXPECT_EQ(log.host, "here,there");
        EXPECT_EQ(log.cpu, "one core\ntwo cores\n");
        EXPECT_EQ(log.start, "2026-01-01 00:00:00");
        EXPECT_EQ(log.duration, 4.0);
        EXPECT_EQ(log.properties, assembleLog(runsOf(smallHead(), isAny)).properties);
        for (std::size_t i = 0; i < 2; ++i)
        {
            EXPECT_EQ(log.planners[i].name, smallHead().planners[i].name);
            ASSERT_EQ(log.planners[i].runs.size(), RUNS);
            ASSERT_EQ(log.planners[i].progress.size(), RUNS);
            for (unsigned int run = 0; run < RUNS; ++run)
            {
                EXPECT_EQ(log.planners[i].runs[run].at("run INTEGER"), std::to_string(run));
            }
        }
    }

    TEST(MergeRuns, RefusesPartsThatDoNotBelongTogether)
    {
        const CampaignRuns even = runsOf(smallHead(), isEven);
        const CampaignRuns odd = runsOf(smallHead(), isOdd);
        EXPECT_EQ(mergeError(even, odd), "");
        EXPECT_NE(mergeError(even, even).find("b.log: run 2 of planner geometric_B is in a.log too"), std::string::npos)
            << mergeError(even, even);
        CampaignRuns other = odd;
        other.header.campaign = "def";
        EXPECT_NE(mergeError(even, other)
                      .find("b.log: not a part of the same campaign as a.log: the campaign is 'def' "
                            "there and 'abc' here"),
                  std::string::npos);
        EXPECT_NE(errorWhere([](BenchmarkLog &head) { head.seed = 8; }).find("the seed is '8'"), std::string::npos);
        EXPECT_NE(errorWhere([](BenchmarkLog &head) { head.version = "2.0.2"; }).find("OMPL's version"),
                  std::string::npos);
        EXPECT_NE(errorWhere([](BenchmarkLog &head) { head.experiment = "x"; }).find("the experiment"),
                  std::string::npos);
        EXPECT_NE(errorWhere([](BenchmarkLog &head) { head.planners[1].name = "geometric_C"; }).find("a planner"),
                  std::string::npos);
        EXPECT_NE(errorWhere([](BenchmarkLog &head) { head.planners.pop_back(); }).find("the number of planners"),
                  std::string::npos);
        EXPECT_NE(inputErrorOf([] { mergeRuns({}, {}); }), "");
    }

    TEST(MergeRuns, MissesNoRunInSilence)
    {
        const CampaignRuns even = runsOf(smallHead(), isEven);
        const auto merge = [&even](bool allowMissing) { return mergeRuns({even}, {"a.log"}, allowMissing); };
        EXPECT_NE(inputErrorOf([&] { merge(false); }).find("run 1 of planner geometric_B is in none of the parts"),
                  std::string::npos);
        EXPECT_EQ(assembleLog(merge(true)).planners[0].runs.size(), 2u);
    }

    TEST_F(MergeCampaign, TakesLogsWithTheirJournalsAndJournals)
    {
        write("even.log.journal", runsOf(smallHead(), isEven));
        write("odd", runsOf(smallHead(), isOdd));
        const BenchmarkLog log = mergeCampaign({file("even.log"), file("odd")}, file("merged.log"), false);
        EXPECT_EQ(log.planners[1].runs.size(), RUNS);
        EXPECT_TRUE(std::filesystem::exists(file("merged.log")));
        const CampaignRuns merged = readCampaignRuns(file("merged.log.journal"));
        EXPECT_EQ(merged.records.size(), 2 * RUNS);
        EXPECT_EQ(merged.header.duration, 4.0);
        // A merged campaign can be merged again.
        EXPECT_EQ(errorOf({file("merged.log")}), "");
        EXPECT_NE(errorOf({file("merged.log.journal"), file("odd")}).find("odd: run 3 of planner geometric_B is in"),
                  std::string::npos);
    }

    TEST_F(MergeCampaign, SaysWhatIsNoPart)
    {
        EXPECT_NE(errorOf({file("none.log")}).find("none.log: cannot be read"), std::string::npos);
        std::ofstream(file("old.log")) << "OMPL version 1.5.2\n";
        EXPECT_NE(errorOf({file("old.log")}).find("old.log: is no journal, and there is no "), std::string::npos);
        write("other.journal", {{"abc", "", "today", {{"kind", "another"}}, 0.0}, {}});
        EXPECT_NE(errorOf({file("other.journal")}).find("other.journal:1: not the journal of 'ompl_mfa benchmark'"),
                  std::string::npos);
        EXPECT_FALSE(std::filesystem::exists(file("merged.log")));
    }

    TEST_F(MergeCampaign, LeavesTheJournalOfAnotherCampaignAlone)
    {
        write("all.journal", runsOf(smallHead(), isAny));
        CampaignRuns other = runsOf(smallHead(), isEven);
        other.header.campaign = "def";
        write("merged.log.journal", other);
        EXPECT_NE(errorOf({file("all.journal")}).find("merged.log.journal: has the runs of another campaign"),
                  std::string::npos);
        EXPECT_EQ(readCampaignRuns(file("merged.log.journal")).header.campaign, "def");
        EXPECT_FALSE(std::filesystem::exists(file("merged.log")));
    }
}  // namespace ompl_mfa::benchmark
