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

#include "ompl_mfa/robots/RobotKinematics.h"

#include <fstream>
#include <functional>
#include <sstream>

#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>
#include <kdl/tree.hpp>
#include <kdl/treefksolverpos_recursive.hpp>

#include "robots/TestRobots.h"

namespace ompl_mfa::robots
{
    namespace
    {
        KDL::Frame frameOf(const urdf::Pose &pose)
        {
            return {KDL::Rotation::Quaternion(pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w),
                    KDL::Vector(pose.position.x, pose.position.y, pose.position.z)};
        }

        KDL::Joint kdlJoint(const urdf::Joint &joint)
        {
            const KDL::Frame origin = frameOf(joint.parent_to_joint_origin_transform);
            const KDL::Vector axis(joint.axis.x, joint.axis.y, joint.axis.z);
            switch (joint.type)
            {
                case urdf::Joint::REVOLUTE:
                case urdf::Joint::CONTINUOUS:
                    return {joint.name, origin.p, origin.M * axis, KDL::Joint::RotAxis};
                case urdf::Joint::PRISMATIC:
                    return {joint.name, origin.p, origin.M * axis, KDL::Joint::TransAxis};
                default:
                    return KDL::Joint(joint.name, KDL::Joint::Fixed);
            }
        }

        /* The robot in KDL, read from its file independently of this library. */
        KDL::Tree kdlTree(const std::filesystem::path &file)
        {
            std::ostringstream text;
            text << std::ifstream(file).rdbuf();
            const auto urdf = urdf::parseURDF(text.str());
            KDL::Tree tree(urdf->getRoot()->name);
            const std::function<void(const urdf::Link &)> add = [&](const urdf::Link &link)
            {
                for (const auto &joint : link.child_joints)
                {
                    tree.addSegment(KDL::Segment(joint->child_link_name, kdlJoint(*joint),
                                                 frameOf(joint->parent_to_joint_origin_transform)),
                                    link.name);
                    add(*urdf->getLink(joint->child_link_name));
                }
            };
            add(*urdf->getRoot());
            return tree;
        }

        double difference(const fcl::Transform3d &ours, const KDL::Frame &theirs)
        {
            double largest = 0.;
            for (int row = 0; row < 3; ++row)
            {
                largest = std::max(largest, std::abs(ours.translation()[row] - theirs.p(row)));
                for (int column = 0; column < 3; ++column)
                {
                    largest = std::max(largest, std::abs(ours.linear()(row, column) - theirs.M(row, column)));
                }
            }
            return largest;
        }

        /* Largest difference to KDL of the poses of all links in random states of all moving joints. */
        double worstDifference(const TestRobot &robot, int states)
        {
            const PlacedRobot all = placed(robot, false, std::make_shared<collision::RobotScene>(), robot.group);
            const KDL::Tree tree = kdlTree(robot.urdf());
            KDL::TreeFkSolverPos_recursive solver(tree);
            PlacedRobot moving = all;
            moving.group = RobotSemantics(*all.model).jointsOf("");
            const RobotKinematics kinematics(*moving.model, moving.group, moving.values);
            std::vector<fcl::Transform3d> bodies(kinematics.bodyCount());
            RandomJoints random(moving);
            double worst = 0.;
            for (int state = 0; state < states; ++state)
            {
                const std::vector<double> q = random.next();
                std::vector<double> values = moving.values;
                for (std::size_t i = 0; i < q.size(); ++i)
                {
                    values[moving.group[i]] = q[i];
                }
                KDL::JntArray array(tree.getNrOfJoints());
                for (std::size_t i = 0; i < values.size(); ++i)
                {
                    const Joint &joint = moving.model->joints()[i];
                    const double value =
                        joint.mimic ? joint.mimic->multiplier * values[joint.mimic->joint] + joint.mimic->offset
                                    : values[i];
                    if (joint.isMoving())
                    {
                        array(tree.getSegment(moving.model->links()[joint.childLink].name)->second.q_nr) = value;
                    }
                }
                kinematics.place(q.data(), bodies.data());
                const std::vector<fcl::Transform3d> links = moving.model->linkPoses(values);
                for (std::size_t i = 0; i < links.size(); ++i)
                {
                    KDL::Frame frame;
                    EXPECT_GE(solver.JntToCart(array, frame, moving.model->links()[i].name), 0);
                    worst = std::max(worst, difference(links[i], frame));
                    worst = std::max(worst, difference(bodies[kinematics.bodyOf(i)] * kinematics.poseInBody(i), frame));
                }
            }
            return worst;
        }

