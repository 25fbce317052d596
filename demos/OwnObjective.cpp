/* An objective of one's own: the path that is cheapest to drive over uneven ground, not the shortest one. */

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
    /** \brief Energy of a drive: a metre costs 1 on firm ground and up to 5 in the middle of a bog. */
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

        /* No metre is cheaper than on firm ground, so the straight distance bounds a motion's energy from below. A
           planner rejects motions by this bound before it checks them. */
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
