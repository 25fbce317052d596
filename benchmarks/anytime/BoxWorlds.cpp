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

#include <map>
#include <utility>

#include "anytime/WorldList.h"
#include "oracle/ShortestPath.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        /* Obstacles are open boxes: a path may touch them, like the exact optimum. */
        struct Box
        {
            Eigen::VectorXd lower;
            Eigen::VectorXd upper;
        };

        struct BoxScene
        {
            Eigen::VectorXd start;
            Eigen::VectorXd goal;
            std::vector<Box> boxes;

            Eigen::Index dimension() const
            {
                return start.size();
            }
        };

        /* Longest distance between two checked states of a motion in a unit cube; no wall is thinner than 0.02. */
        constexpr double RESOLUTION = 0.001;
        /* Walls extend this far out of the cube, so that no path passes along its face. */
        constexpr double OUTSIDE = 0.1;

        /* Stores the coordinates of all boxes contiguously, as pairs of lower and upper. */
        StateCheck boxCheck(const BoxScene &scene)
        {
            std::vector<double> intervals;
            for (const Box &box : scene.boxes)
            {
                for (Eigen::Index i = 0; i < scene.dimension(); ++i)
                {
                    intervals.insert(intervals.end(), {box.lower[i], box.upper[i]});
                }
            }
            const auto dimension = static_cast<std::size_t>(scene.dimension());
            return [intervals = std::move(intervals), dimension](const double *x)
            {
                for (std::size_t first = 0; first < intervals.size(); first += 2 * dimension)
                {
                    std::size_t i = 0;
                    while (i < dimension && intervals[first + 2 * i] < x[i] && x[i] < intervals[first + 2 * i + 1])
                    {
                        ++i;
                    }
                    if (i == dimension)
                    {
                        return false;
                    }
                }
                return true;
            };
        }

        Problem makeBoxProblem(const BoxScene &scene)
        {
            const auto n = scene.dimension();
            return makeProblem(Eigen::VectorXd::Zero(n), Eigen::VectorXd::Ones(n), scene.start, scene.goal, RESOLUTION,
                               boxCheck(scene));
        }

        double planarOptimum(const BoxScene &scene)
        {
            oracle::Scene exact;
            exact.lower = {0.0, 0.0};
            exact.upper = {1.0, 1.0};
            for (const Box &box : scene.boxes)
            {
                exact.obstacles.push_back(oracle::rectangle((box.lower + box.upper) / 2.0, box.upper - box.lower));
            }
            return oracle::shortestPath(exact, scene.start, scene.goal).length;
        }

        BoxScene emptyScene(Eigen::Index dimension, double startX, double goalX)
        {
            BoxScene scene{Eigen::VectorXd::Constant(dimension, 0.5), Eigen::VectorXd::Constant(dimension, 0.5), {}};
            scene.start[0] = startX;
            scene.goal[0] = goalX;
            return scene;
        }

        /* Adds a wall of the given extent in x and y that spans the cube in all other coordinates. */
        void addWall(BoxScene &scene, double lowX, double highX, double lowY, double highY)
        {
            const auto n = scene.dimension();
            Box wall{Eigen::VectorXd::Constant(n, -OUTSIDE), Eigen::VectorXd::Constant(n, 1.0 + OUTSIDE)};
            wall.lower.head<2>() << lowX, lowY;
            wall.upper.head<2>() << highX, highY;
            scene.boxes.push_back(std::move(wall));
        }

        /* One wall between start and goal, with a narrow gap in it and a wide passage around its end. */
        BoxScene wallGap(Eigen::Index dimension, WorldRandom &random)
        {
            BoxScene scene = emptyScene(dimension, 0.1, 0.9);
            const double gap = random.uniform(0.62, 0.68);
            addWall(scene, 0.45, 0.55, -OUTSIDE, gap);
            addWall(scene, 0.45, 0.55, gap + 0.03, 0.9);
            return scene;
        }

        /* Three walls with four gaps each, of different widths: many homotopy classes. */
        BoxScene dividingWalls(Eigen::Index dimension, WorldRandom &random)
        {
            BoxScene scene = emptyScene(dimension, 0.1, 0.9);
            for (const double x : {0.3, 0.5, 0.7})
            {
                double low = -OUTSIDE;
                for (int i = 0; i < 4; ++i)
                {
                    const double gap = 0.25 * i + random.uniform(0.03, 0.18);
                    addWall(scene, x - 0.03, x + 0.03, low, gap);
                    low = gap + random.uniform(0.02, 0.05);
                }
                addWall(scene, x - 0.03, x + 0.03, low, 1.0 + OUTSIDE);
            }
            return scene;
        }

        struct Shell
        {
            Eigen::VectorXd centre;
            double inner;      // half the inner side length of the room
            double thickness;  // thickness of its walls
            double hole;       // half the side length of the hole in a wall normal to x
            bool opensLow;     // whether the hole is in the wall at low x
        };

        /* The complete wall normal to coordinate \e axis. */
        Box shellWall(const Shell &shell, Eigen::Index axis, bool low)
        {
            const double outer = shell.inner + shell.thickness;
            Box wall{shell.centre.array() - outer, shell.centre.array() + outer};
            if (low)
            {
                wall.upper[axis] = shell.centre[axis] - shell.inner;
            }
            else
            {
                wall.lower[axis] = shell.centre[axis] + shell.inner;
            }
            return wall;
        }

        void addShell(BoxScene &scene, const Shell &shell)
        {
            for (Eigen::Index axis = 0; axis < scene.dimension(); ++axis)
            {
                for (const bool low : {true, false})
                {
                    if (axis != 0 || low != shell.opensLow)
                    {
                        scene.boxes.push_back(shellWall(shell, axis, low));
                    }
                }
            }
            // the rest of the open wall around the hole: two slabs for each other coordinate
            for (Eigen::Index axis = 1; axis < scene.dimension(); ++axis)
            {
                Box slab = shellWall(shell, 0, shell.opensLow);
                slab.upper[axis] = shell.centre[axis] - shell.hole;
                scene.boxes.push_back(slab);
                slab = shellWall(shell, 0, shell.opensLow);
                slab.lower[axis] = shell.centre[axis] + shell.hole;
                scene.boxes.push_back(slab);
            }
        }

        /* Start and goal are each in a room whose hole faces away from the other. */
        BoxScene doubleEnclosure(Eigen::Index dimension, WorldRandom &random)
        {
            BoxScene scene = emptyScene(dimension, 0.25, 0.75);
            const double hole = random.uniform(0.035, 0.05);
            addShell(scene, {scene.start, random.uniform(0.09, 0.12), 0.03, hole, true});
            addShell(scene, {scene.goal, random.uniform(0.09, 0.12), 0.03, hole, false});
            return scene;
        }

        bool keepsClear(const Box &box, const Eigen::VectorXd &x)
        {
            return (x.array() < box.lower.array() - 0.02 || x.array() > box.upper.array() + 0.02).any();
        }

        /* Random boxes, a third of them on the straight line, as only these matter in many dimensions. */
        BoxScene randomBoxes(Eigen::Index dimension, int count, double low, double high, WorldRandom &random)
        {
            BoxScene scene = emptyScene(dimension, 0.05, 0.95);
            while (static_cast<int>(scene.boxes.size()) < count)
            {
                const bool across = scene.boxes.size() % 3 == 0;
                Box box{Eigen::VectorXd(dimension), Eigen::VectorXd(dimension)};
                for (Eigen::Index i = 0; i < dimension; ++i)
                {
                    const double side = random.uniform(low, high) * (across && i == 0 ? 0.5 : 1.0);
                    const double reach = across && i > 0 ? 0.5 * side : 0.5;
                    const double centre = 0.5 + random.uniform(-reach, reach);
                    box.lower[i] = centre - side / 2.0;
                    box.upper[i] = centre + side / 2.0;
                }
                if (keepsClear(box, scene.start) && keepsClear(box, scene.goal))
                {
                    scene.boxes.push_back(std::move(box));
                }
            }
            return scene;
        }

        BoxScene randomBoxes(Eigen::Index dimension, WorldRandom &random)
        {
            switch (dimension)
            {
                case 2:
                    return randomBoxes(dimension, 40, 0.08, 0.2, random);
                case 4:
                    return randomBoxes(dimension, 60, 0.2, 0.5, random);
                case 8:
                    return randomBoxes(dimension, 60, 0.4, 0.8, random);
                default:
                    return randomBoxes(dimension, 60, 0.6, 0.95, random);
            }
        }

        struct BoxKind
        {
            BoxScene (*make)(Eigen::Index, WorldRandom &);
            /* The shortest path keeps to the plane of the first two coordinates, so that the optimum of the same scene
               in two dimensions is the optimum. */
            bool planar;
        };

        const BoxKind &kindOf(const std::string &kind)
        {
            static const std::map<std::string, BoxKind> KINDS = {{"wall_gap", {wallGap, true}},
                                                                 {"double_enclosure", {doubleEnclosure, true}},
                                                                 {"dividing_walls", {dividingWalls, true}},
                                                                 {"random_boxes", {randomBoxes, false}}};
            return KINDS.at(kind);
        }

        BoxScene makeScene(const std::string &kind, Eigen::Index dimension, std::uint64_t seed)
        {
            WorldRandom random(seed);
            return kindOf(kind).make(dimension, random);
        }
    }  // namespace

    World boxWorld(const std::string &kind, int dimension, std::uint64_t seed)
    {
        World world;
        world.family = kind + "_" + std::to_string(dimension) + "d";
        world.name = world.family + "_" + std::to_string(seed);
        world.make = [=] { return makeBoxProblem(makeScene(kind, dimension, seed)); };
        if (dimension == 2 || kindOf(kind).planar)
        {
            world.optimum = [=] { return planarOptimum(makeScene(kind, 2, seed)); };
        }
        return world;
    }

    std::vector<World> boxWorlds()
    {
        std::vector<World> worlds;
        for (const int dimension : {2, 4, 8})
        {
            worlds.push_back(boxWorld("wall_gap", dimension, 1));
        }
        for (const char *kind : {"double_enclosure", "dividing_walls"})
        {
            worlds.push_back(boxWorld(kind, 2, 1));
            worlds.push_back(boxWorld(kind, 4, 1));
        }
        for (const std::uint64_t seed : {1, 2})
        {
            for (const int dimension : {2, 4, 8, 16})
            {
                worlds.push_back(boxWorld("random_boxes", dimension, seed));
            }
        }
        return worlds;
    }
}  // namespace ompl_mfa::anytime
