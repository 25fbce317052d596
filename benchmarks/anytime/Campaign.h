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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_CAMPAIGN_
#define OMPL_MFA_BENCHMARKS_ANYTIME_CAMPAIGN_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "anytime/PlannerRun.h"
#include "campaign/Campaign.h"

namespace ompl_mfa::anytime
{
    struct CampaignRequest
    {
        std::vector<World> worlds;
        /** \brief In the format of parsePlanner(). */
        std::vector<std::string> planners;
        /** \brief The seeds are 1 to this number. */
        std::uint32_t seeds;
        /** \brief Seconds per run on \e clock. */
        double timeLimit;
        Clock clock;
    };

    /** \brief Called in the process of the run. */
    using RunBody = std::function<RunResult(const RunRequest &, RunMemory &)>;

    /** \brief One run. It is killed far beyond its time limit: after 1.5 times the limit plus 1 s of processor time, or
        6 times plus 30 s of wall time. */
    campaign::Work makeWork(const RunRequest &request, const RunBody &body = runPlanner);

    /** \brief Makes the runs missing in the journal, which may contain others, ordered by seed, so that an interrupted
        campaign has a similar number of runs of each planner. Each is bound to a core, so that planners with several
        threads have no advantage. Throws InputError for an invalid planner and as campaign::makeRuns() does. */
    campaign::RunsMade runCampaign(const CampaignRequest &request, campaign::RunOptions options);
}  // namespace ompl_mfa::anytime

#endif
