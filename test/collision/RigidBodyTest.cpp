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
