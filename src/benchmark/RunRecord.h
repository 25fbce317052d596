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

#ifndef OMPL_MFA_BENCHMARK_RUN_RECORD_
#define OMPL_MFA_BENCHMARK_RUN_RECORD_

#include <cstdint>
#include <string>
#include <vector>

#include "benchmark/RunState.h"
#include "campaign/RunJournal.h"
#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"

namespace ompl_mfa::benchmark
{
    /** \brief All data of one run. */
    struct RunRecord
    {
        /** \brief Name of the planner in logs, such as geometric_RRTstar. */
        std::string planner;
        /** \brief Counted from 0 for each planner. */
        unsigned int run{0};
        std::uint32_t seed{0};
        RunTermination termination{RunTermination::Unknown};
        /** \brief The signal that ended the process, 0 if none did. */
        int signal{0};
        /** \brief The last output of a run that did not return, or the message of the exception that its planner
            threw. */
        std::string message;
        LogProperties properties;
        /** \brief Parameters of planner and space, the same for all runs of a planner. */
        LogProperties common;
        /** \brief Printed settings of SimpleSetup and planner. */
        std::string setup;
        std::vector<std::string> progressNames;
        std::vector<ProgressSample> progress;
        /** \brief States of an exact solution in the format of PathGeometric::printAsMatrix(), if paths are saved. */
        std::string path;
        /** \brief Cost of `path`. */
        double pathCost{0.0};
        /** \brief Seconds from the end of the previous run, or the start, to the end of this one; set by the
            journal. */
        double duration{0.0};
    };

    /** \brief \e record as an object for the journal. */
    OMPL_MFA_EXPORT campaign::Json toJson(const RunRecord &record);

    /** \brief Reverse of toJson(). Throws std::invalid_argument for any other JSON value. */
    OMPL_MFA_EXPORT RunRecord runRecordFrom(const campaign::Json &json);

    /** \brief toJson() as one line of text, without the line break. */
    OMPL_MFA_EXPORT std::string writeRunRecord(const RunRecord &record);

    /** \brief Reverse of writeRunRecord(). Throws std::invalid_argument for any other text. */
    OMPL_MFA_EXPORT RunRecord readRunRecord(const std::string &line);

    /** \brief The name of a property in logs. The type DOUBLE of OMPL's BIT* family is replaced by REAL; otherwise its
        best cost would be a different property from that of all other planners. */
    OMPL_MFA_EXPORT std::string logPropertyName(const std::string &name);
}  // namespace ompl_mfa::benchmark

#endif
