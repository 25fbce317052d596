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

#include "benchmark/MapProblem.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "benchmark/InputErrorOf.h"
#include "maps/MapFolder.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "ompl_mfa/maps/MapMotionValidator.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using maps::test::MapFolder;
        using test::inputErrorOf;

        const std::string POINT = "robot = point\n";
        const std::string POSITIONS = "start.x = 0\nstart.y = 0\ngoal.x = 4\ngoal.y = 0\n";

        /* A folder with a map of both kinds, 5 cells wide and 3 high, and a scenario. */
        class MapProblem : public testing::Test
        {
        protected:
            MapProblem()
            {
                folder_.write("a.map", "type octile\nheight 3\nwidth 5\nmap\n.....\n..@..\n.....\n");
                folder_.write("a.map.scen",
                              "version 1\n0\ta.map\t5\t3\t0\t0\t4\t0\t4\n0\tmaps/a.map\t5\t3\t0\t2\t4\t2\t4.5\n"
                              "1\ta.map\t5\t3\t0\t1\t4\t1\t4.828\n");
                folder_.write("m.pgm", "P2 5 3 255\n254 254 254 254 254 254 254 0 254 254 254 254 254 254 205\n");
                folder_.write("m.yaml",
                              "image: m.pgm\nresolution: 0.1\norigin: [1, 2, 0]\nnegate: 0\n"
                              "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
                folder_.write("scene.yaml", "world:\n  collision_objects: []\n");
            }

            BenchmarkConfig config(const std::string &lines) const
            {
                std::istringstream in("[problem]\n" + lines);
                return parseBenchmarkConfig(in, folder_.path() / "a.cfg");
            }

            std::string faultOf(const std::string &lines) const
            {
                const std::string fault = inputErrorOf([&] { ProblemFactory(config(lines)).create(); });
                const std::string place = folder_.path().string() + "/";
                return fault.rfind(place, 0) == 0 ? fault.substr(place.size()) : fault;
            }

            void expectFault(const std::string &lines, const std::string &begin, const std::string &part) const
            {
                const std::string fault = faultOf(lines);
                EXPECT_EQ(fault.rfind(begin, 0), 0U) << fault;
                EXPECT_NE(fault.find(part), std::string::npos) << fault;
            }

            MapFolder folder_;
        };
    }  // namespace

    TEST_F(MapProblem, ProblemsOfAMapAreCheckedContinuouslyInItsBox)
    {
        const ProblemFactory factory(config("world = a.map\n" + POINT + POSITIONS));
        ASSERT_NE(factory.map(), nullptr);
        EXPECT_TRUE(factory.world().objects().empty());
        const auto setup = factory.create();
        const auto &si = setup->getSpaceInformation();
        EXPECT_NE(dynamic_cast<maps::MapMotionValidator *>(si->getMotionValidator().get()), nullptr);
        EXPECT_NE(dynamic_cast<maps::MapStateValidityChecker *>(si->getStateValidityChecker().get()), nullptr);
        const auto &bounds = setup->getStateSpace()->as<ompl::base::RealVectorStateSpace>()->getBounds();
        EXPECT_EQ(bounds.low, (std::vector<double>{-0.5, -0.5}));
        EXPECT_EQ(bounds.high, (std::vector<double>{4.5, 2.5}));
        const auto discrete =
            ProblemFactory(config("world = a.map\nmotion_validation = discrete\n" + POINT + POSITIONS)).create();
        EXPECT_NE(dynamic_cast<ompl::base::DiscreteMotionValidator *>(
                      discrete->getSpaceInformation()->getMotionValidator().get()),
                  nullptr);
    }

    TEST_F(MapProblem, RobotsAreThoseOfTheKeys)
    {
        const std::string turned = POSITIONS + "start.theta = 0\ngoal.theta = 0\n";
        const ProblemFactory disc(config("world = a.map\nrobot = disc\nrobot.radius = 0.4\n" + POSITIONS));
        EXPECT_EQ(disc.footprint().margin(), 0.4);
        const ProblemFactory polygon(
            config("world = a.map\nrobot = footprint\nrobot.footprint = [[-0.2, -0.1], [0.2,-0.1],[ 0.2 , 0.1], [-.2, "
                   "1e-1] ]\n"
                   "robot.padding = 0.05\n" +
                   turned));
        EXPECT_EQ(polygon.footprint().corners().size(), 4U);
        EXPECT_EQ(polygon.footprint().corners()[3], Eigen::Vector2d(-0.2, 0.1));
        EXPECT_EQ(polygon.footprint().margin(), 0.05);
        EXPECT_TRUE(polygon.create()->getStateSpace()->isCompound());
        for (const char *car : {"dubins", "reedsshepp"})
        {
            EXPECT_EQ(
                faultOf("world = a.map\nstatespace = " + std::string(car) + "\nturningradius = 0.2\n" + POINT + turned),
                "");
        }
    }

    TEST_F(MapProblem, UnknownCellsAreEnteredOnRequest)
    {
        // the lower right cell of the map is unknown
        const std::string lines =
            "world = m.yaml\n" + POINT + "start.x = 1.05\nstart.y = 2.05\ngoal.x = 1.45\ngoal.y = 2.05\n";
        expectFault(lines, "a.cfg:6: goal (1.45, 2.05) is in unknown space", "problem.map.unknown = free");
        expectFault(lines + "map.unknown = occupied\n", "a.cfg:6: goal", "unknown space");
        EXPECT_EQ(faultOf(lines + "map.unknown = free\n"), "");
        expectFault(lines + "map.unknown = maybe\n", "a.cfg:8: problem.map.unknown = maybe", "occupied, free");
    }

    TEST_F(MapProblem, ScenarioGivesASetOfProblems)
    {
        const std::string lines = "world = a.map\nscenario = a.map.scen\n" + POINT;
        ProblemFactory factory(config(lines));
        ASSERT_EQ(factory.problems().size(), 3U);
        EXPECT_EQ(factory.config().problem.goal.x, 4.0);
        EXPECT_EQ(factory.config().problem.goal.y, 0.0);
        factory.select(2);
        EXPECT_EQ(factory.config().problem.start.y, 1.0);
        EXPECT_EQ(factory.problems()[2].octileLength, 4.828);
        const auto setup = factory.create();
        EXPECT_EQ(setup->getProblemDefinition()
                      ->getStartState(0)
                      ->as<ompl::base::RealVectorStateSpace::StateType>()
                      ->values[1],
                  1.0);
        const auto indices = [&](const std::string &index)
        {
            std::string text;
            const ProblemFactory selected(config(lines + "scenario.index = " + index + "\n"));
            for (const auto &problem : selected.problems())
            {
                text += std::to_string(problem.index);
            }
            return text;
        };
        EXPECT_EQ(indices("all"), "012");
        EXPECT_EQ(indices("1"), "1");
        EXPECT_EQ(indices("1-2"), "12");
        EXPECT_EQ(indices("0 - 1"), "01");
        // with angles the problems are of SE(2)
        EXPECT_TRUE(ProblemFactory(config(lines + "start.theta = 0\ngoal.theta = 1\n"))
                        .create()
                        ->getStateSpace()
                        ->isCompound());
    }

    TEST_F(MapProblem, ObjectivesOfMaps)
    {
        const std::string lines = "world = a.map\n" + POINT + POSITIONS;
        const std::string turned = "start.theta = 0\ngoal.theta = 0\n";
        const auto cost = [&](const std::string &objective)
        {
            const auto setup = ProblemFactory(config(lines + objective)).create();
            const auto &si = setup->getSpaceInformation();
            ompl::geometric::PathGeometric path(si, setup->getProblemDefinition()->getStartState(0),
                                                setup->getGoal()->as<ompl::base::GoalState>()->getState());
            return path.cost(setup->getOptimizationObjective()).value();
        };
        // 0.5 from the edge all the way
        EXPECT_NEAR(cost("objective = clearance_cost\nobjective.cost_penalty = 3\nobjective.cost_scaling_factor = 2\n"),
                    4.0 * (1.0 + 3.0 * std::exp(-1.0)), 1e-6);
        EXPECT_NEAR(cost("objective = clearance_cost\nobjective.inscribed_radius = 0.5\n"), 4.0 * 3.0, 1e-6);
        EXPECT_NEAR(
            cost("objective = weighted\nobjective.weight.length = 2\nobjective.weight.smoothness = 7\n" + turned), 8.0,
            1e-12);
        expectFault("volume.min.x = -9\nvolume.min.y = -9\nvolume.max.x = 9\nvolume.max.y = 9\n" + POINT + POSITIONS +
                        "objective = clearance_cost\n",
                    "a.cfg:11: ", "clearance_cost is for maps");
        expectFault(lines + "objective = weighted\nobjective.weight.smoothness = 1\n", "a.cfg:8: ", "in SE(2)");
        expectFault(lines + "objective = length\nobjective.cost_penalty = 1\n",
                    "a.cfg:9: problem.objective.cost_penalty", "only clearance_cost");
    }

    TEST_F(MapProblem, FaultsOfKeys)
    {
        const std::string map = "world = a.map\n";
        expectFault(map + "robot = footprint\n" + POSITIONS, "a.cfg:3: problem.robot = footprint",
                    "needs problem.robot.footprint");
        expectFault(map + POINT + "robot.footprint = [[0, 0], [1, 0], [0, 1]]\n" + POSITIONS, "a.cfg:4",
                    "only 'robot = footprint'");
        expectFault(map + POINT + "robot.padding = 1\n" + POSITIONS, "a.cfg:4", "only 'robot = footprint'");
        const std::string bow = "robot = footprint\nrobot.footprint = [[0, 0], [0.1, 0.1], [0.1, 0], [0, 0.1]]\n";
        expectFault(map + bow + POSITIONS, "a.cfg:4: problem.robot.footprint = [[0, 0]", "crosses or touches itself");
        for (const char *corners :
             {"[0, 0]", "[[0, 0], [1]]", "[[0, 0], [1, x]]", "[[0, 0], [1, 2]", "0, 0, 1, 1", "[[0,0],[1,0]],[[0,1]]"})
        {
            expectFault(map + "robot = footprint\nrobot.footprint = " + corners + "\n" + POSITIONS,
                        "a.cfg:4: problem.robot.footprint", "expected [[x, y]");
        }
        expectFault(map + "robot = sphere\nrobot.radius = 1\n" + POSITIONS, "a.cfg:3: problem.robot = sphere",
                    "point, disc, footprint");
        expectFault(map + POINT + POSITIONS + "start.z = 0\ngoal.z = 0\n", "a.cfg:2: problem.world = a.map",
                    "a map is planar");
        expectFault("world = scene.yaml\nmap.unknown = free\n" + POINT + POSITIONS, "a.cfg:3: problem.map.unknown",
                    "the world is no map");
        expectFault("world = scene.yaml\nscenario = a.map.scen\n" + POINT, "a.cfg:3: problem.scenario",
                    "the world is no map");
        expectFault("world = scene.yaml\nrobot = footprint\nrobot.footprint = [[0,0],[1,0],[0,1]]\n" + POSITIONS,
                    "a.cfg:3: problem.robot", "the world is no map");
        expectFault(map + POINT + "scenario = a.map.scen\nstart.x = 1\n", "a.cfg:5: problem.start.x",
                    "the scenario gives the positions");
        expectFault(map + POINT + POSITIONS + "scenario.index = 1\n", "a.cfg:8: problem.scenario.index",
                    "needs problem.scenario");
        expectFault(map + POINT + "scenario = a.map.scen\nscenario.index = 3\n", "a.cfg:5: problem.scenario.index = 3",
                    "problems 0 to 2");
        expectFault(map + POINT + "scenario = a.map.scen\nscenario.index = 2-1\n",
                    "a.cfg:5: problem.scenario.index = 2-1", "expected a whole number");
        expectFault(map + POINT + "start.x = 2\nstart.y = 1\ngoal.x = 4\ngoal.y = 1\n",
                    "a.cfg:4: start (2, 1) is in collision with the world 'a.map'", "");
        expectFault(map + POINT + "start.x = 0\nstart.y = 1\ngoal.x = 9\ngoal.y = 1\n",
                    "a.cfg:6: goal (9, 1) is outside the bounds", "");
    }

    TEST_F(MapProblem, FaultsOfScenarios)
    {
        const auto faultOfLine = [this](const std::string &line)
        {
            folder_.write("b.scen", "version 1\n" + line + "\n");
            return faultOf("world = a.map\nrobot = point\nscenario = b.scen\n");
        };
        const auto expectLine = [&](const std::string &line, const std::string &part)
        {
            const std::string fault = faultOfLine(line);
            EXPECT_EQ(fault.rfind("a.cfg:4: problem.scenario = b.scen: ", 0), 0U) << fault;
            EXPECT_NE(fault.find("b.scen:2: " + part), std::string::npos) << fault;
        };
        EXPECT_EQ(faultOfLine("0 a.map 5 3 0 0 4 0 4"), "");
        expectLine("0 b.map 5 3 0 0 4 0 4", "the scenario is for the map 'b.map', not for 'a.map'");
        expectLine("0 a.map 6 3 0 0 4 0 4", "the scenario is for a map of 6 x 3 cells");
        expectLine("0 a.map 5 3 0 0 4 3 4", "the goal (4, 3) is outside of the map");
        expectLine("0 a.map 5 3 -1 0 4 0 4", "start x -1: expected a whole number");
        expectLine("0 a.map 5 3 0 0 4 0 x", "length x: expected a number");
        expectLine("0 a.map 5 3 0 0 4 0", "the line has 8 columns");
        EXPECT_NE(faultOfLine("").find("b.scen: the scenario has no problem"), std::string::npos);
        const std::string occupied = faultOfLine("0 a.map 5 3 2 1 4 0 4");
        EXPECT_NE(occupied.find("b.scen:2: start (2, 1) is in collision"), std::string::npos) << occupied;
    }

    TEST(MapProblemOfOthers, EveryProblemOfTheSharedScenariosIsValid)
    {
        const std::filesystem::path folder = maps::test::sharedMaps();
        if (folder.empty())
        {
            GTEST_SKIP() << "no shared maps";
        }
        std::istringstream in(
            "[problem]\nworld = movingai/Berlin_0_256.map\nscenario = movingai/Berlin_0_256.map.scen\n"
            "robot = point\n");
        ProblemFactory factory(parseBenchmarkConfig(in, folder / "a.cfg"));
        EXPECT_EQ(factory.problems().size(), 930U);
        for (std::size_t number = 0; number < factory.problems().size(); number += 31)
        {
            factory.select(number);
            EXPECT_NO_THROW(factory.create());
        }
    }
}  // namespace ompl_mfa::benchmark
