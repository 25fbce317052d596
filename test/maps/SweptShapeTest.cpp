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

#include "maps/SweptShape.h"

#include <gtest/gtest.h>

#include "maps/MapFolder.h"
#include "maps/PlaneGeometry.h"

namespace ompl_mfa::maps
{
    namespace
    {
        using test::Point;
        using test::Polygon;
        using test::uniform;

        /* What is decided by rounding is no question. */
        constexpr double UNCLEAR = 1e-6;

        Point randomPoint(std::mt19937 &random)
        {
            return {uniform(random, 1.0, 29.0), uniform(random, 1.0, 19.0)};
        }

        /* Compares with the distances of the polygon from all cells. */
        void compare(const GridMap &map, const ObstacleGrid &grid, const Polygon &polygon, double radius, int &hits)
        {
            SweptShape shape;
            shape.reset(radius);
            for (std::size_t i = 0; i < polygon.size(); ++i)
            {
                shape.add(polygon[i], polygon[(i + 1) % polygon.size()]);
            }
            const double distance = test::distanceFrom(map, polygon);
            if (std::abs(distance - radius) > UNCLEAR)
            {
                hits += distance < radius ? 1 : 0;
                ASSERT_EQ(shape.touches(grid), distance < radius || distance == 0.0)
                    << polygon.size() << " corners, the first " << polygon[0].transpose() << ", radius " << radius;
            }
        }
    }  // namespace

    TEST(SweptShape, PointsDiscsSegmentsAndPolygonsAgreeWithDistances)
    {
        std::mt19937 random(5);
        int hits = 0;
        constexpr int ROUNDS = 4000;
        const GridMap map = test::randomMap(random, 30, 20, 60);
        const ObstacleGrid grid(map);
        for (int round = 0; round < ROUNDS; ++round)
        {
            const double radius = round % 3 == 0 ? 0.0 : uniform(random, 0.0, 3.0);
            const Point first = randomPoint(random);
            compare(map, grid, {first}, radius, hits);
            const Point second = first + Point(uniform(random, -4.0, 4.0), uniform(random, -4.0, 4.0));
            compare(map, grid, {first, second}, radius, hits);
            compare(map, grid, {first, {second.x(), first.y()}}, radius, hits);
            compare(map, grid, {first, {first.x(), second.y()}}, radius, hits);
            const Point third = first + Point(uniform(random, -4.0, 4.0), uniform(random, -4.0, 4.0));
            compare(map, grid, {first, second, third}, radius, hits);
        }
        EXPECT_GT(hits, ROUNDS / 2);
        EXPECT_LT(hits, 9 * ROUNDS / 2);
    }

    TEST(SweptShape, NothingPassesBetweenCellsThatShareACorner)
    {
        const ObstacleGrid grid(test::mapOf({"....", ".#..", "..#.", "...."}));
        SweptShape shape;
        shape.reset(0.0);
        shape.add({1.5, 1.5}, {2.5, 2.5});
        EXPECT_TRUE(shape.touches(grid));
        shape.reset(0.0);
        shape.add({1.5, 1.5}, {1.9, 1.9});
        EXPECT_FALSE(shape.touches(grid));
    }
}  // namespace ompl_mfa::maps
