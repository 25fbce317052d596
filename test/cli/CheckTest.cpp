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

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/ConfigFixture.h"

namespace ompl_mfa::cli
{
    namespace
    {
        const std::string START = "start.x = 1\nstart.y = 3\n";

        class Check : public ConfigFixture
        {
        };
    }  // namespace

    TEST_F(Check, TellsWhereTheStraightMotionIsBlocked)
    {
        const ProgramResult result = runProgram("check " + config(START, "prm =\nmfa =\n") + " --json");
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["problem"], "a");
        EXPECT_EQ(document["space"], "R^2");
        EXPECT_EQ(document["obstacles"], 1);
        EXPECT_EQ(document["robot_radius"], 0.5);
        EXPECT_FALSE(document["straight_motion"]["free"]);
        // the disc touches the wall after 3 m of 8 m, and a hundredth of the diagonal is the resolution
        EXPECT_NEAR(document["straight_motion"]["free_fraction"].get<double>(), 3.0 / 8.0, 0.02);
        EXPECT_NEAR(document["straight_motion"]["length"].get<double>(), 8.0, 1e-9);
        ASSERT_EQ(document["planners"].size(), 2U);
        EXPECT_EQ(document["planners"][1]["type"], "mfa");
    }

    TEST_F(Check, TellsThatTheStraightMotionIsFree)
    {
        const std::string file = config("start.x = 1\nstart.y = 7\n");
        std::string text = readFile(file);
        text.replace(text.find("goal.y = 3"), 10, "goal.y = 7");
        write("a.cfg", text);
        const ProgramResult result = runProgram("check " + file);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("straight   free, length 8\n"), std::string::npos) << result.out;
    }

    TEST_F(Check, MeasuresAStateCheckForTheConfig)
    {
        const std::string file = config("start.x = 1\nstart.y = 7\n");
        const ProgramResult json = runProgram("check " + file + " --json");
        ASSERT_EQ(json.status, 0) << json.err;
        const double time = nlohmann::json::parse(json.out)["state_check_time"];
        EXPECT_GT(time, 0.0);
        const ProgramResult plain = runProgram("check " + file);
        // the output contains a valid line of a config
        const std::size_t line = plain.out.find("mfa.state_check_time=");
        ASSERT_NE(line, std::string::npos) << plain.out;
        const std::string setting = plain.out.substr(line, plain.out.find('\n', line) - line);
        const ProgramResult again =
            runProgram("plan " + file + " --planner mfa --iterations 500 --seed 3 --parameter " +
                       setting.substr(setting.find('.') + 1));
        EXPECT_EQ(again.status, 0) << setting << ": " << again.err;
    }

    TEST_F(Check, PrintsTheBoxesOfWorldAndRobot)
    {
        write("robot.obj", "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 1.5\nf 1 2 3\nf 1 2 4\nf 1 3 4\n");
        const std::string file = config("start.x = 1\nstart.y = 7\nstart.theta = 0\ngoal.theta = 0\n");
        std::string text = readFile(file);
        text.replace(text.find("robot = disc\nrobot.radius = 0.5"), 31, "robot = robot.obj");
        write("a.cfg", text);
        const ProgramResult json = runProgram("check " + file + " --json");
        ASSERT_EQ(json.status, 0) << json.err;
        const auto document = nlohmann::json::parse(json.out);
        EXPECT_EQ(document["world_box"]["min"], nlohmann::json({4.5, 1.0, -0.5}));
        EXPECT_EQ(document["world_box"]["max"], nlohmann::json({5.5, 5.0, 0.5}));
        // the reference point is the mean of the nine corners of faces in the plane; heights are those of the file
        EXPECT_NEAR(document["robot_box"]["min"][0].get<double>(), -2.0 / 3.0, 1e-12);
        EXPECT_EQ(document["robot_box"]["min"][2], 0.0);
        EXPECT_NEAR(document["robot_box"]["max"][1].get<double>(), 7.0 / 3.0, 1e-12);
        EXPECT_EQ(document["robot_box"]["max"][2], 1.5);
        EXPECT_EQ(document["warnings"], nlohmann::json::array());
        const ProgramResult plain = runProgram("check " + file);
        EXPECT_NE(plain.out.find("\nworld box  (4.5, 1, -0.5) to (5.5, 5, 0.5)\n"), std::string::npos) << plain.out;
        EXPECT_NE(plain.out.find("\nrobot box  (-0.666667, -0.666667, 0) to (2.33333, 2.33333, 1.5)\n"),
                  std::string::npos)
            << plain.out;
        EXPECT_EQ(plain.err, "");
    }

    TEST_F(Check, CountsThePointsAndLinesThatItPassesOver)
    {
        write("lines.obj", "v 4 1 0\nv 5 1 0\nv 4 4 0\nv 5 4 0\nf 1 2 3\nl 1 4\nl 2 4\n");
        const std::string file = config("start.x = 1\nstart.y = 7\n", "", "world = lines.obj\n");
        const auto document = nlohmann::json::parse(runProgram("check " + file + " --json").out);
        EXPECT_EQ(document["world_skipped_faces"], 2);
        EXPECT_EQ(document["robot_skipped_faces"], 0);
        const ProgramResult plain = runProgram("check " + file);
        EXPECT_NE(plain.out.find("1 obstacles, 2 points and lines passed over\n"), std::string::npos) << plain.out;
        EXPECT_NE(plain.out.find("robot      disc, radius 0.5\n"), std::string::npos) << plain.out;
    }

    TEST_F(Check, WarnsWhereNothingReachesTheHeightOfAPlanarRobot)
    {
        const auto warningOf = [this](const std::string &world)
        {
            const ProgramResult result =
                runProgram("check " + config("start.x = 1\nstart.y = 7\n", "", world) + " --json");
            EXPECT_EQ(result.status, 0) << result.err;
            const auto document = nlohmann::json::parse(result.out);
            EXPECT_EQ(document["warnings"].size(), result.err.empty() ? 0U : 1U);
            return result.err;
        };
        const auto box = [](const std::string &z)
        {
            return "world:\n  collision_objects:\n    - id: wall\n      primitives: [{type: box, dimensions: [1, 4, "
                   "1]}]\n"
                   "      primitive_poses: [{position: [5, 3, " +
                   z + "], orientation: [0, 0, 0, 1]}]\n";
        };
        write("high.yaml", box("2.5"));
        const std::string warning = warningOf("world = high.yaml\n");
        EXPECT_EQ(warning.rfind("warning: ", 0), 0U) << warning;
        EXPECT_EQ(warning.find('\n'), warning.size() - 1) << warning;
        for (const char *words : {"a.cfg:2: problem.world = high.yaml", "z = -0.5 to 0.5", "2 to 3"})
        {
            EXPECT_NE(warning.find(words), std::string::npos) << warning;
        }
        // a mesh with a floor, a ceiling and nothing between them
        write("gap.obj", "v 0 0 -2\nv 9 0 -2\nv 9 9 -2\nv 0 0 4\nv 9 0 4\nv 9 9 4\nf 1 2 3\nf 4 5 6\n");
        EXPECT_NE(warningOf("world = gap.obj\n").find("gap.obj"), std::string::npos);
        write("low.yaml", box("0.9"));
        EXPECT_EQ(warningOf("world = low.yaml\n"), "");
        EXPECT_EQ(warningOf("world = wall.yaml\n"), "");
        EXPECT_EQ(warningOf(""), "");
    }

    TEST_F(Check, SaysByHowMuchAStartCollidesAndWhereToItCouldGo)
    {
        // the disc of radius 0.5 would touch the wall at x = 4; the diagonal is 14.1, a hundredth of it 0.14
        expectBadInput("check " + config("start.x = 4.1\nstart.y = 3\n"),
                       {"a.cfg:5", "start (4.1, 3) is in collision with the world 'wall.yaml' by 0.1; ", "(3.998, 3)"});
        const ProgramResult deep = runProgram("check " + config("start.x = 4.2\nstart.y = 3\n"));
        EXPECT_EQ(deep.status, 2);
        EXPECT_EQ(deep.err.substr(deep.err.find("start (4.2")),
                  "start (4.2, 3) is in collision with the world 'wall.yaml'\n");
    }

    TEST_F(Check, TriesEveryPlannerOfTheConfig)
    {
        expectBadInput("check " + config(START, "prm =\nprm.max_neighbors = 3\n"),
                       {"a.cfg:19", "max_neighbors", "max_nearest_neighbors"});
        expectBadInput("check " + config(START, "rrt =\nrrt.goal_bias = often\n"), {"a.cfg:19", "goal_bias", "often"});
        expectBadInput("check " + config(START, "rrt =\nproblem.sampler = magic\n"), {"a.cfg:19", "sampler", "magic"});
    }

    TEST_F(Check, RefusesEachFaultOfAConfig)
    {
        expectBadInput("check " + config("start.x = 1\nstart.y\n"), {"a.cfg:6", "start.y"});
        expectBadInput("check " + config(START + "start.x = 2\n"), {"a.cfg:7", "start.x", "a.cfg:5"});
        expectBadInput("check " + config(START + "threshold = near\n"), {"a.cfg:7", "threshold", "near"});
        expectBadInput("check " + config(START + "control = blimp\n"), {"a.cfg:7", "control", "blimp"});
        expectBadInput("check " + config(START, "", "world = none.dae\n"), {"a.cfg:2", "none.dae"});
        expectBadInput("check " + config(START, "prm =\nprm.name = x\nrrt =\nrrt.name = x\n"), {"a.cfg:20", "x"});
        expectBadInput("check " + path("none.cfg"), {"none.cfg"});
        expectBadInput("check", {"FILE"});
    }

    TEST_F(Check, RefusesEachFaultOfAWorld)
    {
        const auto expectFault =
            [this](const std::string &world, const std::string &content, const std::vector<std::string> &words)
        {
            write(world, content);
            std::vector<std::string> all{"a.cfg:2", world};
            all.insert(all.end(), words.begin(), words.end());
            expectBadInput("check " + config(START, "", "world = " + world + "\n"), all);
        };
        const auto scene = [](const std::string &shape, const std::string &orientation)
        {
            return "world:\n  collision_objects:\n    - id: thing\n      primitives: [{" + shape +
                   "}]\n      primitive_poses: [{orientation: [" + orientation + "]}]\n";
        };
        expectFault("unreadable.dae", "no XML", {"not a readable mesh"});
        expectFault("empty.stl", "", {"not a readable mesh"});
        expectFault("robot.urdf", "<robot/>", {"unknown kind", ".yaml", ".scene", ".bt", ".dae"});
        expectFault("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"no triangles"});
        expectFault("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", {"not a finite number"});
        expectFault("zero.yaml", scene("type: box, dimensions: [1, 1, 1]", "0, 0, 0, 1e-9"), {":5", "orientation"});
        expectFault("negative.yaml", scene("type: cylinder, dimensions: [1, -0.5]", "0, 0, 0, 1"),
                    {":4", "cylinder radius = -0.5"});
        expectFault("unknown.yaml", scene("type: torus, dimensions: [1, 1]", "0, 0, 0, 1"),
                    {":4", "'torus'", "sphere"});
        expectFault("mesh.yaml",
                    "world:\n  collision_objects:\n    - id: thing\n      meshes: [{resource: none.stl}]\n",
                    {":4", "none.stl", "not found"});
        expectFault("old.bt", "# OctoMap v0.5\n", {":1", "version 1.0"});
        expectFault("other.ot", "# Octomap OcTree file\nid ColorOcTree\nsize 1\nres 0.1\ndata\n", {"ColorOcTree"});
        expectFault("none.bt", "# Octomap OcTree binary file\nid OcTree\nsize 0\nres 0.1\ndata\n",
                    {"no occupied cell"});
    }

    TEST_F(Check, WarnsOfWhatASceneLeavesUnset)
    {
        write("scene.yaml",
              "world:\n  collision_objects:\n  - id: thing\n"
              "    primitives: [{type: sphere, dimensions: [0.1]}, {type: sphere, dimensions: [0.1]}]\n"
              "    primitive_poses: [{orientation: [0, 0, 0, 0]}, {orientation: [0, 0, 0, 0]}]\n");
        const ProgramResult result = runProgram("check " + config(START, "", "world = scene.yaml\n") + " --json");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(nlohmann::json::parse(result.out)["obstacles"], 2);
        EXPECT_EQ(result.err.find("warning: "), 0U) << result.err;
        EXPECT_NE(result.err.find("scene.yaml:3: object 'thing'"), std::string::npos) << result.err;
        EXPECT_EQ(result.err.find("'thing'"), result.err.rfind("'thing'")) << result.err;
    }

    TEST_F(Check, WhatFilesHoldIsPrintedOnOneLineThatATerminalCanTake)
    {
        write("nul.yaml",
              "world:\n  collision_objects:\n    - id: thing\n"
              "      primitives: [{type: \"b\\0x\\e[31m\\n\\x9B\", dimensions: [1, 1, 1]}]\n");
        expectBadInput("check " + config(START, "", "world = nul.yaml\n"),
                       {"nul.yaml:4", "'b\\x00x\\x1b[31m \\x9b'", "accepted are", "sphere"});
        write("a.cfg", readFile(config()) + "mfa =\nmfa.slices = 1\x1b[2J\n");
        expectBadInput("check " + path("a.cfg"), {"a.cfg:19", "slices = 1\\x1b[2J"});
        const std::string world = std::string("w\x1b[7mall.yaml");
        write(world, readFile(path("wall.yaml")));
        const ProgramResult result = runProgram("check " + config(START, "", "world = " + world + "\n"));
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("w\\x1b[7mall.yaml, 1 obstacles"), std::string::npos) << result.out;
    }

    TEST_F(Check, AcceptsByteOrderMarksAndAnglesBeyondPi)
    {
        const std::string text = readFile(config(START + "start.theta = 3.5\ngoal.theta = -9.75\n"));
        write("a.cfg", "\xEF\xBB\xBF" + text);
        const ProgramResult result = runProgram("check " + path("a.cfg") + " --json");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(nlohmann::json::parse(result.out)["space"], "SE(2)");
    }

    TEST(CheckConfigs, EveryProblemOfTheProjectIsReady)
    {
        unsigned int count = 0;
        for (const auto &entry :
             std::filesystem::directory_iterator(std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks" / "configs"))
        {
            if (entry.path().extension() != ".cfg")
            {
                continue;
            }
            const ProgramResult result = runProgram("check '" + entry.path().string() + "' --json");
            EXPECT_EQ(result.status, 0) << result.err;
            EXPECT_FALSE(nlohmann::json::parse(result.out)["straight_motion"]["free"]) << entry.path();
            ++count;
        }
        EXPECT_GE(count, 12U);
    }

    TEST(CheckConfigs, WorldsAreWhatTheirScriptWrites)
    {
        const std::filesystem::path worlds = std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks" / "worlds";
        if (std::system("python3 --version >/dev/null 2>&1") != 0)
        {  // NOLINT(bugprone-command-processor): a fixed command
            GTEST_SKIP() << "python3 is not there";
        }
        const std::filesystem::path copy = temporaryFile("worlds");
        std::filesystem::create_directories(copy);
        std::filesystem::copy(worlds / "make_worlds.py", copy);
        const std::string command = "python3 '" + (copy / "make_worlds.py").string() + "'";
        ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(bugprone-command-processor): the test's own file
        unsigned int count = 0;
        for (const auto &entry : std::filesystem::directory_iterator(copy))
        {
            if (entry.path().filename() != "make_worlds.py")
            {
                EXPECT_EQ(readFile(entry.path().string()), readFile((worlds / entry.path().filename()).string()))
                    << entry.path().filename();
                ++count;
            }
        }
        EXPECT_GE(count, 10U);
        std::filesystem::remove_all(copy);
    }
}  // namespace ompl_mfa::cli
