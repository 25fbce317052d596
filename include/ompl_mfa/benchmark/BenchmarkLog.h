/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_BENCHMARK_BENCHMARK_LOG_
#define OMPL_MFA_BENCHMARK_BENCHMARK_LOG_

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::benchmark
{
    /** \brief Properties in the format of OMPL's logs: "words TYPE" and a value. */
    using LogProperties = std::map<std::string, std::string>;

    /** \brief The progress of a planner at one time. */
    struct ProgressSample
    {
        /** \brief Seconds since the start of solve(). */
        double time{0.0};
        /** \brief One value per progress property, in the order of PlannerLog::progressNames. */
        std::vector<std::string> values;
    };

    /** \brief The runs of one planner in a log. */
    struct PlannerLog
    {
        std::string name;
        LogProperties common;
        /** \brief One map per run; a property that a run lacks is written as an empty value. */
        std::vector<LogProperties> runs;
        std::vector<std::string> progressNames;
        /** \brief One series per run, or none at all; each may be empty. */
        std::vector<std::vector<ProgressSample>> progress;
    };

    /** \brief The names of the values of an ENUM property, from 0 on. */
    struct LogEnum
    {
        std::string property;
        std::vector<std::string> names;
    };

    /** \brief A log in the format of OMPL's Benchmark, readable by `ompl_benchmark_statistics` and Planner Arena. */
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
        /** \brief Seconds per run. */
        double timeLimit{0.0};
        /** \brief Megabytes per run. */
        double memoryLimit{0.0};
        unsigned int runCount{0};
        /** \brief Seconds spent on the runs. */
        double duration{0.0};
        std::vector<LogEnum> enums;
        std::vector<PlannerLog> planners;
    };

    /** \brief Writes \e log. Blanks in the experiment's name become underscores, values that are not finite become
        `inf` or `nan`, and progress samples with the same time after rounding are left out. */
    OMPL_MFA_EXPORT void writeBenchmarkLog(std::ostream &out, const BenchmarkLog &log);

    /** \brief As above, to \e file, which is replaced atomically. Throws InputError if it cannot be written. */
    OMPL_MFA_EXPORT void writeBenchmarkLog(const std::filesystem::path &file, const BenchmarkLog &log);
}  // namespace ompl_mfa::benchmark

#endif
