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

#include "ompl_mfa/robots/RobotModel.h"

#include <gtest/gtest.h>

#include "collision/TestFiles.h"
#include "robots/TestRobots.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using collision::expectInputError;
        using collision::TemporaryFolder;

        std::string joint(const std::string &name, const std::string &type, const std::string &parent,
                          const std::string &child, const std::string &more = "")
        {
            return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" +
                   child + "'/>" + more + "</joint>\n";
        }

        std::string limit(double lower, double upper)
        {
            return "<limit lower='" + std::to_string(lower) + "' upper='" + std::to_string(upper) +
                   "' velocity='1' effort='1'/>";
        }

        std::string robotOf(const std::string &joints, const std::string &shape = "<box size='1 1 1'/>")
        {
            return "<robot name='r'>\n<link name='a'/>\n<link name='b'><collision><geometry>" + shape +
                   "</geometry></collision></link>\n<link name='c'/>\n" + joints + "</robot>\n";
        }

        template <typename... Parts>
        void expectFault(const std::string &content, const Parts &...parts)
        {
            const TemporaryFolder folder;
            const auto file = folder.write("robot.urdf", content);
            expectInputError([&file] { loadRobotModel(file); }, "robot.urdf", parts...);
        }

        const std::string FIXED_B = joint("jb", "fixed", "a", "b");
        const std::string FIXED_C = joint("jc", "fixed", "b", "c");

        TEST(RobotModel, ReadsEveryKindOfJointAndShape)
        {
            const RobotModel model = loadRobotModel(picker().urdf());
            EXPECT_EQ(model.name(), "picker");
            EXPECT_EQ(model.links().size(), 10U);
            EXPECT_EQ(model.joints().size(), 9U);
            const auto named = [&model](const char *name) { return model.joints()[*model.findJoint(name)]; };
            EXPECT_EQ(named("lift").type, JointType::Prismatic);
            EXPECT_EQ(named("lift").upper, 0.45);
            EXPECT_EQ(named("lift").velocity, 0.3);
            EXPECT_EQ(named("lift").acceleration, 0.6);
            EXPECT_EQ(named("turn").type, JointType::Revolute);
            // not the soft limits
            EXPECT_EQ(named("turn").lower, -2.7);
            EXPECT_EQ(named("roll").type, JointType::Continuous);
            EXPECT_TRUE(std::isinf(named("roll").upper));
            EXPECT_EQ(named("grasp").type, JointType::Fixed);
            EXPECT_EQ(named("right_finger").mimic->joint, *model.findJoint("left_finger"));
            EXPECT_EQ(named("right_finger").mimic->multiplier, -1.);
            const auto kind = [&model](const char *link)
            { return model.links()[*model.findLink(link)].shapes.front().geometry->getNodeType(); };
            EXPECT_EQ(kind("foot"), fcl::GEOM_BOX);
            EXPECT_EQ(kind("turret"), fcl::GEOM_CYLINDER);
            EXPECT_EQ(kind("wrist_link"), fcl::GEOM_SPHERE);
            EXPECT_EQ(kind("palm"), fcl::BV_OBBRSS);
            // the mesh is in centimetres
            const fcl::AABBd box = collision::RigidBody(model.links()[*model.findLink("palm")].shapes).bounds();
            EXPECT_NEAR(box.max_.x(), 0.05, 1e-12);
            EXPECT_EQ(model.links()[*model.findLink("foot")].shapes.size(), 2U);
        }

        TEST(RobotModel, ReadsTheSharedRobots)
        {
            if (sharedRobots().empty())
            {
                GTEST_SKIP() << "no shared arms";
            }
            for (const TestRobot &robot : sharedRobots())
            {
                const RobotModel mesh = loadRobotModel(robot.urdf());
                const RobotModel balls = loadRobotModel(robot.urdf(true));
                EXPECT_EQ(mesh.name(), robot.name);
                EXPECT_EQ(balls.name(), robot.name);
                for (const Link &link : balls.links())
                {
                    for (const auto &shape : link.shapes)
                    {
                        EXPECT_EQ(shape.geometry->getNodeType(), fcl::GEOM_SPHERE) << link.name;
                    }
                }
            }
        }

        TEST(RobotModel, ChainsOfMimicryAreResolved)
        {
            const TemporaryFolder folder;
            const auto file = folder.write(
                "robot.urdf",
                "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>" +
                    joint("j1", "revolute", "a", "b", limit(-1, 1)) +
                    joint("j2", "revolute", "b", "c", limit(-1, 1) + "<mimic joint='j1' multiplier='2' offset='1'/>") +
                    joint("j3", "revolute", "c", "d", limit(-1, 1) + "<mimic joint='j2' multiplier='3' offset='5'/>") +
                    "</robot>");
            const RobotModel model = loadRobotModel(file);
            const Joint &last = model.joints()[*model.findJoint("j3")];
            EXPECT_EQ(last.mimic->joint, *model.findJoint("j1"));
            EXPECT_EQ(last.mimic->multiplier, 6.);
            EXPECT_EQ(last.mimic->offset, 8.);
        }

        TEST(RobotModel, DefaultValueIsWithinTheLimits)
        {
            const TemporaryFolder folder;
            const auto file = folder.write("robot.urdf", robotOf(joint("jb", "revolute", "a", "b", limit(1, 2)) +
                                                                 joint("jc", "revolute", "b", "c", limit(-1, 2))));
            const RobotModel model = loadRobotModel(file);
            EXPECT_EQ(model.defaultValue(*model.findJoint("jb")), 1.5);
            EXPECT_EQ(model.defaultValue(*model.findJoint("jc")), 0.);
        }

        TEST(RobotModel, EachFaultIsOneLineThatNamesIt)
        {
            expectFault(robotOf(joint("jb", "planar", "a", "b") + FIXED_C), ":5", "'jb' is planar", "revolute");
            expectFault(robotOf(joint("jb", "floating", "a", "b") + FIXED_C), "'jb' is floating");
            expectFault(robotOf(FIXED_B + joint("jc", "revolute", "b", "c", limit(1, -1))), ":6", "'jc'", "contradict",
                        "lower 1", "upper -1");
            expectFault(robotOf(FIXED_B + joint("jc", "revolute", "b", "c")), "jc", "limits");
            expectFault(robotOf(FIXED_B + FIXED_C + joint("second", "fixed", "a", "c")), ":7", "'second'", "'c'",
                        "'jc'", "loops");
            expectFault("<robot name='r'><link name='a'/><link name='b'/><link name='c'/>" +
                            joint("jb", "fixed", "c", "b") + FIXED_C + "</robot>",
                        "loop");
            expectFault(robotOf(FIXED_B), "not a valid URDF");
            expectFault(robotOf(FIXED_B + joint("jc", "revolute", "b", "c", limit(-1, 1) + "<axis xyz='0 0 0'/>")),
                        "'jc'", "axis");
            expectFault(robotOf(FIXED_B + joint("jc", "revolute", "b", "c", limit(-1, 1) + "<mimic joint='x'/>")),
                        "'jc' mimics 'x'");
            expectFault(robotOf(FIXED_B + joint("jc", "revolute", "b", "c", limit(-1, 1) + "<mimic joint='jc'/>")),
                        "'jc' mimics itself");
            expectFault(robotOf(FIXED_B + FIXED_C, "<mesh filename='package://none/arm.stl'/>"), "link 'b'",
                        "not found", "none/arm.stl");
            expectFault(robotOf(FIXED_B + FIXED_C, "<sphere radius='-1'/>"), "link 'b'", "radius");
            expectFault("<robot name='r' xmlns:xacro='x'><xacro:include filename='y'/></robot>", "xacro", "expand");
            expectFault("<robot name='r'><link", "malformed");
            expectFault("<urdf/>", "'urdf'", "expected 'robot'");
            expectInputError([] { loadRobotModel("/no/such/robot.urdf"); }, "/no/such/robot.urdf", "not found");
        }
    }  // namespace
}  // namespace ompl_mfa::robots
