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

/* A point among discs in the plane: ompl_mfa::MFA in OMPL's SimpleSetup, like any other planner. */

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <vector>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/planner/MFA.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    struct Disc
    {
        double x, y, radius;
    };

    bool isFree(const ob::State *state)
    {
        static const std::vector<Disc> DISCS{{3.0, 3.5, 1.5}, {6.5, 5.5, 1.2}, {5.0, 8.0, 1.0}, {8.0, 8.5, 0.8}};
        const double *position = state->as<ob::RealVectorStateSpace::StateType>()->values;
        return std::none_of(DISCS.begin(), DISCS.end(),
                            [position](const Disc &disc)
                            { return std::hypot(position[0] - disc.x, position[1] - disc.y) < disc.radius; });
    }
}  // namespace

int main()
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 10.0);

    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(isFree);
    ob::ScopedState<ob::RealVectorStateSpace> start(space);
    start[0] = start[1] = 0.5;
    ob::ScopedState<ob::RealVectorStateSpace> goal(space);
    goal[0] = goal[1] = 9.5;
    setup.setStartAndGoalStates(start, goal);
    setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation()));

    const auto planner = std::make_shared<ompl_mfa::MFA>(setup.getSpaceInformation());
    planner->params().setParam("population_size", "40");
    setup.setPlanner(planner);

    /* MFA is an anytime planner: it uses all of the given time to shorten the path. */
    if (setup.solve(0.5) != ob::PlannerStatus::EXACT_SOLUTION)
    {
        std::cerr << "no path found\n";
        return 1;
    }
    std::cout << "length " << setup.getSolutionPath().length() << " after " << planner->iterations() << " iterations\n";
    setup.getSolutionPath().printAsMatrix(std::cout);
    return 0;
}
