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

#include "benchmark/FileNames.h"

#include <cstdlib>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "benchmark/InputErrorOf.h"

using ompl_mfa::test::inputErrorOf;

namespace ompl_mfa::benchmark
{
    TEST(FileNames, OrdinaryNamesStayAsTheyAre)
    {
        for (const std::string name : {"RRT*", "MFA-2", "two words", "a.b", "~", "...", "\xC3\xA4"})
        {
            EXPECT_EQ(fileNamePart(name), name);
            EXPECT_TRUE(isFileName(name)) << name;
        }
    }

    TEST(FileNames, RefusesWhatIsNoFile)
    {
        for (const std::string name : {"", ".", "..", "a/b", "/", "../a", "a\nb", "a\x7f"})
        {
            EXPECT_FALSE(isFileName(name)) << name;
        }
        EXPECT_FALSE(isFileName(std::string("a\0b", 3)));
        EXPECT_TRUE(isFileName(std::string(LONGEST_NAME, 'n')));
        EXPECT_FALSE(isFileName(std::string(LONGEST_NAME + 1, 'n')));
    }

    RC_GTEST_PROP(FileNames, PartsOfNamesAreNoFoldersAndTellNamesApart, (const std::string &a, const std::string &b))
    {
        const std::string part = fileNamePart(a);
        RC_ASSERT(part.find('/') == std::string::npos);
        RC_ASSERT(!hasControlCharacter(part));
        RC_ASSERT((part == fileNamePart(b)) == (a == b));
    }

    TEST(FileNames, TheTildeIsTheHomeFolder)
    {
        const char *before = std::getenv("HOME");
        const std::string home = before == nullptr ? "" : before;
        setenv("HOME", "/home/me", 1);
        EXPECT_EQ(writtenPath("~", "o"), "/home/me/");
        EXPECT_EQ(writtenPath("~/", "o"), "/home/me/");
        EXPECT_EQ(writtenPath("~/a/b", "o"), "/home/me/a/b");
        EXPECT_EQ(writtenPath("~//a", "o"), "/home/me/a");
        EXPECT_EQ(writtenPath("a/b~", "o"), "a/b~");
        EXPECT_EQ(writtenPath("../a", "o"), "../a");
        EXPECT_EQ(writtenPath("/a", "o"), "/a");
        EXPECT_EQ(writtenPath("", "o"), "");
        for (const std::string path : {"~you", "~you/a", "a/~", "a/~/b", "/~", "~/~", "a\tb"})
        {
            EXPECT_EQ(inputErrorOf([&] { writtenPath(path, "x.cfg:3"); }).rfind("x.cfg:3: ", 0), 0U) << path;
        }
        unsetenv("HOME");
        EXPECT_NE(inputErrorOf([] { writtenPath("~/a", "o"); }).find("HOME"), std::string::npos);
        EXPECT_EQ(writtenPath("a", "o"), "a");
        if (before != nullptr)
        {
            setenv("HOME", home.c_str(), 1);
        }
    }
}  // namespace ompl_mfa::benchmark
