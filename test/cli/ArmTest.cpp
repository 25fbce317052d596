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

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/ConfigFixture.h"
#include "cli/RunProgram.h"

namespace
{
    const std::string ARMS = std::string(OMPL_MFA_SOURCE_DIR) + "/benchmarks/arms/";
    const std::string PICKER = "--robot " + ARMS + "picker/picker.urdf --semantics " + ARMS + "picker/picker.srdf ";

    std::string problem(int number)
    {
        const std::string ending = "000" + std::to_string(number) + ".yaml ";
        return PICKER + "--scene " + ARMS + "problems/scene" + ending + "--request " + ARMS + "problems/request" +
               ending;
    }

    class ArmTest : public ConfigFixture
    {
    };

    TEST_F(ArmTest, PlansTheProblemsOfTheRepository)
    {
        for (const int number : {1, 2, 3})
        {
            const ProgramResult result =
                runProgram("plan " + problem(number) + "--time 1 --json --path " + path("path.csv"));
            ASSERT_EQ(result.status, 0) << result.err;
            const auto document = nlohmann::json::parse(result.out);
            EXPECT_EQ(document["status"], "Exact solution");
            EXPECT_TRUE(document["valid"]);
            EXPECT_EQ(document["problem"], "request000" + std::to_string(number));
            EXPECT_LT(document["cost"], 4.);
            const std::string csv = readFile(path("path.csv"));
            EXPECT_EQ(csv.rfind("time,lift,turn,shoulder,elbow,wrist,lift.velocity", 0), 0U) << csv;
        }
    }

    TEST_F(ArmTest, PathsMayBeMessages)
    {
        const ProgramResult result = runProgram("plan " + problem(1) + "--time 0.3 --path " + path("path.yaml"));
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(readFile(path("path.yaml")).rfind("joint_trajectory:", 0), 0U);
    }

    TEST_F(ArmTest, GoalsMayBePoses)
    {
        const std::string posed =
            PICKER + "--scene " + ARMS + "problems/scene0001.yaml --request " + ARMS + "problems/request0004.yaml ";
        for (const char *planner : {"mfa", "rrtconnect", "rrtstar"})
        {
            const ProgramResult result =
                runProgram("plan " + posed + "--time 2 --json --planner " + std::string(planner));
            ASSERT_EQ(result.status, 0) << planner << result.err;
            EXPECT_EQ(result.err, "");
        }
        const ProgramResult check = runProgram("check " + posed);
        EXPECT_NE(check.out.find("goal       valid"), std::string::npos) << check.out;
    }

    TEST_F(ArmTest, GroupStatesAreStartAndGoal)
    {
        const ProgramResult result = runProgram(
            "plan " + PICKER + "--group arm --start ready --goal stretched --time 0.3 --json --planner rrtconnect");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_GT(nlohmann::json::parse(result.out)["length"], 2.);
    }

    TEST_F(ArmTest, ChecksAProblem)
    {
        const ProgramResult result = runProgram("check " + problem(3) + "--json");
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["space"], "joints");
        EXPECT_EQ(document["group"], "arm");
        EXPECT_EQ(document["joints"].size(), 5U);
        EXPECT_EQ(document["obstacles"], 4);
        EXPECT_EQ(document["attached_objects"], 1);
        EXPECT_GT(document["checked_link_pairs"], 20);
        // eight links on four obstacles each, of which the rod may touch one
        EXPECT_EQ(document["checked_obstacle_pairs"], 35);
        const ProgramResult text = runProgram("check " + problem(3));
        EXPECT_NE(text.out.find("5 joints of the group arm"), std::string::npos) << text.out;
    }

    TEST_F(ArmTest, ConfigsMayHaveAnArm)
    {
        const ProgramResult plan = runProgram("plan " + ARMS + "shelf.cfg --time 0.5 --json");
        ASSERT_EQ(plan.status, 0) << plan.err;
        EXPECT_EQ(nlohmann::json::parse(plan.out)["problem"], "shelf");
        const ProgramResult check = runProgram("check " + ARMS + "shelf.cfg --json");
        ASSERT_EQ(check.status, 0) << check.err;
        EXPECT_EQ(nlohmann::json::parse(check.out)["planners"].size(), 3U);
    }

    TEST_F(ArmTest, ConfigsOfArmsAreRunAsCampaigns)
    {
        std::filesystem::copy(ARMS, folder_ / "arms", std::filesystem::copy_options::recursive);
        write("arms/a.cfg",
              "[problem]\nname = a\nrobot = picker/picker_spherized.urdf\n"
              "robot.semantics = picker/picker.srdf\nrobot.group = arm\nstart = ready\n"
              "goal = 0.1, 0.5, 0, 0, 0\nmotion_validation = continuous\nrobot.link_padding = 0.01\n"
              "robot.weights = 2, 1, 1, 1, 1\n[benchmark]\ntime_limit = 0.2\nrun_count = 2\n"
              "[planner]\nrrtconnect =\nkpiece =\n");
        const ProgramResult result = runProgram("benchmark " + path("arms/a.cfg") + " --json");
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["planners"][0]["solved"], 2);
    }

    TEST_F(ArmTest, EachFaultIsOneLine)
    {
        const std::string urdf = "--robot " + ARMS + "picker/picker.urdf ";
        expectBadInput("plan", {"FILE", "--robot"});
        expectBadInput("plan a.cfg " + urdf, {"a.cfg", "--robot"});
        expectBadInput("plan --scene x.yaml", {"--scene", "--robot"});
        expectBadInput("plan --robot x.stl", {"--robot x.stl", ".urdf"});
        expectBadInput("check --robot none.urdf", {"none.urdf", "no such file"});
        expectBadInput("check " + problem(1) + "--group arms", {"group_name", "'arms'"});
        expectBadInput("check " + PICKER + "--group arms --start ready --goal ready", {"'arms'", "arm_and_roll"});
        expectBadInput("check " + PICKER + "--group arm --start redy --goal ready", {"'redy'", "stretched"});
        expectBadInput("check " + problem(1) + "--start stretched", {"start", "collision", "by at most"});
        expectBadInput("plan " + problem(1) + "--picture x.svg", {"--picture", "arms"});
        const auto config = [this](const std::string &lines)
        {
            write("a.cfg", "[problem]\nrobot = " + ARMS + "picker/picker.urdf\n" + lines + "[planner]\nmfa =\n");
            return "check " + path("a.cfg");
        };
        expectBadInput(config("start.x = 1\n"), {"a.cfg:3", "start.x", "arms do not have this"});
        expectBadInput(config("mesh_interior = solid\n"), {"a.cfg:3", "mesh_interior"});
        expectBadInput(config("robot.semantics = none.srdf\n"), {"a.cfg:3", "none.srdf", "no such file"});
        expectBadInput(config("robot.weights = 1, x\n"), {"a.cfg:3", "robot.weights", "above 0"});
        expectBadInput(config("robot.packages = none\n"), {"a.cfg:3", "'none' is no folder"});
        write("b.cfg",
              "[problem]\nrobot = disc\nrobot.radius = 1\nrobot.group = arm\nstart.x = 0\nstart.y = 0\n"
              "goal.x = 1\ngoal.y = 1\n[planner]\nmfa =\n");
        expectBadInput("check " + path("b.cfg"), {"b.cfg:4", "robot.group", "only arms"});
    }
}  // namespace
