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

/* A user-defined objective: the path that takes the least energy to drive over uneven ground, instead of the shortest
   one. */

#include <cmath>
#include <iostream>
#include <memory>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/planner/MFA.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{
    /** \brief Driving energy: 1 per metre on firm ground and up to 5 in the middle of a bog. */
    class DrivingEnergy : public ob::StateCostIntegralObjective
    {
    public:
        explicit DrivingEnergy(const ob::SpaceInformationPtr &si)
          : ob::StateCostIntegralObjective(si, true)
        {
            description_ = "Driving energy";
        }

        ob::Cost stateCost(const ob::State *state) const override
        {
            const double *position = state->as<ob::RealVectorStateSpace::StateType>()->values;
            const double toBog = std::hypot(position[0] - 5.0, position[1] - 4.5);
            return ob::Cost(1.0 + 4.0 * std::exp(-0.5 * toBog * toBog));
        }

        /* Firm ground has the lowest cost, so the straight distance is a lower bound on a motion's energy. A planner
           rejects motions by this bound before it checks them. */
        ob::Cost motionCostHeuristic(const ob::State *from, const ob::State *to) const override
        {
            return ob::Cost(si_->distance(from, to));
        }
    };
}  // namespace

int main()
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 10.0);

    og::SimpleSetup setup(space);
    setup.setStateValidityChecker([](const ob::State *) { return true; });
    ob::ScopedState<ob::RealVectorStateSpace> start(space);
    start[0] = 0.5;
    start[1] = 5.0;
    ob::ScopedState<ob::RealVectorStateSpace> goal(space);
    goal[0] = 9.5;
    goal[1] = 5.0;
    setup.setStartAndGoalStates(start, goal);
    const auto energy = std::make_shared<DrivingEnergy>(setup.getSpaceInformation());
    setup.setOptimizationObjective(energy);
    setup.setPlanner(std::make_shared<ompl_mfa::MFA>(setup.getSpaceInformation()));

    if (setup.solve(0.5) != ob::PlannerStatus::EXACT_SOLUTION)
    {
        std::cerr << "no path found\n";
        return 1;
    }
    const double straight = energy->motionCost(start.get(), goal.get()).value();
    const double found = setup.getSolutionPath().cost(energy).value();
    std::cout << "energy of the straight line " << straight << ", of the path found " << found << ", its length "
              << setup.getSolutionPath().length() << '\n';
    return found < straight ? 0 : 1;
}
