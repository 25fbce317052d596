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

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include "collision/TestFiles.h"
#include "ompl_mfa/collision/SceneLoader.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        class TextSceneTest : public ::testing::Test
        {
        protected:
            Scene load(const std::string &text) const
            {
                return loadScene(folder_.write("room.scene", text));
            }

            template <typename... Parts>
            void expectFault(const std::string &text, const Parts &...parts) const
            {
                expectInputError([&] { load(text); }, "room.scene", parts...);
            }

            TemporaryFolder folder_;
        };

        // As exported by RViz before objects had poses.
        const std::string OLDER =
            "(noname)+\n"
            "* big table\n"
            "2\n"
            "box\n1 2 0.5\n"
            "1 2 3\n0 0 0.70710678 0.70710678\n"
            "0 0 0 0\n"
            "sphere\n0.25\n"
            "4 5 6\n0 0 0 1\n"
            "0.1 0.2 0.3 1\n"
            "* post\n"
            "1\n"
            "cylinder\n0.1 2\n"
            "0 0 1\n0 0 0 1\n"
            "0 0 0 0\n"
            ".\n";

        // As exported since then: the pose of the object before its shapes, its subframes after them.
        const std::string NEWER =
            "room\n"
            "* table\n"
            "10 0 0\n0 0 0.70710678 0.70710678\n"
            "2\n"
            "cone\n0.5 3\n"
            "1 0 0\n0 0 0 1\n"
            "0 0 0 0\n"
            "mesh\n4 4\n"
            "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
            "0 2 1\n0 1 3\n1 2 3\n2 0 3\n"
            "0 0 0\n0 0 0 1\n"
            "1 0 0 1\n"
            "1\n"
            "handle\n"
            "0 0 0.5\n0 0 0 1\n"
            ".\n";

        TEST_F(TextSceneTest, ReadsTheOlderFormat)
        {
            const Scene scene = load(OLDER);
            ASSERT_EQ(scene.objects().size(), 3U);
            EXPECT_EQ(scene.objects()[0].id, "big table");
            EXPECT_EQ(scene.objects()[2].id, "post");
            EXPECT_EQ(static_cast<const fcl::Boxd &>(*scene.objects()[0].geometry).side, fcl::Vector3d(1., 2., 0.5));
            EXPECT_EQ(scene.objects()[0].pose.translation(), fcl::Vector3d(1., 2., 3.));
            EXPECT_TRUE(scene.objects()[0].pose.linear().col(0).isApprox(fcl::Vector3d::UnitY(), 1e-7));
            EXPECT_EQ(static_cast<const fcl::Sphered &>(*scene.objects()[1].geometry).radius, 0.25);
            // MoveIt writes a cylinder's radius first here, and its height first in messages.
            const auto &post = static_cast<const fcl::Cylinderd &>(*scene.objects()[2].geometry);
            EXPECT_EQ(post.radius, 0.1);
            EXPECT_EQ(post.lz, 2.);
        }

        TEST_F(TextSceneTest, ReadsTheNewerFormat)
        {
            const Scene scene = load(NEWER);
            ASSERT_EQ(scene.objects().size(), 2U);
            const auto &cone = static_cast<const fcl::Coned &>(*scene.objects()[0].geometry);
            EXPECT_EQ(cone.radius, 0.5);
            EXPECT_EQ(cone.lz, 3.);
            EXPECT_TRUE(scene.objects()[0].pose.translation().isApprox(fcl::Vector3d(10., 1., 0.), 1e-7));
            EXPECT_EQ(static_cast<const MeshGeometry &>(*scene.objects()[1].geometry).num_tris, 4);
        }

        TEST_F(TextSceneTest, MayHaveABlankNameAndWindowsLineEnds)
        {
            const std::string unnamed = NEWER.substr(NEWER.find('\n'));
            EXPECT_EQ(load(unnamed).objects().size(), 2U);
            std::string windows = NEWER;
            for (std::size_t at = windows.find('\n'); at != std::string::npos; at = windows.find('\n', at + 2))
            {
                windows.insert(at, "\r");
            }
            ASSERT_EQ(load(windows).objects().size(), 2U);
            EXPECT_EQ(load(windows).objects()[0].id, "table");
        }

        TEST_F(TextSceneTest, MayBeARobot)
        {
            EXPECT_EQ(loadRobot(folder_.write("robot.scene", NEWER), RobotCentring::VertexMean).shapes().size(), 2U);
        }

        TEST_F(TextSceneTest, TakesUnsetOrientationsAsIdentityWithAWarning)
        {
            std::string text = OLDER;
            text.replace(text.find("0 0 0 1\n0.1"), 7, "0 0 0 0");
            const std::string warning =
                standardErrorOf([&] { EXPECT_TRUE(load(text).objects()[1].pose.linear().isIdentity()); });
            EXPECT_EQ(countOf("Warning:", warning), 1U) << warning;
            EXPECT_NE(warning.find("'big table'"), std::string::npos) << warning;
        }

        TEST_F(TextSceneTest, NamesTheLineOfAFault)
        {
            const auto changed = [](std::string text, const std::string &from, const std::string &to)
            { return text.replace(text.find(from), from.size(), to); };
            expectFault("", "empty");
            expectFault("room\n.\n", "no obstacle");
            expectFault(changed(OLDER, "sphere", "plane"), ":9", "'plane'", "mesh");
            expectFault(changed(OLDER, "sphere", "torus"), ":9", "'torus'", "box");
            expectFault(changed(OLDER, "0.25", "-1"), ":10", "radius = -1");
            expectFault(changed(OLDER, "1 2 0.5", "1 two 0.5"), ":5", "two", "number");
            expectFault(changed(OLDER, "1 2 0.5", "1 0,5 0.5"), ":5", "0,5", "number");
            expectFault(changed(OLDER, "* post\n1", "* post\n1.5"), ":15", "1.5", "whole number");
            expectFault(changed(OLDER, "* post", "+ post"), ":14", "'+'");
            expectFault(changed(NEWER, "0 2 1", "0 2 4"), ":17", "vertex index 4", "below 4");
            expectFault(OLDER.substr(0, OLDER.size() - 2), "ends", "'.'");
            expectFault(OLDER.substr(0, OLDER.find("sphere")), "ends");
            expectFault(OLDER + "* more\n", ":22", "behind the '.'");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
