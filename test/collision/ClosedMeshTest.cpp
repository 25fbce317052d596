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

#include "collision/ClosedMesh.h"

#include "collision/RandomScenes.h"
#include "collision/TestFiles.h"

namespace ompl_mfa::collision
{
    namespace
    {
        TEST(ClosedMesh, ContainsWhatIsInABox)
        {
            const fcl::Vector3d side(1., 2., 3.);
            const auto mesh = makeMeshGeometry(boxMesh(side));
            const ClosedMesh box(*mesh, "box");
            Random random(3);
            int inside = 0;
            for (int i = 0; i < 20000; ++i)
            {
                const fcl::Vector3d point = random.point(2.);
                const bool expected = (2. * point.cwiseAbs() - side).maxCoeff() < 0.;
                EXPECT_EQ(box.contains(point), expected) << point.transpose();
                inside += expected ? 1 : 0;
            }
            EXPECT_GT(inside, 500);
        }

        // A ray from such a point meets edges and corners of the mesh.
        TEST(ClosedMesh, CountsEdgesAndCornersOnce)
        {
            const auto mesh = makeMeshGeometry(boxMesh({2., 2., 2.}));
            const ClosedMesh box(*mesh, "box");
            EXPECT_TRUE(box.contains({0., 0., 0.}));
            EXPECT_TRUE(box.contains({0.5, -0.5, 0.3}));
            EXPECT_FALSE(box.contains({0., 0., -2.}));
            EXPECT_FALSE(box.contains({1., 1., -2.}) && !box.contains({1., 1., 0.}));
            EXPECT_FALSE(box.contains({-1., -1., -2.}));
            EXPECT_FALSE(box.contains({0., 0., 2.}));
        }

        TEST(ClosedMesh, LeavesOutACavity)
        {
            TriangleMesh hollow = boxMesh({4., 4., 4.});
            const TriangleMesh cavity = boxMesh({2., 2., 2.});
            for (const fcl::Triangle &triangle : cavity.triangles)
            {
                hollow.triangles.emplace_back(triangle[0] + 8, triangle[1] + 8, triangle[2] + 8);
            }
            hollow.vertices.insert(hollow.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
            const auto mesh = makeMeshGeometry(hollow);
            const ClosedMesh solid(*mesh, "hollow box");
            EXPECT_FALSE(solid.contains({0.1, 0.2, 0.3}));
            EXPECT_TRUE(solid.contains({1.5, 0.2, 0.3}));
            EXPECT_FALSE(solid.contains({2.5, 0.2, 0.3}));
            EXPECT_EQ(ClosedMesh::partVertices(*mesh).size(), 2U);
        }

        TEST(ClosedMesh, RefusesASurfaceWithARim)
        {
            TriangleMesh open = boxMesh({1., 1., 1.});
            open.triangles.pop_back();
            const auto mesh = makeMeshGeometry(open);
            expectInputError([&mesh] { const ClosedMesh solid(*mesh, "obstacle 'open'"); }, "obstacle 'open'",
                             "not closed", "3 edges");
        }

        // Files repeat vertices; vertices are compared by position.
        TEST(ClosedMesh, WeldsRepeatedVertices)
        {
            const TriangleMesh shared = boxMesh({1., 1., 1.});
            TriangleMesh soup;
            for (const fcl::Triangle &triangle : shared.triangles)
            {
                const std::size_t first = soup.vertices.size();
                for (int corner = 0; corner < 3; ++corner)
                {
                    soup.vertices.push_back(shared.vertices[triangle[corner]]);
                }
                soup.triangles.emplace_back(first, first + 1, first + 2);
            }
            const auto mesh = makeMeshGeometry(soup);
            EXPECT_TRUE(ClosedMesh(*mesh, "soup").contains({0.1, 0.1, 0.1}));
            EXPECT_EQ(ClosedMesh::partVertices(*mesh).size(), 1U);
        }
    }  // namespace
}  // namespace ompl_mfa::collision
