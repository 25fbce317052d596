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

#ifndef OMPL_MFA_ROBOTS_ROBOT_VALIDITY_CHECKER_
#define OMPL_MFA_ROBOTS_ROBOT_VALIDITY_CHECKER_

#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/robots/JointSpace.h"
#include "ompl_mfa/robots/RobotCollision.h"

namespace ompl_mfa::robots
{
    /** \brief A state is valid if the joints are within their limits and no checked pair touches.

        Const functions are safe to call from several threads and allocate nothing after a thread's first call. */
    class OMPL_MFA_EXPORT RobotValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \param si of the space of `joints`.
            \throw std::invalid_argument if `collision` is null or has another number of joints. */
        RobotValidityChecker(const ompl::base::SpaceInformationPtr &si, JointSpace joints,
                             std::shared_ptr<const RobotCollision> collision);

        bool isValid(const ompl::base::State *state) const override;

        /** \brief RobotCollision::distance(), metres; joint limits are ignored. */
        double clearance(const ompl::base::State *state) const override;

        const JointSpace &joints() const
        {
            return joints_;
        }

        const RobotCollision &collision() const
        {
            return *collision_;
        }

    private:
        JointSpace joints_;
        std::shared_ptr<const RobotCollision> collision_;
    };

    /** \brief Validation of motions at the states at which OMPL's DiscreteMotionValidator checks them, several at a
       time, which is faster for robots of balls (RobotCollision::isOfBalls()). The answers are the same.

        The states on a motion are not checked by way of SpaceInformation::isValid(). */
    class OMPL_MFA_EXPORT RobotDiscreteValidator : public ompl::base::MotionValidator
    {
    public:
        RobotDiscreteValidator(const ompl::base::SpaceInformationPtr &si,
                               std::shared_ptr<const RobotValidityChecker> checker);

        /** \brief Whether the states are valid; `s1` is assumed to be valid. */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief As above. If the motion is invalid, `lastValid` is set to the last state before the first invalid one
            (unless its pointer is null) and the fraction of the motion up to it, in [0, 1). */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

    private:
        std::shared_ptr<const RobotValidityChecker> checker_;
    };

    /** \brief Continuous validation of motions by conservative advancement: at a distance d between two links, or a
       link and an obstacle, they cannot touch before the joints between them have moved by d at the ends of their
       levers. Even arbitrarily thin obstacles are found. A motion that comes closer than clearanceTolerance() counts as
       a collision. */
    class OMPL_MFA_EXPORT RobotMotionValidator : public ompl::base::MotionValidator
    {
    public:
        RobotMotionValidator(const ompl::base::SpaceInformationPtr &si,
                             std::shared_ptr<const RobotValidityChecker> checker);

        /** \brief Whether the whole motion is valid; `s1` is assumed to be valid. */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief As above. If the motion is invalid, `lastValid` is set to the last state found valid (unless its
           pointer is null) and the fraction of the motion up to it, in [0, 1). */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

        /** \brief Metres: 1e-7 of the size of robot and scene. */
        double clearanceTolerance() const
        {
            return clearanceTolerance_;
        }

    private:
        double advance(const ompl::base::State *s1, const ompl::base::State *s2, bool untilFirst) const;

        std::shared_ptr<const RobotValidityChecker> checker_;
        double clearanceTolerance_;
    };
}  // namespace ompl_mfa::robots

#endif
