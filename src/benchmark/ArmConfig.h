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

#ifndef OMPL_MFA_BENCHMARK_ARM_CONFIG_
#define OMPL_MFA_BENCHMARK_ARM_CONFIG_

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "benchmark/ConfigKeys.h"
#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/robots/RobotProblem.h"

namespace ompl_mfa::benchmark
{
    /** \brief The rows of [problem] for robot arms. */
    std::vector<ConfigRow<ProblemConfig>> armRows();

    /** \brief Whether a value of the key `robot` is the description of an arm. */
    OMPL_MFA_EXPORT bool isArmFile(const std::string &robot);

    /** \brief Throws InputError if \e section has a key that is not for the kind of its robot. */
    void checkArmKeys(const std::map<std::string, ConfigEntry> &section, const ProblemConfig &problem);

    /** \brief The files of the arm of \e config: the robot, its semantics, the scene and the request. */
    std::vector<std::filesystem::path> armFiles(const BenchmarkConfig &config);

    /** \brief Loads the arm of \e config. Throws InputError beginning with the key at fault, if it is known. */
    std::shared_ptr<const robots::RobotProblem> loadArm(const BenchmarkConfig &config);

    /** \brief A setup with the space, the resolution and the checkers of an arm; start and goal are not set yet. */
    ompl::geometric::SimpleSetupPtr makeArmSetup(const robots::RobotProblem &arm, const robots::JointSpace &joints,
                                                 const ProblemConfig &problem, const ContextConfig &context);
}  // namespace ompl_mfa::benchmark

#endif
