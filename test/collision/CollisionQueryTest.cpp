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

#include "ompl_mfa/collision/CollisionQuery.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>

#include "collision/RandomScenes.h"
#include "collision/TestFiles.h"

namespace ompl_mfa::collision
{
    namespace
    {
        constexpr double UNLIMITED = std::numeric_limits<double>::infinity();

        std::shared_ptr<const Scene> share(Scene scene)
        {
            return std::make_shared<const Scene>(std::move(scene));
        }

        RigidBody bodyOf(std::shared_ptr<fcl::CollisionGeometryd> geometry)
        {
            return RigidBody({{std::move(geometry)}});
        }

        // Depth of the best separating axis of two boxes: positive where they are apart. S. Gottschalk et al., 1996.
        double separatingAxes(const fcl::Vector3d &sideA, const fcl::Transform3d &poseA, const fcl::Vector3d &sideB,
                              const fcl::Transform3d &poseB)
        {
            std::vector<fcl::Vector3d> axes;
            for (int i = 0; i < 3; ++i)
            {
                axes.emplace_back(poseA.linear().col(i));
                axes.emplace_back(poseB.linear().col(i));
                for (int j = 0; j < 3; ++j)
                {
                    axes.emplace_back(poseA.linear().col(i).cross(poseB.linear().col(j)));
                }
            }
            double best = -UNLIMITED;
            for (const fcl::Vector3d &axis : axes)
            {
                if (axis.norm() > 1e-9)
                {
                    const fcl::Vector3d n = axis.normalized();
                    const double reachA = 0.5 * sideA.dot((poseA.linear().transpose() * n).cwiseAbs());
                    const double reachB = 0.5 * sideB.dot((poseB.linear().transpose() * n).cwiseAbs());
                    best = std::max(best, std::abs(n.dot(poseA.translation() - poseB.translation())) - reachA - reachB);
                }
            }
            return best;
        }

        TEST(CollisionQuery, SpheresAgreeWithTheClosedForm)
        {
            Random random(1);
            Scene scene;
            std::vector<std::pair<fcl::Vector3d, double>> balls;
            for (int i = 0; i < 40; ++i)
            {
                balls.emplace_back(random.point(10.), random.uniform(0.1, 1.5));
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation() = balls.back().first;
                scene.add({"", makePrimitive(*findPrimitiveKind("sphere"), {balls.back().second}), pose});
            }
            for (const double radius : {0., 0.6})
            {
                const CollisionQuery query(share(scene), {RigidBody::sphere(radius)});
                int hits = 0;
                for (int i = 0; i < 5000; ++i)
                {
                    const fcl::Transform3d pose = random.pose(10.);
                    double expected = UNLIMITED;
                    for (const auto &[centre, size] : balls)
                    {
                        expected = std::min(expected, (pose.translation() - centre).norm() - size - radius);
                    }
                    EXPECT_EQ(query.collides(&pose), expected <= 0.);
                    EXPECT_NEAR(query.distance(&pose, UNLIMITED), expected, 1e-12);
                    hits += expected <= 0. ? 1 : 0;
                }
                EXPECT_GT(hits, 50);
            }
        }

        TEST(CollisionQuery, BoxesAgreeWithSeparatingAxes)
        {
            Random random(2);
            Scene scene;
            std::vector<std::pair<fcl::Vector3d, fcl::Transform3d>> boxes;
            for (int i = 0; i < 40; ++i)
            {
                boxes.emplace_back(fcl::Vector3d(random.uniform(0.1, 3.), random.uniform(0.1, 3.), 1.),
                                   random.pose(8.));
                scene.add({"", std::make_shared<fcl::Boxd>(boxes.back().first), boxes.back().second});
            }
            const fcl::Vector3d side(0.5, 1., 2.);
            const CollisionQuery query(share(scene), {RigidBody::box(side[0], side[1], side[2])});
            int hits = 0;
            for (int i = 0; i < 20000; ++i)
            {
                const fcl::Transform3d pose = random.pose(8.);
                double expected = UNLIMITED;
                for (const auto &[size, place] : boxes)
                {
                    expected = std::min(expected, separatingAxes(size, place, side, pose));
                }
                EXPECT_EQ(query.collides(&pose), expected <= 0.) << expected;
                hits += expected <= 0. ? 1 : 0;
            }
            EXPECT_GT(hits, 1000);
        }

