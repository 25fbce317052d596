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

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/RunProgram.h"

namespace ompl_mfa::cli
{
    namespace
    {
        /* A folder with a map of 40 x 25 cells and a wall from the lower edge, a map without it, and a config. */
        class Drive : public testing::Test
        {
        protected:
            Drive()
              : folder_(std::filesystem::temp_directory_path() / ("ompl_mfa_drive_" + std::to_string(::getpid())))
            {
                std::filesystem::create_directories(folder_);
                const std::string open(40, '.');
                std::string wall = open;
                wall[20] = '@';
                std::string empty = "type octile\nheight 25\nwidth 40\nmap\n";
                std::string walled = empty;
                for (int row = 0; row < 25; ++row)
                {
                    empty += open + "\n";
                    walled += (row < 5 ? open : wall) + "\n";
                }
                write("empty.map", empty);
                write("wall.map", walled);
                write("small.map", "type octile\nheight 1\nwidth 3\nmap\n...\n");
                write("wall.scen",
                      "version 1\n0\twall.map\t40\t25\t1\t8\t2\t8\t1\n4\twall.map\t40\t25\t1\t8\t8\t8\t7\n");
            }

            ~Drive() override
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

            /* Writes and names a.cfg, from the left of the wall to its right. */
            std::string config(const std::string &settings = "",
                               const std::string &poses = "start.x = 3\nstart.y = 12\ngoal.x = 36\ngoal.y = 12\n",
                               const std::string &world = "wall.map") const
            {
                write("a.cfg", "[problem]\nworld = " + world +
                                   "\nrobot = disc\nrobot.radius = 0.6\nobjective = length\ndrive.speed = 2\n"
                                   "drive.period = 0.5\ndrive.replan_time = 0.02\n" +
                                   poses + settings);
                return path("a.cfg");
            }

            std::filesystem::path folder_;
        };

        std::vector<std::vector<std::string>> readCsv(const std::string &file)
        {
            std::vector<std::vector<std::string>> rows;
            std::ifstream in(file);
            for (std::string line; std::getline(in, line);)
            {
                rows.emplace_back();
                std::istringstream cells(line);
                for (std::string cell; std::getline(cells, cell, ',');)
                {
                    rows.back().push_back(cell);
                }
            }
            return rows;
        }
    }  // namespace

