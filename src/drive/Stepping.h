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

#ifndef OMPL_MFA_DRIVE_STEPPING_
#define OMPL_MFA_DRIVE_STEPPING_

#include <ompl/base/SpaceInformation.h>

#include "drive/KnownWorld.h"
#include "drive/Route.h"
#include "ompl_mfa/maps/Footprint.h"

namespace ompl_mfa::drive
{
    /** \brief The pose of \e state in R^2, SE(2) or a space of cars; in R^2 the yaw is 0. */
    Pose poseOf(const ompl::base::SpaceInformation &si, const ompl::base::State *state);

    /** \brief How a robot moves on a map: in steps of at most step(), each of them straight, in what it knows and in
       the map as it is. A curve is followed by chords, whose distance from it is far below a cell. */
    class Stepping
    {
    public:
        /** \param si of the planner, with the checks of what \e world knows
            \param world what is known and what is true
            \param footprint the robot */
        Stepping(const ompl::base::SpaceInformationPtr &si, const KnownWorld &world, const maps::Footprint &footprint);

        /** \brief A quarter of a cell, in world units. */
        double step() const
        {
            return step_;
        }

        /** \brief Whether the planner's motions are the curves of a car. */
        bool isCurved() const
        {
            return isCurved_;
        }

        Pose pose(const ompl::base::State *state) const
        {
            return poseOf(*si_, state);
        }

        /** \brief Whether the straight motion between two states is valid in what is known; \e from is assumed to
            be. */
        bool isKnownFree(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return known_->checkMotion(from, to);
        }

        /** \brief The same on the map as it is. */
        bool isTrulyFree(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return true_->checkMotion(from, to);
        }

        /** \brief Whether the \e route is valid from where the robot is on, in what is known. */
        bool isRestValid(const Route &route) const;

    private:
        bool isBeginningValid(const Route &route) const;

        ompl::base::SpaceInformationPtr si_;
        double step_;
        bool isCurved_;
        ompl::base::SpaceInformationPtr known_;
        ompl::base::SpaceInformationPtr true_;
    };
}  // namespace ompl_mfa::drive

#endif
