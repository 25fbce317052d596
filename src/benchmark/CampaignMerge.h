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

#ifndef OMPL_MFA_BENCHMARK_CAMPAIGN_MERGE_
#define OMPL_MFA_BENCHMARK_CAMPAIGN_MERGE_

#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/CampaignLog.h"
#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"

namespace ompl_mfa::benchmark
{
    /** \brief Joins the shards of one campaign. \e names are the names of the shards in messages.

        Throws InputError if the shards are not of the same campaign, if two of them have the same run of a planner, or
        if runs are missing, unless \e allowMissing. */
    OMPL_MFA_EXPORT CampaignRuns mergeRuns(const std::vector<CampaignRuns> &parts,
                                           const std::vector<std::string> &names, bool allowMissing = false);

    /** \brief Joins \e parts, which are journals or logs with a journal, into the log \e output and its journal, and
        returns that log.

        Throws InputError as mergeRuns() does, if a journal cannot be read, if the result cannot be written, and if \e
        output has a journal of another campaign. */
    OMPL_MFA_EXPORT BenchmarkLog mergeCampaign(const std::vector<std::string> &parts,
                                               const std::filesystem::path &output, bool allowMissing);
}  // namespace ompl_mfa::benchmark

#endif