    TEST_F(Drive, OneDriveIsPrintedAndWritten)
    {
        const ProgramResult result = runProgram("drive " + config() + " --json --optimum-time 0.3 --csv " +
                                                path("a.csv") + " --animation " + path("a.html"));
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(result.err, "");
        const auto document = nlohmann::json::parse(result.out);
        ASSERT_EQ(document["drives"].size(), 1U);
        const auto &drive = document["drives"][0];
        EXPECT_EQ(drive["status"], "arrived");
        EXPECT_EQ(drive["planner"], "MFA");
        // around the wall's end at (20, 4.5)
        const double least = 2.0 * std::hypot(16.5, 7.5) - 2.0;
        EXPECT_GE(drive["optimum"].get<double>(), least);
        EXPECT_GE(drive["length"].get<double>(), drive["optimum"].get<double>() - 0.1);
        EXPECT_GE(drive["blockages"].get<int>(), 1);
        EXPECT_EQ(drive["repair_times"]["count"], drive["blockages"]);
        const auto &times = drive["repair_times"];
        EXPECT_LE(times["median"].get<double>(), times["quantile_99"].get<double>());
        EXPECT_LE(times["quantile_99"].get<double>(), times["longest"].get<double>());
        EXPECT_EQ(document["planners"][0]["arrived"], 1);
        EXPECT_EQ(document["planners"][0]["collisions"], 0);

        const auto rows = readCsv(path("a.csv"));
        ASSERT_EQ(rows.size(), 1 + drive["periods"].get<std::size_t>());
        EXPECT_EQ(rows[0][0], "planner");
        EXPECT_EQ(rows[1][3], "3");
        double before = -1.0;
        int blocked = 0;
        for (std::size_t i = 1; i < rows.size(); ++i)
        {
            EXPECT_EQ(std::stod(rows[i][2]), 0.5 * static_cast<double>(i - 1));
            const double driven = std::stod(rows[i][6]);
            EXPECT_TRUE(driven >= before && driven <= before + 2.0) << i;
            before = driven;
            blocked += rows[i][8] == "1" ? 1 : 0;
        }
        EXPECT_EQ(blocked, drive["blockages"].get<int>());

        const std::string page = readFile(path("a.html"));
        EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0U);
        EXPECT_NE(page.find("MFA drives on a"), std::string::npos);
        EXPECT_NE(page.find("default-src 'none'"), std::string::npos) << "the page may load something";
    }

    TEST_F(Drive, PeopleGetAText)
    {
        const ProgramResult result = runProgram("drive " + config() + " --optimum-time 0");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("status                   arrived\n"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("optimum, all known       none\n"), std::string::npos) << result.out;
    }

    TEST_F(Drive, ManyDrivesOfSeveralPlannersMakeATable)
    {
        const std::string arguments = "drive " + config("drive.patience = 0.5\n") +
                                      " --drives 3 --seed 5 --optimum-time 0.1 --planner mfa,rrtconnect";
        const ProgramResult result = runProgram(arguments);
        ASSERT_EQ(result.status, 0) << result.out << result.err;
        std::istringstream lines(result.out);
        std::string line;
        std::getline(lines, line);
        EXPECT_EQ(line.rfind("planner", 0), 0U);
        for (const char *planner : {"MFA", "RRTConnect"})
        {
            std::getline(lines, line);
            std::istringstream cells(line);
            std::string name;
            int drives = 0;
            int arrived = 0;
            int collisions = -1;
            cells >> name >> drives >> arrived >> collisions;
            EXPECT_EQ(name, planner);
            EXPECT_EQ(drives, 3);
            EXPECT_EQ(arrived, 3);
            EXPECT_EQ(collisions, 0);
        }
        const auto document = nlohmann::json::parse(runProgram(arguments + " --json").out);
        ASSERT_EQ(document["drives"].size(), 6U);
        ASSERT_EQ(document["planners"].size(), 2U);
        EXPECT_EQ(document["drives"][5]["drive"], 2);
    }

    TEST_F(Drive, AGoalThatCannotBeReachedIsStatusOne)
    {
        std::string closed = readFile(path("wall.map"));
        for (std::size_t row = 0; row < 5; ++row)
        {
            closed[closed.find("map\n") + 4 + 41 * row + 20] = '@';
        }
        write("closed.map", closed);
        const std::string arguments =
            "drive " +
            config("drive.patience = 0.2\n", "start.x = 3\nstart.y = 12\ngoal.x = 36\ngoal.y = 12\n", "closed.map") +
            " --optimum-time 0.1 --json";
        const ProgramResult result = runProgram(arguments);
        EXPECT_EQ(result.status, 1) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["drives"][0]["status"], "no path");
        EXPECT_TRUE(document["drives"][0]["optimum"].is_null());
        EXPECT_EQ(document["planners"][0]["arrived"], 0);
    }

    TEST_F(Drive, ScenariosGiveAProblem)
    {
        const std::string scenario = "scenario = wall.scen\nscenario.index = ";
        EXPECT_EQ(runProgram("drive " + config("", scenario + "1\n") + " --optimum-time 0").status, 0);
        expectBadInput("drive " + config("", scenario + "0-1\n"), {"stands for 2 problems", "scenario.index"});
    }

    TEST_F(Drive, BadInputIsOneLine)
    {
        expectBadInput("drive " + config("sensor.range = 0\n"), {"sensor.range = 0", "a number above 0"});
        expectBadInput("drive " + config("sensor.rays = 0\n"), {"sensor.rays = 0", "a whole number from 1 to 100000"});
        expectBadInput("drive " + config("drive.sped = 1\n"), {"drive.sped", "drive.speed"});
        expectBadInput("drive " + config("drive.time_limit = inf\n"), {"drive.time_limit = inf"});
        expectBadInput("drive " + config("known_map = none.map\n"), {"known_map = none.map", "no such file"});
        expectBadInput("drive " + config("known_map = small.map\n"), {"3 x 1 cells, the world 40 x 25"});
        expectBadInput("drive " + config("motion_validation = discrete\n"), {"motion_validation", "continuous"});
        expectBadInput("drive " + config("", "start.x = 20\nstart.y = 12\ngoal.x = 36\ngoal.y = 12\n"),
                       {"start (20, 12) is in collision"});
        expectBadInput("drive " + config() + " --drives 2 --optimum-time 0", {"--optimum-time 0", "above 0"});
        expectBadInput("drive " + config() + " --optimum-time -1", {"--optimum-time -1"});
        expectBadInput("drive " + config() + " --drives 2 --animation " + path("a.html"), {"--animation"});
        expectBadInput("drive " + config() + " --planner mfo", {"mfo", "mfa"});
        expectBadInput("drive " + config() + " --csv " + path("none/a.csv"), {"--csv", "none/a.csv"});
        write("b.cfg",
              "[problem]\nrobot = disc\nrobot.radius = 0.5\nstart.x = 1\nstart.y = 1\ngoal.x = 2\ngoal.y = 2\n"
              "volume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 9\nvolume.max.y = 9\n");
        expectBadInput("drive " + path("b.cfg"), {"b.cfg", "a map"});
    }
}  // namespace ompl_mfa::cli
