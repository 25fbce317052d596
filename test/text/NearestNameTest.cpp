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

#include "text/NearestName.h"

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::text
{
    TEST(NearestName, IsTheLeastEditedOne)
    {
        const std::vector<std::string> known = {"rrtconnect", "rrtstar", "prm", "prmstar"};
        EXPECT_EQ(nearestName("rrtconect", known), "rrtconnect");
        EXPECT_EQ(nearestName("prm*", known), "prm");
        EXPECT_EQ(nearestName("rttstar", known), "rrtstar");
        EXPECT_EQ(nearestName("rrt", known), "rrtstar");
        EXPECT_EQ(nearestName("", known), "");
        EXPECT_EQ(nearestName("zzzzzzzzzzzzzzzz", known), "");
    }

    TEST(NearestName, GuessesOnlyWhatIsClose)
    {
        EXPECT_EQ(describeUnknown("planner", "rrtstr", {"bitstar", "rrtstar"}),
                  "unknown planner 'rrtstr'; did you mean 'rrtstar'? accepted: bitstar, rrtstar");
        EXPECT_EQ(describeUnknown("planner", "xyz", {"bitstar", "rrtstar"}),
                  "unknown planner 'xyz'; accepted: bitstar, rrtstar");
        EXPECT_EQ(describeUnknown("planner", "", {"a"}), "unknown planner ''; did you mean 'a'? accepted: a");
    }

    TEST(NearestName, AllAreAcceptedWhereTheyAreFewOrNoneIsNear)
    {
        std::vector<std::string> known = {"rrtconnect", "rrtstar", "prm"};
        EXPECT_EQ(suggestion("prn", known), "; did you mean 'prm'? accepted: rrtconnect, rrtstar, prm");
        while (known.size() <= 10)
        {
            known.push_back("a" + std::to_string(known.size()));
        }
        EXPECT_EQ(suggestion("prn", known), "; did you mean 'prm'?");
        EXPECT_EQ(suggestion("zzzzzz", known), "; accepted: rrtconnect, rrtstar, prm, a3, a4, a5, a6, a7, a8, a9, a10");
    }

    TEST(NearestName, ThrowsOnlyForUnknownNames)
    {
        EXPECT_NO_THROW(requireKnown("planner", "a", {"a", "b"}));
        EXPECT_THROW(requireKnown("planner", "c", {"a", "b"}), InputError);
    }
}  // namespace ompl_mfa::text
