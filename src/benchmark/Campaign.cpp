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

#include <csignal>
#include <ctime>

#include <algorithm>
#include <deque>
#include <fstream>
#include <locale>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include <ompl/util/RandomNumbers.h>

#include "benchmark/CampaignProgress.h"
#include "benchmark/FileNames.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        volatile std::sig_atomic_t interruption = 0;

        void noteInterruption(int number)
        {
            interruption = number;
        }

        /* Turns the signals that ask a program to end into a note for as long as it lives. */
        class InterruptionNote
        {
        public:
            InterruptionNote()
            {
                interruption = 0;
                struct sigaction action = {};
                action.sa_handler = noteInterruption;
                for (std::size_t i = 0; i < COUNT; ++i)
                {
                    sigaction(SIGNALS[i], &action, &before_[i]);
                }
            }

            ~InterruptionNote()
            {
                for (std::size_t i = 0; i < COUNT; ++i)
                {
                    sigaction(SIGNALS[i], &before_[i], nullptr);
                }
            }

            InterruptionNote(const InterruptionNote &) = delete;
            InterruptionNote &operator=(const InterruptionNote &) = delete;

        private:
            static constexpr std::size_t COUNT = 3;
            static constexpr int SIGNALS[COUNT] = {SIGINT, SIGTERM, SIGHUP};
            struct sigaction before_[COUNT];
        };

        std::string wallClock()
        {
            const std::time_t now = std::time(nullptr);
            char text[32];
            std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S", std::localtime(&now));
            return text;
        }

        ob::PlannerStatus::StatusType statusOf(RunTermination termination)
        {
            switch (termination)
            {
                case RunTermination::TIME_LIMIT:
                    return ob::PlannerStatus::TIMEOUT;
                case RunTermination::MEMORY_LIMIT:
                    return ob::PlannerStatus::ABORT;
                default:
                    return ob::PlannerStatus::CRASH;
            }
        }

        /* What is left of a run that has not handed back a record. */
        RunRecord salvageRun(const RunProcess &process)
        {
            RunRecord record;
            const RunState &state = process.state();
            record.properties["solved BOOLEAN"] = "0";
            record.properties["status ENUM"] = std::to_string(static_cast<int>(statusOf(process.termination())));
            record.properties["time REAL"] = numberText(state.phase == RunPhase::SOLVING ? process.phaseTime() : 0.0);
            record.properties["collision checks INTEGER"] = std::to_string(state.collisionChecks);
            record.properties["time to first solution REAL"] = numberText(state.firstSolution);
            record.properties["final best cost REAL"] = numberText(state.bestCost);
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
                if (which == SavePaths::ALL)
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
                if (which == SavePaths::SHORTEST)
                {
                    savePath(stem + "." + fileNamePart(entry.first) + ".path", *entry.second);
                }
            }
        }

        void addToDigest(std::uint64_t &digest, const std::string &text)
        {
            // FNV-1a, 64 bits; the separator keeps "a", "bc" apart from "ab", "c".
            for (const char letter : text + '\0')
            {
                digest = (digest ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
            }
        }
    }  // namespace

    /* The state of Campaign::run(). */
    class Campaign::Execution
    {
    public:
        Execution(const Campaign &campaign, const CampaignOptions &options);

        CampaignResult run();

    private:
        struct Active
        {
            std::size_t planner;
            unsigned int run;
            std::unique_ptr<RunProcess> process;
            double start;
        };

        std::unique_ptr<RunJournal> openJournal(std::size_t expected) const;
        void start(std::size_t planner, unsigned int run);
        bool finish(Active &active);
        void showProgress();
        double secondsLeft() const;
        RunLimits limits() const;

        const Campaign &campaign_;
        const CampaignOptions &options_;
        std::string shard_;
        std::unique_ptr<RunJournal> journal_;
        std::deque<std::pair<std::size_t, unsigned int>> pending_;
        std::vector<Active> active_;
        std::unique_ptr<CampaignProgress> progress_;
        std::map<std::size_t, std::pair<double, unsigned int>> durations_;
        double lastEnd_{0.0};
    };

    Campaign::Execution::Execution(const Campaign &campaign, const CampaignOptions &options)
      : campaign_(campaign)
      , options_(options)
    {
        if (options_.shards > 1)
        {
            shard_ = std::to_string(options_.shard) + "/" + std::to_string(options_.shards);
        }
        const auto runs = campaign_.runs(options_.shard, options_.shards);
        const std::filesystem::path folder = options_.log.parent_path();
        std::error_code failed;
        if (!folder.empty() && !std::filesystem::is_directory(folder) &&
            !std::filesystem::create_directories(folder, failed))
        {
            throw InputError(folder.string() + ": cannot be made a folder: " + failed.message());
        }
        if (std::filesystem::exists(options_.log) && !std::filesystem::is_regular_file(options_.log))
        {
            throw InputError(options_.log.string() + ": is not a regular file; the log is to be one, or a new file");
        }
        journal_ = openJournal(runs.size());
        std::set<std::pair<std::string, unsigned int>> done;
        for (const RunRecord &record : journal_->records())
        {
            done.insert({record.planner, record.run});
        }
        for (const auto &entry : runs)
        {
            if (done.count({"geometric_" + campaign_.description_.planners[entry.first].name, entry.second}) == 0)
            {
                pending_.push_back(entry);
            }
        }
        progress_ = std::make_unique<CampaignProgress>(options_.progress, options_.terminal, runs.size(),
                                                       runs.size() - pending_.size());
    }

    std::unique_ptr<RunJournal> Campaign::Execution::openJournal(std::size_t expected) const
    {
        const std::filesystem::path file = journalFile(options_.log);
        const std::string fingerprint = campaign_.fingerprint();
        if (std::filesystem::exists(file) && !options_.overwrite)
        {
            auto journal = std::make_unique<RunJournal>(file);
            const bool same = journal->header().campaign == fingerprint && journal->header().shard == shard_;
            if (options_.resume && same)
            {
                return journal;
            }
            if (options_.resume)
            {
                throw InputError(file.string() +
                                 ": these runs are of another campaign, so it cannot be resumed: the "
                                 "config, a file that it names or the program has changed; --overwrite "
                                 "starts anew");
            }
            if (!same || journal->records().size() < expected)
            {
                throw InputError(file.string() + ": has " + std::to_string(journal->records().size()) +
                                 " runs of an interrupted campaign; --resume continues it, --overwrite starts anew");
            }
        }
        return std::make_unique<RunJournal>(file, JournalHeader{fingerprint, shard_, wallClock(), 0.0});
    }

    CampaignResult Campaign::Execution::run()
    {
        const InterruptionNote note;
        lastEnd_ = monotonicSeconds();
        while (interruption == 0 && (!pending_.empty() || !active_.empty()))
        {
            while (!pending_.empty() && active_.size() < options_.jobs)
            {
                start(pending_.front().first, pending_.front().second);
                pending_.pop_front();
            }
            active_.front().process->waitForOutput(0.01);
            active_.erase(std::remove_if(active_.begin(), active_.end(), [this](Active &run) { return finish(run); }),
                          active_.end());
            showProgress();
        }
        CampaignResult result;
        result.missing = pending_.size() + active_.size();
        result.interruptedBy = result.missing > 0 ? static_cast<int>(interruption) : 0;
        active_.clear();
        progress_->close();
        result.records = journal_->records();
        result.log = assembleLog(campaign_, result.records, journal_->header());
        writeBenchmarkLog(options_.log, result.log);
        savePaths(options_.log, campaign_.description_.savePaths, result.records);
        return result;
    }

    void Campaign::Execution::start(std::size_t planner, unsigned int run)
    {
        const CampaignDescription &description = campaign_.description_;
        const CampaignPlanner &entry = description.planners[planner];
        const std::uint32_t seed = runSeed(description.seed, run);
        const auto body = [&description, &entry, seed](RunState &state)
        { return writeRunRecord(measureRun(entry.makeProblem, entry.makePlanner, description.settings, seed, state)); };
        Active active{planner, run, nullptr, monotonicSeconds()};
        active.process = std::make_unique<RunProcess>(body, limits());
        active_.push_back(std::move(active));
    }

    bool Campaign::Execution::finish(Active &active)
    {
        RunProcess &process = *active.process;
        if (!process.update())
        {
            return false;
        }
        const bool returned = process.termination() == RunTermination::RETURNED;
        RunRecord record = returned ? readRunRecord(process.result()) : salvageRun(process);
        record.planner = "geometric_" + campaign_.description_.planners[active.planner].name;
        record.run = active.run;
        record.seed = runSeed(campaign_.description_.seed, active.run);
        record.termination = returned ? record.termination : process.termination();
        record.signal = process.signal();
        record.message = record.termination == RunTermination::RETURNED ? "" : process.console();
        record.properties["run INTEGER"] = std::to_string(record.run);
        record.properties["seed INTEGER"] = std::to_string(record.seed);
        record.properties["termination ENUM"] = std::to_string(static_cast<int>(record.termination));
        record.properties["signal INTEGER"] = record.signal == 0 ? "" : std::to_string(record.signal);

        const double now = monotonicSeconds();
        auto &duration = durations_[active.planner];
        duration.first += now - active.start;
        ++duration.second;
        progress_->finished(record);
        journal_->append(std::move(record), now - lastEnd_);
        lastEnd_ = now;
        return true;
    }

    void Campaign::Execution::showProgress()
    {
        if (!active_.empty())
        {
            const Active &oldest = active_.front();
            progress_->running(campaign_.description_.planners[oldest.planner].name, oldest.run, secondsLeft());
        }
    }

    double Campaign::Execution::secondsLeft() const
    {
        const auto expected = [this](std::size_t planner)
        {
            const auto found = durations_.find(planner);
            return found == durations_.end() ? campaign_.description_.settings.timeLimit
                                             : found->second.first / found->second.second;
        };
        double seconds = 0.0;
        for (const auto &entry : pending_)
        {
            seconds += expected(entry.first);
        }
        for (const Active &entry : active_)
        {
            seconds += std::max(0.0, expected(entry.planner) - (monotonicSeconds() - entry.start));
        }
        return seconds / options_.jobs;
    }

    RunLimits Campaign::Execution::limits() const
    {
        const RunSettings &settings = campaign_.description_.settings;
        RunLimits limits;
        limits.solve = settings.timeLimit + (options_.grace >= 0.0 ? options_.grace : 1.0 + 0.1 * settings.timeLimit);
        limits.memory = settings.memoryLimit;
        return limits;
    }

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
        description_.settings.keepPath = description_.savePaths != SavePaths::NONE;
    }

    void Campaign::validate() const
    {
        const auto body = [this](RunState &)
        {
            ompl::RNG::setSeed(runSeed(description_.seed, 0));
            for (const CampaignPlanner &planner : description_.planners)
            {
                planner.makePlanner(planner.makeProblem()->getSpaceInformation());
            }
            return std::string("valid");
        };
        RunProcess process(body, RunLimits());
        process.wait();
        if (process.termination() == RunTermination::EXCEPTION)
        {
            throw InputError(process.console());
        }
    }

    CampaignResult Campaign::run(const CampaignOptions &options) const
    {
        return Execution(*this, options).run();
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
        std::uint64_t digest = 0xcbf29ce484222325ULL;
        for (const std::string &text : {std::string(OMPL_MFA_OMPL_VERSION), std::string(OMPL_MFA_VERSION),
                                        description_.name, description_.identity, numbers.str()})
        {
            addToDigest(digest, text);
        }
        for (const CampaignPlanner &planner : description_.planners)
        {
            addToDigest(digest, planner.name);
        }
        std::ostringstream hex;
        hex.imbue(std::locale::classic());
        hex << std::hex << digest;
        return hex.str();
    }

    std::vector<std::pair<std::size_t, unsigned int>> Campaign::runs(unsigned int shard, unsigned int shards) const
    {
        std::vector<std::pair<std::size_t, unsigned int>> mine;
        const std::size_t planners = description_.planners.size();
        for (unsigned int run = 0; run < description_.runCount; ++run)
        {
            for (std::size_t planner = 0; planner < planners; ++planner)
            {
                // The turn by one planner a run spreads each planner over all parts when planners divides shards.
                const std::size_t index = run * planners + (planner + run) % planners;
                if (index % shards == shard - 1)
                {
                    mine.emplace_back(planner, run);
                }
            }
        }
        return mine;
    }

    const CampaignDescription &Campaign::description() const
    {
        return description_;
    }

    std::filesystem::path Campaign::journalFile(const std::filesystem::path &log)
    {
        return log.string() + ".journal";
    }
}  // namespace ompl_mfa
