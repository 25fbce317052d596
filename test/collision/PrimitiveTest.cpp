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

#include "ompl_mfa/collision/Primitive.h"

#include <limits>
#include <stdexcept>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <gtest/gtest.h>

#include "collision/RandomScenes.h"
#include "ompl_mfa/collision/CollisionQuery.h"
#include "ompl_mfa/collision/PlanarOutline.h"

namespace ompl_mfa::collision
{
    namespace
    {
        TEST(Primitive, IsFoundByNameAndByMoveItsNumber)
        {
            EXPECT_STREQ(findPrimitiveKind("box")->name, "box");
            EXPECT_STREQ(findPrimitiveKind("1")->name, "box");
            EXPECT_STREQ(findPrimitiveKind("2")->name, "sphere");
            EXPECT_STREQ(findPrimitiveKind("3")->name, "cylinder");
            EXPECT_STREQ(findPrimitiveKind("4")->name, "cone");
            EXPECT_EQ(findPrimitiveKind("torus"), nullptr);
            EXPECT_EQ(findPrimitiveKind(""), nullptr);
        }

        // shape_msgs/SolidPrimitive: CYLINDER_HEIGHT = 0, CYLINDER_RADIUS = 1, and so for the cone.
        TEST(Primitive, TakesDimensionsInMoveItsOrder)
        {
            const auto cylinder = makePrimitive(*findPrimitiveKind("cylinder"), {3., 0.5});
            EXPECT_EQ(static_cast<const fcl::Cylinderd &>(*cylinder).lz, 3.);
            EXPECT_EQ(static_cast<const fcl::Cylinderd &>(*cylinder).radius, 0.5);
            const auto cone = makePrimitive(*findPrimitiveKind("cone"), {3., 0.5});
            EXPECT_EQ(static_cast<const fcl::Coned &>(*cone).lz, 3.);
            EXPECT_EQ(static_cast<const fcl::Coned &>(*cone).radius, 0.5);
            const auto box = makePrimitive(*findPrimitiveKind("box"), {1., 2., 3.});
            EXPECT_EQ(static_cast<const fcl::Boxd &>(*box).side, fcl::Vector3d(1., 2., 3.));
        }

        // All kinds: each has a box, a radius and a picture, and is tested against each other kind of obstacle.
        TEST(Primitive, IsServedByEveryPartOfTheLibrary)
        {
            std::vector<CollisionObject> obstacles{{"mesh", makeMeshGeometry(boxMesh({1., 1., 1.}))},
                                                   {"map", occupancyMap({{-1, -1, -1}, {0, 0, 0}}, 0.5)}};
            for (const PrimitiveKind &kind : primitiveKinds())
            {
                obstacles.push_back({kind.name, makePrimitive(kind, std::vector<double>(kind.dimensions.size(), 1.))});
            }
            for (std::size_t i = 2; i < obstacles.size(); ++i)
            {
                const CollisionObject &primitive = obstacles[i];
                const fcl::Transform3d here = fcl::Transform3d::Identity();
                const fcl::AABBd box = boundingBox(*primitive.geometry, here);
                const RigidBody robot({{primitive.geometry}});
                EXPECT_GE(robot.radius(), box.max_.maxCoeff()) << primitive.id;
                EXPECT_LE(robot.radius(), box.max_.norm() + 1e-12) << primitive.id;
                EXPECT_EQ(planarOutline(primitive).size(), 1U) << primitive.id;
                for (const CollisionObject &obstacle : obstacles)
                {
                    Scene scene;
                    scene.add(obstacle);
                    const CollisionQuery query(std::make_shared<Scene>(scene), {robot});
                    EXPECT_TRUE(query.collides(&here)) << primitive.id << ", " << obstacle.id;
                    fcl::Transform3d away = here;
                    away.translation().x() = 5.;
                    EXPECT_FALSE(query.collides(&away)) << primitive.id << ", " << obstacle.id;
                    const double distance = query.distance(&away, 10.);
                    const double between = 5. - box.max_.x() - boundingBox(*obstacle.geometry, here).max_.x();
                    EXPECT_GE(distance, between - 1e-9) << primitive.id << ", " << obstacle.id;
                    EXPECT_LE(distance, between + 0.25) << primitive.id << ", " << obstacle.id;
                }
            }
        }

        TEST(Primitive, RefusesWrongDimensions)
        {
            const PrimitiveKind &box = *findPrimitiveKind("box");
            EXPECT_THROW(makePrimitive(box, {1., 2.}), std::invalid_argument);
            EXPECT_THROW(makePrimitive(box, {1., 2., 0.}), std::invalid_argument);
            EXPECT_THROW(makePrimitive(box, {1., -2., 3.}), std::invalid_argument);
            EXPECT_THROW(makePrimitive(box, {1., 2., std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
            EXPECT_THROW(makePrimitive(box, {1., 2., std::numeric_limits<double>::infinity()}), std::invalid_argument);
            const PrimitiveKind &sphere = *findPrimitiveKind("sphere");
            EXPECT_THROW(makePrimitive(sphere, {-0.1}), std::invalid_argument);
            EXPECT_NO_THROW(makePrimitive(sphere, {0.}));
        }
    }  // namespace
}  // namespace ompl_mfa::collision
