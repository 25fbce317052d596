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

#include "oracle/ShortestPath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace ompl_mfa::oracle
{
    namespace
    {
        double lengthOf(const Points &path)
        {
            double length = 0.0;
            for (std::size_t i = 1; i < path.size(); ++i)
            {
                length += (path[i] - path[i - 1]).norm();
            }
            return length;
        }

        /* Two tangents from distances \e toStart and \e toGoal to the centre of a disc, and the arc between them. */
        double aroundDisc(double toStart, double toGoal, double radius)
        {
            const double arc = M_PI - std::acos(radius / toStart) - std::acos(radius / toGoal);
            return std::sqrt(toStart * toStart - radius * radius) + std::sqrt(toGoal * toGoal - radius * radius) +
                   radius * arc;
        }

        /* Regular polygon with its corners (circumscribed: its sides) on the circle. */
        Obstacle polygonFor(const Point &centre, double radius, int sides, bool circumscribed)
        {
            Obstacle polygon;
            const double reach = circumscribed ? radius / std::cos(M_PI / sides) : radius;
            for (int k = 0; k < sides; ++k)
            {
                polygon.vertices.push_back(
                    centre + reach * Point(std::cos(2.0 * M_PI * k / sides), std::sin(2.0 * M_PI * k / sides)));
            }
            return polygon;
        }

        /* An obstacle for an independent distance function: a disc (size.y() == 0) or a turned box. */
        struct Shape
        {
            Point centre;
            Point size;
            double angle;

            double distanceTo(const Point &p) const
            {
                const Point d = p - centre;
                if (size.y() == 0.0)
                {
                    return d.norm() - size.x();
                }
                const Point local(std::cos(angle) * d.x() + std::sin(angle) * d.y(),
                                  -std::sin(angle) * d.x() + std::cos(angle) * d.y());
                return (local.cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm();
            }
        };

        std::vector<Shape> randomShapes(unsigned int seed)
        {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> place(2.0, 18.0);
            std::uniform_real_distribution<double> size(0.4, 3.0);
            std::uniform_real_distribution<double> angle(0.0, M_PI);
            std::vector<Shape> shapes;
            for (int k = 0; k < 24; ++k)
            {
                const double x = place(random);
                const double y = place(random);
                const double length = size(random);
                const double width = size(random);
                if (k % 2 == 0)
                {
                    shapes.push_back({{x, y}, {0.6 * length, 0.0}, 0.0});
                }
                else
                {
                    shapes.push_back({{x, y}, {length, width}, angle(random)});
                }
            }
            return shapes;
        }

        bool isFree(const std::vector<Shape> &shapes, const Point &p, double clearance)
        {
            return std::all_of(shapes.begin(), shapes.end(),
                               [&](const Shape &shape) { return shape.distanceTo(p) >= clearance; });
        }

        bool isFree(const std::vector<Shape> &shapes, const Point &p, const Point &q, double clearance)
        {
            const int pieces = 1 + static_cast<int>((q - p).norm() / 0.01);
            for (int k = 0; k <= pieces; ++k)
            {
                if (!isFree(shapes, p + (q - p) * k / pieces, clearance))
                {
                    return false;
                }
            }
            return true;
        }

        /* Dijkstra over a grid of 0.1 m from (0, 0) to (20, 20) with the 16 moves of a king and a knight. */
        double gridLength(const std::vector<Shape> &shapes, double clearance, int startCell, int goalCell)
        {
            constexpr int SIDE = 201;
            constexpr std::size_t CELLS = std::size_t{SIDE} * SIDE;
            constexpr double CELL = 0.1;
            const int moves[16][2] = {{1, 0}, {1, 1}, {0, 1},  {-1, 1}, {-1, 0},  {-1, -1}, {0, -1}, {1, -1},
                                      {2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}};
            std::vector<double> cost(CELLS, std::numeric_limits<double>::infinity());
            using Entry = std::pair<double, int>;
            std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
            cost[startCell * SIDE + startCell] = 0.0;
            open.emplace(0.0, startCell * SIDE + startCell);
            while (!open.empty())
            {
                const auto [reached, cell] = open.top();
                open.pop();
                if (reached > cost[cell])
                {
                    continue;
                }
                const int row = cell / SIDE;
                const int column = cell % SIDE;
                for (const auto &move : moves)
                {
                    const int toRow = row + move[0];
                    const int toColumn = column + move[1];
                    if (toRow < 0 || toColumn < 0 || toRow >= SIDE || toColumn >= SIDE)
                    {
                        continue;
                    }
                    const int to = toRow * SIDE + toColumn;
                    const double length = CELL * std::hypot(move[0], move[1]);
                    if (reached + length < cost[to] &&
                        isFree(shapes, CELL * Point(row, column), CELL * Point(toRow, toColumn), clearance))
                    {
                        cost[to] = reached + length;
                        open.emplace(cost[to], to);
                    }
                }
            }
            return cost[goalCell * SIDE + goalCell];
        }
    }  // namespace

    TEST(ShortestPath, IsTheStraightLineInAnEmptyScene)
    {
        const ShortestPath best = shortestPath(Scene(), {1.0, 2.0}, {4.0, 6.0});
        EXPECT_DOUBLE_EQ(best.length, 5.0);
        ASSERT_EQ(best.path.size(), 2u);
        EXPECT_EQ(best.path.front(), Point(1.0, 2.0));
        EXPECT_EQ(best.path.back(), Point(4.0, 6.0));
    }

    TEST(ShortestPath, WrapsADiscWithTwoTangentsAndAnArc)
    {
        Scene scene;
        scene.obstacles = {disc({5.0, 0.0}, 1.5)};
        scene.robotRadius = 0.5;
        const ShortestPath best = shortestPath(scene, {0.0, 0.0}, {9.0, 0.0});
        EXPECT_NEAR(best.length, aroundDisc(5.0, 4.0, 2.0), 1e-7);
        EXPECT_GT(lengthOf(best.path), best.length);
        EXPECT_LT(lengthOf(best.path), best.length + 4e-5 * 2.0 * M_PI);
    }

    TEST(ShortestPath, RoundsTheCornersOfABoxByTheRobotsRadius)
    {
        Scene scene;
        scene.obstacles = {rectangle({0.0, 0.0}, {2.0, 6.0})};
        /* The path of a point turns at the corners (-1, 3) and (1, 3). */
        EXPECT_NEAR(shortestPath(scene, {-5.0, 0.0}, {5.0, 0.0}).length, 2.0 + 2.0 * 5.0, 1e-7);
        /* That of a disc follows an arc at each corner. */
        scene.robotRadius = 0.5;
        const double toCorner = 5.0;
        const double slope = std::atan2(3.0, 4.0) + std::asin(0.5 / toCorner);
        const double expected = 2.0 + 2.0 * (std::sqrt(25.0 - 0.25) + 0.5 * slope);
        EXPECT_NEAR(shortestPath(scene, {-5.0, 0.0}, {5.0, 0.0}).length, expected, 1e-7);
    }

    TEST(ShortestPath, TurnsWithTheScene)
    {
        const double angle = 0.7;
        Eigen::Matrix2d turn;
        turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
        Scene straight;
        straight.robotRadius = 0.3;
        straight.obstacles = {rectangle({3.0, 0.5}, {1.0, 4.0}), disc({6.0, -1.0}, 1.2)};
        Scene turned = straight;
        turned.obstacles = {rectangle(turn * Point(3.0, 0.5), {1.0, 4.0}, angle), disc(turn * Point(6.0, -1.0), 1.2)};
        const Point goal(10.0, 0.0);
        EXPECT_NEAR(shortestPath(straight, {0.0, 0.0}, goal).length,
                    shortestPath(turned, {0.0, 0.0}, turn * goal).length, 1e-7);
    }

    TEST(ShortestPath, PassesAGapOnlyIfTheRobotFits)
    {
        Scene scene;
        scene.obstacles = {disc({5.0, 2.0}, 1.5), disc({5.0, -2.0}, 1.5)};
        scene.robotRadius = 0.49;
        EXPECT_NEAR(shortestPath(scene, {0.0, 0.0}, {10.0, 0.0}).length, 10.0, 1e-7);
        scene.robotRadius = 0.51;
        EXPECT_GT(shortestPath(scene, {0.0, 0.0}, {10.0, 0.0}).length, 11.0);
    }

    TEST(ShortestPath, DoesNotFollowAnArcIntoAnotherObstacle)
    {
        /* Two overlapping discs: the path around the far one is shorter on the side where they do not overlap. */
        Scene scene;
        scene.obstacles = {disc({5.0, 0.0}, 1.0), disc({5.0, 1.5}, 1.0)};
        EXPECT_NEAR(shortestPath(scene, {0.0, 0.0}, {10.0, 0.0}).length, aroundDisc(5.0, 5.0, 1.0), 1e-7);
        /* With the near side closed by a wall too, only the path over the upper disc is left. */
        scene.obstacles.push_back(rectangle({5.0, -500.0}, {0.2, 1000.0}));
        const double toUpper = std::hypot(5.0, 1.5);
        const double tangent = std::sqrt(toUpper * toUpper - 1.0);
        const double arc = M_PI - 2.0 * (std::acos(1.0 / toUpper) - std::atan2(1.5, 5.0));
        EXPECT_NEAR(shortestPath(scene, {0.0, 0.0}, {10.0, 0.0}).length, 2.0 * tangent + arc, 1e-7);
    }

    TEST(ShortestPath, StaysWithinTheBounds)
    {
        Scene scene;
        scene.obstacles = {rectangle({5.0, 1.0}, {1.0, 4.0})};
        scene.lower = {0.0, -1.5};
        scene.upper = {10.0, 20.0};
        const double below = shortestPath(scene, {1.0, 0.0}, {9.0, 0.0}).length;
        scene.lower.y() = -0.5;
        const double above = shortestPath(scene, {1.0, 0.0}, {9.0, 0.0}).length;
        EXPECT_NEAR(below, 1.0 + 2.0 * std::hypot(3.5, 1.0), 1e-7);
        EXPECT_NEAR(above, 1.0 + 2.0 * std::hypot(3.5, 3.0), 1e-7);
    }

    TEST(ShortestPath, IsInfiniteForAnEnclosedGoal)
    {
        Scene scene;
        scene.lower = {0.0, 0.0};
        scene.upper = {10.0, 10.0};
        scene.obstacles = {rectangle({5.0, 5.0}, {1.0, 12.0})};
        const ShortestPath best = shortestPath(scene, {1.0, 5.0}, {9.0, 5.0});
        EXPECT_TRUE(std::isinf(best.length));
        EXPECT_TRUE(best.path.empty());
    }

    TEST(ShortestPath, LiesBetweenInscribedAndCircumscribedPolygons)
    {
        Scene exact;
        Scene inner;
        Scene outer;
        const std::vector<std::pair<Point, double>> discs{{{4.0, 4.5}, 1.5},   {{8.0, 7.0}, 2.0},  {{12.0, 13.5}, 1.8},
                                                          {{14.0, 11.0}, 1.2}, {{7.0, 11.0}, 1.0}, {{17.0, 17.5}, 0.9}};
        for (const auto &[centre, radius] : discs)
        {
            exact.obstacles.push_back(disc(centre, radius));
            inner.obstacles.push_back(polygonFor(centre, radius, 60, false));
            outer.obstacles.push_back(polygonFor(centre, radius, 60, true));
        }
        const Point start(0.3, 2.2);
        const Point goal(20.0, 20.0);
        const double length = shortestPath(exact, start, goal).length;
        const double lower = shortestPath(inner, start, goal).length;
        const double upper = shortestPath(outer, start, goal).length;
        EXPECT_GT(length, lower - 1e-7);
        EXPECT_LT(length, upper + 1e-7);
        EXPECT_LT(upper - lower, 0.02);
    }

    TEST(ShortestPath, IsFreeAndNoLongerThanAGridPathInRandomScenes)
    {
        for (unsigned int seed = 0; seed < 6; ++seed)
        {
            SCOPED_TRACE(seed);
            const std::vector<Shape> shapes = randomShapes(seed);
            Scene scene;
            scene.robotRadius = 0.25;
            scene.lower = {0.0, 0.0};
            scene.upper = {20.0, 20.0};
            for (const Shape &shape : shapes)
            {
                scene.obstacles.push_back(shape.size.y() == 0.0 ? disc(shape.centre, shape.size.x())
                                                                : rectangle(shape.centre, shape.size, shape.angle));
            }
            const ShortestPath best = shortestPath(scene, {0.4, 0.4}, {19.6, 19.6});
            ASSERT_TRUE(std::isfinite(best.length));
            EXPECT_GE(lengthOf(best.path), best.length - 1e-9);
            EXPECT_LT(lengthOf(best.path), best.length * (1.0 + 4e-5));
            for (std::size_t i = 1; i < best.path.size(); ++i)
            {
                EXPECT_TRUE(isFree(shapes, best.path[i - 1], best.path[i], scene.robotRadius - 1e-3));
            }
            /* The grid's moves cost 2.8% in open space; the rest is its error beside obstacles. */
            const double grid = gridLength(shapes, scene.robotRadius, 4, 196);
            EXPECT_LE(best.length, grid);
            EXPECT_GT(best.length, 0.96 * grid);
        }
    }

    TEST(ShortestPath, RefusesWhatItCannotSolve)
    {
        Scene scene;
        scene.obstacles = {disc({5.0, 5.0}, 1.0)};
        EXPECT_THROW(shortestPath(scene, {5.0, 5.5}, {9.0, 9.0}), std::invalid_argument);
        EXPECT_THROW(shortestPath(scene, {0.0, 0.0}, {5.5, 5.0}), std::invalid_argument);
        scene.upper = {8.0, 8.0};
        EXPECT_THROW(shortestPath(scene, {0.0, 0.0}, {9.0, 9.0}), std::invalid_argument);
        scene.robotRadius = -0.1;
        EXPECT_THROW(shortestPath(scene, {0.0, 0.0}, {7.0, 7.0}), std::invalid_argument);
        EXPECT_THROW(disc({0.0, 0.0}, 0.0), std::invalid_argument);
        EXPECT_THROW(rectangle({0.0, 0.0}, {1.0, -1.0}), std::invalid_argument);
        Scene clockwise;
        clockwise.obstacles = {{{Point(2.0, 2.0), Point(2.0, 3.0), Point(3.0, 3.0)}, 0.0}};
        EXPECT_THROW(shortestPath(clockwise, {0.0, 0.0}, {7.0, 7.0}), std::invalid_argument);
    }
}  // namespace ompl_mfa::oracle
