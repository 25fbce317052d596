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

#ifndef OMPL_MFA_COLLISION_FCL_MOTION_VALIDATOR_
#define OMPL_MFA_COLLISION_FCL_MOTION_VALIDATOR_

#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/FclStateValidityChecker.h"

namespace ompl_mfa::collision
{
    /** \brief How motions between two states are checked. */
    enum class MotionValidation
    {
        /** \brief OMPL's DiscreteMotionValidator: checks states at the resolution of the space. */
        Discrete,

        /** \brief FclMotionValidator: checks the whole motion. */
        Continuous
    };

    /** \brief Continuous motion validation by conservative advancement.

        At a distance d from the obstacles, no point of the body can reach one before it has travelled d; its travel is
        bounded by the translation plus the rotation times the radius of the body about its reference point. The motion
        is repeatedly advanced by this bound, so that even arbitrarily thin obstacles are found. A motion that comes
        closer than clearanceTolerance() to an obstacle counts as a collision.

        Source: B. Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, PhD thesis, UC Berkeley, 1996. */
    class OMPL_MFA_EXPORT FclMotionValidator : public ompl::base::MotionValidator
    {
    public:
        /** \throw InputError if the space does not interpolate along straight lines (Dubins, Reeds-Shepp). */
        FclMotionValidator(const ompl::base::SpaceInformationPtr &si,
                           std::shared_ptr<const FclStateValidityChecker> checker);

        /** \brief Whether the whole motion is valid; `s1` is assumed to be valid. */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief As above. If the motion is invalid, `lastValid` is set to the last state found valid (unless its
            pointer is null) and the fraction of the motion up to it, in [0, 1). */
        bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                         std::pair<ompl::base::State *, double> &lastValid) const override;

        /** \brief Distance in world units below which a body counts as touching: 1e-7 of the diagonal of the scene. */
        double clearanceTolerance() const
        {
            return clearanceTolerance_;
        }

    private:
        double advance(const ompl::base::State *s1, const ompl::base::State *s2, bool untilFirst) const;

        /** \brief Fraction of the motion, at most `reached`, that stays within the bounds of the space. */
        double shareWithinBounds(const ompl::base::State *s1, const ompl::base::State *s2, double reached) const;

        std::shared_ptr<const FclStateValidityChecker> checker_;
        double clearanceTolerance_;
    };

    /** \brief Set the validity checker and the motion validator of `si`.
        \throw InputError as the constructor of FclMotionValidator does. */
    OMPL_MFA_EXPORT void setCollisionChecking(const ompl::base::SpaceInformationPtr &si,
                                              const std::shared_ptr<FclStateValidityChecker> &checker,
                                              MotionValidation validation);
}  // namespace ompl_mfa::collision

#endif
