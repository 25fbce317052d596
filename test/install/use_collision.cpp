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

#include <memory>

#include <fcl/geometry/shape/sphere.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl_mfa/collision/FclStateValidityChecker.h>

namespace ob = ompl::base;
namespace oc = ompl_mfa::collision;

/* A disc of radius 0.1 beside a ball of radius 0.5 about the origin. */
int main()
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(-1.0, 1.0);
    const auto si = std::make_shared<ob::SpaceInformation>(space);
    oc::Scene scene;
    scene.add({"ball", std::make_shared<fcl::Sphered>(0.5), fcl::Transform3d::Identity()});
    si->setStateValidityChecker(std::make_shared<oc::FclStateValidityChecker>(
        si, std::make_shared<const oc::Scene>(scene), oc::RigidBody::sphere(0.1)));
    si->setup();
    ob::ScopedState<> apart(space);
    apart = std::vector<double>{0.7, 0.0};
    ob::ScopedState<> inside(space);
    inside = std::vector<double>{0.55, 0.0};
    return si->isValid(apart.get()) && !si->isValid(inside.get()) ? 0 : 1;
}
