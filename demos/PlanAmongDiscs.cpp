/* A point among discs in the plane: ompl_mfa::MFA in OMPL's SimpleSetup, as any other planner. */

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
        static const std::vector<Disc> discs{{3.0, 3.5, 1.5}, {6.5, 5.5, 1.2}, {5.0, 8.0, 1.0}, {8.0, 8.5, 0.8}};
        const double *position = state->as<ob::RealVectorStateSpace::StateType>()->values;
        return std::none_of(discs.begin(), discs.end(),
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

    /* MFA is an anytime planner: it uses the time that it is given to shorten the path. */
    if (setup.solve(0.5) != ob::PlannerStatus::EXACT_SOLUTION)
    {
        std::cerr << "no path found\n";
        return 1;
    }
    std::cout << "length " << setup.getSolutionPath().length() << " after " << planner->iterations() << " iterations\n";
    setup.getSolutionPath().printAsMatrix(std::cout);
    return 0;
}
