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

#include <utility>

#include "anytime/WorldList.h"
#include "oracle/ShortestPath.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        constexpr int CIRCLES = 70;
        constexpr double RESOLUTION = 0.001;

        oracle::Point start()
        {
            return {0.05, 0.5};
        }

        oracle::Point goal()
        {
            return {0.95, 0.5};
        }

        oracle::Scene drawScene(WorldRandom &random)
        {
            oracle::Scene scene;
            scene.lower = {0.0, 0.0};
            scene.upper = {1.0, 1.0};
            while (static_cast<int>(scene.obstacles.size()) < CIRCLES)
            {
                const double radius = random.uniform(0.02, 0.06);
                const double x = random.uniform(0.0, 1.0);
                const oracle::Point centre(x, random.uniform(0.0, 1.0));
                if ((centre - start()).norm() > radius + 0.02 && (centre - goal()).norm() > radius + 0.02)
                {
                    scene.obstacles.push_back(oracle::disc(centre, radius));
                }
            }
            return scene;
        }

        oracle::Scene makeScene(std::uint64_t seed)
        {
            WorldRandom random(seed);
            return drawScene(random);
        }

        StateCheck circleCheck(std::uint64_t seed)
        {
            std::vector<double> circles;  // x, y and squared radius of each disc
            for (const auto &disc : makeScene(seed).obstacles)
            {
                circles.insert(circles.end(), {disc.vertices[0].x(), disc.vertices[0].y(), disc.radius * disc.radius});
            }
            return [circles = std::move(circles)](const double *x)
            {
                for (std::size_t i = 0; i < circles.size(); i += 3)
                {
                    const double dx = x[0] - circles[i];
                    const double dy = x[1] - circles[i + 1];
                    if (dx * dx + dy * dy < circles[i + 2])
                    {
                        return false;
                    }
                }
                return true;
            };
        }
    }  // namespace

    double circleOptimum(std::uint64_t seed, double margin)
    {
        oracle::Scene scene = makeScene(seed);
        scene.robotRadius = margin;
        return oracle::shortestPath(scene, start(), goal()).length;
    }

    bool hasNarrowCircles(std::uint64_t seed)
    {
        return circleOptimum(seed, 0.004) > 1.02 * circleOptimum(seed, 0.0);
    }

    World circleWorld(std::uint64_t seed)
    {
        World world;
        world.family = "circles_narrow_2d";
        world.name = world.family + "_" + std::to_string(seed);
        world.make = [seed]
        {
            return makeProblem(Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones(), start(), goal(), RESOLUTION,
                               circleCheck(seed));
        };
        world.optimum = [seed] { return circleOptimum(seed, 0.0); };
        return world;
    }

    std::vector<World> circleWorlds()
    {
        // the first seeds for which hasNarrowCircles()
        return {circleWorld(3), circleWorld(7), circleWorld(8)};
    }
}  // namespace ompl_mfa::anytime
