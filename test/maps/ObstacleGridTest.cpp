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

#include "ompl_mfa/maps/ObstacleGrid.h"

#include <gtest/gtest.h>

#include "maps/MapFolder.h"
#include "maps/PlaneGeometry.h"

namespace ompl_mfa::maps
{
    namespace
    {
        using test::mapOf;
        using test::Point;

        GridMap inverse(const GridMap &map)
        {
            std::vector<Cell> cells = map.cells();
            for (Cell &cell : cells)
            {
                cell = cell == Cell::Free ? Cell::Occupied : Cell::Free;
            }
            return GridMap(map.width(), map.height(), cells, map.frame());
        }

        /* Distance of a point in an obstacle from the nearest free cell; the outside is not free. */
        double depth(const GridMap &map, const Point &point)
        {
            double least = std::numeric_limits<double>::infinity();
            const GridMap free = inverse(map);
            for (std::size_t y = 0; y < map.height(); ++y)
            {
                for (std::size_t x = 0; x < map.width(); ++x)
                {
                    const Point lower(static_cast<double>(x), static_cast<double>(y));
                    const Point nearest = point.cwiseMax(lower).cwiseMin(lower + Point(1.0, 1.0));
                    least = free.cell(x, y) != Cell::Free ? std::min(least, (nearest - point).norm()) : least;
                }
            }
            return least;
        }
    }  // namespace

    TEST(ObstacleGrid, UnknownCellsAreWhatTheyAreSaidToBe)
    {
        const GridMap map = mapOf({".?#", "..."});
        EXPECT_TRUE(ObstacleGrid(map).isOccupied(1, 1));
        EXPECT_FALSE(ObstacleGrid(map, UnknownCells::Free).isOccupied(1, 1));
        EXPECT_TRUE(ObstacleGrid(map, UnknownCells::Free).isOccupied(2, 1));
        EXPECT_FALSE(ObstacleGrid(map).isOccupied(0, 0));
        EXPECT_TRUE(ObstacleGrid(map).isOccupied(-1, 0));
        EXPECT_TRUE(ObstacleGrid(map).isOccupied(0, 2));
    }

    TEST(ObstacleGrid, RangesAgreeWithCells)
    {
        std::mt19937 random(3);
        const GridMap map = test::randomMap(random, 200, 4, 60);
        const ObstacleGrid grid(map);
        for (int round = 0; round < 20000; ++round)
        {
            const int row = static_cast<int>(random() % 6) - 1;
            const int first = static_cast<int>(random() % 203) - 2;
            const int last = first + static_cast<int>(random() % 150);
            bool expected = false;
            for (int x = first; x <= last; ++x)
            {
                expected = expected || row < 0 || row > 3 || x < 0 || x > 199 ||
                           map.cell(static_cast<std::size_t>(x), static_cast<std::size_t>(row)) != Cell::Free;
            }
            ASSERT_EQ(grid.isAnyOccupied(row, first, last), expected) << row << ": " << first << " to " << last;
        }
    }

    TEST(ObstacleGrid, DistancesAreTrueToWithinACell)
    {
        std::mt19937 random(11);
        for (const unsigned int spacing : {3U, 20U, 200U})
        {
            const GridMap map = test::randomMap(random, 37, 23, spacing);
            const ObstacleGrid grid(map);
            for (int round = 0; round < 1500; ++round)
            {
                const Point point(test::uniform(random, 0.0, 37.0), test::uniform(random, 0.0, 23.0));
                const double outside = test::distanceFrom(map, {point});
                const double expected = outside > 0.0 ? outside : -depth(map, point);
                const std::string place = std::to_string(point.x()) + ", " + std::to_string(point.y());
                ASSERT_NEAR(grid.distance(point), expected, 1.0) << place;
                ASSERT_LE(grid.leastDistance(point), outside) << place;
                ASSERT_GE(grid.largestDistance(point), outside) << place;
                ASSERT_LE(grid.largestDistance(point), outside + 1.8) << place;
            }
        }
    }

