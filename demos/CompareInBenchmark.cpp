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

/* MFA and other planners in OMPL's Benchmark, which writes a log for ompl_benchmark_statistics.py and Planner Arena. */

#include <cmath>
#include <iostream>
#include <memory>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include "ompl_mfa/planner/MFA.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

int main(int argc, char *argv[])
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 10.0);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [](const ob::State *state)
        {
            const double *position = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return std::hypot(position[0] - 5.0, position[1] - 5.0) > 3.0;
        });
    ob::ScopedState<ob::RealVectorStateSpace> start(space);
    start[0] = start[1] = 0.5;
    ob::ScopedState<ob::RealVectorStateSpace> goal(space);
    goal[0] = goal[1] = 9.5;
    setup.setStartAndGoalStates(start, goal);
    const auto &si = setup.getSpaceInformation();
    setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));

    ompl::tools::Benchmark benchmark(setup, "around a disc");
    benchmark.addPlanner(std::make_shared<ompl_mfa::MFA>(si));
    benchmark.addPlanner(std::make_shared<og::RRTstar>(si));
    benchmark.addPlanner(std::make_shared<og::PRMstar>(si));
    benchmark.benchmark(ompl::tools::Benchmark::Request(0.2, 1000.0, 3));
    return benchmark.saveResultsToFile(argc > 1 ? argv[1] : "around_a_disc.log") ? 0 : 1;
}
