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

#ifndef OMPL_MFA_BENCHMARK_OBJECTIVE_FACTORY_
#define OMPL_MFA_BENCHMARK_OBJECTIVE_FACTORY_

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::benchmark
{
    /** \brief The integral of 1/(1 + clearance) along the path, clearance in world units. It is finite on contact, at
        most the path's length, and smaller for paths farther from obstacles. */
    class OMPL_MFA_EXPORT ProximityIntegralObjective : public ompl::base::StateCostIntegralObjective
    {
    public:
        explicit ProximityIntegralObjective(const ompl::base::SpaceInformationPtr &si);

        ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    };

    /** \brief The objective of \e problem with its threshold; null if it has none. The validity checker of \e si is to
        be set. Throws InputError for a clearance_cost without a map and a smoothness outside of SE(2). */
    OMPL_MFA_EXPORT ompl::base::OptimizationObjectivePtr makeObjective(const ompl::base::SpaceInformationPtr &si,
                                                                       const ProblemConfig &problem);
}  // namespace ompl_mfa::benchmark

#endif
