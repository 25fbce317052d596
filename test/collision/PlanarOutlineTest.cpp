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

#include "ompl_mfa/collision/PlanarOutline.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include "ompl_mfa/collision/OccupancyMap.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        CollisionObject primitive(const char *kind, const std::vector<double> &dimensions,
                                  const fcl::Vector3d &position,
                                  const Eigen::AngleAxisd &rotation = Eigen::AngleAxisd::Identity())
        {
            CollisionObject object{kind, makePrimitive(*findPrimitiveKind(kind), dimensions)};
            object.pose = Eigen::Translation3d(position) * rotation;
            return object;
        }

        double area(const Polygon &polygon)
        {
            double twice = 0.;
            for (std::size_t i = 0; i < polygon.size(); ++i)
            {
                const Eigen::Vector2d &a = polygon[i];
                const Eigen::Vector2d &b = polygon[(i + 1) % polygon.size()];
                twice += a.x() * b.y() - a.y() * b.x();
            }
            return 0.5 * twice;
        }

        TEST(PlanarOutline, OfABoxIsItsRotatedRectangle)
        {
            const Eigen::AngleAxisd turn(0.3, Eigen::Vector3d::UnitZ());
            const auto outline = planarOutline(primitive("box", {4., 2., 1.}, {5., 6., 0.2}, turn));
            ASSERT_EQ(outline.size(), 1U);
            ASSERT_EQ(outline[0].size(), 4U);
            EXPECT_NEAR(area(outline[0]), 8., 1e-12);
            const Eigen::Rotation2Dd back(-0.3);
            for (const Eigen::Vector2d &corner : outline[0])
            {
                const Eigen::Vector2d local = back * (corner - Eigen::Vector2d(5., 6.));
                EXPECT_NEAR(std::abs(local.x()), 2., 1e-12);
                EXPECT_NEAR(std::abs(local.y()), 1., 1e-12);
            }
        }

        TEST(PlanarOutline, OfRoundShapesIsOnTheCircle)
        {
            struct Case
            {
                CollisionObject object;
                double radius;
            };
            const std::vector<Case> cases{
                {primitive("cylinder", {1., 1.5}, {5., 5., 0.}), 1.5},
                // A ball whose centre is 0.6 above the plane, and a cone at half of its height.
                {primitive("sphere", {1.}, {5., 5., 0.6}), 0.8},
                {primitive("cone", {2., 1.}, {5., 5., 0.}), 0.5},
            };
            for (const Case &round : cases)
            {
                const auto outline = planarOutline(round.object);
                ASSERT_EQ(outline.size(), 1U) << round.object.id;
                EXPECT_GE(outline[0].size(), 90U);
                for (const Eigen::Vector2d &corner : outline[0])
                {
                    EXPECT_NEAR((corner - Eigen::Vector2d(5., 5.)).norm(), round.radius, 1e-9) << round.object.id;
                }
                EXPECT_NEAR(area(outline[0]), M_PI * round.radius * round.radius, 0.003 * round.radius * round.radius);
            }
        }

        TEST(PlanarOutline, IsEmptyOutsideTheSlab)
        {
            EXPECT_TRUE(planarOutline(primitive("box", {1., 1., 1.}, {0., 0., 2.})).empty());
            EXPECT_TRUE(planarOutline(primitive("sphere", {1.}, {0., 0., 2.})).empty());
            EXPECT_EQ(planarOutline(primitive("box", {1., 1., 1.}, {0., 0., 2.}), 0., 3.).size(), 1U);
            EXPECT_THROW(planarOutline(primitive("box", {1., 1., 1.}, {0., 0., 2.}), 1., 0.), std::invalid_argument);
        }

        TEST(PlanarOutline, OfALyingCylinderIsARectangle)
        {
            const Eigen::AngleAxisd lie(M_PI / 2., Eigen::Vector3d::UnitY());
            const auto outline = planarOutline(primitive("cylinder", {4., 0.5}, {0., 0., 0.}, lie));
            ASSERT_EQ(outline.size(), 1U);
            EXPECT_NEAR(area(outline[0]), 4., 1e-9);
        }

        TEST(PlanarOutline, OfACubeAcrossItsDiagonalIsAHexagon)
        {
            const Eigen::AngleAxisd upright(
                Eigen::Quaterniond::FromTwoVectors(fcl::Vector3d(1., 1., 1.), fcl::Vector3d::UnitZ()));
            const auto outline = planarOutline(primitive("box", {1., 1., 1.}, {2., 3., 0.}, upright));
            ASSERT_EQ(outline.size(), 1U);
            EXPECT_EQ(outline[0].size(), 6U);
            EXPECT_NEAR(area(outline[0]), 0.75 * std::sqrt(3.), 1e-12);
        }

        TEST(PlanarOutline, HoldsWhatOnlyTouchesTheSlab)
        {
            const auto below = planarOutline(primitive("box", {4., 2., 1.}, {0., 0., -0.5}));
            const auto above = planarOutline(primitive("box", {4., 2., 1.}, {0., 0., 0.5}));
            ASSERT_EQ(below.size(), 1U);
            ASSERT_EQ(above.size(), 1U);
            EXPECT_NEAR(area(below[0]), 8., 1e-12);
            EXPECT_NEAR(area(above[0]), 8., 1e-12);
        }

        TEST(PlanarOutline, OfALyingCapsuleIsAStadium)
        {
            const Eigen::AngleAxisd lie(M_PI / 2., Eigen::Vector3d::UnitY());
            const auto outline = planarOutline(primitive("capsule", {4., 0.5}, {1., 2., 0.}, lie));
            ASSERT_EQ(outline.size(), 1U);
            EXPECT_NEAR(area(outline[0]), 4. + 0.25 * M_PI, 1e-3);
        }

        TEST(PlanarOutline, HeightsAreReachedWhereThereIsAnOutline)
        {
            const CollisionObject box = primitive("box", {1., 1., 1.}, {0., 0., 2.});
            const CollisionObject cylinder =
                primitive("cylinder", {2., 0.5}, {0., 0., 2.}, Eigen::AngleAxisd(0.7, fcl::Vector3d::UnitX()));
            TriangleMesh triangles;
            triangles.vertices = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.5}, {0., 0., 4.}, {1., 0., 4.}, {1., 1., 4.}};
            triangles.triangles = {{0, 1, 2}, {3, 4, 5}};
            const CollisionObject mesh{"mesh", makeMeshGeometry(triangles)};
            auto tree = std::make_shared<octomap::OcTree>(0.5);
            tree->updateNode(0.25, 0.25, 0.25, true);
            tree->updateNode(0.25, 0.25, 3.25, true);
            const CollisionObject map{
                "map", std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree))};
            unsigned int reached = 0;
            for (const CollisionObject *object : {&box, &cylinder, &mesh, &map})
            {
                for (int step = 0; step < 60; ++step)
                {
                    const double low = -1.05 + 0.1 * step;
                    for (const double height : {0., 0.07, 0.6})
                    {
                        const bool isReached = reachesHeights(*object, low, low + height);
                        EXPECT_EQ(isReached, !planarOutline(*object, low, low + height).empty())
                            << object->id << " from " << low << " to " << low + height;
                        reached += isReached ? 1 : 0;
                    }
                }
            }
            EXPECT_GT(reached, 100U);
        }

        TEST(PlanarOutline, OfAMeshIsOneConvexPieceATriangle)
        {
            TriangleMesh mesh;
            mesh.vertices = {{0., 0., 0.}, {2., 0., 0.}, {0., 2., 0.}, {0., 0., 4.}, {2., 0., -4.}};
            // One in the plane, one upright through it, and one far below.
            mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
            const auto outline = planarOutline({"mesh", makeMeshGeometry(mesh)});
            ASSERT_EQ(outline.size(), 2U);
            EXPECT_NEAR(area(outline[0]), 2., 1e-12);
            EXPECT_EQ(outline[1].size(), 2U);
            mesh.vertices.assign({{0., 0., -1.}, {2., 0., -1.}, {0., 2., -1.}});
            mesh.triangles = {{0, 1, 2}};
            EXPECT_TRUE(planarOutline({"mesh", makeMeshGeometry(mesh)}).empty());
        }

        TEST(PlanarOutline, OfAMapIsItsCells)
        {
            auto tree = std::make_shared<octomap::OcTree>(0.5);
            tree->updateNode(1.25, 1.25, 0.25, true);
            tree->updateNode(3.25, 1.25, 0.25, true);
            tree->updateNode(1.25, 1.25, 2.25, true);
            tree->updateNode(2.25, 1.25, 0.25, false);
            const auto map = std::make_shared<fcl::OcTree<double>>(std::shared_ptr<const octomap::OcTree>(tree));
            const auto outline = planarOutline({"map", map}, 0.1, 0.2);
            ASSERT_EQ(outline.size(), 2U);
            EXPECT_NEAR(area(outline[0]), 0.25, 1e-12);
        }
    }  // namespace
}  // namespace ompl_mfa::collision
