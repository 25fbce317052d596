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

#include "ompl_mfa/benchmark/Campaign.h"

#include <algorithm>
#include <fstream>
#include <locale>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include <ompl/util/RandomNumbers.h>

#include "benchmark/CampaignLog.h"
#include "benchmark/FileNames.h"
#include "benchmark/MeasuredRun.h"
#include "benchmark/RunText.h"
#include "campaign/Campaign.h"
#include "campaign/Digest.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/ResultsDatabase.h"
#include "text/NumberText.h"

namespace ob = ompl::base;
using ompl_mfa::campaign::RunProcess;

namespace ompl_mfa::benchmark
{
    namespace
    {
        ob::PlannerStatus::StatusType statusOf(RunTermination termination)
        {
            switch (termination)
            {
                case RunTermination::TimeLimit:
                    return ob::PlannerStatus::TIMEOUT;
                case RunTermination::MemoryLimit:
                    return ob::PlannerStatus::ABORT;
                default:
                    return ob::PlannerStatus::CRASH;
            }
        }

        /* The record of a run that returned none, from its shared state. */
        RunRecord salvageRun(const RunProcess &process, const RunState &state)
        {
            RunRecord record;
            record.properties["solved BOOLEAN"] = "0";
            record.properties["status ENUM"] = std::to_string(static_cast<int>(statusOf(process.termination())));
            record.properties["time REAL"] =
                text::numberText(state.phase == RunPhase::Solving ? process.phaseTime() : 0.0);
            record.properties["collision checks INTEGER"] = std::to_string(state.collisionChecks);
            record.properties["time to first solution REAL"] = text::numberText(state.firstSolution);
            record.properties["final best cost REAL"] = text::numberText(state.bestCost);
            return record;
        }

        void savePath(const std::filesystem::path &file, const RunRecord &record)
        {
            std::ofstream out(file);
            out << record.path;
            if (!out)
            {
                throw InputError(file.string() + ": cannot be written");
            }
        }

        void savePaths(const std::filesystem::path &log, SavePaths which, const std::vector<RunRecord> &records)
        {
            const std::string stem = (log.parent_path() / log.stem()).string();
            std::map<std::string, const RunRecord *> best;
            for (const RunRecord &record : records)
            {
                if (record.path.empty())
                {
                    continue;
                }
                if (which == SavePaths::All)
                {
                    savePath(stem + "." + fileNamePart(record.planner) + "." + std::to_string(record.run) + ".path",
                             record);
                }
                const RunRecord *&shortest = best[record.planner];
                if (shortest == nullptr || record.pathCost < shortest->pathCost)
                {
                    shortest = &record;
                }
            }
            for (const auto &entry : best)
            {
                if (which == SavePaths::Shortest)
                {
                    savePath(stem + "." + fileNamePart(entry.first) + ".path", *entry.second);
                }
            }
        }

        std::string logName(const CampaignPlanner &planner)
        {
            return "geometric_" + planner.name;
        }

        campaign::RunLimits limitsOf(const RunSettings &settings, double grace)
        {
            campaign::RunLimits limits;
            limits.solve = settings.timeLimit + (grace >= 0.0 ? grace : 1.0 + 0.1 * settings.timeLimit);
            limits.memory = settings.memoryLimit;
            return limits;
        }

        /* The record of run \e run of \e planner for the journal, after its process has ended. */
        RunRecord recordOf(const RunProcess &process, const RunState &state, const CampaignPlanner &planner,
                           unsigned int run, std::uint32_t seed)
        {
            const bool returned = process.termination() == RunTermination::Returned;
            RunRecord record = returned ? readRunRecord(process.result()) : salvageRun(process, state);
            record.planner = logName(planner);
            record.run = run;
            record.seed = seed;
            record.termination = returned ? record.termination : process.termination();
            record.signal = process.signal();
            record.message = record.termination == RunTermination::Returned ? "" : process.console();
            record.properties["run INTEGER"] = std::to_string(record.run);
            record.properties["seed INTEGER"] = std::to_string(record.seed);
            record.properties["termination ENUM"] = std::to_string(static_cast<int>(record.termination));
            record.properties["signal INTEGER"] = record.signal == 0 ? "" : std::to_string(record.signal);
            return record;
        }

        std::size_t problemOf(const CampaignDescription &description, unsigned int run)
        {
            return description.problems.empty() ? 0 : run % description.problems.size();
        }

        campaign::Task makeTask(const CampaignDescription &description, const CampaignPlanner &planner,
                                unsigned int run, double grace)
        {
            const std::uint32_t seed = runSeed(description.seed, run);
            const std::size_t problem = problemOf(description, run);
            campaign::Task task;
            task.key = {{"planner", logName(planner)}, {"run", run}};
            task.name = planner.name + ", run " + std::to_string(run + 1);
            task.group = planner.name;
            task.expected = description.settings.timeLimit;
            task.makeWork = [&description, &planner, run, seed, problem, grace]
            {
                const auto state = campaign::makeShared<RunState>();
                campaign::Work work;
                work.state = state;
                work.limits = limitsOf(description.settings, grace);
                work.body = [&description, &planner, seed, problem, state]
                {
                    return writeRunRecord(measureRun([&planner, problem] { return planner.makeProblem(problem); },
                                                     planner.makePlanner, description.settings, seed, *state));
                };
                work.report = [&description, &planner, run, seed, problem, state](const RunProcess &process)
                {
                    RunRecord record = recordOf(process, *state, planner, run, seed);
                    if (!description.problems.empty())
                    {
                        const LogProperties &properties = description.problems[problem];
                        record.properties.insert(properties.begin(), properties.end());
                    }
                    return campaign::RunReport{toJson(record), describeRun(record),
                                               record.termination != RunTermination::Returned};
                };
                return work;
            };
            return task;
        }

