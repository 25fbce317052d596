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

#include "benchmark/CampaignMerge.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        void requireSame(const std::string &what, const std::string &first, const std::string &other,
                         const std::vector<std::string> &names, std::size_t part)
        {
            if (first != other)
            {
                throw InputError(names[part] + ": not a part of the same campaign as " + names[0] + ": " + what +
                                 " is '" + other + "' there and '" + first + "' here");
            }
        }

        void requireSameCampaign(const std::vector<CampaignRuns> &parts, const std::vector<BenchmarkLog> &heads,
                                 const std::vector<std::string> &names)
        {
            const BenchmarkLog &first = heads.front();
            for (std::size_t part = 1; part < parts.size(); ++part)
            {
                const BenchmarkLog &other = heads[part];
                requireSame("the experiment", first.experiment, other.experiment, names, part);
                requireSame("the seed", std::to_string(first.seed), std::to_string(other.seed), names, part);
                requireSame("OMPL's version", first.version, other.version, names, part);
                requireSame("the number of planners", std::to_string(first.planners.size()),
                            std::to_string(other.planners.size()), names, part);
                for (std::size_t i = 0; i < first.planners.size(); ++i)
                {
                    requireSame("a planner", first.planners[i].name, other.planners[i].name, names, part);
                }
                requireSame("the campaign", parts.front().header.campaign, parts[part].header.campaign, names, part);
            }
        }

        /* All runs, sorted by planner and run number. */
        std::vector<RunRecord> joinRecords(const std::vector<CampaignRuns> &parts, const BenchmarkLog &head,
                                           const std::vector<std::string> &names, bool allowMissing)
        {
            // (planner, run) -> (index of the shard, record).
            std::map<std::pair<std::string, unsigned int>, std::pair<std::size_t, const RunRecord *>> places;
            for (std::size_t part = 0; part < parts.size(); ++part)
            {
                for (const RunRecord &record : parts[part].records)
                {
                    const auto added = places.insert({{record.planner, record.run}, {part, &record}});
                    if (!added.second)
                    {
                        throw InputError(names[part] + ": run " + std::to_string(record.run) + " of planner " +
                                         record.planner + " is in " + names[added.first->second.first] + " too");
                    }
                }
            }
            std::vector<RunRecord> joined;
            for (const PlannerLog &planner : head.planners)
            {
                for (unsigned int run = 0; run < head.runCount; ++run)
                {
                    const auto place = places.find({planner.name, run});
                    if (place != places.end())
                    {
                        joined.push_back(*place->second.second);
                    }
                    else if (!allowMissing)
                    {
                        throw InputError("run " + std::to_string(run) + " of planner " + planner.name +
                                         " is in none of the parts; --allow-missing joins them all the same");
                    }
                }
            }
            return joined;
        }

        std::string joinTexts(const std::set<std::string> &texts, const std::string &separator)
        {
            std::string joined;
            for (const std::string &text : texts)
            {
                joined += (joined.empty() ? "" : separator) + text;
            }
            return joined;
        }

        campaign::JournalHeader joinHeaders(const std::vector<CampaignRuns> &parts,
                                            const std::vector<BenchmarkLog> &heads)
        {
            campaign::JournalHeader joined = parts.front().header;
            joined.shard.clear();
            joined.duration = 0.0;
            std::set<std::string> hosts;
            std::set<std::string> cpus;
            for (std::size_t part = 0; part < parts.size(); ++part)
            {
                joined.duration += parts[part].header.duration;
                joined.start = std::min(joined.start, parts[part].header.start);
                hosts.insert(heads[part].host);
                cpus.insert(heads[part].cpu);
            }
            BenchmarkLog head = heads.front();
            head.host = joinTexts(hosts, ",");
            head.cpu = joinTexts(cpus, "");
            joined.description = toJson(head);
            return joined;
        }

        /* The journal of a log, or the file itself. */
        std::filesystem::path journalOf(const std::string &part)
        {
            std::filesystem::path beside = Campaign::journalFile(part);
            if (std::filesystem::exists(beside))
            {
                return beside;
            }
            std::ifstream in(part);
            if (in && in.peek() != '{')
            {
                throw InputError(part + ": is no journal, and there is no " + beside.string() +
                                 ": parts are joined from the journals that 'ompl_mfa benchmark' leaves beside its "
                                 "logs");
            }
            return part;
        }

        void requireNoOtherCampaign(const std::filesystem::path &journal, const std::string &campaign)
        {
            if (std::filesystem::exists(journal) &&
                campaign::RunJournal(journal, [](const campaign::Json &, std::size_t) {}).header().campaign != campaign)
            {
                throw InputError(journal.string() + ": has the runs of another campaign; --output needs another name");
            }
        }

        void writeJournal(const std::filesystem::path &file, const CampaignRuns &runs)
        {
            const std::filesystem::path unfinished = file.string() + ".unfinished";
            {
                campaign::RunJournal journal(unfinished, runs.header);
                for (const RunRecord &record : runs.records)
                {
                    journal.append(toJson(record), record.duration);
                }
            }
            std::error_code failed;
            std::filesystem::rename(unfinished, file, failed);
            if (failed)
            {
                throw InputError(file.string() + ": cannot be written: " + failed.message());
            }
        }
    }  // namespace

    CampaignRuns mergeRuns(const std::vector<CampaignRuns> &parts, const std::vector<std::string> &names,
                           bool allowMissing)
    {
        if (parts.empty())
        {
            throw InputError("there is no part to join");
        }
        std::vector<BenchmarkLog> heads;
        heads.reserve(parts.size());
        for (const CampaignRuns &part : parts)
        {
            heads.push_back(logHeadFrom(part.header.description));
        }
        requireSameCampaign(parts, heads, names);
        CampaignRuns merged;
        merged.records = joinRecords(parts, heads.front(), names, allowMissing);
        merged.header = joinHeaders(parts, heads);
        return merged;
    }

    BenchmarkLog mergeCampaign(const std::vector<std::string> &parts, const std::filesystem::path &output,
                               bool allowMissing)
    {
        std::vector<CampaignRuns> runs;
        std::vector<std::string> names;
        for (const std::string &part : parts)
        {
            const std::filesystem::path journal = journalOf(part);
            runs.push_back(readCampaignRuns(journal));
            names.push_back(journal.string());
        }
        const CampaignRuns merged = mergeRuns(runs, names, allowMissing);
        BenchmarkLog log = assembleLog(merged);
        requireNoOtherCampaign(Campaign::journalFile(output), merged.header.campaign);
        writeBenchmarkLog(output, log);
        writeJournal(Campaign::journalFile(output), merged);
        return log;
    }
}  // namespace ompl_mfa::benchmark
