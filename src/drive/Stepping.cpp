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

#include "drive/Stepping.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "ompl_mfa/maps/MapMotionValidator.h"

namespace ompl_mfa::drive
{
    namespace
    {
        namespace ob = ompl::base;

        ob::SpaceInformationPtr onGrid(const ob::StateSpacePtr &space, std::shared_ptr<const maps::ObstacleGrid> grid,
                                       const maps::Footprint &footprint)
        {
            auto si = std::make_shared<ob::SpaceInformation>(space);
            maps::setMapChecking(si, std::move(grid), footprint);
            si->setup();
            return si;
        }

        /* By the distance of \e space per length that a point of a turning robot moves, at least. */
        double distancePerMovement(const ob::SE2StateSpace &space, bool isCurved, double reach, double turningRadius)
        {
            return isCurved ? 1.0 / (1.0 + reach / turningRadius)
                            : 1.0 / std::max(1.0, reach / space.getSubspaceWeight(1));
        }
    }  // namespace

    Pose poseOf(const ob::SpaceInformation &si, const ob::State *state)
    {
        if (dynamic_cast<const ob::SE2StateSpace *>(si.getStateSpace().get()) != nullptr)
        {
            const auto *pose = state->as<ob::SE2StateSpace::StateType>();
            return {{pose->getX(), pose->getY()}, pose->getYaw()};
        }
        const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
        return {{values[0], values[1]}, 0.0};
    }

    Stepping::Stepping(const ob::SpaceInformationPtr &si, const KnownWorld &world, const maps::Footprint &footprint,
                       double turningRadius)
      : si_(si)
      , true_(onGrid(si->getStateSpace(), world.trueGrid(), footprint))
      , isCurved_(dynamic_cast<const ob::DubinsStateSpace *>(si->getStateSpace().get()) != nullptr ||
                  dynamic_cast<const ob::ReedsSheppStateSpace *>(si->getStateSpace().get()) != nullptr)
      , turns_(dynamic_cast<const ob::SE2StateSpace *>(si->getStateSpace().get()) != nullptr)
      , longStep_(0.25 * world.truth().map().frame().resolution)
      , shortStep_(longStep_)
    {
        if (turns_)
        {
            shortStep_ = 0.05 * world.truth().map().frame().resolution *
                         distancePerMovement(*si->getStateSpace()->as<ob::SE2StateSpace>(), isCurved_,
                                             footprint.reach() + footprint.margin(), turningRadius);
        }
    }

    bool Stepping::isBeginningValid(const Route &route) const
    {
        ob::ScopedState<> from(si_);
        ob::ScopedState<> to(si_);
        const double end = route.endOfMotion();
        route.stateAt(route.driven(), from.get());
        route.stateAt(end, to.get());
        if (si_->checkMotion(from.get(), to.get()))
        {
            return true;
        }
        if (!turns_)
        {
            return false;
        }
        // a part of a valid motion is another motion for the check, and by rounding also for OMPL's curves
        for (double distance = route.driven(); distance < end;)
        {
            distance = std::min(distance + shortStep_, end);
            route.stateAt(distance, to.get());
            if (!isKnownFree(to.get()))
            {
                return false;
            }
        }
        return true;
    }

    bool Stepping::isRestValid(const Route &route) const
    {
        const ompl::geometric::PathGeometric rest = route.rest();
        for (std::size_t i = 2; i < rest.getStateCount(); ++i)
        {
            const auto last = static_cast<unsigned int>(i);
            if (!si_->checkMotion(rest.getState(last - 1), rest.getState(last)))
            {
                return false;
            }
        }
        return isBeginningValid(route);
    }
}  // namespace ompl_mfa::drive
