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

#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

#include "anytime/PlannerText.h"
#include "text/NumberText.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        using campaign::Json;
        using campaign::RunProcess;
        using campaign::RunTermination;

        /* The same for all journals, so that files of runs can be concatenated: the key of a run identifies it
           completely. */
        const char *const IDENTITY = "ompl_mfa_anytime";

        /* JSON has no infinity. */
        Json finiteOrNull(double value)
        {
            return std::isfinite(value) ? Json(value) : Json(nullptr);
        }

        /* One entry per improvement: wall seconds, processor seconds, cost, states checked. */
        Json toJson(const ImprovementLog &log)
        {
            Json improvements = Json::array();
            for (std::uint32_t i = 0; i < log.count; ++i)
            {
                const Improvement &entry = log.entries[i];
                improvements.push_back({entry.wall, entry.cpu, entry.cost, entry.checks});
            }
            return improvements;
        }

        Json toJson(const RunResult &result)
        {
            return {{"solved", result.solved},
                    {"valid", result.valid},
                    {"strict", result.strict},
                    {"cost", finiteOrNull(result.cost)},
                    {"wall", result.wall},
                    {"cpu", result.cpu},
                    {"checks", result.checks},
                    {"path_check", result.pathCheck},
                    {"path_checks", result.pathChecks},
                    {"looks", result.looks},
                    {"longest_gap", result.longestGap},
                    {"path", result.path}};
        }

        std::string statusOf(const RunProcess &process)
        {
            switch (process.termination())
            {
                case RunTermination::Returned:
                    return "returned";
                case RunTermination::Exception:
                    return "exception";
                case RunTermination::Exited:
                    return "exited";
                case RunTermination::Signal:
                    return std::string("signal ") + sigabbrev_np(process.signal());
                case RunTermination::MemoryLimit:
                    return "out of memory";
                default:
                    return "killed";
            }
        }

        campaign::RunReport reportOf(const RunProcess &process, const RunRequest &request, const RunMemory &memory)
        {
            const bool returned = process.termination() == RunTermination::Returned;
            const Json result = returned ? campaign::parseJson(process.result()) : toJson(RunResult());
            campaign::RunReport report;
            report.record = {
                {"family", request.world->family}, {"status", statusOf(process)}, {"note", process.lastLine()}};
            report.record.update(result);
            report.record["improvements"] = toJson(memory.log);
            report.failed = !returned;
            report.text = statusOf(process);
            if (!process.lastLine().empty())
            {
                report.text += " (" + process.lastLine() + ")";
            }
            if (result.at("solved"))
            {
                report.text +=
                    ", cost " + text::numberText(result.at("cost"), 6) +
                    (!result.at("valid")    ? ", which fails check()"
                     : !result.at("strict") ? ", which fails at " + std::to_string(STRICTNESS) + " times the resolution"
                                            : "");
            }
            return report;
        }

        campaign::Task makeTask(const RunRequest &request)
        {
            campaign::Task task;
            task.key = {{"world", request.world->name},
                        {"planner", request.planner},
                        {"seed", request.seed},
                        {"time_limit", request.timeLimit},
                        {"clock", clockName(request.clock)}};
            task.name = request.world->name + " " + request.planner + " #" + std::to_string(request.seed);
            task.group = request.planner;
            task.expected = request.timeLimit;
            task.makeWork = [request] { return makeWork(request); };
            return task;
        }
    }  // namespace

    campaign::Work makeWork(const RunRequest &request, const RunBody &body)
    {
        const auto memory = campaign::makeShared<RunMemory>();
        campaign::Work work;
        work.state = memory;
        work.limits.processor = 1.5 * request.timeLimit + 1.0;
        work.limits.solve = 6.0 * request.timeLimit + 30.0;
        work.body = [request, body, memory] { return campaign::jsonLine(toJson(body(request, *memory))); };
        work.report = [request, memory](const RunProcess &process) { return reportOf(process, request, *memory); };
        return work;
    }

    campaign::RunsMade runCampaign(const CampaignRequest &request, campaign::RunOptions options)
    {
        for (const std::string &planner : request.planners)
        {
            parsePlanner(planner);
        }
        std::vector<campaign::Task> tasks;
        for (std::uint32_t seed = 1; seed <= request.seeds; ++seed)
        {
            for (const World &world : request.worlds)
            {
                for (const std::string &planner : request.planners)
                {
                    tasks.push_back(makeTask({&world, planner, seed, request.timeLimit, request.clock}));
                }
            }
        }
        options.bindToCores = true;
        options.resume = !options.overwrite;
        campaign::JournalHeader header;
        header.campaign = IDENTITY;
        return campaign::makeRuns(std::move(header), tasks, options);
    }
}  // namespace ompl_mfa::anytime
