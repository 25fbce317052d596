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

#include "campaign/Progress.h"

#include <sstream>

#include <gtest/gtest.h>

#include "ForeignLocale.h"

namespace ompl_mfa::campaign
{
    TEST(Progress, ShowsABarWithTheRunAndTheTimeLeft)
    {
        std::ostringstream out;
        Progress progress(&out, true, 10, 4);
        ASSERT_TRUE(progress.isDue());
        progress.running("RRTstar, run 3", 125.0);
        EXPECT_NE(out.str().find("4/10  RRTstar, run 3  time left 2:05"), std::string::npos) << out.str();
        EXPECT_FALSE(progress.isDue()) << "not so soon";
        progress.finished("RRTstar, run 3", "solved", false);
        EXPECT_EQ(out.str().find("solved"), std::string::npos);
        progress.finished("RRTstar, run 4", "killed", true);
        EXPECT_NE(out.str().find("6/10  RRTstar, run 4: killed\n"), std::string::npos) << out.str();
    }

    TEST(Progress, ShowsALineARunWhereThereIsNoTerminal)
    {
        std::ostringstream out;
        Progress progress(&out, false, 2, 0);
        progress.running("X, run 1", 1.0);
        EXPECT_EQ(out.str(), "");
        progress.finished("X, run 1", "solved", false);
        EXPECT_EQ(out.str(), "1/2  X, run 1: solved\n");
        Progress silent(nullptr, true, 2, 0);
        EXPECT_FALSE(silent.isDue());
        silent.running("X, run 1", 1.0);
        silent.finished("X, run 1", "solved", true);
        silent.close();
    }

    TEST(Progress, WritesDurationsAsClocksDo)
    {
        EXPECT_EQ(formatDuration(3.4), "3 s");
        EXPECT_EQ(formatDuration(125.0), "2:05");
        EXPECT_EQ(formatDuration(3725.0), "1:02:05");
        EXPECT_EQ(formatDuration(-1.0), "0 s");
    }

    TEST(Progress, CountsWithoutGroupsOfDigits)
    {
        const test::ForeignStreams foreign;
        std::ostringstream out;
        Progress progress(&out, false, 20000, 9999);
        progress.finished("A, run 5000", "killed", true);
        EXPECT_EQ(out.str(), "10000/20000  A, run 5000: killed\n");
    }
}  // namespace ompl_mfa::campaign
