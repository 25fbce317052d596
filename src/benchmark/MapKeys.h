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

#ifndef OMPL_MFA_BENCHMARK_MAP_KEYS_
#define OMPL_MFA_BENCHMARK_MAP_KEYS_

#include <map>
#include <string>
#include <vector>

#include "benchmark/ConfigKeys.h"

namespace ompl_mfa::benchmark
{
    /** \brief The row of `map.unknown`. */
    ConfigRow<ProblemConfig> unknownCellsRow();

    /** \brief The rows of `robot.footprint` and `robot.padding`. */
    std::vector<ConfigRow<ProblemConfig>> footprintRows();

    /** \brief The rows of `scenario` and `scenario.index`. */
    std::vector<ConfigRow<ProblemConfig>> scenarioRows();

    /** \brief Throws InputError where keys of robots, scenarios or objectives lack others that they need or exclude. \e
       entries are those of [problem]. */
    void checkRobotKeys(const std::map<std::string, ConfigEntry> &entries, const ProblemConfig &problem,
                        const std::string &file);
    void checkScenarioKeys(const std::map<std::string, ConfigEntry> &entries);
    void checkClearanceCostKeys(const std::map<std::string, ConfigEntry> &entries, const ProblemConfig &problem);
}  // namespace ompl_mfa::benchmark

#endif
