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

#include "ompl_mfa/benchmark/BenchmarkLog.h"

#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"

using ompl_mfa::BenchmarkLog;
using ompl_mfa::mergeBenchmarkLogs;
using ompl_mfa::PlannerLog;
using ompl_mfa::test::inputErrorOf;

namespace
{
    BenchmarkLog smallLog()
    {
        BenchmarkLog log;
        log.version = "1.5.2";
        log.experiment = "two words";
        log.properties = {{"campaign TEXT", "abc"}, {"base_seed INTEGER", "7"}};
        log.host = "here";
        log.start = "2026-01-02 03:04:05";
        log.setup = "a\nb\n";
        log.cpu = "one core\n";
        log.seed = 7;
        log.timeLimit = 0.125;
        log.memoryLimit = 100.0;
        log.runCount = 4;
        log.duration = 12.5;
        log.enums = {{"status", {"Unknown status", "Crash"}}, {"termination", {"Returned", "Signal"}}};
        for (const char *name : {"geometric_A", "geometric_B"})
        {
            PlannerLog planner;
            planner.name = name;
            planner.common = {{"range", "0.5"}};
            planner.progressNames = {"best cost REAL"};
            for (int run = 0; run < 4; ++run)
            {
                planner.runs.push_back({{"run INTEGER", std::to_string(run)}, {"time REAL", "0.5"}});
                planner.progress.push_back({{0.001, {"inf"}}, {0.002, {"3.5"}}});
            }
            log.planners.push_back(planner);
        }
        return log;
    }

    std::string written(const BenchmarkLog &log)
    {
        std::ostringstream out;
        writeBenchmarkLog(out, log);
        return out.str();
    }

    BenchmarkLog read(const std::string &text)
    {
        std::istringstream in(text);
        return ompl_mfa::readBenchmarkLog(in, "a.log");
    }

    /* The runs of \e log for which \e keep says so. */
    template <class Keep>
    BenchmarkLog part(const BenchmarkLog &log, Keep keep)
    {
        BenchmarkLog some = log;
        for (PlannerLog &planner : some.planners)
        {
            const PlannerLog all = planner;
            planner.runs.clear();
            planner.progress.clear();
            for (std::size_t i = 0; i < all.runs.size(); ++i)
            {
                if (keep(i))
                {
                    planner.runs.push_back(all.runs[i]);
                    planner.progress.push_back(all.progress[i]);
                }
            }
        }
        return some;
    }

    bool isEven(std::size_t i)
    {
        return i % 2 == 0;
    }

    bool isOdd(std::size_t i)
    {
        return i % 2 == 1;
    }

    std::string mergeError(const BenchmarkLog &a, const BenchmarkLog &b)
    {
        return inputErrorOf([&] { mergeBenchmarkLogs({a, b}, {"a.log", "b.log"}); });
    }
}  // namespace

TEST(BenchmarkLog, HasTheOrderOfOmplsFormat)
{
    BenchmarkLog log = smallLog();
    log.planners.resize(1);
    log.planners[0].runs.resize(1);
    log.planners[0].progress.resize(1);
    EXPECT_EQ(written(log),
              "OMPL version 1.5.2\nExperiment two_words\n2 experiment properties\nbase_seed INTEGER = 7\n"
              "campaign TEXT = abc\nRunning on here\nStarting at 2026-01-02 03:04:05\n<<<|\na\nb\n|>>>\n"
              "<<<|\none core\n|>>>\n7 is the random seed\n0.125 seconds per run\n100 MB per run\n"
              "4 runs per planner\n12.5 seconds spent to collect the data\n2 enum types\n"
              "status|Unknown status|Crash\ntermination|Returned|Signal\n1 planners\ngeometric_A\n"
              "1 common properties\nrange = 0.5\n2 properties for each run\nrun INTEGER\ntime REAL\n"
              "1 runs\n0; 0.5; \n2 progress properties for each run\ntime REAL\nbest cost REAL\n1 runs\n"
              "0.001000,inf,;0.002000,3.5,;\n.\n");
}

TEST(BenchmarkLog, ReadsWhatItWrites)
{
    const std::string text = written(smallLog());
    EXPECT_EQ(written(read(text)), text);
}

TEST(BenchmarkLog, NeverWritesWhatBreaksTheParsers)
{
    BenchmarkLog log = smallLog();
    auto &run = log.planners[0].runs[0];
    run["a REAL"] = "-nan";
    run["b REAL"] = "-inf";
    run["c REAL"] = "inf";
    run["d TEXT"] = "two; values\nand a line, more";
    log.planners[0].progress[0] = {{0.001, {"-nan"}}, {0.0010000001, {"2"}}, {0.002, {"1,5;"}}};
    const std::string text = written(log);
    EXPECT_EQ(text.find("-nan"), std::string::npos);
    EXPECT_EQ(text.find("-inf"), std::string::npos);
    EXPECT_NE(text.find("\nnan; nan; inf; two  values and a line  more; 0; 0.5; \n"), std::string::npos) << text;
    EXPECT_NE(text.find("\n0.001000,nan,;0.002000,1 5 ,;\n"), std::string::npos) << text;
    EXPECT_EQ(read(text).planners[0].runs.size(), 4u);
}

