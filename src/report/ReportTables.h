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

#ifndef OMPL_MFA_REPORT_REPORT_TABLES_
#define OMPL_MFA_REPORT_REPORT_TABLES_

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "report/Analysis.h"
#include "report/Results.h"

namespace ompl_mfa::report
{
    /** \brief All computed tables as JSON. Infinity and NaN are null. */
    nlohmann::json tablesAsJson(const std::vector<Experiment> &experiments,
                                const std::vector<ExperimentSummary> &summaries, const Comparison &comparison);

    /** \brief Successes, final costs and times to all levels of an experiment, as HTML. */
    std::string resultsTable(const ExperimentSummary &summary);

    /** \brief Ratios to the best peer at all levels of an experiment, as HTML. */
    std::string ratiosTable(const ExperimentSummary &summary);

    /** \brief A few points of the curves of an experiment, as HTML for readers without scripts. */
    std::string curvesTable(const ExperimentSummary &summary);

    /** \brief The mean ranks of \e ranking with their tests, as HTML. */
    std::string ranksTable(const Comparison &comparison, const Ranking &ranking);

    /** \brief The lowest coverage of the intervals of medians of \e summary, in [0, 1]. */
    double lowestCoverage(const ExperimentSummary &summary);
}  // namespace ompl_mfa::report

#endif