    TEST(ObstacleGrid, OutsideIsAnObstacle)
    {
        const ObstacleGrid grid(mapOf({"....", "....", "....", "...."}));
        EXPECT_NEAR(grid.distance({2.0, 2.0}), 2.0, 1.0);
        EXPECT_NEAR(grid.distance({0.0, 2.0}), 0.0, 1e-6);
        EXPECT_NEAR(grid.distance({-3.0, 2.0}), -3.0, 1.0);
        EXPECT_LE(grid.leastDistance({7.0, 2.0}), 0.0);
        EXPECT_EQ(grid.largestDistance({1e30, -1e30}), 0.0);
    }

    TEST(ObstacleGrid, UpdatedDistancesAreThoseOfANewGrid)
    {
        std::mt19937 random(11);
        for (int round = 0; round < 60; ++round)
        {
            const std::size_t width = 1 + random() % 180;
            const std::size_t height = 1 + random() % 180;
            const UnknownCells unknown = random() % 2 == 0 ? UnknownCells::Free : UnknownCells::Occupied;
            const double farthest = std::vector<double>{1.0, 2.5, 7.0, 30.0, 1000.0, INFINITY}[random() % 6];
            ObstacleGrid grid(test::randomMap(random, width, height, 1 + static_cast<unsigned int>(random() % 100)),
                              unknown, farthest);
            for (int step = 0; step < 6; ++step)
            {
                // a few cells at one place or anywhere, of which some stay what they are
                std::vector<CellChange> changes;
                const std::size_t spread = std::vector<std::size_t>{2, 12, 200}[random() % 3];
                const std::size_t left = random() % width;
                const std::size_t low = random() % height;
                for (std::size_t i = random() % 40; i-- > 0;)
                {
                    changes.push_back({std::min(left + random() % spread, width - 1),
                                       std::min(low + random() % spread, height - 1), static_cast<Cell>(random() % 3)});
                }
                const ObstacleGrid before = grid;
                const bool isChanged = grid.update(changes);
                const ObstacleGrid made(grid.map(), unknown, farthest);
                bool differs = false;
                for (int y = -1; y <= static_cast<int>(height); ++y)
                {
                    for (int x = -1; x <= static_cast<int>(width); ++x)
                    {
                        const Point centre(x + 0.5, y + 0.5);
                        ASSERT_EQ(grid.isOccupied(x, y), made.isOccupied(x, y));
                        ASSERT_EQ(grid.distance(centre), made.distance(centre)) << x << ", " << y;
                        ASSERT_EQ(grid.leastDistance(centre), made.leastDistance(centre));
                        ASSERT_EQ(grid.largestDistance(centre), made.largestDistance(centre));
                        differs = differs || before.isOccupied(x, y) != grid.isOccupied(x, y);
                    }
                }
                // what was changed and changed back in one update may be reported
                ASSERT_TRUE(isChanged || !differs);
                for (const CellChange &change : changes)
                {
                    ASSERT_TRUE(isChanged || grid.map().cell(change.x, change.y) != Cell::Occupied ||
                                before.isOccupied(static_cast<int>(change.x), static_cast<int>(change.y)));
                }
            }
        }
    }

    TEST(ObstacleGrid, LimitedDistancesBoundTheTrueOnes)
    {
        std::mt19937 random(12);
        const GridMap map = test::randomMap(random, 90, 70, 400);
        const ObstacleGrid exact(map);
        const ObstacleGrid limited(map, UnknownCells::Occupied, 5.0);
        int beyond = 0;
        for (int round = 0; round < 5000; ++round)
        {
            const Point point(test::uniform(random, 0.0, 90.0), test::uniform(random, 0.0, 70.0));
            const double outside = test::distanceFrom(map, {point});
            ASSERT_LE(limited.leastDistance(point), outside);
            ASSERT_GE(limited.largestDistance(point), outside);
            ASSERT_NEAR(limited.distance(point), std::min(exact.distance(point), 4.5), 1.0);
            beyond += exact.distance(point) > 6.0 ? 1 : 0;
        }
        EXPECT_GT(beyond, 100);
    }
}  // namespace ompl_mfa::maps