TEST(BenchmarkLog, ReadsOmplsOwnLogs)
{
    // As OMPL 1.5 writes it: the time is not the first of the progress properties.
    const BenchmarkLog log = read(
        "OMPL version \nExperiment x\n0 experiment properties\nRunning on h\nStarting at t\n<<<|\n|>>>\n<<<|\n|>>>\n"
        "1 is the random seed\n1 seconds per run\n1 MB per run\n1 runs per planner\n1 seconds spent to collect the "
        "data\n"
        "1 enum type\nstatus|A\n1 planners\ngeometric_P\n0 common properties\n1 properties for each run\ntime REAL\n"
        "2 runs\n1; \n; \n3 progress properties for each run\nbest cost REAL\nstates INTEGER\ntime REAL\n2 runs\n"
        "7,3,0.1,;6,4,0.2,;\n\n.\n");
    ASSERT_EQ(log.planners[0].progress[0].size(), 2u);
    EXPECT_EQ(log.planners[0].progress[0][1].time, 0.2);
    EXPECT_EQ(log.planners[0].progress[0][1].values, (std::vector<std::string>{"6", "4"}));
    EXPECT_EQ(log.planners[0].progressNames, (std::vector<std::string>{"best cost REAL", "states INTEGER"}));
    EXPECT_TRUE(log.planners[0].progress[1].empty());
    EXPECT_TRUE(log.planners[0].runs[1].empty());
}

TEST(BenchmarkLog, NamesTheLineThatIsWrong)
{
    const std::string text = written(smallLog());
    // Cut off anywhere, the text is refused, and never crashes the reader.
    for (std::size_t length = 0; length + 2 < text.size(); length += 7)
    {
        const std::string message = inputErrorOf([&] { read(text.substr(0, length)); });
        EXPECT_EQ(message.rfind("a.log:", 0), 0u) << length << ": " << message;
    }
    EXPECT_NE(inputErrorOf([] { read("hello\n"); }).find("a.log:1: expected 'OMPL version '"), std::string::npos);
    std::string shifted = text;
    shifted.replace(shifted.find("\n0; 0.5; \n"), 10, "\n0; 0.5; 9; \n");
    EXPECT_NE(inputErrorOf([&] { read(shifted); }).find("expected 2 values, found 3"), std::string::npos);
    EXPECT_NE(
        inputErrorOf([] { ompl_mfa::readBenchmarkLog(std::filesystem::path("/no/such.log")); }).find("/no/such.log"),
        std::string::npos);
    EXPECT_NE(
        inputErrorOf([] { writeBenchmarkLog(std::filesystem::path("/no/such.log"), smallLog()); }).find("/no/such.log"),
        std::string::npos);
}

TEST(MergeBenchmarkLogs, JoinsPartsInTheOrderOfTheRuns)
{
    const BenchmarkLog whole = smallLog();
    BenchmarkLog even = part(whole, isEven);
    BenchmarkLog odd = part(whole, isOdd);
    even.properties["shard TEXT"] = "1/2";
    odd.properties["shard TEXT"] = "2/2";
    odd.host = "there";
    odd.duration = 1.0;
    const BenchmarkLog merged = mergeBenchmarkLogs({odd, even}, {"odd", "even"});
    EXPECT_EQ(merged.host, "here,there");
    EXPECT_EQ(merged.duration, 13.5);
    EXPECT_EQ(merged.properties, whole.properties);
    for (std::size_t i = 0; i < 2; ++i)
    {
        EXPECT_EQ(merged.planners[i].runs, whole.planners[i].runs);
        EXPECT_EQ(merged.planners[i].progress.size(), 4u);
    }
}

TEST(MergeBenchmarkLogs, RefusesPartsThatDoNotBelongTogether)
{
    const BenchmarkLog even = part(smallLog(), isEven);
    const BenchmarkLog odd = part(smallLog(), isOdd);
    EXPECT_EQ(mergeError(even, odd), "");
    EXPECT_NE(mergeError(even, even).find("b.log: run 0 of planner geometric_A is in a.log too"), std::string::npos);

    BenchmarkLog other = odd;
    other.properties["campaign TEXT"] = "def";
    EXPECT_NE(mergeError(even, other).find("the campaign is 'def' there and 'abc' here"), std::string::npos);
    other.properties.erase("campaign TEXT");
    EXPECT_NE(mergeError(even, other).find("b.log: no experiment property"), std::string::npos);
    other = odd;
    other.seed = 8;
    EXPECT_NE(mergeError(even, other).find("the seed"), std::string::npos);
    other = odd;
    other.version = "2.0.2";
    EXPECT_NE(mergeError(even, other).find("OMPL's version"), std::string::npos);
    other = odd;
    other.planners[1].name = "geometric_C";
    EXPECT_NE(mergeError(even, other).find("a planner"), std::string::npos);
    other = odd;
    other.planners.pop_back();
    EXPECT_NE(mergeError(even, other).find("the number of planners"), std::string::npos);
    EXPECT_NE(inputErrorOf([] { mergeBenchmarkLogs({}, {}); }), "");
}

TEST(MergeBenchmarkLogs, MissesNoRunInSilence)
{
    const BenchmarkLog even = part(smallLog(), isEven);
    const auto merge = [&even](bool allowMissing) { return mergeBenchmarkLogs({even}, {"a.log"}, allowMissing); };
    EXPECT_NE(inputErrorOf([&] { merge(false); }).find("run 1 of planner geometric_A is in none of the parts"),
              std::string::npos);
    EXPECT_EQ(merge(true).planners[0].runs.size(), 2u);
}
