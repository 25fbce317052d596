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

#ifndef OMPL_MFA_BENCHMARK_PLANNER_FACTORY_
#define OMPL_MFA_BENCHMARK_PLANNER_FACTORY_

#include <cstdint>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::benchmark
{
    /** \brief A parameter that a planner declares. */
    struct PlannerParameter
    {
        std::string name;
        /** \brief `bool`, `integer`, `unsigned`, `real` or `text`. */
        std::string type;
        /** \brief In OMPL's format, "first:step:last" or "a,b,c"; empty if the planner declares none. */
        std::string range;
        std::string defaultValue;
    };

    /** \brief Names of every geometric planner of the linked OMPL and of this project, sorted; aliases included. */
    OMPL_MFA_EXPORT std::vector<std::string> plannerNames();

    /** \brief Throws InputError, beginning with \e origin, unless \e type is known to createPlanner(). */
    OMPL_MFA_EXPORT void requireKnownPlanner(const std::string &type, const std::string &origin);

    /** \brief The name in logs of a planner of a known \e type, such as `RRTstar`. */
    OMPL_MFA_EXPORT std::string plannerTitle(const std::string &type);

    /** \brief The parameters of planner \e type with ranges and defaults. Makes a planner, and with it random number
        generators, so a seed has to be set before. */
    OMPL_MFA_EXPORT std::vector<PlannerParameter> plannerParameters(const std::string &type);

    /** \brief Makes the planner of \e spec, named and with its parameters set, on \e si.

        Makes random number generators, so a seed has to be set before. Throws InputError, naming origin, key, value and
        what is accepted, for an unknown planner or parameter (with the nearest known name), for a value that is not of
        the parameter's type or out of its range, and for a planner that does not support the space of \e si. */
    OMPL_MFA_EXPORT ompl::base::PlannerPtr createPlanner(const ompl::base::SpaceInformationPtr &si,
                                                         const PlannerSpec &spec);

    /** \brief Sets the planner's parameter `seed`, if it has one. */
    OMPL_MFA_EXPORT void seedPlanner(ompl::base::Planner &planner, std::uint_fast32_t seed);
}  // namespace ompl_mfa::benchmark

#endif
