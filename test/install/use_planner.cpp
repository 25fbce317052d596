#include <memory>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl_mfa/planner/MFA.h>

namespace ob = ompl::base;

/* Plans around a disc in the middle of a square. */
int main()
{
    const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0.0, 1.0);
    ompl::geometric::SimpleSetup setup(space);
    setup.setStateValidityChecker(
        [](const ob::State *state)
        {
            const double *position = state->as<ob::RealVectorStateSpace::StateType>()->values;
            const double x = position[0] - 0.5;
            const double y = position[1] - 0.5;
            return x * x + y * y > 0.04;
        });
    ob::ScopedState<> start(space);
    start = std::vector<double>{0.1, 0.5};
    ob::ScopedState<> goal(space);
    goal = std::vector<double>{0.9, 0.5};
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<ompl_mfa::MFA>(setup.getSpaceInformation()));
    const bool solved = setup.solve(0.5) == ob::PlannerStatus::EXACT_SOLUTION;
    return solved && setup.getSolutionPath().length() < 1.2 ? 0 : 1;
}