        void requireLogFile(const std::filesystem::path &log)
        {
            const std::filesystem::path folder = log.parent_path();
            std::error_code failed;
            if (!folder.empty() && !std::filesystem::is_directory(folder) &&
                !std::filesystem::create_directories(folder, failed))
            {
                throw InputError(folder.string() + ": cannot be made a folder: " + failed.message());
            }
            if (std::filesystem::exists(log) && !std::filesystem::is_regular_file(log))
            {
                throw InputError(log.string() + ": is not a regular file; the log is to be one, or a new file");
            }
        }
    }  // namespace

    Campaign::Campaign(CampaignDescription description)
      : description_(std::move(description))
    {
        if (description_.planners.empty())
        {
            throw InputError(description_.name + ": there is no planner to run");
        }
        if (description_.runCount == 0)
        {
            throw InputError(description_.name + ": run_count = 0: a campaign needs at least one run");
        }
        std::set<std::string> names;
        for (const CampaignPlanner &planner : description_.planners)
        {
            if (!names.insert(planner.name).second)
            {
                throw InputError(description_.name + ": two planners have the name " + planner.name +
                                 "; each configuration needs its own");
            }
        }
        description_.settings.keepPath = description_.savePaths != SavePaths::None;
    }

    void Campaign::validate() const
    {
        const auto body = [this]
        {
            ompl::RNG::setSeed(runSeed(description_.seed, 0));
            for (const CampaignPlanner &planner : description_.planners)
            {
                planner.makePlanner(planner.makeProblem(0)->getSpaceInformation());
            }
            for (std::size_t problem = 1; problem < description_.problems.size(); ++problem)
            {
                description_.planners.front().makeProblem(problem);
            }
            return std::string("valid");
        };
        RunProcess process(body, campaign::RunLimits(), campaign::makeShared<campaign::RunState>());
        process.wait();
        if (process.termination() == RunTermination::Exception)
        {
            throw InputError(process.lastLine());
        }
    }

    CampaignResult Campaign::run(const CampaignOptions &options) const
    {
        requireLogFile(options.log);
        if (!options.database.empty())
        {
            prepareDatabase(options.database);
        }
        std::vector<campaign::Task> tasks;
        for (const auto &entry : runs())
        {
            tasks.push_back(makeTask(description_, description_.planners[entry.first], entry.second, options.grace));
        }
        campaign::RunOptions runOptions;
        runOptions.journal = journalFile(options.log);
        runOptions.jobs = options.jobs;
        runOptions.shard = options.shard;
        runOptions.shards = options.shards;
        runOptions.resume = options.resume;
        runOptions.overwrite = options.overwrite;
        runOptions.progress = options.progress;
        runOptions.terminal = options.terminal;
        const campaign::RunsMade made = campaign::makeRuns(makeJournalHeader(*this), tasks, runOptions);

        const CampaignRuns runs = readCampaignRuns(runOptions.journal);
        CampaignResult result;
        result.missing = made.missing;
        result.interruptedBy = made.interruptedBy;
        result.log = assembleLog(runs);
        writeBenchmarkLog(options.log, result.log);
        savePaths(options.log, description_.savePaths, runs.records);
        if (!options.database.empty())
        {
            addToDatabase(options.database, result.log);
        }
        return result;
    }

    std::string Campaign::fingerprint() const
    {
        std::ostringstream numbers;
        const RunSettings &settings = description_.settings;
        numbers.imbue(std::locale::classic());
        numbers.precision(17);
        numbers << settings.timeLimit << ' ' << settings.memoryLimit << ' ' << settings.progressInterval << ' '
                << settings.iterationLimit << ' ' << settings.simplify << ' ' << description_.runCount << ' '
                << description_.seed << ' ' << static_cast<int>(description_.savePaths);
        std::vector<std::string> texts{OMPL_MFA_OMPL_VERSION, OMPL_MFA_VERSION, description_.name,
                                       description_.identity, numbers.str()};
        for (const LogProperties &problem : description_.problems)
        {
            for (const auto &property : problem)
            {
                texts.push_back(property.first + " = " + property.second);
            }
        }
        for (const CampaignPlanner &planner : description_.planners)
        {
            texts.push_back(planner.name);
        }
        return campaign::digestOf(texts);
    }

    std::vector<std::pair<std::size_t, unsigned int>> Campaign::runs() const
    {
        std::vector<std::pair<std::size_t, unsigned int>> all;
        const std::size_t planners = description_.planners.size();
        for (unsigned int run = 0; run < description_.runCount; ++run)
        {
            for (std::size_t turn = 0; turn < planners; ++turn)
            {
                // Rotating the order by one planner per run gives every shard runs of each planner, even if the number
                // of shards is a multiple of the number of planners.
                all.emplace_back((turn + planners - run % planners) % planners, run);
            }
        }
        return all;
    }

    const CampaignDescription &Campaign::description() const
    {
        return description_;
    }

    std::filesystem::path Campaign::journalFile(const std::filesystem::path &log)
    {
        return log.string() + ".journal";
    }
}  // namespace ompl_mfa::benchmark