        // The depth of a ball is the distance from its centre to the outside plus its radius.
        TEST(CollisionQuery, DepthOfABallIsThatOfItsCentre)
        {
            Random random(6);
            const fcl::Vector3d side(2., 3., 4.);
            const fcl::Transform3d place = random.pose(1.);
            Scene boxes;
            boxes.add({"", std::make_shared<fcl::Boxd>(side), place});
            Scene cylinders;
            cylinders.add({"", std::make_shared<fcl::Cylinderd>(1., 4.), place});
            Scene cones;
            cones.add({"", std::make_shared<fcl::Coned>(1., 4.), place});
            const double radius = 0.25;
            const CollisionQuery inBox(share(boxes), {RigidBody::sphere(radius)});
            const CollisionQuery inCylinder(share(cylinders), {RigidBody::sphere(radius)});
            const CollisionQuery inCone(share(cones), {RigidBody::sphere(radius)});
            Scene capsules;
            capsules.add({"", std::make_shared<fcl::Capsuled>(1., 4.), place});
            const CollisionQuery inCapsule(share(capsules), {RigidBody::sphere(radius)});
            for (int i = 0; i < 1000; ++i)
            {
                const fcl::Vector3d centre = random.point(1.);
                const fcl::Transform3d pose = place * Eigen::Translation3d(centre);
                const double inside = (0.5 * side - centre.cwiseAbs()).minCoeff();
                EXPECT_NEAR(inBox.distance(&pose, UNLIMITED), -inside - radius, 1e-12);
                const double radial = centre.head<2>().norm();
                EXPECT_NEAR(inCylinder.distance(&pose, UNLIMITED),
                            radial - radius - std::min(1., radial + 2. - std::abs(centre.z())), 1e-12);
                EXPECT_GE(inCone.distance(&pose, UNLIMITED), 0.);
                EXPECT_NEAR(inCapsule.distance(&pose, UNLIMITED), radial - radius - 1., 1e-12);
            }
        }

        double triangleDistance(const MeshGeometry &a, const fcl::Transform3d &poseA, const MeshGeometry &b,
                                const fcl::Transform3d &poseB)
        {
            double smallest = UNLIMITED;
            for (int i = 0; i < a.num_tris; ++i)
            {
                for (int j = 0; j < b.num_tris; ++j)
                {
                    std::array<fcl::Vector3d, 3> s;
                    std::array<fcl::Vector3d, 3> t;
                    for (int corner = 0; corner < 3; ++corner)
                    {
                        s[corner] = poseA * a.vertices[a.tri_indices[i][corner]];
                        t[corner] = poseB * b.vertices[b.tri_indices[j][corner]];
                    }
                    fcl::Vector3d p;
                    fcl::Vector3d q;
                    smallest = std::min(smallest,
                                        fcl::detail::TriangleDistance<double>::triDistance(s.data(), t.data(), p, q));
                }
            }
            return smallest;
        }

