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

#include "ompl_mfa/maps/MapStateValidityChecker.h"

#include <utility>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "maps/GridRobot.h"
#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;

namespace ompl_mfa::maps
{
    MapStateValidityChecker::MapStateValidityChecker(const ob::SpaceInformationPtr &si,
                                                     std::shared_ptr<const ObstacleGrid> grid,
                                                     const Footprint &footprint)
      : ob::StateValidityChecker(si)
      , robot_(std::make_shared<GridRobot>(std::move(grid), footprint))
      , turns_(dynamic_cast<const ob::SE2StateSpace *>(si->getStateSpace().get()) != nullptr)
    {
        const auto *positions = dynamic_cast<const ob::RealVectorStateSpace *>(si->getStateSpace().get());
        if (!turns_ && (positions == nullptr || positions->getDimension() != 2))
        {
            throw InputError("a robot on a map moves in R^2, SE(2), a Dubins or a Reeds-Shepp space, not in '" +
                             si->getStateSpace()->getName() + "'");
        }
        specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::BOUNDED_APPROXIMATE;
    }

    GridPose MapStateValidityChecker::pose(const ob::State *state) const
    {
        const GridMap &map = robot_->grid().map();
        if (turns_)
        {
            const auto *pose = state->as<ob::SE2StateSpace::StateType>();
            return {map.toGrid({pose->getX(), pose->getY()}), pose->getYaw() - map.frame().yaw};
        }
        const double *position = state->as<ob::RealVectorStateSpace::StateType>()->values;
        return {map.toGrid({position[0], position[1]}), -map.frame().yaw};
    }

    bool MapStateValidityChecker::isValid(const ob::State *state) const
    {
        return si_->satisfiesBounds(state) && robot_->isFree(pose(state));
    }

    double MapStateValidityChecker::clearance(const ob::State *state) const
    {
        return grid().map().frame().resolution * robot_->clearance(pose(state));
    }

    double MapStateValidityChecker::pointClearance(const ob::State *state) const
    {
        return grid().map().frame().resolution * grid().distance(pose(state).position);
    }

    const Footprint &MapStateValidityChecker::footprint() const
    {
        return robot_->footprint();
    }

    const ObstacleGrid &MapStateValidityChecker::grid() const
    {
        return robot_->grid();
    }
}  // namespace ompl_mfa::maps
