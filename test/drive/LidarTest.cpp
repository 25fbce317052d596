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

#include "drive/Lidar.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "maps/MapFolder.h"
#include "maps/PlaneGeometry.h"

namespace ompl_mfa::drive
{
    namespace
    {
        using maps::test::Point;
        using Seen = std::vector<std::tuple<std::int64_t, std::int64_t, bool>>;

        /* Where a ray is within the square of a cell, as distances from its beginning. */
        std::optional<std::pair<double, double>> withinCell(const Point &from, const Point &direction, double range,
                                                            double x, double y)
        {
            double begin = 0.0;
            double end = range;
            for (int axis = 0; axis < 2; ++axis)
            {
                const double low = (axis == 0 ? x : y) - from[axis];
                const double first = low / direction[axis];
                const double second = (low + 1.0) / direction[axis];
                begin = std::max(begin, std::min(first, second));
                end = std::min(end, std::max(first, second));
            }
            return end > begin ? std::make_optional(std::make_pair(begin, end)) : std::nullopt;
        }

        /* The cells of a ray, from all cells of the map. */
        Seen bruteForce(const maps::GridMap &map, const Point &from, const Point &direction, double range)
        {
            std::vector<std::tuple<double, std::int64_t, std::int64_t>> crossed;
            for (std::size_t y = 0; y < map.height(); ++y)
            {
                for (std::size_t x = 0; x < map.width(); ++x)
                {
                    const auto part =
                        withinCell(from, direction, range, static_cast<double>(x), static_cast<double>(y));
                    if (part)
                    {
                        crossed.emplace_back(part->first, x, y);
                    }
                }
            }
            std::sort(crossed.begin(), crossed.end());
            Seen seen;
            for (const auto &[begin, x, y] : crossed)
            {
                const bool isObstacle =
                    map.cell(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) != maps::Cell::Free;
                seen.emplace_back(x, y, isObstacle);
                if (isObstacle)
                {
                    break;
                }
            }
            return seen;
        }
    }  // namespace

    TEST(Lidar, ARaySeesWhatItCrossesUpToTheFirstObstacle)
    {
        std::mt19937 random(5);
        std::size_t hits = 0;
        std::size_t ends = 0;
        for (int round = 0; round < 4000; ++round)
        {
            const std::size_t width = 1 + random() % 40;
            const std::size_t height = 1 + random() % 40;
            const maps::ObstacleGrid truth(
                maps::test::randomMap(random, width, height, 2 + static_cast<unsigned int>(random() % 200)));
            const Point from(maps::test::uniform(random, 0.0, static_cast<double>(width)),
                             maps::test::uniform(random, 0.0, static_cast<double>(height)));
            const double angle = maps::test::uniform(random, -3.15, 3.15);
            const Point direction(std::cos(angle), std::sin(angle));
            const double range = maps::test::uniform(random, 0.1, 60.0);
            Seen seen;
            castRay(truth, from, direction, range,
                    [&seen](std::int64_t x, std::int64_t y, bool isObstacle) { seen.emplace_back(x, y, isObstacle); });
            ASSERT_EQ(seen, bruteForce(truth.map(), from, direction, range)) << round;
            (std::get<2>(seen.back()) ? hits : ends) += 1;
        }
        EXPECT_GT(hits, 500U);
        EXPECT_GT(ends, 500U);
    }

    TEST(Lidar, RaysAlongTheAxesStayInTheirRow)
    {
        const maps::ObstacleGrid truth(maps::test::mapOf({".....", "...#.", "....."}));
        for (const auto &[direction, count, last] :
             {std::make_tuple(Point(1.0, 0.0), 3, true), std::make_tuple(Point(-1.0, 0.0), 2, false),
              std::make_tuple(Point(0.0, 1.0), 2, false), std::make_tuple(Point(0.0, -1.0), 2, false)})
        {
            int visits = 0;
            bool isObstacle = false;
            castRay(truth, {1.5, 1.5}, direction, 100.0,
                    [&](std::int64_t, std::int64_t, bool obstacle)
                    {
                        ++visits;
                        isObstacle = obstacle;
                    });
            EXPECT_EQ(visits, count);
            EXPECT_EQ(isObstacle, last);
        }
    }

    TEST(Lidar, AScanSeesARoomButNotBehindItsWalls)
    {
        const maps::ObstacleGrid truth(
            maps::test::mapOf({".......", ".#####.", ".#...#.", ".#...#.", ".#####.", "......."}));
        std::set<std::pair<std::int64_t, std::int64_t>> seen;
        scan(truth, {3.4, 3.1}, 50.0, 2000, [&seen](std::int64_t x, std::int64_t y, bool) { seen.emplace(x, y); });
        for (std::int64_t y = 0; y < 6; ++y)
        {
            for (std::int64_t x = 0; x < 7; ++x)
            {
                const bool isCorner = (x == 1 || x == 5) && (y == 1 || y == 4);
                const bool isRoom = x >= 1 && x <= 5 && y >= 1 && y <= 4 && !isCorner;
                // of a corner's square a ray sees nothing but the corner
                EXPECT_EQ(seen.count({x, y}) > 0, isRoom) << x << ", " << y;
            }
        }
        // what is beyond the range is not seen
        std::size_t near = 0;
        scan(truth, {3.5, 2.5}, 0.4, 100,
             [&near](std::int64_t x, std::int64_t y, bool) { near += x == 3 && y == 2 ? 0 : 1; });
        EXPECT_EQ(near, 0U);
    }
}  // namespace ompl_mfa::drive
