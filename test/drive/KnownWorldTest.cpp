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

#include "drive/KnownWorld.h"

#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "maps/MapFolder.h"
#include "maps/PlaneGeometry.h"

namespace ompl_mfa::drive
{
    namespace
    {
        using maps::Cell;
        using maps::Footprint;
        using maps::test::Point;

        std::shared_ptr<maps::ObstacleGrid> gridOf(const maps::GridMap &map)
        {
            return std::make_shared<maps::ObstacleGrid>(map);
        }
    }  // namespace

    TEST(KnownWorld, NothingIsKnownAndFreeUntilItIsScanned)
    {
        const auto truth = gridOf(maps::test::mapOf({".....#.", ".....#.", ".....#."}));
        KnownWorld world(truth, std::nullopt, Footprint::point(), 100.0, 720);
        EXPECT_FALSE(world.grid()->isOccupied(5, 1));
        const auto changes = world.scanned({1.5, 1.5});
        EXPECT_TRUE(world.learn(changes));
        EXPECT_TRUE(world.grid()->isOccupied(5, 1));
        EXPECT_EQ(maps::test::rowsOf(world.grid()->map()), (std::vector<std::string>{".....#?", ".....#?", ".....#?"}));
        EXPECT_EQ(changes.size(), 18U) << "each cell once";
        EXPECT_TRUE(world.scanned({1.5, 1.5}).empty());
        EXPECT_EQ(world.takeNews().size(), 18U);
        EXPECT_TRUE(world.takeNews().empty());
    }

    TEST(KnownWorld, AWrongMapIsCorrectedWhereItIsSeen)
    {
        const auto truth = gridOf(maps::test::mapOf({"......", "......"}));
        KnownWorld world(truth, maps::test::mapOf({"..#...", "..#..."}), Footprint::point(), 100.0, 720);
        EXPECT_TRUE(world.grid()->isOccupied(2, 0));
        EXPECT_TRUE(world.learn(world.scanned({0.5, 0.5})));
        EXPECT_FALSE(world.grid()->isOccupied(2, 0));
        EXPECT_EQ(maps::test::rowsOf(world.grid()->map()), (std::vector<std::string>{"......", "......"}));
    }

    TEST(KnownWorld, CellsNearTheOutlineAreFeltWhateverIsBetween)
    {
        std::mt19937 random(8);
        maps::MapFrame frame;
        frame.resolution = 0.1;
        frame.origin = {-1.0, 2.0};
        frame.yaw = 0.4;
        const Footprint::Polygon corners = {{-0.5, -0.2}, {0.7, -0.2}, {0.7, 0.2}, {-0.5, 0.2}};
        for (const Footprint &footprint :
             {Footprint::point(), Footprint::disc(0.33), Footprint::polygon(corners, 0.05)})
        {
            const auto truth = gridOf(maps::test::randomMap(random, 40, 30, 5, frame));
            for (int round = 0; round < 40; ++round)
            {
                KnownWorld world(truth, std::nullopt, footprint, 1.0, 4);
                const Pose pose{truth->map().toWorld(
                                    {maps::test::uniform(random, 0.0, 40.0), maps::test::uniform(random, 0.0, 30.0)}),
                                maps::test::uniform(random, -3.0, 3.0)};
                world.learn(world.felt(pose));
                maps::test::Polygon outline;
                for (const Point &corner : footprint.corners())
                {
                    outline.push_back(truth->map().toGrid(pose.position + Eigen::Rotation2Dd(pose.yaw) * corner));
                }
                for (std::size_t y = 0; y < 30; ++y)
                {
                    for (std::size_t x = 0; x < 40; ++x)
                    {
                        const Point low(static_cast<double>(x), static_cast<double>(y));
                        const double distance =
                            maps::test::distanceOf(
                                outline, {low, low + Point(1.0, 0.0), low + Point(1.0, 1.0), low + Point(0.0, 1.0)}) -
                            footprint.margin() / frame.resolution;
                        const Cell known = world.grid()->map().cell(x, y);
                        ASSERT_TRUE(known == Cell::Unknown || known == truth->map().cell(x, y));
                        ASSERT_TRUE(distance > 2.0 || known != Cell::Unknown) << x << ", " << y;
                        ASSERT_TRUE(distance < 3.5 || known == Cell::Unknown) << x << ", " << y;
                    }
                }
            }
        }
    }
}  // namespace ompl_mfa::drive