        // Meshes, maps and primitives of the same boxes give the same answers by different algorithms of FCL.
        TEST(CollisionQuery, EveryKindOfABoxGivesTheSameAnswers)
        {
            Random random(4);
            std::vector<Eigen::Vector3i> cells;
            Scene boxes;
            Scene meshes;
            for (int i = 0; i < 25; ++i)
            {
                const Eigen::Vector3i cell = random.point(8.).cast<int>();
                cells.push_back(cell);
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation() = 0.5 * (cell.cast<double>() + fcl::Vector3d::Constant(0.5));
                boxes.add({"", std::make_shared<fcl::Boxd>(0.5, 0.5, 0.5), pose});
                meshes.add({"", makeMeshGeometry(boxMesh({0.5, 0.5, 0.5})), pose});
            }
            Scene map;
            map.add({"", occupancyMap(cells, 0.5)});
            const auto boxScene = share(boxes);
            const auto meshScene = share(meshes);
            const auto mapScene = share(map);

            // A mesh larger than every obstacle cannot be inside of one.
            const std::vector<std::shared_ptr<fcl::CollisionGeometryd>> robots{
                std::make_shared<fcl::Boxd>(1., 1.5, 0.7), std::make_shared<fcl::Sphered>(0.6),
                std::make_shared<fcl::Cylinderd>(0.6, 1.), std::make_shared<fcl::Coned>(0.6, 1.2),
                makeMeshGeometry(boxMesh({1., 1.5, 0.7}))};
            for (const auto &robot : robots)
            {
                const CollisionQuery amongBoxes(boxScene, {bodyOf(robot)});
                const CollisionQuery amongMeshes(meshScene, {bodyOf(robot)});
                const CollisionQuery inMap(mapScene, {bodyOf(robot)});
                const bool isMesh = robot->getNodeType() == fcl::BV_OBBRSS;
                int hits = 0;
                for (int i = 0; i < 300; ++i)
                {
                    const fcl::Transform3d pose = random.pose(4.);
                    const bool collides = amongBoxes.collides(&pose);
                    const double distance = amongBoxes.distance(&pose, UNLIMITED);
                    EXPECT_EQ(collides, distance <= 0.);
                    EXPECT_EQ(inMap.collides(&pose), collides);
                    EXPECT_NEAR(inMap.distance(&pose, UNLIMITED), std::max(0., distance), 1e-9);
                    hits += collides ? 1 : 0;
                    if (!collides)
                    {
                        // A mesh inside of a box collides with the solid box, but not with its surface.
                        EXPECT_FALSE(amongMeshes.collides(&pose));
                        EXPECT_NEAR(amongMeshes.distance(&pose, UNLIMITED), distance, 1e-9);
                    }
                    else if (!isMesh)
                    {
                        EXPECT_TRUE(amongMeshes.collides(&pose));
                        EXPECT_EQ(amongMeshes.distance(&pose, UNLIMITED), 0.);
                    }
                }
                EXPECT_GT(hits, 5);
            }
        }

        TEST(CollisionQuery, MeshDistanceIsThatOfTheClosestTriangles)
        {
            Random random(5);
            const auto mesh = makeMeshGeometry(boxMesh({1., 2., 3.}));
            const auto robot = makeMeshGeometry(boxMesh({0.5, 0.5, 2.}));
            for (int i = 0; i < 200; ++i)
            {
                Scene scene;
                scene.add({"", mesh, random.pose(3.)});
                const CollisionQuery query(share(scene), {bodyOf(robot)});
                const fcl::Transform3d pose = random.pose(3.);
                const double expected = triangleDistance(*mesh, scene.objects()[0].pose, *robot, pose);
                EXPECT_EQ(query.collides(&pose), expected <= 0.);
                EXPECT_NEAR(query.distance(&pose, UNLIMITED), expected, 1e-9);
                EXPECT_NEAR(query.distance(&pose, 0.5), std::min(0.5, expected), 1e-9);
            }
        }

        // Every kind of shape, all lengths scaled: a scene for each shape, and a pose.
        std::vector<std::shared_ptr<fcl::CollisionGeometryd>> everyShape(double scale)
        {
            std::vector<std::shared_ptr<fcl::CollisionGeometryd>> shapes{
                makeMeshGeometry(boxMesh(scale * fcl::Vector3d(1., 1.5, 0.7))),
                occupancyMap({{0, 0, 0}, {2, 1, 0}, {-1, 0, 1}}, 0.5 * scale)};
            for (const PrimitiveKind &kind : primitiveKinds())
            {
                shapes.push_back(makePrimitive(kind, std::vector<double>(kind.dimensions.size(), scale)));
            }
            return shapes;
        }

        // Micrometres and megametres give the same answers as metres.
        TEST(CollisionQuery, AnswersScaleWithTheWorld)
        {
            const auto unscaled = everyShape(1.);
            for (const double scale : {1e-6, 1e6})
            {
                const auto scaled = everyShape(scale);
                for (std::size_t i = 0; i < scaled.size(); ++i)
                {
                    for (std::size_t j = 0; j < scaled.size(); ++j)
                    {
                        Scene scene;
                        scene.add({"", unscaled[i]});
                        Scene scaledScene;
                        scaledScene.add({"", scaled[i]});
                        const CollisionQuery query(share(scene), {bodyOf(unscaled[j])});
                        const CollisionQuery scaledQuery(share(scaledScene), {bodyOf(scaled[j])});
                        Random random(9);
                        for (int k = 0; k < 50; ++k)
                        {
                            fcl::Transform3d pose = random.pose(1.5);
                            const bool collides = query.collides(&pose);
                            const double distance = query.distance(&pose, UNLIMITED);
                            pose.translation() *= scale;
                            EXPECT_EQ(scaledQuery.collides(&pose), collides) << scale << ' ' << i << ' ' << j;
                            EXPECT_NEAR(scaledQuery.distance(&pose, UNLIMITED), scale * distance, 1e-7 * scale)
                                << scale << ' ' << i << ' ' << j;
                        }
                    }
                }
            }
        }

