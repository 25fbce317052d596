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

#include <filesystem>
#include <sstream>

#include <ompl/geometric/SimpleSetup.h>
#include <ompl_mfa/benchmark/ConfigFile.h>
#include <ompl_mfa/benchmark/PlannerFactory.h>
#include <ompl_mfa/benchmark/ProblemFactory.h>

/* A config without a world: the straight line is the solution. */
int main()
{
    std::istringstream config(
        "[problem]\n"
        "name = empty\n"
        "robot = point\n"
        "start.x = 0.1\n"
        "start.y = 0.2\n"
        "goal.x = 0.9\n"
        "goal.y = 0.8\n"
        "volume.min.x = 0\n"
        "volume.min.y = 0\n"
        "volume.max.x = 1\n"
        "volume.max.y = 1\n"
        "[planner]\n"
        "mfa =\n");
    ompl_mfa::benchmark::setRandomSeed(1);
    const ompl_mfa::benchmark::ProblemFactory problem(ompl_mfa::benchmark::parseBenchmarkConfig(config, "empty.cfg"));
    const auto setup = problem.create();
    setup->setPlanner(
        ompl_mfa::benchmark::createPlanner(setup->getSpaceInformation(), problem.config().planners.front()));
    const bool solved = setup->solve(0.5) == ompl::base::PlannerStatus::EXACT_SOLUTION;
    return solved && setup->getSolutionPath().length() < 1.0 + 1e-6 ? 0 : 1;
}
