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

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "oracle/ShortestPath.h"

namespace ompl_mfa::oracle
{
    /* Reads the scene with its own reader, so that the optimum against which planners are measured depends neither on
       ompl_mfa_collision nor on the planner. */
    namespace
    {
        const Point START(0.3, 2.2);
        const Point GOAL(20.0, 20.0);
        constexpr double ROBOT_RADIUS = 0.3;

        Scene readScene()
        {
            const YAML::Node file = YAML::LoadFile(OMPL_MFA_SOURCE_DIR "/benchmarks/worlds/paper_scene.yaml");
            Scene scene;
            scene.robotRadius = ROBOT_RADIUS;
            scene.lower = {0.0, 0.0};
            scene.upper = {20.0, 20.0};
            for (const YAML::Node &object : file["world"]["collision_objects"])
            {
                const YAML::Node primitive = object["primitives"][0];
                const YAML::Node pose = object["primitive_poses"][0];
                const auto size = primitive["dimensions"].as<std::vector<double>>();
                const auto position = pose["position"].as<std::vector<double>>();
                const auto turn = pose["orientation"].as<std::vector<double>>();
                const Point centre(position.at(0), position.at(1));
                if (turn.at(0) != 0.0 || turn.at(1) != 0.0 || position.at(2) != 0.0)
                {
                    throw std::invalid_argument("paper_scene.yaml: obstacles must stand upright at z = 0");
                }
                const auto type = primitive["type"].as<std::string>();
                const double angle = 2.0 * std::atan2(turn.at(2), turn.at(3));
                if (type != "cylinder" && type != "box")
                {
                    throw std::invalid_argument("paper_scene.yaml: unexpected type " + type);
                }
                scene.obstacles.push_back(type == "box" ? rectangle(centre, {size.at(0), size.at(1)}, angle)
                                                        : disc(centre, size.at(1)));
            }
            return scene;
        }

        Point centreOf(const Obstacle &obstacle)
        {
            Point sum = Point::Zero();
            for (const Point &vertex : obstacle.vertices)
            {
                sum += vertex;
            }
            return sum / static_cast<double>(obstacle.vertices.size());
        }
    }  // namespace

    TEST(PaperScene, HasAnOptimumNear28)
    {
        const Scene scene = readScene();
        EXPECT_GE(scene.obstacles.size(), 8u);
        EXPECT_LE(scene.obstacles.size(), 12u);
        /* The figure that the config, the README and the study quote. */
        EXPECT_NEAR(shortestPath(scene, START, GOAL).length, 27.8225, 5e-5);
    }

    TEST(PaperScene, HasAnOptimumThatSlicesCanExpress)
    {
        const ShortestPath best = shortestPath(readScene(), START, GOAL);
        const Point axis = (GOAL - START).normalized();
        for (std::size_t i = 1; i < best.path.size(); ++i)
        {
            EXPECT_GT((best.path[i] - best.path[i - 1]).dot(axis), 0.0);
        }
    }

    TEST(PaperScene, HasSeveralHomotopyClassesNearTheOptimum)
    {
        /* A wall from an obstacle outwards, on one side of it, leaves only the homotopy classes on the other side. */
        const Scene scene = readScene();
        const double optimum = shortestPath(scene, START, GOAL).length;
        const Point along = (GOAL - START).normalized();
        const Point across(-along.y(), along.x());
        std::vector<double> classes{optimum};
        for (const Obstacle &obstacle : scene.obstacles)
        {
            for (const double side : {-1.0, 1.0})
            {
                Scene walled = scene;
                walled.obstacles.push_back(rectangle(centreOf(obstacle) + 20.0 * side * across, {40.0, 0.01},
                                                     std::atan2(across.y(), across.x())));
                const double length = shortestPath(walled, START, GOAL).length;
                const bool isNew = std::none_of(classes.begin(), classes.end(),
                                                [&](double other) { return std::abs(other - length) < 1e-4; });
                if (isNew && length < 1.05 * optimum)
                {
                    classes.push_back(length);
                }
            }
        }
        EXPECT_GE(classes.size(), 6u);
    }

    TEST(PaperScene, IsSymmetricInStartAndGoal)
    {
        const Scene scene = readScene();
        EXPECT_NEAR(shortestPath(scene, START, GOAL).length, shortestPath(scene, GOAL, START).length, 1e-9);
    }
}  // namespace ompl_mfa::oracle
