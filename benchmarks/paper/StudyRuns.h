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

#ifndef OMPL_MFA_BENCHMARKS_PAPER_STUDY_RUNS_
#define OMPL_MFA_BENCHMARKS_PAPER_STUDY_RUNS_

#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/RunJournal.h"
#include "paper/Study.h"

namespace ompl_mfa::paper
{
    using campaign::Json;

    /** \brief One run of the study. */
    struct StudyRun
    {
        /** \brief Identifies the run in its journal. */
        Json key;
        /** \brief Called in a separate process, which passes back the result. */
        std::function<Json()> make;
    };

    /** \brief Makes those runs of a section of the study that are missing in its journal PART.journal in the output
        folder, and returns all runs in order. \e identity is the input, besides their keys, that determines them.

        Throws std::runtime_error for a run that does not return, and Interrupted. */
    std::vector<Json> makeStudyRuns(const StudyOptions &options, const std::string &part, const std::string &identity,
                                    const std::vector<StudyRun> &runs);

    /** \brief A CSV file in the output folder, with its header. Throws InputError if it cannot be written. */
    std::ofstream openTable(const StudyOptions &options, const std::string &name, const std::string &header);

    /** \brief A number as JSON, also if it is infinite or NaN. */
    Json numberToJson(double value);

    /** \brief Reverse of numberToJson(). */
    double numberFrom(const Json &value);
}  // namespace ompl_mfa::paper

#endif
