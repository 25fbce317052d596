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

#ifndef OMPL_MFA_BENCHMARK_CAMPAIGN_LOG_
#define OMPL_MFA_BENCHMARK_CAMPAIGN_LOG_

#include <filesystem>
#include <vector>

#include "benchmark/RunRecord.h"
#include "campaign/RunJournal.h"
#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"
#include "ompl_mfa/benchmark/Campaign.h"

namespace ompl_mfa::benchmark
{
    /** \brief A journal of `ompl_mfa benchmark`. */
    struct CampaignRuns
    {
        campaign::JournalHeader header;
        std::vector<RunRecord> records;
    };

    /** \brief The header of the journal of \e campaign on this machine; its description is the part of a log that
        concerns the whole campaign. */
    OMPL_MFA_EXPORT campaign::JournalHeader makeJournalHeader(const Campaign &campaign);

    /** \brief Reads a journal. Throws InputError if \e file is not a journal of `ompl_mfa benchmark`. */
    OMPL_MFA_EXPORT CampaignRuns readCampaignRuns(const std::filesystem::path &file);

    /** \brief The properties of a whole campaign that makeJournalHeader() stored in \e description: all except start,
        duration and the data of runs; of the planners only the names. Throws std::invalid_argument for any other JSON
        value. */
    OMPL_MFA_EXPORT BenchmarkLog logHeadFrom(const campaign::Json &description);

    /** \brief As an object for the header of a journal. */
    OMPL_MFA_EXPORT campaign::Json toJson(const BenchmarkLog &logHead);

    /** \brief The log of \e runs, which may be in any order. */
    OMPL_MFA_EXPORT BenchmarkLog assembleLog(const CampaignRuns &runs);
}  // namespace ompl_mfa::benchmark

#endif
