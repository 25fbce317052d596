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

#include <algorithm>
#include <map>
#include <set>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"
#include "text/NumberText.h"

namespace ompl_mfa
{
    namespace
    {
        const char *const CAMPAIGN = "campaign TEXT";
        const char *const SHARD = "shard TEXT";
        const char *const RUN = "run INTEGER";

        std::string campaignOf(const BenchmarkLog &log, const std::string &name)
        {
            const auto found = log.properties.find(CAMPAIGN);
            if (found == log.properties.end())
            {
                throw InputError(name + ": no experiment property '" + CAMPAIGN +
                                 "': only logs that 'ompl_mfa benchmark' wrote can be joined");
            }
            return found->second;
        }

        void requireSame(const std::string &what, const std::string &first, const std::string &other,
                         const std::vector<std::string> &names, std::size_t part)
        {
            if (first != other)
            {
                throw InputError(names[part] + ": not a part of the same campaign as " + names[0] + ": " + what +
                                 " is '" + other + "' there and '" + first + "' here");
            }
        }

        std::string joinWords(const std::set<std::string> &words)
        {
            std::string joined;
            for (const std::string &word : words)
            {
                joined += (joined.empty() ? "" : ",") + word;
            }
            return joined;
        }

        unsigned int runOf(const LogProperties &run, const std::string &name, const std::string &planner)
        {
            const auto found = run.find(RUN);
            if (found == run.end())
            {
                throw InputError(name + ": planner " + planner + ": a run without property '" + RUN + "'");
            }
            unsigned int number = 0;
            if (!readNumber(found->second, number))
            {
                throw InputError(name + ": planner " + planner + ": " + RUN + " = " + found->second +
                                 ": expected a whole number of at least 0");
            }
            return number;
        }

        /* Where a run of a planner stands: which part, and at which place in it. */
        struct RunPlace
        {
            std::size_t part;
            const PlannerLog *planner;
            std::size_t index;
        };

        PlannerLog mergePlanner(std::size_t which, const std::vector<BenchmarkLog> &parts,
                                const std::vector<std::string> &names, bool allowMissing)
        {
            const std::string &name = parts[0].planners[which].name;
            PlannerLog merged;
            merged.name = name;
            std::map<unsigned int, RunPlace> places;
            for (std::size_t part = 0; part < parts.size(); ++part)
            {
                const PlannerLog &planner = parts[part].planners[which];
                merged.common.insert(planner.common.begin(), planner.common.end());
                merged.progressNames = merged.progressNames.empty() ? planner.progressNames : merged.progressNames;
                for (std::size_t i = 0; i < planner.runs.size(); ++i)
                {
                    const unsigned int run = runOf(planner.runs[i], names[part], name);
                    const auto added = places.insert({run, {part, &planner, i}});
                    if (!added.second)
                    {
                        throw InputError(names[part] + ": run " + std::to_string(run) + " of planner " + name +
                                         " is in " + names[added.first->second.part] + " too");
                    }
                }
            }
            for (unsigned int run = 0; !allowMissing && run < parts[0].runCount; ++run)
            {
                if (places.count(run) == 0)
                {
                    throw InputError("run " + std::to_string(run) + " of planner " + name +
                                     " is in none of the parts; --allow-missing joins them all the same");
                }
            }
            for (const auto &place : places)
            {
                const RunPlace &at = place.second;
                merged.runs.push_back(at.planner->runs[at.index]);
                if (!merged.progressNames.empty())
                {
                    merged.progress.push_back(at.planner->progress.empty() ? std::vector<ProgressSample>()
                                                                           : at.planner->progress[at.index]);
                }
            }
            return merged;
        }

        void requireParts(const std::vector<BenchmarkLog> &parts, const std::vector<std::string> &names)
        {
            const BenchmarkLog &first = parts.front();
            const std::string campaign = campaignOf(first, names.front());
            for (std::size_t part = 1; part < parts.size(); ++part)
            {
                const BenchmarkLog &other = parts[part];
                requireSame("the experiment", first.experiment, other.experiment, names, part);
                requireSame("the seed", std::to_string(first.seed), std::to_string(other.seed), names, part);
                requireSame("OMPL's version", first.version, other.version, names, part);
                requireSame("the campaign", campaign, campaignOf(other, names[part]), names, part);
                requireSame("the number of planners", std::to_string(first.planners.size()),
                            std::to_string(other.planners.size()), names, part);
                for (std::size_t i = 0; i < first.planners.size(); ++i)
                {
                    requireSame("a planner", first.planners[i].name, other.planners[i].name, names, part);
                }
            }
        }
    }  // namespace

    BenchmarkLog mergeBenchmarkLogs(const std::vector<BenchmarkLog> &parts, const std::vector<std::string> &names,
                                    bool allowMissing)
    {
        if (parts.empty())
        {
            throw InputError("there is no log to join");
        }
        requireParts(parts, names);
        BenchmarkLog merged = parts.front();
        merged.properties.erase(SHARD);
        merged.duration = 0.0;
        std::set<std::string> hosts;
        std::set<std::string> cpus;
        for (const BenchmarkLog &part : parts)
        {
            merged.duration += part.duration;
            merged.start = std::min(merged.start, part.start);
            merged.setup = merged.setup.empty() ? part.setup : merged.setup;
            hosts.insert(part.host);
            cpus.insert(part.cpu);
        }
        merged.host = joinWords(hosts);
        merged.cpu.clear();
        for (const std::string &cpu : cpus)
        {
            merged.cpu += cpu;
        }
        merged.planners.clear();
        for (std::size_t which = 0; which < parts.front().planners.size(); ++which)
        {
            merged.planners.push_back(mergePlanner(which, parts, names, allowMissing));
        }
        return merged;
    }
}  // namespace ompl_mfa
