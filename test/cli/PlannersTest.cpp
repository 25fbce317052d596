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

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/RunProgram.h"

namespace ompl_mfa::cli
{
    TEST(Planners, ListsEveryPlannerWithItsParameters)
    {
        const ProgramResult result = runProgram("planners --json");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        const auto document = nlohmann::json::parse(result.out);
        std::set<std::string> names;
        for (const auto &planner : document["planners"])
        {
            names.insert(planner["name"].get<std::string>());
            for (const auto &parameter : planner["parameters"])
            {
                for (const char *key : {"name", "type", "range", "default"})
                {
                    EXPECT_TRUE(parameter.contains(key)) << planner["name"] << " " << key;
                }
            }
        }
        for (const char *name : {"mfa", "mfa_paper", "fa_paper", "aps", "informedrrtstar", "rrtconnect"})
        {
            EXPECT_EQ(names.count(name), 1U) << name;
        }
    }

    TEST(Planners, ListsOnlyThoseThatAreAskedFor)
    {
        const ProgramResult result = runProgram("planners rrt mfa");
        ASSERT_EQ(result.status, 0);
        EXPECT_EQ(result.out.find("prm"), std::string::npos);
        EXPECT_NE(result.out.find("goal_bias"), std::string::npos);
        EXPECT_NE(result.out.find("0.:.05:1."), std::string::npos);
        EXPECT_NE(result.out.find("population_size"), std::string::npos);
    }

    TEST(Planners, NamesTheNearestKnownPlanner)
    {
        expectBadInput("planners rrtconect", {"rrtconect", "rrtconnect"});
    }
}  // namespace ompl_mfa::cli
