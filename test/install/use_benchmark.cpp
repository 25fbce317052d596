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
    ompl_mfa::setRandomSeed(1);
    const ompl_mfa::ProblemFactory problem(ompl_mfa::parseBenchmarkConfig(config, "empty.cfg"));
    const auto setup = problem.create();
    setup->setPlanner(ompl_mfa::createPlanner(setup->getSpaceInformation(), problem.config().planners.front()));
    const bool solved = setup->solve(0.5) == ompl::base::PlannerStatus::EXACT_SOLUTION;
    return solved && setup->getSolutionPath().length() < 1.0 + 1e-6 ? 0 : 1;
}
