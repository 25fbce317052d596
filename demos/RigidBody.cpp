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

/* A bar in SE(3) that has to rotate to pass a window, with collision checking by FCL. */

#include <iostream>
#include <memory>

#include <fcl/geometry/shape/box.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/collision/FclMotionValidator.h"
#include "ompl_mfa/collision/FclStateValidityChecker.h"
#include "ompl_mfa/planner/MFA.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
namespace oc = ompl_mfa::collision;

namespace
{
    /** \brief A wall across x = 0 with a window of 1 m x 1 m in the middle. */
    oc::Scene wallWithWindow()
    {
        const auto slab = [](double y, double z, double width, double height)
        {
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            pose.translation() = fcl::Vector3d(0.0, y, z);
            return oc::CollisionObject{"slab", std::make_shared<fcl::Boxd>(0.2, width, height), pose};
        };
        oc::Scene scene;
        scene.add(slab(-1.75, 0.0, 2.5, 6.0));
        scene.add(slab(1.75, 0.0, 2.5, 6.0));
        scene.add(slab(0.0, -1.75, 1.0, 2.5));
        scene.add(slab(0.0, 1.75, 1.0, 2.5));
        return scene;
    }

    ob::ScopedState<ob::SE3StateSpace> poseAt(const ob::StateSpacePtr &space, double x)
    {
        ob::ScopedState<ob::SE3StateSpace> pose(space);
        pose->setXYZ(x, 0.0, 0.0);
        pose->rotation().setIdentity();
        return pose;
    }
}  // namespace

int main()
{
    const auto space = std::make_shared<ob::SE3StateSpace>();
    ob::RealVectorBounds bounds(3);
    bounds.setLow(-3.0);
    bounds.setHigh(3.0);
    space->setBounds(bounds);

    og::SimpleSetup setup(space);
    const auto checker = std::make_shared<oc::FclStateValidityChecker>(
        setup.getSpaceInformation(), std::make_shared<const oc::Scene>(wallWithWindow()),
        oc::RigidBody::box(0.4, 1.2, 0.3));
    oc::setCollisionChecking(setup.getSpaceInformation(), checker, oc::MotionValidation::Continuous);
    setup.setStartAndGoalStates(poseAt(space, -2.0), poseAt(space, 2.0));
    setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation()));
    setup.setPlanner(std::make_shared<ompl_mfa::MFA>(setup.getSpaceInformation()));

    if (setup.solve(2.0) != ob::PlannerStatus::EXACT_SOLUTION)
    {
        std::cerr << "no path found\n";
        return 1;
    }
    std::cout << "length " << setup.getSolutionPath().length() << '\n';
    setup.getSolutionPath().printAsMatrix(std::cout);
    return setup.getSolutionPath().check() ? 0 : 1;
}
