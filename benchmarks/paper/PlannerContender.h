#ifndef OMPL_MFA_BENCHMARKS_PAPER_PLANNER_CONTENDER_
#define OMPL_MFA_BENCHMARKS_PAPER_PLANNER_CONTENDER_

#include "paper/Contender.h"
#include "paper/PathProblem.h"

namespace ompl_mfa::paper
{
    /** \brief Runs the planner ompl_mfa::MFA as it comes, with all its parts, on the exact collisions of the scene,
       until it has checked as many motions as BUDGET paths over \e slices slices have, or proved its path optimal. An
        evaluation is that many motion checks. Run::path is the planner's path.

        Makes OMPL's random number generators: runs repeat only if they come in the same order in one thread. */
    struct PlannerRun
    {
        Run run;
        Points path;
    };

    PlannerRun runPlanner(const PathScene &scene, unsigned int slices, double target, std::uint32_t seed);
}  // namespace ompl_mfa::paper

#endif
