#ifndef OMPL_MFA_BENCHMARK_BENCHMARK_LOG_
#define OMPL_MFA_BENCHMARK_BENCHMARK_LOG_

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "ompl_mfa/benchmark/RunRecord.h"

namespace ompl_mfa
{
    /** \brief The runs of one planner in a log. */
    struct PlannerLog
    {
        std::string name;
        LogProperties common;
        /** \brief One map a run; a property that a run does not have is written as an empty value. */
        std::vector<LogProperties> runs;
        std::vector<std::string> progressNames;
        /** \brief As many as `runs`, or none at all; each may be empty. */
        std::vector<std::vector<ProgressSample>> progress;
    };

    /** \brief The names that the values of an ENUM property stand for, from 0 on. */
    struct LogEnum
    {
        std::string property;
        std::vector<std::string> names;
    };

    /** \brief A log in the format of OMPL's Benchmark, as `ompl_benchmark_statistics` and Planner Arena read it. */
    struct BenchmarkLog
    {
        /** \brief Version of the planning library. */
        std::string version;
        std::string experiment;
        /** \brief "name TYPE" and value; the names are single words. */
        LogProperties properties;
        std::string host;
        std::string start;
        std::string setup;
        std::string cpu;
        std::uint64_t seed{0};
        /** \brief Seconds a run. */
        double timeLimit{0.0};
        /** \brief Megabytes a run. */
        double memoryLimit{0.0};
        unsigned int runCount{0};
        /** \brief Seconds spent to collect the runs. */
        double duration{0.0};
        std::vector<LogEnum> enums;
        std::vector<PlannerLog> planners;
    };

    /** \brief Writes \e log. Blanks in the experiment's name become underscores, values that are not finite become
        `inf` or `nan`, and progress samples that the format would round to the same time are left out. */
    void writeBenchmarkLog(std::ostream &out, const BenchmarkLog &log);

    /** \brief As above, replacing \e file at once when all is written. Throws InputError when it cannot be written. */
    void writeBenchmarkLog(const std::filesystem::path &file, const BenchmarkLog &log);

    /** \brief Reads a log; \e name stands for it in messages. Throws InputError naming the line at which the text is
        not a log. */
    BenchmarkLog readBenchmarkLog(std::istream &in, const std::string &name);

    /** \brief As above. Throws InputError when \e file cannot be read or is not a log. */
    BenchmarkLog readBenchmarkLog(const std::filesystem::path &file);

    /** \brief Joins the parts of one campaign into one log. \e names stand for the parts in messages.

        Throws InputError when the parts are not of the same campaign, when two of them have the same run of a planner,
        or when runs are missing after all of them, unless \e allowMissing. */
    BenchmarkLog mergeBenchmarkLogs(const std::vector<BenchmarkLog> &parts, const std::vector<std::string> &names,
                                    bool allowMissing = false);
}  // namespace ompl_mfa

#endif
