#ifndef OMPL_MFA_BENCHMARK_RUN_RECORD_
#define OMPL_MFA_BENCHMARK_RUN_RECORD_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ompl_mfa/benchmark/MeasuredPlanner.h"
#include "ompl_mfa/benchmark/RunProcess.h"

namespace ompl_mfa
{
    /** \brief Properties as OMPL's logs have them: "words TYPE" and a value. */
    using LogProperties = std::map<std::string, std::string>;

    /** \brief All that is known of one run. */
    struct RunRecord
    {
        /** \brief Name of the planner in logs, such as geometric_RRTstar. */
        std::string planner;
        /** \brief Counted from 0 for each planner. */
        unsigned int run{0};
        std::uint32_t seed{0};
        RunTermination termination{RunTermination::UNKNOWN};
        /** \brief The signal that ended the process, 0 if none did. */
        int signal{0};
        /** \brief The last that a run printed which did not return, or what its planner threw. */
        std::string message;
        LogProperties properties;
        /** \brief Parameters of planner and space, the same for all runs of a planner. */
        LogProperties common;
        /** \brief What SimpleSetup and planner print about themselves. */
        std::string setup;
        std::vector<std::string> progressNames;
        std::vector<ProgressSample> progress;
        /** \brief States of an exact solution as PathGeometric::printAsMatrix() writes them, when paths are saved. */
        std::string path;
        /** \brief Cost of `path`. */
        double pathCost{0.0};
    };

    /** \brief \e record as one line of JSON, without the line break. */
    std::string writeRunRecord(const RunRecord &record);

    /** \brief Reads what writeRunRecord() wrote. Throws std::invalid_argument for anything else. */
    RunRecord readRunRecord(const std::string &line);

    /** \brief The name of a property as logs write it. OMPL's BIT* family gives DOUBLE as a type, which makes its best
        cost another property than that of all other planners; it becomes REAL. */
    std::string logPropertyName(const std::string &name);

    /** \brief The seed of run \e run of every planner in a campaign with seed \e base: an output of SplitMix64
        (Steele, Lea and Flood, 2014) for the state base + (run + 1) 0x9e3779b97f4a7c15, folded to [1, 2^31 - 1]. */
    std::uint32_t runSeed(std::uint64_t base, unsigned int run);
}  // namespace ompl_mfa

#endif
