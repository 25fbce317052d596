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
