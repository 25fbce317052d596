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

#include "ompl_mfa/maps/SmoothnessObjective.h"

#include <cmath>

#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::maps
{
    namespace
    {
        constexpr double PI = 3.14159265358979323846;
        constexpr double SHORTEST = 1e-6;

        double squaredAngle(double from, double to)
        {
            const double angle = std::remainder(to - from, 2.0 * PI);
            return angle * angle;
        }
    }  // namespace

    SmoothnessObjective::SmoothnessObjective(const ob::SpaceInformationPtr &si)
      : ob::OptimizationObjective(si)
    {
        const ob::StateSpace *space = si->getStateSpace().get();
        if (dynamic_cast<const ob::SE2StateSpace *>(space) == nullptr ||
            dynamic_cast<const ob::DubinsStateSpace *>(space) != nullptr ||
            dynamic_cast<const ob::ReedsSheppStateSpace *>(space) != nullptr)
        {
            throw InputError(
                "smoothness is measured between yaw and direction of travel, in SE(2); start and goal have "
                "x, y, theta, and there is no 'statespace'");
        }
        description_ = "Smoothness";
    }

    ob::Cost SmoothnessObjective::stateCost(const ob::State * /*state*/) const
    {
        return identityCost();
    }

    ob::Cost SmoothnessObjective::motionCost(const ob::State *s1, const ob::State *s2) const
    {
        const auto *from = s1->as<ob::SE2StateSpace::StateType>();
        const auto *to = s2->as<ob::SE2StateSpace::StateType>();
        const double x = to->getX() - from->getX();
        const double y = to->getY() - from->getY();
        if (std::hypot(x, y) <= SHORTEST)
        {
            return ob::Cost(squaredAngle(from->getYaw(), to->getYaw()));
        }
        const double direction = std::atan2(y, x);
        return ob::Cost(squaredAngle(from->getYaw(), direction) + squaredAngle(direction, to->getYaw()));
    }
}  // namespace ompl_mfa::maps
