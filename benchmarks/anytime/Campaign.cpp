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

#include "anytime/Campaign.h"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <list>
#include <ostream>
#include <thread>

#include <sched.h>

#include "anytime/PlannerText.h"
#include "anytime/RunFile.h"
#include "anytime/RunProcess.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        /* The one first on which this process is: the scheduler has found it the least busy. */
        std::vector<int> availableCores()
        {
            cpu_set_t set;
            CPU_ZERO(&set);
            sched_getaffinity(0, sizeof(set), &set);
            std::vector<int> cores;
            for (int core = 0; core < CPU_SETSIZE; ++core)
            {
                if (CPU_ISSET(core, &set))
                    cores.push_back(core);
            }
            const auto here = std::find(cores.begin(), cores.end(), sched_getcpu());
            if (here != cores.end())
                std::rotate(cores.begin(), here, cores.end());
            return cores;
        }

        std::list<RunRequest> missingRuns(const CampaignRequest &campaign, const RunFile &file)
        {
            std::list<RunRequest> missing;
            for (std::uint32_t seed = 1; seed <= campaign.seeds; ++seed)
            {
                for (const World &world : campaign.worlds)
                {
                    for (const std::string &planner : campaign.planners)
                    {
                        RunRequest request{&world, planner, seed, campaign.timeLimit, campaign.clock};
                        if (!file.has(request))
                            missing.push_back(std::move(request));
                    }
                }
            }
            return missing;
        }

        void reportRun(const RunProcess &run, std::size_t number, std::size_t total, std::ostream &progress)
        {
            const RunRequest &request = run.request();
            const RunResult &result = run.result();
            progress << "[" << number << "/" << total << "] " << request.world->name << " " << request.planner << " #"
                     << request.seed << ": " << run.status();
            if (!run.note().empty())
                progress << " (" << run.note() << ")";
            if (result.solved)
                progress << ", cost " << std::setprecision(6) << result.cost
                         << (result.valid ? "" : ", which fails check()");
            progress << std::endl;
        }

        struct Slot
        {
            int core;
            std::unique_ptr<RunProcess> run;
        };
    }  // namespace

    void runCampaign(const CampaignRequest &campaign, const std::filesystem::path &runs, std::ostream &progress)
    {
        const std::vector<int> cores = availableCores();
        if (campaign.jobs < 1 || campaign.jobs > cores.size())
            throw InputError("--jobs " + std::to_string(campaign.jobs) + ": accepted are 1 to " +
                             std::to_string(cores.size()) + ", the number of cores");
        for (const std::string &planner : campaign.planners)
            parsePlanner(planner);
        RunFile file(runs);
        std::list<RunRequest> waiting = missingRuns(campaign, file);
        const std::size_t total = waiting.size();
        std::size_t done = 0;
        std::vector<Slot> slots;
        for (unsigned int i = 0; i < campaign.jobs; ++i)
            slots.push_back({cores[i], nullptr});
        while (done < total)
        {
            for (Slot &slot : slots)
            {
                if (slot.run && slot.run->finished())
                {
                    if (slot.run->status() == "bad request")
                        throw InputError(slot.run->note());
                    file.append(*slot.run);
                    reportRun(*slot.run, ++done, total, progress);
                    slot.run.reset();
                }
                if (!slot.run && !waiting.empty())
                {
                    slot.run = std::make_unique<RunProcess>(waiting.front(), slot.core);
                    waiting.pop_front();
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
}  // namespace ompl_mfa::anytime
