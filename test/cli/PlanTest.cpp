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

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/ConfigFixture.h"
#include "cli/PdfText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        /* Two tangents, two arcs about the corners of the wall, and a segment along it. */
        const double SHORTEST = 9.643501;

        using Point = std::pair<double, double>;

        std::vector<Point> readPath(const std::string &file)
        {
            std::vector<Point> points;
            std::ifstream in(file);
            for (Point point; in >> point.first >> point.second;)
            {
                points.push_back(point);
            }
            return points;
        }

        double length(const std::vector<Point> &points)
        {
            double sum = 0.0;
            for (std::size_t i = 1; i < points.size(); ++i)
            {
                sum += std::hypot(points[i].first - points[i - 1].first, points[i].second - points[i - 1].second);
            }
            return sum;
        }

        double distanceToWall(const Point &point)
        {
            return std::hypot(std::max(0.0, std::abs(point.first - 5.0) - 0.5),
                              std::max(0.0, std::abs(point.second - 3.0) - 2.0));
        }

        class Plan : public ConfigFixture
        {
        };
    }  // namespace

    TEST_F(Plan, PrintsDocumentedKeys)
    {
        const ProgramResult result = runProgram("plan " + config() + " --planner mfa --time 0.5 --seed 3 --json");
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_EQ(document["problem"], "a");
        EXPECT_EQ(document["planner"], "mfa");
        EXPECT_EQ(document["seed"], 3);
        EXPECT_EQ(document["status"], "Exact solution");
        EXPECT_TRUE(document["valid"]);
        EXPECT_GE(document["cost"].get<double>(), SHORTEST - 0.01);
        EXPECT_LE(document["cost"].get<double>(), 1.1 * SHORTEST);
        EXPECT_EQ(document["cost"], document["length"]);
        EXPECT_GT(document["time_to_first_solution"].get<double>(), 0.0);
        EXPECT_LE(document["time_to_first_solution"].get<double>(), document["time"].get<double>());
        EXPECT_GE(document["states"].get<int>(), 3);
        EXPECT_GT(document["evaluations"].get<int>(), 0);
        EXPECT_GT(document["checked_states"].get<int>(), 0);
        EXPECT_GT(document["checked_motions"].get<int>(), 0);
    }

    TEST_F(Plan, WritesThePathThatItPrints)
    {
        const ProgramResult result =
            runProgram("plan " + config() + " --planner rrtstar --json --path " + path("out.path"));
        ASSERT_EQ(result.status, 0) << result.err;
        const auto document = nlohmann::json::parse(result.out);
        const auto points = readPath(path("out.path"));
        ASSERT_EQ(points.size(), document["states"].get<std::size_t>());
        EXPECT_EQ(points.front(), Point(1.0, 3.0));
        EXPECT_EQ(points.back(), Point(9.0, 3.0));
        EXPECT_NEAR(length(points), document["cost"].get<double>(), 1e-9);
        for (const auto &point : points)
        {
            EXPECT_GE(distanceToWall(point), 0.5 - 1e-6);
        }
    }

    TEST_F(Plan, DrawsTheProblemAndItsPath)
    {
        ASSERT_EQ(runProgram("plan " + config() + " --planner mfa --picture " + path("out.pdf")).status, 0);
        std::string text = pdfText(path("out.pdf"));
        for (const std::string word : {"a, MFA, cost 9.6", "obstacles", "best path", "robot", "start", "goal",
                                       "x (world units)", "y (world units)"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
        // the paper's swarm keeps its slices to the end; those of windows come and go
        ASSERT_EQ(runProgram("plan " + config() + " --planner mfa_paper --picture " + path("out.pdf")).status, 0);
        text = pdfText(path("out.pdf"));
        for (const std::string word : {"slices", "the swarm's paths"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
    }

    TEST_F(Plan, DrawsStartAndGoalOfAPointInTheLegendToo)
    {
        const std::string file = OMPL_MFA_SOURCE_DIR "/benchmarks/configs/circle_field.cfg";
        runProgram("plan '" + file + "' --planner rrtconnect --time 5 --picture " + path("out.pdf"));
        const std::string text = pdfText(path("out.pdf"));
        for (const std::string word : {"start", "goal", "obstacles", "best path"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
        EXPECT_EQ(text.find("robot"), std::string::npos) << text;
    }

    TEST_F(Plan, DrawsInTheFormatOfTheExtension)
    {
        const std::string command = "plan " + config() + " --planner mfa_paper --iterations 2000 --time 60 --picture ";
        for (const char *name : {"a.svg", "b.svg", "a.PNG", "b.PNG", "a.pdf", "b.pdf"})
        {
            ASSERT_EQ(runProgram(command + path(name)).status, 0) << name;
        }
        const std::string svg = readFile(path("a.svg"));
        EXPECT_EQ(svg.rfind("<?xml", 0), 0U);
        // the wall from (4.5, 1) to (5.5, 5) in axes of 48 pixels a unit with their corner at (62, 36)
        EXPECT_NE(svg.find("L 278 276 "), std::string::npos);
        EXPECT_NE(svg.find("L 326 468 "), std::string::npos);
        EXPECT_NE(svg.find("stroke:rgb(4.313725%,23.529412%,47.058824%)"), std::string::npos) << "the best path";
        EXPECT_NE(svg.find("stroke:rgb(89.019608%,60.392157%,23.137255%);stroke-opacity:0.3"), std::string::npos)
            << "the swarm";
        EXPECT_NE(svg.find("</svg>"), std::string::npos);
        EXPECT_EQ(readFile(path("a.PNG")).rfind("\x89PNG\r\n\x1a\n", 0), 0U);
        EXPECT_EQ(readFile(path("a.pdf")).rfind("%PDF-", 0), 0U);
        for (const char *extension : {".svg", ".PNG", ".pdf"})
        {
            EXPECT_TRUE(readFile(path(std::string("a") + extension)) == readFile(path(std::string("b") + extension)))
                << extension << ": the same run is the same picture";
        }
    }

    TEST_F(Plan, DrawsASpatialProblemFromTwoSides)
    {
        const std::string file = OMPL_MFA_SOURCE_DIR "/benchmarks/configs/asteroids.cfg";
        runProgram("plan '" + file + "' --planner rrtconnect --time 5 --picture " + path("out.pdf"));
        const std::string text = pdfText(path("out.pdf"));
        for (const std::string word : {", from above", ", from the side", "z (world units)"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << word << " is not in: " << text;
        }
    }

    TEST_F(Plan, PlansThePapersScene)
    {
        const ProgramResult result = runProgram("plan '" OMPL_MFA_SOURCE_DIR
                                                "/benchmarks/configs/paper_scene.cfg'"
                                                " --planner mfa --time 1 --seed 7 --json --path " +
                                                path("out.path"));
        ASSERT_EQ(result.status, 0) << result.err;
        const double optimum = 27.8225;
        const double cost = nlohmann::json::parse(result.out)["cost"].get<double>();
        EXPECT_GE(cost, optimum - 1e-2);
        EXPECT_LE(cost, 1.2 * optimum);
        EXPECT_NEAR(length(readPath(path("out.path"))), cost, 1e-9);
    }

    TEST_F(Plan, PrintsATableForPeople)
    {
        const ProgramResult result = runProgram("plan " + config() + " --planner rrtconnect");
        EXPECT_EQ(result.status, 0);
        EXPECT_EQ(result.err, "");
        for (const std::string word :
             {"status                   Exact solution", "cost ", "time to first solution ", "states ", "evaluations "})
        {
            EXPECT_NE(result.out.find(word), std::string::npos) << word;
        }
    }

    TEST_F(Plan, RepeatsUnderAnIterationLimit)
    {
        const auto cost = [this](const std::string &seed)
        {
            const ProgramResult result = runProgram(
                "plan " + config() + " --planner mfa_paper --iterations 3000 --time 60 --json --seed " + seed);
            return nlohmann::json::parse(result.out)["cost"];
        };
        EXPECT_EQ(cost("4"), cost("4"));
        EXPECT_NE(cost("4"), cost("5"));
    }

    TEST_F(Plan, SimplifiesOnRequest)
    {
        const ProgramResult result = runProgram("plan " + config() + " --planner rrtconnect --simplify --json");
        ASSERT_EQ(result.status, 0);
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_LE(document["cost"].get<double>(), document["unsimplified_cost"].get<double>());
        EXPECT_TRUE(document["valid"]);
    }

    TEST_F(Plan, TakesPlannersAndTheirParametersFromTheConfig)
    {
        const std::string file =
            config("start.x = 1\nstart.y = 3\n", "rrt =\nrrt.name = greedy\nrrt.goal_bias = 0.9\nrrtconnect =\n");
        const auto name = [&file](const std::string &planner)
        { return nlohmann::json::parse(runProgram("plan " + file + " --json --planner " + planner).out)["name"]; };
        EXPECT_EQ(name("greedy"), "greedy");
        EXPECT_EQ(name("rrt"), "greedy");
        EXPECT_EQ(name("prm"), "PRM");
        EXPECT_EQ(runProgram("plan " + file + " --planner greedy --parameter goal_bias=0.05").status, 0);
    }

    TEST_F(Plan, AnApproximateSolutionIsNotASuccess)
    {
        write("closed.yaml",
              "world:\n  collision_objects:\n    - id: wall\n"
              "      primitives: [{type: box, dimensions: [1.0, 40.0, 1.0]}]\n"
              "      primitive_poses: [{position: [5.0, 3.0, 0.0], orientation: [0, 0, 0, 1]}]\n");
        const ProgramResult result =
            runProgram("plan " + config("start.x = 1\nstart.y = 3\n", "", "world = closed.yaml\n") +
                       " --planner rrtconnect --time 0.2 --json");
        EXPECT_EQ(result.status, 1);
        const auto document = nlohmann::json::parse(result.out);
        EXPECT_NE(document["status"], "Exact solution");
        EXPECT_TRUE(document["time_to_first_solution"].is_null());
    }

    TEST_F(Plan, RefusesWhatItCannotUse)
    {
        const std::string file = config();
        expectBadInput("plan " + file + " --planner mfaa", {"mfaa", "mfa"});
        expectBadInput("plan " + file + " --parameter populaton_size=20", {"populaton_size", "population_size"});
        expectBadInput("plan " + file + " --parameter population_size=-4", {"population_size", "-4"});
        expectBadInput("plan " + file + " --parameter population_size", {"NAME=VALUE"});
        expectBadInput("plan " + file + " --seed 0", {"seed"});
        for (const char *time : {"-1", "0", "nan", "inf", "1e10", "x"})
        {
            expectBadInput("plan " + file + " --time " + time, {"--time"});
        }
        expectBadInput("plan " + file + " --picture /no/such/folder/a.svg --time 1000", {"/no/such/folder/a.svg"});
        std::filesystem::create_directory(path("folder.svg"));
        expectBadInput("plan " + file + " --picture " + path("folder.svg") + " --time 1000", {"folder.svg:"});
        for (const char *name : {"a.jpg", "a", "a.svg.gz"})
        {
            expectBadInput("plan " + file + " --picture " + path(name) + " --time 1000", {name, ".svg, .png or .pdf"});
        }
        // it can be opened, but not written to
        std::filesystem::create_symlink("/dev/full", path("full.png"));
        expectBadInput("plan " + file + " --picture " + path("full.png") + " --planner rrtconnect", {"full.png"});
        expectBadInput("plan " + file + " --path /no/such/folder/a.path --planner rrtconnect",
                       {"/no/such/folder/a.path"});
        expectBadInput("plan " + path("none.cfg"), {"none.cfg"});
    }

    TEST_F(Plan, APlannerThatReturnsEarlyIsNotHeldUpByALongTimeLimit)
    {
        const ProgramResult result = runProgram("plan " + config() + " --planner rrtconnect --time 1e9 --json");
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_LT(nlohmann::json::parse(result.out)["time"].get<double>(), 60.0);
    }

    TEST_F(Plan, NamesFileAndLineOfABadConfig)
    {
        const std::string start = "start.x = 1\nstart.y = 3\n";
        expectBadInput("plan " + config(start, "rrtsta =\n"), {"a.cfg:18", "rrtsta", "rrtstar"});
        expectBadInput("plan " + config(start + "start.w = 3\n"), {"a.cfg:7", "start.w"});
        expectBadInput("plan " + config("start.x = 5\nstart.y = 3\n"), {"a.cfg:5", "start (5, 3)", "collision"});
        expectBadInput("plan " + config("start.x = 1\nstart.y = -3\n"), {"a.cfg:5", "start (1, -3)", "bounds"});
        expectBadInput("plan " + config(start, "", "world = none.yaml\n"), {"a.cfg:2", "none.yaml"});
        write("empty.yaml", "");
        expectBadInput("plan " + config(start, "", "world = empty.yaml\n"), {"a.cfg:2", "empty.yaml"});
        write("broken.yaml", "world: {");
        expectBadInput("plan " + config(start, "", "world = broken.yaml\n"), {"a.cfg:2", "broken.yaml"});
        write("negative.yaml",
              "world:\n  collision_objects:\n    - id: ball\n"
              "      primitives: [{type: sphere, dimensions: [-1.0]}]\n");
        expectBadInput("plan " + config(start, "", "world = negative.yaml\n"), {"a.cfg:2", "negative.yaml", "-1"});
    }
}  // namespace ompl_mfa::cli
