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

#include "anytime/PlannerText.h"

#include <sstream>

#include "OmplCompatibility.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        std::vector<std::string> split(const std::string &text, char separator)
        {
            std::vector<std::string> parts;
            std::istringstream in(text);
            for (std::string part; std::getline(in, part, separator);)
            {
                parts.push_back(part);
            }
            return parts;
        }

        [[noreturn]] void failForm(const std::string &text, const std::string &part)
        {
            throw InputError("--planners '" + text + "': expected PLANNER:KEY=VALUE,... and found '" + part + "'");
        }
    }  // namespace

    std::vector<std::string> peers()
    {
        std::vector<std::string> names{"rrtstar", "informedrrtstar",       "prmstar",         "bitstar", "abitstar",
                                       "aitstar", "anytimepathshortening", "restart_simplify"};
#ifdef OMPL_MFA_HAS_EITSTAR
        names.emplace_back("eitstar");
#endif
#ifdef OMPL_MFA_HAS_BLITSTAR
        names.emplace_back("blitstar");
#endif
#ifdef OMPL_MFA_HAS_AORRTC
        names.emplace_back("aorrtc");
#endif
        names.emplace_back("rrtconnect");
        return names;
    }

    std::vector<std::string> splitPlanners(const std::string &text)
    {
        std::vector<std::string> planners;
        for (const std::string &part : split(text, ','))
        {
            const bool isParameter = part.find('=') != std::string::npos && part.find(':') == std::string::npos;
            if (isParameter && !planners.empty() && planners.back().find(':') != std::string::npos)
            {
                planners.back() += "," + part;
            }
            else if (part == "peers")
            {
                const auto all = peers();
                planners.insert(planners.end(), all.begin(), all.end());
            }
            else
            {
                planners.push_back(part);
            }
        }
        if (planners.empty())
        {
            throw InputError("--planners '" + text + "': expected PLANNER[:KEY=VALUE,...],...");
        }
        return planners;
    }

    benchmark::PlannerSpec parsePlanner(const std::string &text)
    {
        const std::string origin = "--planners";
        const std::size_t colon = text.find(':');
        benchmark::PlannerSpec spec;
        spec.type = text.substr(0, colon);
        spec.name = text;
        spec.origin = origin;
        benchmark::requireKnownPlanner(spec.type, origin);
        if (colon == std::string::npos)
        {
            return spec;
        }
        for (const std::string &part : split(text.substr(colon + 1), ','))
        {
            const std::size_t equals = part.find('=');
            if (equals == std::string::npos || equals == 0)
            {
                failForm(text, part);
            }
            spec.parameters.push_back({part.substr(0, equals), part.substr(equals + 1), origin});
        }
        return spec;
    }
}  // namespace ompl_mfa::anytime
