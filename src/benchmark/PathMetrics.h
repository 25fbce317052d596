#ifndef OMPL_MFA_BENCHMARK_PATH_METRICS_
#define OMPL_MFA_BENCHMARK_PATH_METRICS_

#include <ompl/geometric/PathGeometric.h>

namespace ompl_mfa
{
    /** \brief Measures that only compare between paths whose states lie alike. */
    struct PathMetrics
    {
        /** \brief Smallest clearance of a state, in the units of the validity checker's clearance(). */
        double minimumClearance{0.0};
        /** \brief OMPL's PathGeometric::smoothness(); 0 for a straight motion. */
        double smoothness{0.0};
    };

    /** \brief States along \e path at equal distances of at most \e step, both ends included; \e path's own vertices
        are not kept. Distances are those of the state space; \e step is above 0. At most 5000 motions. */
    ompl::geometric::PathGeometric resamplePath(const ompl::geometric::PathGeometric &path, double step);

    /** \brief Measures \e path resampled at the space's longest valid segment length. PathGeometric::clearance() is a
        mean over the vertices and smoothness() depends on how far apart they are: neither compares between planners. */
    PathMetrics measurePath(const ompl::geometric::PathGeometric &path);
}  // namespace ompl_mfa

#endif
