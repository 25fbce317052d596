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

#ifndef OMPL_MFA_BENCHMARK_PLANNER_TABLE_
#define OMPL_MFA_BENCHMARK_PLANNER_TABLE_

#include <map>
#include <string>

#include <ompl/base/Planner.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief A row of the planner table. */
    struct PlannerEntry
    {
        /** \brief The name in logs. */
        std::string title;
        ompl::base::PlannerAllocator allocate;
        /** \brief setup() throws if the state space has no default projection. */
        bool needsProjection{false};
        /** \brief It treats motions as symmetric, so its paths of Dubins curves are invalid. */
        bool needsSymmetry{false};
        /** \brief It relies on the triangle inequality: in spaces without it, it aborts or never returns. */
        bool needsMetric{false};
    };

    /** \brief Every planner that createPlanner() can make, by its name in configs. */
    OMPL_MFA_EXPORT const std::map<std::string, PlannerEntry> &plannerTable();

    /** \brief Geometric planners of OMPL that cannot be used with a config, with the reason. */
    OMPL_MFA_EXPORT const std::map<std::string, std::string> &unavailablePlanners();
}  // namespace ompl_mfa::benchmark

#endif
