#ifndef OMPL_MFA_BENCHMARK_MEASURED_RUN_
#define OMPL_MFA_BENCHMARK_MEASURED_RUN_

#include <cstdint>
#include <functional>

#include <ompl/base/Planner.h>
#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/benchmark/RunRecord.h"

namespace ompl_mfa
{
    /** \brief What is the same for every run of a campaign. */
    struct RunSettings
    {
        /** \brief Seconds. */
        double timeLimit{5.0};
        /** \brief Megabytes (2^20 bytes). */
        double memoryLimit{4096.0};
        /** \brief Seconds between two samples of the progress properties. */
        double progressInterval{0.01};
        /** \brief Evaluations of the termination condition before the planner has to stop; 0: no limit. */
        std::uint64_t iterationLimit{0};
        bool simplify{true};
        /** \brief Whether records hold the path of an exact solution. */
        bool keepPath{false};
    };

    /** \brief Makes the problem of a run. It is called in the run's own process, after the seed is set. */
    using ProblemAllocator = std::function<ompl::geometric::SimpleSetupPtr()>;

    /** \brief Runs a planner once through OMPL's Benchmark in the calling process and measures the run.

        Seeds OMPL with \e seed before it makes anything, and the planner by its parameter `seed` where it has one.
        The record has OMPL's own run properties and those that docs/benchmarks.md lists. */
    RunRecord measureRun(const ProblemAllocator &makeProblem, const ompl::base::PlannerAllocator &makePlanner,
                         const RunSettings &settings, std::uint32_t seed, RunState &state);
}  // namespace ompl_mfa

#endif
