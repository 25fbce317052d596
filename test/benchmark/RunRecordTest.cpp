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

#include "benchmark/RunRecord.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace ompl_mfa::benchmark
{
    namespace
    {
        RunRecord someRecord(unsigned int run)
        {
            RunRecord record;
            record.planner = "geometric_A";
            record.run = run;
            record.seed = 2147483647u;
            record.termination = campaign::RunTermination::Signal;
            record.signal = 11;
            record.message = "line one\nbytes \xff\xfe";
            record.properties = {{"time REAL", "inf"}, {"status ENUM", "7"}};
            record.common = {{"range", "1"}};
            record.setup = "text\n";
            record.progressNames = {"best cost REAL"};
            record.progress = {{0.001, {"nan"}}, {0.1234567890123, {"1.5"}}};
            record.path = "1 2\n3 4\n";
            record.pathCost = 0.1;
            return record;
        }
    }  // namespace

    TEST(RunRecord, ComesBackAsItWas)
    {
        const RunRecord before = someRecord(3);
        const std::string line = writeRunRecord(before);
        EXPECT_EQ(line.find('\n'), std::string::npos);
        const RunRecord after = readRunRecord(line);
        EXPECT_EQ(after.planner, before.planner);
        EXPECT_EQ(after.run, before.run);
        EXPECT_EQ(after.seed, before.seed);
        EXPECT_EQ(after.termination, before.termination);
        EXPECT_EQ(after.signal, before.signal);
        EXPECT_EQ(after.message.substr(0, 15), before.message.substr(0, 15));
        EXPECT_EQ(after.properties, before.properties);
        EXPECT_EQ(after.common, before.common);
        EXPECT_EQ(after.setup, before.setup);
        EXPECT_EQ(after.progressNames, before.progressNames);
        ASSERT_EQ(after.progress.size(), 2u);
        EXPECT_EQ(after.progress[1].time, before.progress[1].time);
        EXPECT_EQ(after.progress[1].values, before.progress[1].values);
        EXPECT_EQ(after.path, before.path);
        EXPECT_EQ(after.pathCost, before.pathCost);
        EXPECT_THROW(readRunRecord("{}"), std::invalid_argument);
        EXPECT_THROW(readRunRecord(line.substr(0, line.size() / 2)), std::invalid_argument);
    }
}  // namespace ompl_mfa::benchmark
