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

#include "drive/Drive.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include "drive/DriveSet.h"
#include "maps/MapFolder.h"
#include "maps/PlaneGeometry.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::drive
{
    namespace
    {
        using maps::test::Point;
        using Rows = std::vector<std::string>;

        const std::string DISC = "robot = disc\nrobot.radius = 0.6\n";

        /* Drives on MovingAI maps, whose cells have side 1. */
        class DriveTest : public testing::Test
        {
        protected:
            void writeMap(const std::string &name, const Rows &rows) const
            {
                std::string text = "type octile\nheight " + std::to_string(rows.size()) + "\nwidth " +
                                   std::to_string(rows.front().size()) + "\nmap\n";
                for (const std::string &row : rows)
                {
                    text += row + "\n";
                }
                folder_.write(name, text);
            }

            /* Plans for 0.01 s a period unless the settings say otherwise. */
            benchmark::ProblemFactory factory(const Rows &rows, const std::string &settings) const
            {
                writeMap("world.map", rows);
                std::string text =
                    "[problem]\nworld = world.map\nobjective = length\nsensor.range = 8\n"
                    "drive.speed = 2\ndrive.period = 0.5\n";
                text += settings.find("replan_time") == std::string::npos ? "drive.replan_time = 0.01\n" : "";
                std::istringstream in(text + settings);
                return benchmark::ProblemFactory(benchmark::parseBenchmarkConfig(in, folder_.path() / "a.cfg"));
            }

            static DriveResult driveWith(const benchmark::ProblemFactory &factory, const std::string &planner = "mfa")
            {
                return drive(factory, loadKnownMap(factory), {planner, planner, "test", {}, {}});
            }

            /* Compares what the robot covers along its trail with all cells, without the library's checks. */
            static void expectNoContact(const benchmark::ProblemFactory &factory, const DriveResult &result)
            {
                // between the poses, a robot that turns is a little beside the mean of two
                const bool turns = factory.config().problem.space != benchmark::StateSpaceKind::R2;
                const double rounding = turns ? 0.03 : 1e-6;
                const maps::GridMap &map = factory.map()->map();
                const double resolution = map.frame().resolution;
                const maps::Footprint &footprint = factory.footprint();
                for (std::size_t i = 0; i + 1 < result.trail.size(); ++i)
                {
                    const Pose &from = result.trail[i];
                    const Pose &to = result.trail[i + 1];
                    ASSERT_LE((to.position - from.position).norm(), 0.25 * resolution + rounding);
                    const double turn = std::remainder(to.yaw - from.yaw, 2.0 * std::acos(-1.0));
                    for (const double share : {0.0, 0.5})
                    {
                        maps::test::Polygon outline;
                        for (const Point &corner : footprint.corners())
                        {
                            const Point place = from.position + share * (to.position - from.position);
                            outline.push_back(map.toGrid(place + Eigen::Rotation2Dd(from.yaw + share * turn) * corner));
                        }
                        ASSERT_GE(maps::test::distanceFrom(map, outline) + rounding, footprint.margin() / resolution)
                            << i << " of " << result.trail.size();
                    }
                }
            }

            static void expectArrival(const benchmark::ProblemFactory &factory, const DriveResult &result)
            {
                ASSERT_EQ(statusText(result.status), "arrived");
                const benchmark::ProblemConfig &problem = factory.config().problem;
                EXPECT_NEAR(result.trail.front().position.x(), problem.start.x, 1e-9);
                EXPECT_NEAR(result.trail.front().position.y(), problem.start.y, 1e-9);
                EXPECT_NEAR(result.trail.back().position.x(), problem.goal.x, 1e-6);
                EXPECT_NEAR(result.trail.back().position.y(), problem.goal.y, 1e-6);
                EXPECT_EQ(result.repairTimes.size(), result.blockages);
                double length = 0.0;
                for (std::size_t i = 1; i < result.trail.size(); ++i)
                {
                    length += (result.trail[i].position - result.trail[i - 1].position).norm();
                }
                EXPECT_GE(result.driven, length - 1e-6);
                EXPECT_LE(result.duration, problem.drive.period * static_cast<double>(result.periods.size()) + 1e-9);
                expectNoContact(factory, result);
            }

            maps::test::MapFolder folder_;
        };

        Rows openRows(std::size_t width, std::size_t height)
        {
            return Rows(height, std::string(width, '.'));
        }

        /* Cells of the columns and rows, both ends included. */
        void fill(Rows &rows, std::size_t left, std::size_t right, std::size_t low, std::size_t high, char letter = '@')
        {
            for (std::size_t y = low; y <= high; ++y)
            {
                for (std::size_t x = left; x <= right; ++x)
                {
                    rows[y][x] = letter;
                }
            }
        }

        const std::string ACROSS = "start.x = 3\nstart.y = 12\ngoal.x = 36\ngoal.y = 12\n";
    }  // namespace

    TEST_F(DriveTest, InTheOpenTheRobotDrivesStraight)
    {
        const auto world = factory(openRows(40, 25), DISC + ACROSS);
        const DriveResult result = driveWith(world);
        expectArrival(world, result);
        EXPECT_NEAR(result.driven, 33.0, 1e-6);
        EXPECT_NEAR(result.duration, 16.5, 1e-6);
        EXPECT_EQ(result.blockages, 0U);
        EXPECT_EQ(result.periods.size(), 33U);
    }

    TEST_F(DriveTest, AnUnknownWallIsDrivenAround)
    {
        Rows rows = openRows(40, 25);
        fill(rows, 20, 20, 4, 21);
        for (const char *planner : {"mfa", "rrtconnect", "bitstar"})
        {
            const auto world = factory(rows, DISC + ACROSS + "drive.replan_time = 0.03\n");
            const DriveResult result = driveWith(world, planner);
            SCOPED_TRACE(planner);
            expectArrival(world, result);
            EXPECT_GE(result.blockages, 1U);
            EXPECT_GE(result.driven, omniscientLength(world, 0.3) - 0.05);
            EXPECT_LE(result.driven, 80.0);
        }
    }

    TEST_F(DriveTest, ADeadEndIsLeftAgain)
    {
        Rows rows = openRows(40, 25);
        fill(rows, 28, 28, 5, 19);
        fill(rows, 12, 28, 5, 5);
        fill(rows, 12, 28, 19, 19);
        const auto world = factory(rows, DISC + ACROSS);
        const DriveResult result = driveWith(world);
        expectArrival(world, result);
        // into it until the wall at its end is seen
        EXPECT_GE(result.driven, 1.1 * omniscientLength(world, 0.5));
        double farthest = 0.0;
        for (const Pose &pose : result.trail)
        {
            const bool isInside = pose.position.y() > 5.0 && pose.position.y() < 19.0 && pose.position.x() < 28.0;
            farthest = isInside ? std::max(farthest, pose.position.x()) : farthest;
        }
        EXPECT_GE(farthest, 18.0);
    }

    TEST_F(DriveTest, AGoalThatCannotBeReachedIsGivenUp)
    {
        Rows rows = openRows(40, 25);
        fill(rows, 31, 39, 8, 16);
        fill(rows, 33, 38, 10, 14, '.');
        const auto world = factory(rows, DISC + ACROSS + "drive.patience = 0.3\n");
        const DriveResult result = driveWith(world);
        EXPECT_EQ(statusText(result.status), "no path");
        EXPECT_GT(result.driven, 10.0);
        EXPECT_EQ(result.periods.back().pathLength, std::numeric_limits<double>::infinity());
        expectNoContact(world, result);
        EXPECT_EQ(omniscientLength(world, 0.2), std::numeric_limits<double>::infinity());
    }

    TEST_F(DriveTest, TheTimeLimitEndsADrive)
    {
        const auto world = factory(openRows(40, 25), DISC + ACROSS + "drive.time_limit = 4\n");
        const DriveResult result = driveWith(world);
        EXPECT_EQ(statusText(result.status), "time out");
        EXPECT_NEAR(result.driven, 8.0, 1e-6);
        EXPECT_NEAR(result.trail.back().position.x(), 11.0, 1e-6);
    }

    TEST_F(DriveTest, AnObstacleThatIsNotThereIsDrivenThrough)
    {
        Rows known = openRows(40, 25);
        fill(known, 20, 21, 0, 22);
        writeMap("known.map", known);
        const auto world = factory(openRows(40, 25), DISC + ACROSS + "known_map = known.map\n");
        const DriveResult result = driveWith(world);
        expectArrival(world, result);
        // 33 by the straight way; by the map it is 40, of which 10 are driven before the error is seen
        EXPECT_LE(result.driven, 37.0);
        EXPECT_GE(result.improvements, 1U);
    }

    TEST_F(DriveTest, AClosedWallThatIsNotThereIsSeenThrough)
    {
        Rows known = openRows(40, 25);
        fill(known, 9, 9, 0, 24);
        writeMap("known.map", known);
        const auto world = factory(openRows(40, 25), DISC + ACROSS + "known_map = known.map\nsensor.rays = 3000\n");
        expectArrival(world, driveWith(world));
    }

    TEST_F(DriveTest, AWallThatTheMapLacksIsDrivenAround)
    {
        writeMap("known.map", openRows(40, 25));
        Rows rows = openRows(40, 25);
        fill(rows, 20, 22, 3, 24);
        const auto world = factory(rows, DISC + ACROSS + "known_map = known.map\n");
        const DriveResult result = driveWith(world);
        expectArrival(world, result);
        EXPECT_GE(result.blockages, 1U);
    }

    TEST_F(DriveTest, FewRaysNeverLeadIntoAnObstacle)
    {
        // single cells between the rays, which only the robot's sides notice
        std::mt19937 random(4);
        for (int round = 0; round < 4; ++round)
        {
            Rows rows = openRows(40, 25);
            for (int i = 0; i < 40; ++i)
            {
                rows[random() % 25][6 + random() % 26] = '@';
            }
            const auto world =
                factory(rows, "robot = disc\nrobot.radius = 0.3\n" + ACROSS + "sensor.rays = 7\ndrive.patience = 1\n");
            const DriveResult result = driveWith(world);
            EXPECT_NE(statusText(result.status), "collision");
            EXPECT_GT(result.driven, 5.0);
            expectNoContact(world, result);
        }
    }

    TEST_F(DriveTest, FootprintsAndCarsDriveAround)
    {
        Rows rows = openRows(40, 25);
        fill(rows, 20, 20, 6, 24);
        fill(rows, 26, 26, 0, 15);
        const std::string poses = ACROSS + "start.theta = 0\ngoal.theta = 0\n";
        const std::string robot =
            "robot = footprint\nrobot.footprint = [[-1, -0.6], [1.4, -0.6], [1.4, 0.6], [-1, 0.6]]\n"
            "robot.padding = 0.1\ndrive.replan_time = 0.05\n";
        for (const char *space :
             {"", "statespace = dubins\nturningradius = 1.5\n", "statespace = reedsshepp\nturningradius = 1.5\n"})
        {
            const auto world = factory(rows, robot + poses + space);
            SCOPED_TRACE(space);
            const DriveResult result = driveWith(world);
            expectArrival(world, result);
            EXPECT_NEAR(result.trail.back().yaw, 0.0, 1e-6);
        }
    }

    TEST_F(DriveTest, ARecordingHasAllThatWasLearnt)
    {
        Rows rows = openRows(40, 25);
        fill(rows, 20, 20, 4, 21);
        const auto world = factory(rows, DISC + ACROSS);
        const DriveResult result = drive(world, std::nullopt, {"mfa", "MFA", "test", {}, {}}, true);
        ASSERT_EQ(result.frames.size(), result.periods.size() + 1);
        std::size_t cells = 0;
        for (const DriveFrame &frame : result.frames)
        {
            for (const maps::CellChange &change : frame.news)
            {
                ++cells;
                ASSERT_EQ(change.cell, world.map()->map().cell(change.x, change.y));
            }
        }
        EXPECT_GT(cells, 300U);
        for (std::size_t i = 0; i < result.periods.size(); ++i)
        {
            EXPECT_EQ(result.trail[result.frames[i].place].position, result.periods[i].pose.position);
            ASSERT_FALSE(result.frames[i].path.empty());
            EXPECT_LE((result.frames[i].path.front() - result.periods[i].pose.position).norm(), 1e-9);
        }
    }

    TEST_F(DriveTest, WrongKnownMapsAreRefused)
    {
        const auto fault = [&](const std::string &name)
        {
            const auto world = factory(openRows(40, 25), DISC + ACROSS + "known_map = " + name + "\n");
            try
            {
                loadKnownMap(world);
            }
            catch (const InputError &error)
            {
                return std::string(error.what());
            }
            return std::string();
        };
        writeMap("small.map", openRows(40, 24));
        EXPECT_NE(fault("small.map").find("known_map = small.map: it has 40 x 24 cells, the world 40 x 25"),
                  std::string::npos);
        EXPECT_NE(fault("none.map").find("no such file"), std::string::npos);
        folder_.write("broken.map", "type octile\n");
        EXPECT_NE(fault("broken.map").find("known_map = broken.map: "), std::string::npos);
        folder_.write("other.txt", "x");
        EXPECT_NE(fault("other.txt").find("expected a map"), std::string::npos);
    }

    TEST_F(DriveTest, RandomProblemsAreConnectedAndRepeat)
    {
        Rows rows = openRows(40, 25);
        fill(rows, 15, 15, 0, 24);
        const auto world = factory(rows, DISC + "start.x = 3\nstart.y = 3\ngoal.x = 8\ngoal.y = 20\n");
        const auto problems = randomProblems(world, 6, 3, 0.05);
        ASSERT_EQ(problems.size(), 6U);
        for (const DriveProblem &problem : problems)
        {
            EXPECT_EQ(problem.start.x < 15.0, problem.goal.x < 15.0);
            EXPECT_TRUE(std::isfinite(problem.optimum));
        }
        const auto again = randomProblems(world, 6, 3, 0.05);
        EXPECT_EQ(again[5].start.x, problems[5].start.x);
        EXPECT_NE(randomProblems(world, 1, 4, 0.05)[0].start.x, problems[0].start.x);
    }

    TEST(DriveSet, QuantilesAreValues)
    {
        EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
        EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
        EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 0.99), 3.0);
        EXPECT_EQ(quantile({3.0, 1.0, 2.0}, 1.0), 3.0);
        EXPECT_EQ(quantile({4.0, 3.0, 2.0, 1.0}, 0.25), 1.0);
    }
}  // namespace ompl_mfa::drive
