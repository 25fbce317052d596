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

#include "paper/StudyScenes.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/PlanningScene.h"
#include "ompl_mfa/optimizer/RandomSource.h"

using ompl_mfa::oracle::Obstacle;

namespace ompl_mfa::paper
{
    namespace
    {
        constexpr double ROBOT_RADIUS = 0.3;
        constexpr double EDGE = 20.0;

        Obstacle toObstacle(const collision::CollisionObject &object, const std::string &file)
        {
            const Point centre = object.pose.translation().head<2>();
            const Eigen::Matrix3d turn = object.pose.linear();
            if (const auto *cylinder = dynamic_cast<const fcl::Cylinderd *>(object.geometry.get()))
            {
                return oracle::disc(centre, cylinder->radius);
            }
            if (const auto *box = dynamic_cast<const fcl::Boxd *>(object.geometry.get()))
            {
                return oracle::rectangle(centre, box->side.head<2>(), std::atan2(turn(1, 0), turn(0, 0)));
            }
            throw InputError(file + ": obstacle '" + object.id + "' is not accepted; it must be a cylinder or a box");
        }

        oracle::Scene emptyWorld()
        {
            oracle::Scene world;
            world.robotRadius = ROBOT_RADIUS;
            world.lower = {0.0, 0.0};
            world.upper = {EDGE, EDGE};
            return world;
        }

        Obstacle drawObstacle(RandomSource &random, bool round)
        {
            const Point centre(EDGE * random.uniform(), EDGE * random.uniform());
            if (round)
            {
                return oracle::disc(centre, 0.6 + 1.2 * random.uniform());
            }
            const double length = 1.5 + 4.5 * random.uniform();
            const double width = 0.5 + 1.0 * random.uniform();
            return oracle::rectangle(centre, {length, width}, M_PI * random.uniform());
        }

        bool isWorthPlanning(const PathScene &scene)
        {
            const PlanarCollision collision(scene.world);
            if (!collision.isValid(scene.start) || !collision.isValid(scene.goal))
            {
                return false;
            }
            if (collision.invalidLength(scene.start, scene.goal) == 0.0)
            {
                return false;
            }
            return std::isfinite(oracle::shortestPath(scene.world, scene.start, scene.goal).length);
        }
    }  // namespace

    std::vector<PathScene> paperScenes(const std::string &worldFile)
    {
        oracle::Scene world = emptyWorld();
        const collision::Scene scene = collision::loadPlanningScene(worldFile);
        for (const auto &object : scene.objects())
        {
            world.obstacles.push_back(toObstacle(object, worldFile));
        }
        const Point goal(20.0, 20.0);
        return {{"paper_1", world, {0.3, 2.2}, goal},
                {"paper_2", world, {0.5, 13.0}, goal},
                {"paper_3", world, {8.0, 1.0}, goal},
                {"paper_4", world, {13.0, 5.0}, goal}};
    }

    std::vector<PathScene> seededScenes(unsigned int count)
    {
        std::vector<PathScene> scenes;
        scenes.reserve(count);
        for (unsigned int i = 1; i <= count; ++i)
        {
            RandomSource random(i);
            PathScene scene;
            do
            {
                scene = {"seeded_" + std::string(i < 10 ? "0" : "") + std::to_string(i),
                         emptyWorld(),
                         {1.0, 1.0},
                         {19.0, 19.0}};
                for (unsigned int k = 0; k < 3 + i; ++k)
                {
                    scene.world.obstacles.push_back(drawObstacle(random, k % 2 == 0));
                }
            } while (!isWorthPlanning(scene));
            scenes.push_back(scene);
        }
        return scenes;
    }
}  // namespace ompl_mfa::paper
