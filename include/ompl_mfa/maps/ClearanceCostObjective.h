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

#ifndef OMPL_MFA_MAPS_CLEARANCE_COST_OBJECTIVE_
#define OMPL_MFA_MAPS_CLEARANCE_COST_OBJECTIVE_

#include <memory>

#include <ompl/base/OptimizationObjective.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/maps/MapStateValidityChecker.h"

namespace ompl_mfa::maps
{
    /** \brief The length of a path, weighted by the inflation of Nav2's costmaps.

        A state whose reference point is at the distance d from the nearest obstacle has the inflation
        I(d) = 252 exp(-costScalingFactor (d - inscribedRadius)), at most 253. The cost of a motion is its length in the
        space times the mean of 1 + penalty I(d) / 252 over states at most a cell apart. Smac, Nav2's planner, weights
        lengths so. Without penalty it is the length, and it is never less.

        Source: the inflation layer of nav2_costmap_2d. It cuts the inflation off at its inflation radius; this does
        not. */
    class OMPL_MFA_EXPORT ClearanceCostObjective : public ompl::base::OptimizationObjective
    {
    public:
        struct Settings
        {
            /** \brief 1 / world units, at least 0: how fast the inflation falls with the distance. */
            double costScalingFactor{3.0};
            /** \brief World units, at least 0. */
            double inscribedRadius{0.0};
            /** \brief At least 0: a state at the inscribed radius costs 1 plus this per length. */
            double penalty{2.0};
        };

        /** \brief Throws std::invalid_argument for a setting that is not finite or below 0. */
        ClearanceCostObjective(const ompl::base::SpaceInformationPtr &si,
                               std::shared_ptr<const MapStateValidityChecker> checker, const Settings &settings);

        /** \brief I(d), from 0 to 253, of the distance \e d in world units. */
        double inflation(double d) const;

        /** \brief Cost per length at \e state. */
        ompl::base::Cost stateCost(const ompl::base::State *state) const override;
        ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;

        /** \brief The distance in the space. */
        ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;

    private:
        std::shared_ptr<const MapStateValidityChecker> checker_;
        Settings settings_;
    };
}  // namespace ompl_mfa::maps

#endif
