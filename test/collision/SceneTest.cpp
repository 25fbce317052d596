#include "ompl_mfa/collision/Scene.h"

#include <stdexcept>

#include <fcl/geometry/shape/box.h>
#include <gtest/gtest.h>

namespace ompl_mfa::collision
{
    namespace
    {
        TEST(Scene, BoundsAreTightAroundRotatedObstacles)
        {
            Scene scene;
            EXPECT_GT(scene.bounds().min_.x(), scene.bounds().max_.x());
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() << 10., 0., 0.;
            pose.linear() = Eigen::AngleAxisd(M_PI / 2., Eigen::Vector3d::UnitZ()).toRotationMatrix();
            scene.add({"plank", std::make_shared<fcl::Boxd>(8., 1., 2.), pose});
            const fcl::AABBd box = scene.bounds();
            EXPECT_TRUE(box.min_.isApprox(fcl::Vector3d(9.5, -4., -1.), 1e-12)) << box.min_.transpose();
            EXPECT_TRUE(box.max_.isApprox(fcl::Vector3d(10.5, 4., 1.), 1e-12)) << box.max_.transpose();
            EXPECT_THROW(scene.add({"nothing", nullptr}), std::invalid_argument);
        }
    }  // namespace
}  // namespace ompl_mfa::collision