        // Mesh files contain triangles without area.
        TEST(CollisionQuery, TrianglesWithoutAreaAreSegmentsAndPoints)
        {
            TriangleMesh degenerate;
            degenerate.vertices = {{-1., 0., 0.}, {1., 0., 0.}, {0., 0., 0.}, {0., 0., 3.}};
            degenerate.triangles = {{0, 1, 2}, {0, 0, 1}, {3, 3, 3}};
            Scene scene;
            scene.add({"", makeMeshGeometry(degenerate)});
            const double radius = 0.25;
            const CollisionQuery ball(share(scene), {RigidBody::sphere(radius)});
            const CollisionQuery box(share(scene), {RigidBody::box(1., 1., 1.)});
            const CollisionQuery mesh(share(scene), {bodyOf(makeMeshGeometry(boxMesh({1., 1., 1.})))});
            Random random(10);
            int hits = 0;
            for (int i = 0; i < 2000; ++i)
            {
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation() = random.point(2.);
                const fcl::Vector3d &p = pose.translation();
                const double toSegment = (p - fcl::Vector3d(std::clamp(p.x(), -1., 1.), 0., 0.)).norm();
                const double toPoint = (p - fcl::Vector3d(0., 0., 3.)).norm();
                const double expected = std::min(toSegment, toPoint) - radius;
                EXPECT_EQ(ball.collides(&pose), expected <= 0.);
                EXPECT_NEAR(ball.distance(&pose, UNLIMITED), std::max(0., expected), 1e-9);
                hits += expected <= 0. ? 1 : 0;
                // Distance of the segment and of the point to an axis-aligned box.
                const double aside = std::max(0., std::abs(p.x()) - 1.5);
                const double across =
                    std::hypot(std::max(0., std::abs(p.y()) - 0.5), std::max(0., std::abs(p.z()) - 0.5));
                const fcl::Vector3d q = (p - fcl::Vector3d(0., 0., 3.)).cwiseAbs() - fcl::Vector3d::Constant(0.5);
                const double toBox = std::min(std::hypot(aside, across), q.cwiseMax(0.).norm());
                EXPECT_EQ(box.collides(&pose), toBox <= 0.);
                EXPECT_NEAR(box.distance(&pose, UNLIMITED), toBox, 1e-9);
                if (toBox > 0.)
                {
                    EXPECT_FALSE(mesh.collides(&pose));
                    EXPECT_NEAR(mesh.distance(&pose, UNLIMITED), toBox, 1e-9);
                }
            }
            EXPECT_GT(hits, 10);
        }

        TEST(CollisionQuery, ChecksEveryShapeOfABody)
        {
            fcl::Transform3d arm = fcl::Transform3d::Identity();
            arm.translation().x() = 5.;
            const RigidBody body({{std::make_shared<fcl::Sphered>(0.5)}, {std::make_shared<fcl::Sphered>(0.5), arm}});
            Scene scene;
            fcl::Transform3d post = fcl::Transform3d::Identity();
            post.translation().y() = 5.;
            scene.add({"post", std::make_shared<fcl::Sphered>(1.), post});
            const CollisionQuery query(share(scene), {body});
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            EXPECT_FALSE(query.collides(&pose));
            pose.linear() = Eigen::AngleAxisd(M_PI / 2., Eigen::Vector3d::UnitZ()).toRotationMatrix();
            EXPECT_TRUE(query.collides(&pose));
        }

