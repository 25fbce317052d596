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

using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::benchmark
{
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
    }

    TEST(BenchmarkLog, SaysWhyItCannotBeWritten)
    {
        EXPECT_NE(inputErrorOf([] { writeBenchmarkLog(std::filesystem::path("/no/such.log"), smallLog()); })
                      .find("/no/such.log"),
                  std::string::npos);
    }
}  // namespace ompl_mfa::benchmark
