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

#include "anytime/PlannerText.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::anytime
{
    using Texts = std::vector<std::string>;

    TEST(PlannerText, CommasSeparatePlannersAndParameters)
    {
        EXPECT_EQ(splitPlanners("mfa,bitstar"), (Texts{"mfa", "bitstar"}));
        EXPECT_EQ(splitPlanners("mfa:slices=4,gamma=1,rrtstar,mfa:slices=5"),
                  (Texts{"mfa:slices=4,gamma=1", "rrtstar", "mfa:slices=5"}));
        EXPECT_THROW(splitPlanners(""), InputError);
    }

    TEST(PlannerText, PeersStandForAllOfThem)
    {
        const Texts all = splitPlanners("mfa,peers");
        for (const char *name : {"mfa", "rrtstar", "informedrrtstar", "prmstar", "bitstar", "abitstar", "aitstar",
                                 "anytimepathshortening", "restart_simplify", "rrtconnect"})
        {
            EXPECT_EQ(std::count(all.begin(), all.end(), name), 1) << name;
        }
    }

    TEST(PlannerText, ParametersAreRead)
    {
        const auto spec = parsePlanner("mfa:slices=4,gamma=1.5");
        EXPECT_EQ(spec.type, "mfa");
        ASSERT_EQ(spec.parameters.size(), 2U);
        EXPECT_EQ(spec.parameters[0].key, "slices");
        EXPECT_EQ(spec.parameters[0].value, "4");
        EXPECT_EQ(spec.parameters[1].key, "gamma");
        EXPECT_EQ(spec.parameters[1].value, "1.5");
    }

    TEST(PlannerText, RefusesWhatItDoesNotKnow)
    {
        EXPECT_THROW(parsePlanner("mfaa"), InputError);
        EXPECT_THROW(parsePlanner("mfa:slices"), InputError);
        EXPECT_THROW(parsePlanner("mfa:=3"), InputError);
    }
}  // namespace ompl_mfa::anytime
