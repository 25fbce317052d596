#include "ompl_mfa/collision/Primitive.h"

#include <limits>
#include <stdexcept>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <gtest/gtest.h>

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
