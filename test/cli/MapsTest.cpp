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

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/PdfText.h"
#include "cli/RunProgram.h"

namespace ompl_mfa::cli
{
    namespace
    {
        /* Around the end of the wall of columns 4 and 5: from (1, 8) to its corners at (3.5, 1.5) and (5.5, 1.5) and on
           to (8, 8), less than along the octile grid. */
        const double SHORTEST = 2.0 * std::hypot(2.5, 6.5) + 2.0;
        const double OCTILE = 17.071;

        /* A folder with a map of 10 x 10 cells and a wall that is open at the top, its scenario, and configs. */
        class Maps : public testing::Test
        {
        protected:
            Maps()
              : folder_(std::filesystem::temp_directory_path() / ("ompl_mfa_maps_" + std::to_string(::getpid())))
            {
                std::filesystem::create_directories(folder_);
                std::string map = "type octile\nheight 10\nwidth 10\nmap\n..........\n..........\n";
                for (int row = 2; row < 10; ++row)
                {
                    map += "....@@....\n";
                }
                write("wall.map", map);
                write("wall.scen",
                      "version 1\n0\twall.map\t10\t10\t1\t8\t2\t8\t1\n4\twall.map\t10\t10\t1\t8\t8\t8\t17.071\n");
                write("set.cfg",
                      "[problem]\nworld = wall.map\nscenario = wall.scen\nrobot = point\nobjective = length\n"
                      "objective.threshold = 16.2\n[benchmark]\ntime_limit = 20\nrun_count = 2\n[planner]\nmfa "
                      "=\nrrtconnect =\n");
                std::string image = "P2 60 40 255\n";
                for (int pixel = 0; pixel < 60 * 40; ++pixel)
                {
                    const int x = pixel % 60;
                    const int y = pixel / 60;
                    image += x >= 28 && x < 32 && y >= 20 ? "0 " : x < 5 ? "205 " : "254 ";
                }
                write("room.pgm", image + "\n");
                write("room.yaml",
                      "image: room.pgm\nresolution: 0.1\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\n"
                      "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
                write("room.cfg",
                      "[problem]\nworld = room.yaml\nrobot = footprint\n"
                      "robot.footprint = [[-0.3, -0.2], [0.4, -0.2], [0.4, 0.2], [-0.3, 0.2]]\n"
                      "start.x = 0.3\nstart.y = 2.7\nstart.theta = 0\n"
                      "goal.x = 4\ngoal.y = 2.7\ngoal.theta = 1.5\nobjective = length\n[benchmark]\ntime_limit = 20\n");
            }

            ~Maps() override
            {
                std::filesystem::remove_all(folder_);
            }

            void write(const std::string &name, const std::string &text) const
            {
                std::ofstream(folder_ / name) << text;
            }

            std::string path(const std::string &name) const
            {
                return (folder_ / name).string();
            }

            std::filesystem::path folder_;
        };

        std::vector<std::vector<double>> readCsv(const std::string &file)
        {
            std::vector<std::vector<double>> rows;
            std::ifstream in(file);
            std::string line;
            std::getline(in, line);
            EXPECT_EQ(line, "x,y,yaw");
            while (std::getline(in, line))
            {
                rows.emplace_back();
                std::istringstream cells(line);
                for (std::string cell; std::getline(cells, cell, ',');)
                {
                    rows.back().push_back(std::stod(cell));
                }
            }
            return rows;
        }
    }  // namespace

    TEST_F(Maps, PlanSelectsAProblemOfTheSet)
    {
        const ProgramResult result =
            runProgram("plan " + path("set.cfg") + " --problem 1 --json --spacing 0.5 --path " + path("a.csv"));
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["scenario_index"], 1);
        EXPECT_EQ(document["octile_length"], OCTILE);
        EXPECT_TRUE(document["valid"]);
        EXPECT_GE(document["cost"].get<double>(), SHORTEST);
        EXPECT_LE(document["cost"].get<double>(), 1.02 * SHORTEST);
        const auto rows = readCsv(path("a.csv"));
        EXPECT_EQ(rows.front()[0], 1.0);
        EXPECT_EQ(rows.front()[1], 8.0);
        EXPECT_EQ(rows.back()[0], 8.0);
        double length = 0.0;
        for (std::size_t i = 1; i < rows.size(); ++i)
        {
            const double x = rows[i][0] - rows[i - 1][0];
            const double y = rows[i][1] - rows[i - 1][1];
            EXPECT_LE(std::hypot(x, y), 0.5 + 1e-9);
            EXPECT_NEAR(rows[i - 1][2], std::atan2(y, x), 1e-6);
            length += std::hypot(x, y);
        }
        EXPECT_NEAR(length, document["cost"].get<double>(), 1e-6);
        expectBadInput("plan " + path("set.cfg"), {"set.cfg: stands for 2 problems", "--problem", "0 to 1"});
        expectBadInput("plan " + path("set.cfg") + " --problem 2", {"--problem 2: expected one of 0 to 1"});
        expectBadInput("plan " + path("room.cfg") + " --problem 0", {"--problem 0", "single problem"});
        expectBadInput("plan " + path("set.cfg") + " --problem 1 --spacing 0", {"--spacing 0", "above 0"});
    }

