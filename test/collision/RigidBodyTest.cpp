#include "ompl_mfa/collision/RigidBody.h"

#include <cmath>
#include <stdexcept>

#include <fcl/geometry/shape/sphere.h>
#include <gtest/gtest.h>

#include "collision/TestFiles.h"
#include "ompl_mfa/collision/SceneLoader.h"

namespace ompl_mfa::collision
{
    namespace
    {
        TEST(RigidBody, RadiusReachesTheFarthestPoint)
        {
            EXPECT_DOUBLE_EQ(RigidBody::sphere(0.7).radius(), 0.7);
            EXPECT_EQ(RigidBody::sphere(0.).radius(), 0.);
            const RigidBody box = RigidBody::box(2., 4., 6.);
            EXPECT_DOUBLE_EQ(box.radius(), std::sqrt(14.));
            EXPECT_DOUBLE_EQ(box.planarRadius(), std::sqrt(5.));
        }

        TEST(RigidBody, RadiusCountsWhereShapesSit)
        {
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() << 3., 4., 12.;
            const RigidBody body({{std::make_shared<fcl::Sphered>(0.5)}, {std::make_shared<fcl::Sphered>(1.), pose}});
            EXPECT_DOUBLE_EQ(body.radius(), 14.);
            EXPECT_DOUBLE_EQ(body.planarRadius(), 6.);
        }

        TEST(RigidBody, RadiusOfAMeshIsThatOfItsFarthestVertex)
        {
            const TemporaryFolder folder;
            const RigidBody cube = loadRobot(folder.write("cube.obj", cubeObj()), RobotCentring::None);
            EXPECT_DOUBLE_EQ(cube.radius(), std::sqrt(0.75));
            EXPECT_DOUBLE_EQ(cube.planarRadius(), std::sqrt(0.5));
        }

        TEST(RigidBody, RefusesNothing)
        {
            EXPECT_THROW(RigidBody({}), std::invalid_argument);
            EXPECT_THROW(RigidBody({{nullptr}}), std::invalid_argument);
            EXPECT_THROW(RigidBody::sphere(-1.), std::invalid_argument);
            EXPECT_THROW(RigidBody::box(1., 0., 1.), std::invalid_argument);
        }
    }  // namespace
}  // namespace ompl_mfa::collision
