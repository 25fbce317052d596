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

#include "ompl_mfa/robots/RobotSemantics.h"

#include <gtest/gtest.h>

#include "collision/TestFiles.h"
#include "robots/TestRobots.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using collision::expectInputError;
        using collision::TemporaryFolder;

        const RobotModel &model()
        {
            static const RobotModel MODEL = loadRobotModel(picker().urdf());
            return MODEL;
        }

        std::vector<std::string> names(const std::vector<std::size_t> &joints)
        {
            std::vector<std::string> result;
            for (const std::size_t joint : joints)
            {
                result.push_back(model().joints()[joint].name);
            }
            return result;
        }

        using Names = std::vector<std::string>;

        RobotSemantics read(const std::string &content)
        {
            const TemporaryFolder folder;
            return RobotSemantics(model(),
                                  folder.write("robot.srdf", "<robot name='picker'>\n" + content + "</robot>"));
        }

        TEST(RobotSemantics, GroupsAreChainsLinksJointsAndSubgroups)
        {
            const RobotSemantics semantics(model(), picker().srdf());
            EXPECT_EQ(semantics.groups(), (Names{"arm", "hand", "arm_and_roll"}));
            EXPECT_EQ(names(semantics.jointsOf("arm")), (Names{"lift", "turn", "shoulder", "elbow", "wrist"}));
            // the right finger follows the left one
            EXPECT_EQ(names(semantics.jointsOf("hand")), (Names{"left_finger"}));
            EXPECT_EQ(names(semantics.jointsOf("arm_and_roll")),
                      (Names{"lift", "turn", "shoulder", "elbow", "wrist", "roll"}));
            EXPECT_EQ(semantics.jointsOf("").size(), 7U);
            EXPECT_EQ(semantics.worldFrame(), "world");
        }

        TEST(RobotSemantics, StatesAndPairsAreRead)
        {
            const RobotSemantics semantics(model(), picker().srdf());
            const GroupState &ready = semantics.state("arm", "ready");
            EXPECT_EQ(ready.values.size(), 5U);
            EXPECT_EQ(ready.values.at(*model().findJoint("elbow")), 2.1);
            EXPECT_EQ(semantics.allowed().find("carriage", "foot"), true);
            EXPECT_EQ(semantics.allowed().find("palm", "foot"), std::nullopt);
            expectInputError([&semantics] { semantics.state("arm", "redy"); }, "picker.srdf", "redy", "ready");
            expectInputError([&semantics] { semantics.jointsOf("arms"); }, "picker.srdf", "arms", "arm");
        }

        TEST(RobotSemantics, WithoutAFileNeighboursMayTouch)
        {
            const RobotSemantics semantics(model());
            EXPECT_EQ(semantics.allowed().find("carriage", "foot"), true);
            EXPECT_EQ(semantics.allowed().find("turret", "foot"), std::nullopt);
            expectInputError([&semantics] { semantics.jointsOf("arm"); }, "arm", "there is none");
        }

        TEST(RobotSemantics, PassiveJointsAndDefaultsOfPairs)
        {
            const RobotSemantics semantics = read(
                "<passive_joint name='roll'/><group name='g'><link name='palm'/>"
                "<joint name='wrist'/></group>"
                "<disable_default_collisions link='palm'/>"
                "<enable_collisions link1='palm' link2='foot'/>");
            EXPECT_EQ(names(semantics.jointsOf("g")), (Names{"wrist"}));
            EXPECT_EQ(semantics.allowed().find("palm", "turret"), true);
            EXPECT_EQ(semantics.allowed().find("foot", "palm"), false);
        }

        TEST(RobotSemantics, EachFaultIsOneLineThatNamesIt)
        {
            const auto expectFault = [](const std::string &content, const auto &...parts)
            { expectInputError([&content] { read(content); }, "robot.srdf", parts...); };
            expectFault("<group name='g'><joint name='elbo'/></group>", ":2", "elbo", "elbow");
            expectFault("<group name='g'><link name='palms'/></group>", "palms", "palm");
            expectFault("<group name='g'><group name='h'/></group>", "unknown group 'h'");
            expectFault("<group name='g'><group name='g'/></group>", "'g' contains itself");
            expectFault("<group name='g'><chain base_link='palm' tip_link='foot'/></group>", "not above");
            expectFault(
                "<virtual_joint name='v' type='floating' parent_frame='w' child_link='foot'/>"
                "<group name='g'><joint name='v'/></group>",
                "'v'", "floating");
            expectFault("<virtual_joint name='v' type='fixed' parent_frame='w' child_link='palm'/>", "'palm'", "foot");
            expectFault("<group name='g'><joint name='lift'/></group><group_state name='s' group='f'/>", "'f'");
            expectFault(
                "<group name='g'><joint name='lift'/></group>"
                "<group_state name='s' group='g'><joint name='lift' value='up'/></group_state>",
                "'lift'", "up");
            expectInputError([] { read("<group name='g'><joint name='grasp'/></group>").jointsOf("g"); }, "'g'",
                             "no joint that moves");
            const TemporaryFolder folder;
            const auto other = folder.write("other.srdf", "<robot name='other'/>");
            expectInputError([&other] { RobotSemantics(model(), other); }, "other.srdf", "'other'", "'picker'");
        }
    }  // namespace
}  // namespace ompl_mfa::robots
