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

#include "ompl_mfa/collision/OccupancyMap.h"

#include <limits>
#include <stdexcept>

#include <octomap/ColorOcTree.h>
#include <octomap/octomap.h>

#include "collision/TestFiles.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    namespace
    {
        class OccupancyMapTest : public ::testing::Test
        {
        protected:
            OccupancyMapTest()
              : tree_(0.5)
            {
                for (double x = 0.25; x < 4.; x += 0.5)
                {
                    tree_.updateNode(x, 0.25, 0.25, true);
                    tree_.updateNode(x, 5.25, 0.25, false);
                }
            }

            std::string text(bool binary)
            {
                std::ostringstream stream;
                if (binary)
                {
                    tree_.writeBinary(stream);
                }
                else
                {
                    tree_.write(stream);
                }
                return stream.str();
            }

            template <typename... Parts>
            void expectFault(const std::string &content, const Parts &...parts)
            {
                expectInputError([&] { loadOccupancyMap(folder_.write("map.bt", content)); }, "map.bt", parts...);
            }

            static std::string replaced(std::string content, const std::string &from, const std::string &to)
            {
                content.replace(content.find(from), from.size(), to);
                return content;
            }

            octomap::OcTree tree_;
            TemporaryFolder folder_;
        };

        TEST_F(OccupancyMapTest, ReadsBothFormats)
        {
            for (const bool binary : {true, false})
            {
                const auto map = loadOccupancyMap(folder_.write("map.bt", text(binary)));
                const fcl::AABBd box = boundingBox(*map, fcl::Transform3d::Identity());
                EXPECT_TRUE(box.min_.isApprox(fcl::Vector3d(0., 0., 0.))) << box.min_.transpose();
                EXPECT_TRUE(box.max_.isApprox(fcl::Vector3d(4., 0.5, 0.5))) << box.max_.transpose();
            }
        }

        TEST_F(OccupancyMapTest, RefusesOtherVersionsAndTrees)
        {
            expectInputError([this] { loadOccupancyMap(folder_.path() / "none.bt"); }, "none.bt", "not found");
            expectFault("", ":1", "not an OctoMap");
            expectFault("# OctoMap v0.5\n", ":1", "not an OctoMap of version 1.0 or newer");
            expectFault(replaced(text(true), "id OcTree", "id FancyTree"), "FancyTree", "OcTree");
            octomap::ColorOcTree colours(0.5);
            colours.updateNode(1., 1., 1., true);
            std::ostringstream stream;
            colours.write(stream);
            expectFault(stream.str(), "ColorOcTree");
            expectFault(replaced(text(true), "res 0.5", "res -1"), "res", "greater than 0");
            expectFault(replaced(text(true), "res 0.5", "resolution 0.5"), ":6", "resolution 0.5");
            expectFault(text(true).substr(0, 60), "no 'data' line");
        }

        TEST_F(OccupancyMapTest, RefusesBrokenNodes)
        {
            for (const bool binary : {true, false})
            {
                const std::string whole = text(binary);
                expectFault(whole.substr(0, whole.size() - 1), "truncated or broken");
                expectFault(whole.substr(0, whole.find("data\n") + 5), "truncated or broken");
                // Endlessly nested children.
                expectFault(whole.substr(0, whole.find("data\n") + 5) + std::string(100000, '\xff'),
                            "truncated or broken");
                const std::string size = "size " + std::to_string(tree_.size());
                expectFault(replaced(whole, size, "size 3"), "size 3");
            }
        }

        TEST_F(OccupancyMapTest, RefusesMapsWithoutObstacles)
        {
            octomap::OcTree empty(0.5);
            std::ostringstream nothing;
            empty.writeBinary(nothing);
            expectFault(nothing.str(), "no occupied cell");
            empty.updateNode(1., 1., 1., false);
            std::ostringstream freeSpace;
            empty.writeBinary(freeSpace);
            expectFault(freeSpace.str(), "no occupied cell");
        }

        TEST_F(OccupancyMapTest, MakesMapsOfTheNodesInMessages)
        {
            for (const bool binary : {true, false})
            {
                const std::string file = text(binary);
                const std::string nodes = file.substr(file.find("data\n") + 5);
                const auto map = makeOccupancyMap(nodes, binary, 0.5);
                ASSERT_NE(map, nullptr);
                const fcl::AABBd box = boundingBox(*map, fcl::Transform3d::Identity());
                EXPECT_TRUE(box.max_.isApprox(fcl::Vector3d(4., 0.5, 0.5))) << box.max_.transpose();
                EXPECT_THROW(makeOccupancyMap(nodes + "x", binary, 0.5), std::invalid_argument);
                EXPECT_THROW(makeOccupancyMap(nodes.substr(1), binary, 0.5), std::invalid_argument);
                EXPECT_THROW(makeOccupancyMap(nodes, binary, 0.), std::invalid_argument);
                EXPECT_THROW(makeOccupancyMap(nodes, binary, std::numeric_limits<double>::infinity()),
                             std::invalid_argument);
            }
            EXPECT_EQ(makeOccupancyMap("", true, 0.5), nullptr);
        }

        TEST_F(OccupancyMapTest, RefusesCellsOfWhichDistancesOverflow)
        {
            expectFault(replaced(text(true), "res 0.5", "res 1e200"), "res", "finite");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
