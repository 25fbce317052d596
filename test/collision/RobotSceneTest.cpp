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

#include "ompl_mfa/collision/RobotScene.h"

#include <gtest/gtest.h>

#include "collision/TestFiles.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // A robot with the link `hand`, which is as high as the joint `lift`.
        std::optional<fcl::Transform3d> handFrame(const std::string &name, const RobotState &state)
        {
            if (name != "hand")
            {
                return std::nullopt;
            }
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            for (const auto &[joint, value] : state.joints)
            {
                pose.translation().z() = joint == "lift" ? value : pose.translation().z();
            }
            return pose;
        }

        RobotScene read(const std::string &content)
        {
            const TemporaryFolder folder;
            return loadRobotScene(folder.write("scene.yaml", content), handFrame);
        }

        const std::string STATE = "robot_state:\n  joint_state: {name: [lift, turn], position: [0.5, 1]}\n";
        const std::string BOX =
            "primitives: [{type: box, dimensions: [1, 1, 1]}], primitive_poses: [{position: [0, 0, 2]}]";

        TEST(RobotScene, StateMatrixPaddingAndScaleAreRead)
        {
            const RobotScene scene =
                read("robot_model_name: crane\n" + STATE +
                     "  multi_dof_joint_state: {joint_names: [floor], transforms: [{translation: [1, 2, 3]}]}\n"
                     "allowed_collision_matrix:\n  entry_names: [a, b, c]\n"
                     "  entry_values: [[false, true, false], [true, false, false], [false, false, false]]\n"
                     "  default_entry_names: [d, e]\n  default_entry_values: [true, false]\n"
                     "link_padding: [{link_name: hand, padding: 0.01}]\nlink_scale: [{link_name: hand, scale: 1.1}]\n"
                     "world: {}\n");
            EXPECT_EQ(scene.robotName, "crane");
            EXPECT_EQ(scene.state.joints, (std::vector<std::pair<std::string, double>>{{"lift", 0.5}, {"turn", 1.}}));
            EXPECT_EQ(scene.state.bases.at("floor").translation(), fcl::Vector3d(1., 2., 3.));
            EXPECT_TRUE(scene.world.objects().empty());
            EXPECT_EQ(scene.allowed.find("b", "a"), true);
            EXPECT_EQ(scene.allowed.find("a", "c"), false);
            EXPECT_EQ(scene.allowed.find("a", "x"), std::nullopt);
            EXPECT_EQ(scene.allowed.find("x", "d"), true);
            EXPECT_EQ(scene.allowed.find("d", "e"), false);
            EXPECT_EQ(scene.padding.at("hand"), 0.01);
            EXPECT_EQ(scene.scale.at("hand"), 1.1);
        }

        TEST(RobotScene, ObjectsMayBeInFramesOfTheRobot)
        {
            const RobotScene scene =
                read(STATE + "world:\n  collision_objects:\n    - {id: box, header: {frame_id: hand}, " + BOX + "}\n");
            ASSERT_EQ(scene.world.objects().size(), 1U);
            EXPECT_NEAR(scene.world.objects()[0].pose.translation().z(), 2.5, 1e-12);
        }

        TEST(RobotScene, AttachedObjectsMoveWithTheirLink)
        {
            const RobotScene scene =
                read(STATE +
                     "  attached_collision_objects:\n"
                     "    - {link_name: hand, touch_links: [finger], object: {id: cup, header: {frame_id: hand}, " +
                     BOX + "}}\n    - {link_name: hand, object: {id: plate, " + BOX +
                     "}}\n    - {link_name: hand, object: {id: bowl}}\n"
                     "world:\n  collision_objects:\n    - {id: bowl, " +
                     BOX + "}\n    - {id: table, " + BOX + "}\n");
            ASSERT_EQ(scene.attached.size(), 3U);
            EXPECT_EQ(scene.attached[0].id, "cup");
            EXPECT_EQ(scene.attached[0].link, "hand");
            EXPECT_EQ(scene.attached[0].touchLinks, std::vector<std::string>{"finger"});
            EXPECT_NEAR(scene.attached[0].shapes[0].pose.translation().z(), 2., 1e-12);
            EXPECT_NEAR(scene.attached[1].shapes[0].pose.translation().z(), 1.5, 1e-12);
            // taken from the world
            EXPECT_NEAR(scene.attached[2].shapes[0].pose.translation().z(), 1.5, 1e-12);
            ASSERT_EQ(scene.world.objects().size(), 1U);
            EXPECT_EQ(scene.world.objects()[0].id, "table");
        }

        TEST(RobotScene, EachFaultIsOneLineThatNamesIt)
        {
            const auto expectFault = [](const std::string &content, const auto &...parts)
            { expectInputError([&content] { read(content + "world: {}\n"); }, "scene.yaml", parts...); };
            expectFault("robot_state: {joint_state: {name: [a, b], position: [1]}}\n", "position", "1 entries", "2");
            expectFault("robot_state: {joint_state: {name: [a], position: [up]}}\n", "'a'", "up");
            expectFault("allowed_collision_matrix: {entry_names: [a, b], entry_values: [[true, true]]}\n", "1 entries");
            expectFault("allowed_collision_matrix: {entry_names: [a], entry_values: [[true, true]]}\n", "2 entries");
            expectFault("allowed_collision_matrix: {entry_names: [a, b], entry_values: [[0, maybe], [0, 0]]}\n",
                        "maybe");
            expectFault("allowed_collision_matrix: {default_entry_names: [a]}\n", "default_entry_values");
            expectFault("link_scale: [{link_name: a, scale: 0}]\n", "scale = 0", "greater than 0");
            expectFault("robot_state: {attached_collision_objects: [{link_name: foot, object: {id: cup}}]}\n", "'cup'",
                        "'foot'");
            expectFault("robot_state: {attached_collision_objects: [{link_name: hand, object: {id: cup}}]}\n", "'cup'",
                        "no shapes");
            expectInputError([] { loadRobotScene("/no/scene.yaml", handFrame); }, "/no/scene.yaml", "not found");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