    TEST_F(Maps, PlanWritesAPathOfRos)
    {
        ASSERT_EQ(runProgram("plan " + path("room.cfg") + " --planner rrtconnect --path " + path("a.yaml")).status, 0);
        const std::string text = readFile(path("a.yaml"));
        EXPECT_EQ(text.rfind("header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}\nposes:\n- header: ", 0), 0U)
            << text;
        EXPECT_NE(text.find("  pose:\n    position: {x: 0.29999999999999999, y: 2.7000000000000002, z: 0.0}\n"
                            "    orientation: {x: 0.0, y: 0.0, z: 0, w: 1}\n"),
                  std::string::npos)
            << text.substr(0, 400);
        // the last pose has half of the goal's angle
        std::ostringstream last;
        last.precision(17);
        last << "z: " << std::sin(0.75) << ", w: " << std::cos(0.75) << "}\n";
        EXPECT_EQ(text.substr(text.size() - last.str().size()), last.str());
        const std::string asteroids = "'" OMPL_MFA_SOURCE_DIR "/benchmarks/configs/asteroids.cfg'";
        expectBadInput("plan " + asteroids + " --path " + path("b.csv"), {"--path", "b.csv", "SE(3)"});
    }

    TEST_F(Maps, PlanDrawsTheMap)
    {
        for (const char *name : {"a.svg", "a.png", "a.pdf"})
        {
            ASSERT_EQ(runProgram("plan " + path("room.cfg") + " --planner rrtconnect --picture " + path(name)).status,
                      0)
                << name;
        }
        std::string text = pdfText(path("a.pdf"));
        for (const std::string word : {"occupied", "unknown", "within the inscribed radius", "low clearance",
                                       "high clearance", "best path", "robot", "x (m)", "y (m)"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
        EXPECT_NE(readFile(path("a.svg")).find("<image"), std::string::npos);
        ASSERT_EQ(runProgram("plan " + path("set.cfg") + " --problem 1 --picture " + path("b.pdf")).status, 0);
        text = pdfText(path("b.pdf"));
        for (const std::string word : {"set, problem 1, MFA", "x (cells)"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
    }

    TEST_F(Maps, CheckDescribesMapsAndSets)
    {
        const ProgramResult room = runProgram("check " + path("room.cfg") + " --json");
        ASSERT_EQ(room.status, 0) << room.err;
        EXPECT_EQ(room.err, "");
        const auto document = nlohmann::json::parse(room.out);
        EXPECT_EQ(document["map"]["width"], 60);
        EXPECT_EQ(document["map"]["height"], 40);
        EXPECT_EQ(document["map"]["resolution"], 0.1);
        EXPECT_EQ(document["map"]["occupied_cells"], 80);
        EXPECT_EQ(document["map"]["unknown_cells"], 200);
        EXPECT_EQ(document["map"]["free_cells"], 2120);
        EXPECT_EQ(document["world_box"]["min"], (std::vector<double>{-1.0, 2.0, 0.0}));
        EXPECT_EQ(document["problems"], 1);
        const ProgramResult set = runProgram("check " + path("set.cfg"));
        EXPECT_EQ(set.status, 0);
        EXPECT_NE(set.out.find("10 x 10 cells of 1, 16 occupied, 0 unknown"), std::string::npos) << set.out;
        EXPECT_NE(set.out.find("problems   2, start and goal of each valid"), std::string::npos) << set.out;
        write("bad.scen", "0 wall.map 10 10 1 8 2 8 1\n0 wall.map 10 10 1 8 4 8 1\n");
        write("bad.cfg", "[problem]\nworld = wall.map\nscenario = bad.scen\nrobot = point\n");
        expectBadInput("check " + path("bad.cfg"), {"bad.scen:2: goal (4, 8) is in collision"});
    }

    TEST_F(Maps, ReadyConfigsAreValid)
    {
        const std::string folder = OMPL_MFA_SOURCE_DIR "/benchmarks/maps/";
        for (const char *name : {"warehouse", "office", "parking", "cave"})
        {
            const ProgramResult result = runProgram("check '" + folder + name + ".cfg'");
            EXPECT_EQ(result.status, 0) << result.err;
        }
        if (std::system("python3 -c ''") != 0)  // NOLINT(bugprone-command-processor)
        {
            GTEST_SKIP() << "no python3";
        }
        ASSERT_EQ(std::system(("python3 '" + folder + "make_maps.py' --city " + path("city")).c_str()), 0);  // NOLINT
        setenv("OMPL_MFA_RESOURCE_DIR", path("city").c_str(), 1);
        const ProgramResult result = runProgram("check '" + folder + "city.cfg'");
        unsetenv("OMPL_MFA_RESOURCE_DIR");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("4000 x 4000 cells"), std::string::npos) << result.out;
    }

    TEST_F(Maps, BenchmarkSummarizesTheSet)
    {
        const ProgramResult result = runProgram("benchmark " + path("set.cfg") + " --quiet --json");
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        for (const auto &planner : document["planners"])
        {
            EXPECT_EQ(planner["runs"], 4);
            EXPECT_EQ(planner["solved"], 4);
            EXPECT_GE(planner["cost_to_best_median"].get<double>(), 1.0);
            EXPECT_GE(planner["cost_to_best_95"], planner["cost_to_best_median"]);
            EXPECT_GE(planner["first_solution_set_95"], planner["first_solution_set_median"]);
        }
        // MFA's paths are the best of both problems, and shorter than the octile ones
        EXPECT_NEAR(document["planners"][0]["cost_to_best_95"].get<double>(), 1.0, 0.03);
        EXPECT_LT(document["planners"][0]["cost_to_octile_median"].get<double>(), 1.0);
        const std::string log = readFile(document["log"]);
        EXPECT_NE(log.find("problem INTEGER"), std::string::npos);
        EXPECT_NE(log.find("octile length REAL"), std::string::npos);
        const ProgramResult table = runProgram("benchmark " + path("set.cfg") + " --quiet --overwrite");
        EXPECT_NE(table.out.find("cost / octile"), std::string::npos) << table.out;
    }
}  // namespace ompl_mfa::cli
