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

#include "benchmark/CampaignLog.h"

#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <ompl/base/PlannerStatus.h>
#include <ompl/tools/benchmark/MachineSpecs.h>

#include "ompl_mfa/InputError.h"

namespace ob = ompl::base;
using ompl_mfa::campaign::JournalHeader;
using ompl_mfa::campaign::Json;

namespace ompl_mfa::benchmark
{
    namespace
    {
        const std::string PLANNER_SECTION = "Properties of benchmarked planners:";

        LogEnum statusNames()
        {
            LogEnum names{"status", {}};
            for (int i = 0; i < ob::PlannerStatus::TYPE_COUNT; ++i)
            {
                const auto status = static_cast<ob::PlannerStatus::StatusType>(i);
                std::string name = ob::PlannerStatus(status).asString();
                // OMPL has no names for its newer values, and Planner Arena needs distinct ones.
                if (i > ob::PlannerStatus::CRASH && name == ob::PlannerStatus().asString())
                {
                    name = status == ob::PlannerStatus::ABORT ? "Abort" : "Infeasible";
                }
                names.names.push_back(name);
            }
            return names;
        }

        LogEnum terminationNames()
        {
            return {
                "termination",
                {"Returned", "Exception", "Process exited", "Signal", "Time limit enforced", "Memory limit enforced"}};
        }

        /* Planner Arena joins the tables of runs and progress, and draws the wrong one of two columns with the same
           name. */
        void renameProgressDuplicates(const std::set<std::string> &progressNames, LogProperties &run)
        {
            for (const std::string &name : progressNames)
            {
                const auto found = run.find(name);
                if (found != run.end())
                {
                    run.insert({"final " + name, found->second});
                    run.erase(found);
                }
            }
        }

        PlannerLog assemblePlanner(const std::string &name, const std::map<unsigned int, const RunRecord *> &runs,
                                   const std::set<std::string> &progressNames)
        {
            PlannerLog planner;
            planner.name = name;
            for (const auto &entry : runs)
            {
                const RunRecord &record = *entry.second;
                planner.common.insert(record.common.begin(), record.common.end());
                planner.progressNames = planner.progressNames.empty() ? record.progressNames : planner.progressNames;
                planner.runs.push_back(record.properties);
                renameProgressDuplicates(progressNames, planner.runs.back());
            }
            for (const auto &entry : runs)
            {
                const RunRecord &record = *entry.second;
                if (!planner.progressNames.empty())
                {
                    planner.progress.push_back(record.progressNames == planner.progressNames
                                                   ? record.progress
                                                   : std::vector<ProgressSample>());
                }
            }
            return planner;
        }

        std::string describeLimits(const CampaignDescription &description)
        {
            std::string text =
                "Campaign:\n  Each run is a process of its own.\n"
                "  Run k (from 0) of every planner: seed = SplitMix64 output number k + 1 of base seed " +
                std::to_string(description.seed) + ", folded to [1, 2^31 - 1]; property 'seed' of each run.\n";
            if (description.settings.iterationLimit > 0)
            {
                text += "  Evaluations of the termination condition: at most " +
                        std::to_string(description.settings.iterationLimit) + " a run.\n";
            }
            return text;
        }

        std::string assembleSetup(const std::string &limits, const std::vector<RunRecord> &records)
        {
            std::string problem;
            std::map<std::string, std::string> planners;
            for (const RunRecord &record : records)
            {
                const std::size_t section = record.setup.find(PLANNER_SECTION);
                if (section != std::string::npos)
                {
                    problem = record.setup.substr(0, section);
                    planners[record.planner] = record.setup.substr(section + PLANNER_SECTION.size() + 1);
                }
            }
            std::string text = problem + PLANNER_SECTION + "\n";
            for (const auto &planner : planners)
            {
                text += planner.second;
            }
            return text + limits;
        }

        LogProperties experimentProperties(const CampaignDescription &description)
        {
            LogProperties properties;
            properties["base_seed INTEGER"] = std::to_string(description.seed);
            properties["run_seed TEXT"] = "splitmix64(base_seed+run)";
            properties["ompl_mfa_version TEXT"] = OMPL_MFA_VERSION;
            if (description.settings.iterationLimit > 0)
            {
                properties["iteration_limit INTEGER"] = std::to_string(description.settings.iterationLimit);
            }
            return properties;
        }
    }  // namespace

