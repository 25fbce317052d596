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

#ifndef OMPL_MFA_MAPS_SMOOTHNESS_OBJECTIVE_
#define OMPL_MFA_MAPS_SMOOTHNESS_OBJECTIVE_

#include <ompl/base/OptimizationObjective.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::maps
{
    /** \brief The sum of squared turning, in SE(2), rad^2.

        The turning at a state lies between two motions, but a cost is a sum over motions. So a motion costs the square
        of the angle from the yaw at its beginning to its direction, plus that of the angle from its direction to the
        yaw at its end; if it is at most a millionth long, the square of the angle between the two yaws. A robot that
        turns by an angle a at a state pays a^2 / 2 if its yaw there is halfway, and more otherwise; one that drives
        sideways pays for it.

        The cost is that of the states of a path: more of them, interpolated, can cost more. */
    class OMPL_MFA_EXPORT SmoothnessObjective : public ompl::base::OptimizationObjective
    {
    public:
        /** \brief Throws InputError unless the space of \e si is SE(2); the curves of cars are smooth. */
        explicit SmoothnessObjective(const ompl::base::SpaceInformationPtr &si);

        /** \brief 0. */
        ompl::base::Cost stateCost(const ompl::base::State *state) const override;
        ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    };
}  // namespace ompl_mfa::maps

#endif