        TEST(CollisionQuery, ChecksBodiesAgainstEachOther)
        {
            const CollisionQuery query(share(Scene()), {RigidBody::sphere(1.), RigidBody::sphere(2.)});
            std::vector<fcl::Transform3d> poses(2, fcl::Transform3d::Identity());
            poses[1].translation().x() = 3.5;
            EXPECT_FALSE(query.collides(poses.data()));
            EXPECT_NEAR(query.distance(poses.data(), UNLIMITED), 0.5, 1e-12);
            poses[1].translation().x() = 2.5;
            EXPECT_TRUE(query.collides(poses.data()));
            EXPECT_NEAR(query.distance(poses.data(), UNLIMITED), -0.5, 1e-12);
        }

        TEST(CollisionQuery, NothingToHitIsInfinitelyFar)
        {
            const CollisionQuery query(share(Scene()), {RigidBody::sphere(1.)});
            const fcl::Transform3d pose = fcl::Transform3d::Identity();
            EXPECT_FALSE(query.collides(&pose));
            EXPECT_EQ(query.distance(&pose, UNLIMITED), UNLIMITED);
            const BodyMotion motion;
            EXPECT_EQ(query.advance(&motion, 1e-6, true), 1.);
            EXPECT_THROW(CollisionQuery(nullptr, {RigidBody::sphere(1.)}), std::invalid_argument);
            EXPECT_THROW(CollisionQuery(share(Scene()), {}), std::invalid_argument);
        }

        TEST(CollisionQuery, SolidMeshesHoldWhatIsWhollyInside)
        {
            Scene scene;
            scene.add({"room", makeMeshGeometry(boxMesh({10., 10., 10.}))});
            const auto room = share(scene);
            const std::vector<std::shared_ptr<fcl::CollisionGeometryd>> robots{std::make_shared<fcl::Boxd>(1., 1., 1.),
                                                                               std::make_shared<fcl::Sphered>(0.),
                                                                               makeMeshGeometry(boxMesh({1., 1., 1.}))};
            for (const auto &robot : robots)
            {
                const CollisionQuery surfaces(room, {bodyOf(robot)});
                const CollisionQuery solids(room, {bodyOf(robot)}, MeshInterior::Solid);
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                EXPECT_FALSE(surfaces.collides(&pose));
                EXPECT_NEAR(surfaces.distance(&pose, UNLIMITED), 5. - 0.5 * (robot->aabb_radius > 0. ? 1. : 0.), 1e-9);
                EXPECT_TRUE(solids.collides(&pose));
                EXPECT_EQ(solids.distance(&pose, UNLIMITED), 0.);
                pose.translation().x() = 8.;
                EXPECT_FALSE(solids.collides(&pose));
                EXPECT_GT(solids.distance(&pose, UNLIMITED), 2.);
            }
        }

        TEST(CollisionQuery, SolidRobotsHoldObstaclesAndEachOther)
        {
            Scene scene;
            scene.add({"pebble", std::make_shared<fcl::Sphered>(0.1)});
            const auto shell = makeMeshGeometry(boxMesh({4., 4., 4.}));
            const fcl::Transform3d pose = fcl::Transform3d::Identity();
            EXPECT_FALSE(CollisionQuery(share(scene), {bodyOf(shell)}).collides(&pose));
            EXPECT_TRUE(CollisionQuery(share(scene), {bodyOf(shell)}, MeshInterior::Solid).collides(&pose));
            const std::vector<fcl::Transform3d> poses(2, fcl::Transform3d::Identity());
            const std::vector<RigidBody> bodies{bodyOf(shell), RigidBody::sphere(0.5)};
            EXPECT_FALSE(CollisionQuery(share(Scene()), bodies).collides(poses.data()));
            EXPECT_TRUE(CollisionQuery(share(Scene()), bodies, MeshInterior::Solid).collides(poses.data()));

            // Each cell of a map is closed on its own.
            Scene cells;
            cells.add({"cells", occupancyMap({{0, 0, 0}, {40, 0, 0}}, 0.1)});
            EXPECT_FALSE(CollisionQuery(share(cells), {bodyOf(shell)}).collides(&pose));
            EXPECT_TRUE(CollisionQuery(share(cells), {bodyOf(shell)}, MeshInterior::Solid).collides(&pose));

            TriangleMesh open = boxMesh({1., 1., 1.});
            open.triangles.pop_back();
            Scene broken;
            broken.add({"open box", makeMeshGeometry(open)});
            expectInputError([&broken] { CollisionQuery(share(broken), {RigidBody::sphere(1.)}, MeshInterior::Solid); },
                             "'open box'", "not closed");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