        TEST(RobotKinematics, AgreesWithKdlForEveryLink)
        {
            for (const TestRobot &robot : allRobots())
            {
                EXPECT_LT(worstDifference(robot, 10000), 1e-12) << robot.name;
            }
        }

        TEST(RobotKinematics, JointsOutsideOfTheGroupKeepTheirValues)
        {
            PlacedRobot robot = placed(picker());
            robot.values[*robot.model->findJoint("left_finger")] = 0.02;
            robot.values[*robot.model->findJoint("roll")] = 0.7;
            robot.base.translation() = fcl::Vector3d(1., -2., 0.5);
            const RobotKinematics kinematics(*robot.model, robot.group, robot.values, robot.base);
            EXPECT_EQ(kinematics.bodyCount(), 6U);
            RandomJoints random(robot);
            std::vector<fcl::Transform3d> bodies(kinematics.bodyCount());
            for (int state = 0; state < 100; ++state)
            {
                const std::vector<double> q = random.next();
                for (std::size_t i = 0; i < q.size(); ++i)
                {
                    robot.values[robot.group[i]] = q[i];
                }
                kinematics.place(q.data(), bodies.data());
                const auto links = robot.model->linkPoses(robot.values);
                for (std::size_t i = 0; i < links.size(); ++i)
                {
                    const fcl::Transform3d pose = bodies[kinematics.bodyOf(i)] * kinematics.poseInBody(i);
                    EXPECT_TRUE(pose.isApprox(robot.base * links[i], 1e-12)) << robot.model->links()[i].name;
                }
            }
        }

        TEST(RobotKinematics, LeveragesBoundTheMovementOfPoints)
        {
            for (const TestRobot &one : allRobots())
            {
                PlacedRobot robot = placed(one);
                robot.group = RobotSemantics(*robot.model).jointsOf("");
                const RobotKinematics kinematics(*robot.model, robot.group, robot.values);
                RandomJoints random(robot);
                std::vector<fcl::Transform3d> before(kinematics.bodyCount());
                std::vector<fcl::Transform3d> after(kinematics.bodyCount());
                double tightest = 0.;
                for (int state = 0; state < 2000; ++state)
                {
                    const std::vector<double> q = random.next();
                    std::vector<double> moved = random.next();
                    kinematics.place(q.data(), before.data());
                    kinematics.place(moved.data(), after.data());
                    for (std::size_t body = 1; body < kinematics.bodyCount(); ++body)
                    {
                        const fcl::Vector3d point = 0.1 * fcl::Vector3d(std::cos(state), std::sin(state), 0.);
                        double bound = 0.;
                        for (const auto &leverage : kinematics.leverages(body, 0.1))
                        {
                            const std::size_t joint = kinematics.steps()[leverage.step].variable;
                            bound += leverage.bound * std::abs(moved[joint] - q[joint]);
                        }
                        const double distance = (before[body] * point - after[body] * point).norm();
                        EXPECT_LE(distance, bound + 1e-12) << one.name << ", body " << body;
                        tightest = std::max(tightest, distance / bound);
                    }
                }
                EXPECT_GT(tightest, 0.5) << one.name;
            }
        }

        TEST(RobotKinematics, RefusesJointsThatDoNotMoveByThemselves)
        {
            const PlacedRobot robot = placed(picker());
            for (const char *name : {"grasp", "right_finger"})
            {
                EXPECT_THROW(RobotKinematics(*robot.model, {*robot.model->findJoint(name)}, robot.values),
                             std::invalid_argument)
                    << name;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::robots
