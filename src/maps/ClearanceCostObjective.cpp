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

#include "ompl_mfa/maps/ClearanceCostObjective.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::maps
{
    namespace
    {
        /* Values of Nav2's costmaps: just outside of the inscribed radius, and within it. */
        constexpr double INSCRIBED_END = 252.0;
        constexpr double INSCRIBED = 253.0;
    }  // namespace

    ClearanceCostObjective::ClearanceCostObjective(const ob::SpaceInformationPtr &si,
                                                   std::shared_ptr<const MapStateValidityChecker> checker,
                                                   const Settings &settings)
      : ob::OptimizationObjective(si)
      , checker_(std::move(checker))
      , settings_(settings)
    {
        for (const double setting : {settings.costScalingFactor, settings.inscribedRadius, settings.penalty})
        {
            if (!(setting >= 0.0) || !std::isfinite(setting))
            {
                throw std::invalid_argument("ClearanceCostObjective: the settings are finite and at least 0");
            }
        }
        description_ = "Clearance Cost";
    }

    double ClearanceCostObjective::inflation(double d) const
    {
        return std::min(INSCRIBED,
                        INSCRIBED_END * std::exp(-settings_.costScalingFactor * (d - settings_.inscribedRadius)));
    }

    ob::Cost ClearanceCostObjective::stateCost(const ob::State *state) const
    {
        return ob::Cost(1.0 + settings_.penalty * inflation(checker_->pointClearance(state)) / INSCRIBED_END);
    }

    ob::Cost ClearanceCostObjective::motionCost(const ob::State *s1, const ob::State *s2) const
    {
        const ob::StateSpacePtr &space = si_->getStateSpace();
        const double length = space->distance(s1, s2);
        const double parts = std::max(1.0, std::ceil(length / checker_->grid().map().frame().resolution));
        ob::State *state = space->allocState();
        double sum = 0.5 * (stateCost(s1).value() + stateCost(s2).value());
        for (double part = 1.0; part < parts; part += 1.0)
        {
            space->interpolate(s1, s2, part / parts, state);
            sum += stateCost(state).value();
        }
        space->freeState(state);
        return ob::Cost(length * sum / parts);
    }

    ob::Cost ClearanceCostObjective::motionCostHeuristic(const ob::State *s1, const ob::State *s2) const
    {
        return ob::Cost(si_->distance(s1, s2));
    }
}  // namespace ompl_mfa::maps
