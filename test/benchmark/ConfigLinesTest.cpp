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

#include "ompl_mfa/benchmark/ConfigLines.h"

#include <sstream>

#include <gtest/gtest.h>

#include "benchmark/InputErrorOf.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using test::inputErrorOf;

        std::vector<ConfigEntry> read(const std::string &text)
        {
            std::istringstream in(text);
            return readConfigLines(in, "a.cfg");
        }

        ConfigEntry valued(const std::string &value)
        {
            return {"key", value, "a.cfg:3"};
        }

        TEST(ConfigLines, KeepsSectionsOrderAndLineNumbers)
        {
            const auto entries =
                read("# a comment\n\n[Problem]\n name = Two words # and why\nWorld=a=b.dae\n[planner]\nprm=\n");
            ASSERT_EQ(entries.size(), 3u);
            EXPECT_EQ(entries[0].key, "problem.name");
            EXPECT_EQ(entries[0].value, "Two words");
            EXPECT_EQ(entries[0].origin, "a.cfg:4");
            EXPECT_EQ(entries[1].key, "problem.world");
            EXPECT_EQ(entries[1].value, "a=b.dae");
            EXPECT_EQ(entries[2].key, "planner.prm");
            EXPECT_EQ(entries[2].value, "");
            EXPECT_EQ(entries[2].origin, "a.cfg:7");
        }

        TEST(ConfigLines, AcceptsByteOrderMarkAndWindowsLineEnds)
        {
            const auto entries = read("\xEF\xBB\xBF[problem]\r\nname=x\r\n");
            ASSERT_EQ(entries.size(), 1u);
            EXPECT_EQ(entries[0].key, "problem.name");
            EXPECT_EQ(entries[0].value, "x");
        }

        TEST(ConfigLines, KeepsRepeatedKeys)
        {
            EXPECT_EQ(read("[planner]\nprm=\nprm=\n").size(), 2u);
        }

        TEST(ConfigLines, NamesTheLineThatIsNeitherSectionNorEntry)
        {
            EXPECT_EQ(inputErrorOf([] { read("[problem]\nname = x\nstart.x 3\n"); }),
                      "a.cfg:3: 'start.x 3' is neither '[section]' nor 'key = value'");
            EXPECT_EQ(inputErrorOf([] { read("[problem\n"); }), "a.cfg:1: '[problem' has no closing ']'");
            EXPECT_EQ(inputErrorOf([] { read(" = 3\n"); }), "a.cfg:1: '= 3' has no key before '='");
            EXPECT_EQ(inputErrorOf([] { read(std::string("na\0me = 3\n", 10)); }),
                      "a.cfg:1: a NUL character; the file is to be UTF-8 text");
            EXPECT_EQ(inputErrorOf([] { read("[problem]\nname = caf\xE9\n"); }),
                      "a.cfg:2: the file is to be UTF-8 text");
            EXPECT_EQ(read("# caf\xE9\nname = caf\xC3\xA9\n").at(0).value, "caf\xC3\xA9");
        }

        TEST(ConfigLines, RealValueTakesNothingButAFiniteNumber)
        {
            EXPECT_EQ(realValue(valued("-0.5e1")), -5.0);
            EXPECT_EQ(realValue(valued("+2")), 2.0);
            for (const char *text : {"", "1.0x", "0x10", "1,5", "nan", "inf", "-inf", "1e999", "one"})
            {
                EXPECT_EQ(inputErrorOf([&] { realValue(valued(text)); }),
                          "a.cfg:3: key = " + std::string(text) + ": expected a finite number");
            }
        }

        TEST(ConfigLines, WholeValueStaysInItsRange)
        {
            EXPECT_EQ(wholeValue(valued("4294967295"), 1, 4294967295), 4294967295u);
            for (const char *text : {"0", "-1", "4294967296", "99999999999999999999999", "1.0", "1e3", ""})
            {
                EXPECT_EQ(inputErrorOf([&] { wholeValue(valued(text), 1, 4294967295); }),
                          "a.cfg:3: key = " + std::string(text) + ": expected a whole number from 1 to 4294967295");
            }
        }

        TEST(ConfigLines, SwitchValueKnowsBothSides)
        {
            for (const char *text : {"1", "true", "Yes", "ON"})
            {
                EXPECT_TRUE(switchValue(valued(text))) << text;
            }
            for (const char *text : {"0", "false", "no", "off"})
            {
                EXPECT_FALSE(switchValue(valued(text))) << text;
            }
            EXPECT_EQ(inputErrorOf([] { switchValue(valued("2")); }),
                      "a.cfg:3: key = 2: expected one of 0, 1, false, true, no, yes, off, on");
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
