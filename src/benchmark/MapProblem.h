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

#ifndef OMPL_MFA_BENCHMARK_MAP_PROBLEM_
#define OMPL_MFA_BENCHMARK_MAP_PROBLEM_

#include <memory>
#include <string>
#include <vector>

#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/maps/Footprint.h"
#include "ompl_mfa/maps/ObstacleGrid.h"
#include "ompl_mfa/maps/Scenario.h"

namespace ompl_mfa::benchmark
{
    /** \brief The map of \e config; null if its world is none. Throws InputError for a map that cannot be read, and for
        keys that only maps have if there is none. */
    std::shared_ptr<const maps::ObstacleGrid> loadMapOf(const BenchmarkConfig &config);

    /** \brief The robot of \e config on a map. Throws InputError if it is none for a map. */
    maps::Footprint makeFootprint(const ProblemConfig &problem);

    /** \brief The problems of the config's scenario that its index selects; none if it has no scenario. */
    std::vector<maps::ScenarioProblem> loadScenarioOf(const BenchmarkConfig &config, const maps::ObstacleGrid &grid);

    /** \brief What is wrong with a \e pose that collides, if the map alone shows it: that it is in unknown space or
        outside of the map; empty otherwise. */
    std::string describeCell(const maps::ObstacleGrid &grid, const ConfigPose &pose);
}  // namespace ompl_mfa::benchmark

#endif
