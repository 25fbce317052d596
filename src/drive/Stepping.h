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

    /** \brief How a robot moves on a map, in short steps: in what it knows and in the map as it is. */
    class Stepping
    {
    public:
        /** \param si of the planner, with the checks of what \e world knows
            \param world what is known and what is true
            \param footprint the robot
            \param turningRadius of a car */
        Stepping(const ompl::base::SpaceInformationPtr &si, const KnownWorld &world, const maps::Footprint &footprint,
                 double turningRadius);

        /** \brief Lengths of a long and of a short step, by the space's distance. In a long one the robot's reference
            point moves by at most a quarter of a cell; in a short one no point of the robot moves by more than a
            twentieth. */
        double longStep() const
        {
            return longStep_;
        }

        double shortStep() const
        {
            return shortStep_;
        }

        /** \brief Whether the robot turns, so that the checks of motions are not exact. */
        bool turns() const
        {
            return turns_;
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

        /** \brief Whether the motion between two states is valid, in what is known or in truth; \e from is assumed to
            be. That of a robot that turns may be taken to be invalid if it comes close to an obstacle, and even if it
           is a part of a motion that is valid. */
        bool isKnownFree(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return si_->checkMotion(from, to);
        }

        bool isTrulyFree(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return true_->checkMotion(from, to);
        }

        /** \brief Whether a state is valid, in what is known or in truth. */
        bool isKnownFree(const ompl::base::State *state) const
        {
            return si_->isValid(state);
        }

        bool isTrulyFree(const ompl::base::State *state) const
        {
            return true_->isValid(state);
        }

        /** \brief Whether the \e route is valid from where the robot is on, in what is known. */
        bool isRestValid(const Route &route) const;

    private:
        bool isBeginningValid(const Route &route) const;

        ompl::base::SpaceInformationPtr si_;
        ompl::base::SpaceInformationPtr true_;
        bool isCurved_;
        bool turns_;
        double longStep_;
        double shortStep_{0.0};
    };
}  // namespace ompl_mfa::drive

#endif