    JournalHeader makeJournalHeader(const Campaign &campaign)
    {
        const CampaignDescription &description = campaign.description();
        BenchmarkLog log;
        log.version = OMPL_MFA_OMPL_VERSION;
        log.experiment = description.name;
        log.properties = experimentProperties(description);
        log.host = ompl::machine::getHostname();
        log.setup = describeLimits(description);
        log.cpu = ompl::machine::getCPUInfo();
        log.seed = description.seed;
        log.timeLimit = description.settings.timeLimit;
        log.memoryLimit = description.settings.memoryLimit;
        log.runCount = description.runCount;
        log.enums = {statusNames(), terminationNames()};
        for (const CampaignPlanner &planner : description.planners)
        {
            log.planners.emplace_back();
            log.planners.back().name = "geometric_" + planner.name;
        }
        JournalHeader header;
        header.campaign = campaign.fingerprint();
        header.description = toJson(log);
        return header;
    }

    CampaignRuns readCampaignRuns(const std::filesystem::path &file)
    {
        CampaignRuns runs;
        runs.header = campaign::readJournal(
            file, [&runs](const Json &record, std::size_t) { runs.records.push_back(runRecordFrom(record)); });
        try
        {
            logHeadFrom(runs.header.description);
        }
        catch (const std::invalid_argument &error)
        {
            throw InputError(file.string() + ":1: " + error.what());
        }
        return runs;
    }

    Json toJson(const BenchmarkLog &logHead)
    {
        Json enums = Json::array();
        for (const LogEnum &entry : logHead.enums)
        {
            enums.push_back({{"property", entry.property}, {"names", entry.names}});
        }
        Json planners = Json::array();
        for (const PlannerLog &planner : logHead.planners)
        {
            planners.push_back(planner.name);
        }
        return {{"version", logHead.version},
                {"experiment", logHead.experiment},
                {"properties", logHead.properties},
                {"host", logHead.host},
                {"cpu", logHead.cpu},
                {"setup", logHead.setup},
                {"seed", logHead.seed},
                {"time_limit", logHead.timeLimit},
                {"memory_limit", logHead.memoryLimit},
                {"run_count", logHead.runCount},
                {"enums", enums},
                {"planners", planners}};
    }

    BenchmarkLog logHeadFrom(const Json &description)
    {
        try
        {
            BenchmarkLog log;
            description.at("version").get_to(log.version);
            description.at("experiment").get_to(log.experiment);
            description.at("properties").get_to(log.properties);
            description.at("host").get_to(log.host);
            description.at("cpu").get_to(log.cpu);
            description.at("setup").get_to(log.setup);
            description.at("seed").get_to(log.seed);
            description.at("time_limit").get_to(log.timeLimit);
            description.at("memory_limit").get_to(log.memoryLimit);
            description.at("run_count").get_to(log.runCount);
            for (const Json &entry : description.at("enums"))
            {
                log.enums.push_back({entry.at("property"), entry.at("names")});
            }
            for (const Json &name : description.at("planners"))
            {
                log.planners.emplace_back();
                name.get_to(log.planners.back().name);
            }
            return log;
        }
        catch (const Json::exception &error)
        {
            throw std::invalid_argument(std::string("not the journal of 'ompl_mfa benchmark': ") + error.what());
        }
    }

    BenchmarkLog assembleLog(const CampaignRuns &campaignRuns)
    {
        const JournalHeader &header = campaignRuns.header;
        std::map<std::string, std::map<unsigned int, const RunRecord *>> runs;
        std::set<std::string> progressNames;
        for (const RunRecord &record : campaignRuns.records)
        {
            runs[record.planner][record.run] = &record;
            progressNames.insert(record.progressNames.begin(), record.progressNames.end());
        }

        BenchmarkLog log = logHeadFrom(header.description);
        log.properties["campaign TEXT"] = header.campaign;
        if (!header.shard.empty())
        {
            log.properties["shard TEXT"] = header.shard;
        }
        log.start = header.start;
        log.setup = assembleSetup(log.setup, campaignRuns.records);
        log.duration = header.duration;
        for (PlannerLog &planner : log.planners)
        {
            planner = assemblePlanner(planner.name, runs[planner.name], progressNames);
        }
        return log;
    }
}  // namespace ompl_mfa::benchmark
