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

#include "anytime/PlanarArm.h"
#include "anytime/WorldList.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        using Point = Eigen::Vector2d;

        /* Radians. Between two checked states the tip moves by less than the thickness of the thinnest obstacle. */
        constexpr double RESOLUTION = 0.01;
        constexpr double PI = 3.14159265358979323846;

        /* Stretched out to one side; the goal is the mirror image. */
        Eigen::VectorXd startAngles(int links)
        {
            Eigen::VectorXd angles = Eigen::VectorXd::Constant(links, 0.05);
            angles[0] = 1.3;
            return angles;
        }

        /* A bar pointing at the base, surrounded by discs, all between start and goal: the arm has to fold. */
        Capsules drawObstacles(int links, WorldRandom &random)
        {
            const Eigen::VectorXd start = startAngles(links);
            const Eigen::VectorXd goal = -start;
            const double bar = random.uniform(-0.2, 0.2);
            Capsules obstacles{{0.6 * Point(std::cos(bar), std::sin(bar)), Point(std::cos(bar), std::sin(bar)), 0.02}};
            while (obstacles.size() < 7)
            {
                const double distance = random.uniform(0.55, 0.95);
                const double angle = random.uniform(-1.0, 1.0);
                const Point centre = distance * Point(std::cos(angle), std::sin(angle));
                obstacles.push_back({centre, centre, random.uniform(0.04, 0.08)});
                if (!armIsFree(start.data(), links, obstacles) || !armIsFree(goal.data(), links, obstacles))
                {
                    obstacles.pop_back();
                }
            }
            return obstacles;
        }
    }  // namespace

    World armWorld(int links, std::uint64_t seed)
    {
        World world;
        world.family = "arm_" + std::to_string(links);
        world.name = world.family + "_" + std::to_string(seed);
        world.make = [links, seed]
        {
            WorldRandom random(seed);
            const Eigen::VectorXd limit = Eigen::VectorXd::Constant(links, PI);
            const Eigen::VectorXd start = startAngles(links);
            return makeProblem(-limit, limit, start, -start, RESOLUTION,
                               [links, obstacles = drawObstacles(links, random)](const double *angles)
                               { return armIsFree(angles, links, obstacles); });
        };
        return world;
    }

    std::vector<World> armWorlds()
    {
        return {armWorld(7, 1), armWorld(12, 1)};
    }
}  // namespace ompl_mfa::anytime
