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

#include "ompl_mfa/robots/JointTrajectory.h"

#include <sstream>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <yaml-cpp/yaml.h>

#include "collision/TestFiles.h"
#include "robots/TestRobots.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::robots
{
    namespace
    {
        class JointTrajectoryTest : public ::testing::Test
        {
        protected:
            explicit JointTrajectoryTest()
            {
                files_.robot = picker().urdf();
                files_.semantics = picker().srdf();
                files_.group = "arm_and_roll";
            }

            JointTrajectory timed(const std::vector<std::vector<double>> &states) const
            {
                const RobotProblem problem(files_);
                const JointSpace joints = problem.makeSpace();
                const auto si = std::make_shared<ob::SpaceInformation>(joints.space());
                problem.setChecks(si, joints, collision::MotionValidation::Discrete);
                si->setup();
                og::PathGeometric path(si);
                for (const auto &values : states)
                {
                    ob::ScopedState<> state(joints.space());
                    joints.setState(values.data(), state.get());
                    path.append(state.get());
                }
                return timedPath(problem, path);
            }

            RobotFiles files_;
        };

        TEST_F(JointTrajectoryTest, SegmentsAreTrapezoids)
        {
            // 1.5 rad/s and 3 rad/s^2: half a second to the full speed, in which 0.375 rad pass
            const JointTrajectory trajectory = timed({{0., 0., 0., 0., 0., 0.}, {0., 2., 0., 0., 0., 0.}});
            ASSERT_EQ(trajectory.points.size(), 4U);
            EXPECT_NEAR(trajectory.points[1].time, 0.5, 1e-12);
            EXPECT_NEAR(trajectory.points[1].positions[1], 0.375, 1e-12);
            EXPECT_NEAR(trajectory.points[1].velocities[1], 1.5, 1e-12);
            EXPECT_NEAR(trajectory.points[2].positions[1], 2. - 0.375, 1e-12);
            EXPECT_NEAR(trajectory.duration(), 1. + (2. - 0.75) / 1.5, 1e-12);
            EXPECT_NEAR(trajectory.points[3].velocities[1], 0., 1e-12);
        }

        TEST_F(JointTrajectoryTest, ShortSegmentsAreTriangles)
        {
            const JointTrajectory trajectory = timed({{0., 0., 0., 0., 0., 0.}, {0., 0.12, 0., 0., 0., 0.}});
            ASSERT_EQ(trajectory.points.size(), 3U);
            EXPECT_NEAR(trajectory.points[1].time, std::sqrt(0.12 / 3.), 1e-12);
            EXPECT_NEAR(trajectory.points[1].positions[1], 0.06, 1e-12);
            EXPECT_NEAR(trajectory.duration(), 2. * std::sqrt(0.12 / 3.), 1e-12);
        }

        TEST_F(JointTrajectoryTest, TheSlowestJointGovernsAndNoLimitIsExceeded)
        {
            const JointTrajectory trajectory = timed({{0., -1., 0.2, 0., 0., 3.},
                                                      {0.4, 1., -0.5, 0.3, 0.1, -3.},
                                                      {0.4, 1., -0.5, 0.3, 0.1, -3.},
                                                      {0.1, 0.9, 0., 0.2, 0.3, 2.9}});
            const RobotProblem problem(files_);
            for (std::size_t i = 0; i < trajectory.points.size(); ++i)
            {
                for (std::size_t k = 0; k < 6; ++k)
                {
                    const Joint &joint = problem.robot().model->joints()[problem.robot().group[k]];
                    EXPECT_LE(std::abs(trajectory.points[i].velocities[k]), joint.velocity + 1e-9);
                    if (i > 0)
                    {
                        const double time = trajectory.points[i].time - trajectory.points[i - 1].time;
                        EXPECT_GT(time, 0.);
                        const double change =
                            trajectory.points[i].velocities[k] - trajectory.points[i - 1].velocities[k];
                        EXPECT_LE(std::abs(change), joint.acceleration * time + 1e-9);
                        // constant acceleration between the points
                        EXPECT_NEAR(
                            trajectory.points[i].positions[k] - trajectory.points[i - 1].positions[k],
                            0.5 * time * (trajectory.points[i].velocities[k] + trajectory.points[i - 1].velocities[k]),
                            1e-9);
                    }
                }
            }
            // the continuous joint goes on through pi and back
            EXPECT_NEAR(trajectory.points.back().positions[5], 2.9, 1e-9);
            double largest = 0.;
            for (const auto &point : trajectory.points)
            {
                largest = std::max(largest, point.positions[5]);
            }
            EXPECT_NEAR(largest, 2. * M_PI - 3., 1e-9);
        }

        TEST_F(JointTrajectoryTest, WithoutAccelerationsTheSpeedIsConstant)
        {
            files_.group = "hand";
            const JointTrajectory trajectory = timed({{0.}, {0.03}});
            ASSERT_EQ(trajectory.points.size(), 2U);
            EXPECT_NEAR(trajectory.duration(), 0.3, 1e-12);
        }

        TEST_F(JointTrajectoryTest, ScalesOfTheRequestSlowDown)
        {
            const collision::TemporaryFolder folder;
            const double before = timed({{0., 0., 0., 0., 0., 0.}, {0., 2., 0., 0., 0., 0.}}).duration();
            files_.request = folder.write("request.yaml",
                                          "group_name: arm_and_roll\nmax_velocity_scaling_factor: 0.5\n"
                                          "max_acceleration_scaling_factor: 0.25\n");
            EXPECT_NEAR(timed({{0., 0., 0., 0., 0., 0.}, {0., 2., 0., 0., 0., 0.}}).duration(), 2. * before, 1e-12);
        }

        TEST_F(JointTrajectoryTest, FilesHoldThePoints)
        {
            const JointTrajectory trajectory = timed({{0., 0., 0., 0., 0., 0.}, {0., 2., 0., 0., 0., 0.25}});
            std::ostringstream csv;
            writeCsv(trajectory, csv);
            std::istringstream lines(csv.str());
            std::string line;
            std::getline(lines, line);
            EXPECT_EQ(line.rfind("time,lift,turn,shoulder,elbow,wrist,roll,lift.velocity,", 0), 0U) << line;
            std::getline(lines, line);
            EXPECT_EQ(line, "0,0,0,0,0,0,0,0,0,0,0,0,0");
            std::ostringstream yaml;
            writeYaml(trajectory, yaml);
            const YAML::Node message = YAML::Load(yaml.str())["joint_trajectory"];
            EXPECT_EQ(message["joint_names"][5].as<std::string>(), "roll");
            ASSERT_EQ(message["points"].size(), trajectory.points.size());
            for (std::size_t i = 0; i < trajectory.points.size(); ++i)
            {
                const YAML::Node point = message["points"][i];
                EXPECT_EQ(point["positions"].as<std::vector<double>>(), trajectory.points[i].positions);
                EXPECT_EQ(point["velocities"].as<std::vector<double>>(), trajectory.points[i].velocities);
                EXPECT_NEAR(point["time_from_start"]["sec"].as<double>() +
                                1e-9 * point["time_from_start"]["nanosec"].as<double>(),
                            trajectory.points[i].time, 1e-9);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::robots
