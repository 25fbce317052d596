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

#include <map>

#include "ForeignLocale.h"
#include "collision/TestFiles.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/SceneLoader.h"

namespace ompl_mfa::collision
{
    namespace
    {
        const std::string SCENE = R"(world:
  collision_objects:
    - id: box
      primitives: [{type: CYLINDER, dimensions: [1.5, 0.25]}]
      primitive_poses: [{position: [1234.5, -0.125, 1e-1], orientation: [0, 0, 0.6, 0.8]}]
    - id: mesh
      meshes: [{vertices: [[0.5, 0, 0], [1.5, 0.5, 0], [0, 0, 2.75]], triangles: [[0, 1, 2]], scale: 0.5}]
)";

        const std::string AMF = R"(<?xml version="1.0"?>
<amf unit="meter"><object id="0"><mesh><vertices>
<vertex><coordinates><x>0.5</x><y>0.25</y><z>1234.5</z></coordinates></vertex>
<vertex><coordinates><x>1.5</x><y>0</y><z>0</z></coordinates></vertex>
<vertex><coordinates><x>0</x><y>1.5</y><z>0</z></coordinates></vertex>
</vertices><volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object></amf>
)";

        const std::string X3D = R"(<?xml version="1.0"?>
<X3D version="3.0"><Scene><Transform translation="0.5 0.25 1.5" scale="1.5 1.5 1.5"><Shape>
<IndexedFaceSet coordIndex="0 1 2 -1"><Coordinate point="0.5 0.25 0 1234.5 0 0.75 0 1.5 0.125"/></IndexedFaceSet>
</Shape></Transform></Scene></X3D>
)";

        // One cell at (0.125, 0.125, 0.125) of edge 0.25.
        std::string map()
        {
            const std::string cell("\x02\0", 2);
            std::string nodes;
            for (int depth = 0; depth < 15; ++depth)
            {
                nodes += depth == 0 ? std::string("\0\xC0", 2) : std::string("\x03\0", 2);
            }
            return "# Octomap OcTree binary file\nid OcTree\nsize 17\nres 0.25\ndata\n" + nodes + cell;
        }

        class LocaleTest : public ::testing::Test
        {
        protected:
            LocaleTest()
            {
                folder_.write("scene.yaml", SCENE);
                folder_.write("text.scene",
                              "name\n* box\n1\nbox\n1.5 0.5 0.25\n1234.5 0.125 0\n0 0 0.6 0.8\n0 0 0 0.5\n.\n");
                folder_.write("map.bt", map());
                folder_.write("plain.obj", "v 0.5 0.25 0\nv 1234.5 0 0.75\nv 0 1.5 0.125\nf 1 2 3\n");
                folder_.write("plain.off", "OFF\n3 1 3\n0.5 0.25 0\n1234.5 0 0.75\n0 1.5 0.125\n3 0 1 2\n");
                folder_.write("mesh.amf", AMF);
                folder_.write("mesh.x3d", X3D);
            }

            // Bounding boxes of the contents of every file in the folder.
            std::map<std::string, Eigen::Matrix<double, 6, 1>> boxes() const
            {
                std::map<std::string, Eigen::Matrix<double, 6, 1>> boxes;
                for (const auto &entry : std::filesystem::directory_iterator(folder_.path()))
                {
                    const fcl::AABBd box = loadScene(entry.path()).bounds();
                    boxes[entry.path().filename().string()] << box.min_, box.max_;
                }
                return boxes;
            }

            void expectBoxes(const std::map<std::string, Eigen::Matrix<double, 6, 1>> &expected) const
            {
                const auto found = boxes();
                ASSERT_EQ(expected.size(), 7U);
                for (const auto &[name, box] : expected)
                {
                    EXPECT_EQ(found.at(name), box)
                        << name << ": " << found.at(name).transpose() << " instead of " << box.transpose();
                }
            }

            TemporaryFolder folder_;
        };

        TEST_F(LocaleTest, WorldsAreTheSameWhateverStreamsTakeForNumbers)
        {
            const auto expected = boxes();
            EXPECT_NEAR(expected.at("scene.yaml")[3], 1234.75, 1e-9);
            EXPECT_NEAR(expected.at("map.bt")[3], 0.25, 1e-9);
            const ompl_mfa::test::ForeignStreams foreign;
            expectBoxes(expected);
        }

        TEST_F(LocaleTest, WorldsAreTheSameWhateverTheLibraryTakesForNumbers)
        {
            const auto expected = boxes();
            const ompl_mfa::test::ForeignLibrary foreign;
            if (!foreign.isThere())
            {
                GTEST_SKIP() << "there is no locale de_DE.UTF-8, and it cannot be compiled";
            }
            const ompl_mfa::test::ForeignStreams streams;
            expectBoxes(expected);
        }

        TEST_F(LocaleTest, MessagesNameNumbersAsTheyAreWritten)
        {
            const ompl_mfa::test::ForeignStreams foreign;
            expectInputError(
                [this]
                {
                    loadScene(folder_.write("a.yaml",
                                            "world:\n  collision_objects:\n    - id: a\n      primitives: "
                                            "[{type: sphere, dimensions: [-1234.5]}]\n"));
                },
                "sphere radius = -1234.5:");
            expectInputError(
                [this]
                {
                    loadScene(folder_.write("c.yaml",
                                            "world:\n  collision_objects:\n    - id: a\n      primitives: "
                                            "[{type: sphere, dimensions: ['1,5']}]\n"));
                },
                "c.yaml:4", "1,5", "finite number");
        }

        TEST_F(LocaleTest, HeadersOfMapsHoldWholeNumbers)
        {
            const auto expectFault = [this](const std::string &from, const std::string &to)
            {
                std::string text = map();
                text.replace(text.find(from), from.size(), to);
                expectInputError([&] { loadScene(folder_.write("broken.bt", text)); }, "broken.bt", to);
            };
            expectFault("res 0.25", "res 0,25");
            expectFault("res 0.25", "res 0.25m");
            expectFault("size 17", "size -17");
            expectFault("size 17", "size 17.5");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
