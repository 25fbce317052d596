#ifndef OMPL_MFA_BENCHMARK_PLANNER_TABLE_
#define OMPL_MFA_BENCHMARK_PLANNER_TABLE_

#include <map>
#include <string>

#include <ompl/base/Planner.h>

namespace ompl_mfa
{
    /** \brief A planner as the table knows it. */
    struct PlannerEntry
    {
        /** \brief The name in logs. */
        std::string title;
        ompl::base::PlannerAllocator allocate;
        /** \brief It throws in setup() when the state space has no default projection. */
        bool needsProjection{false};
        /** \brief It takes a motion from B to A for one from A to B: its paths on Dubins curves fail their check. */
        bool needsSymmetry{false};
        /** \brief It relies on the triangle inequality: in other spaces it aborts or never returns. */
        bool needsMetric{false};
    };

    /** \brief Every planner that createPlanner() makes, by the name that configs use. */
    const std::map<std::string, PlannerEntry> &plannerTable();

    /** \brief Geometric planners of OMPL that a config cannot describe, with the reason. */
    const std::map<std::string, std::string> &unavailablePlanners();
}  // namespace ompl_mfa

#endif
