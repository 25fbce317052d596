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

#include "campaign/Campaign.h"

#include <sched.h>

#include <csignal>
#include <ctime>

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <utility>

#include "campaign/Progress.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::campaign
{
    namespace
    {
        volatile std::sig_atomic_t interruption = 0;

        void noteInterruption(int number)
        {
            interruption = number;
        }

        /* Records termination signals during its lifetime instead of letting them end the program. */
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

        /* The cores this process may use, first its current one, which the scheduler found the least busy. */
        std::deque<int> availableCores()
        {
            cpu_set_t set;
            CPU_ZERO(&set);
            sched_getaffinity(0, sizeof(set), &set);
            std::deque<int> cores;
            for (int core = 0; core < CPU_SETSIZE; ++core)
            {
                if (CPU_ISSET(static_cast<std::size_t>(core), &set))
                {
                    cores.push_back(core);
                }
            }
            const auto here = std::find(cores.begin(), cores.end(), sched_getcpu());
            if (here != cores.end())
            {
                std::rotate(cores.begin(), here, cores.end());
            }
            return cores;
        }

        /* The cores for runs, one per simultaneous run. */
        std::deque<int> coresFor(const RunOptions &options)
        {
            if (!options.bindToCores)
            {
                return std::deque<int>(options.jobs, RunProcess::ANY_CORE);
            }
            std::deque<int> cores = availableCores();
            if (options.jobs > cores.size())
            {
                throw InputError("--jobs " + std::to_string(options.jobs) + ": accepted are 1 to " +
                                 std::to_string(cores.size()) + ", the number of cores");
            }
            cores.resize(options.jobs);
            return cores;
        }

        /* The values in \e record of the fields that \e key has. */
        std::string keyOf(const Json &record, const Json &key)
        {
            Json values = Json::array();
            for (const auto &field : key.items())
            {
                values.push_back(record.at(field.key()));
            }
            return jsonLine(values);
        }

        /* A campaign in progress. */
        class Execution
        {
        public:
            Execution(JournalHeader header, const std::vector<Task> &tasks, const RunOptions &options);

            RunsMade run();

        private:
            struct Active
            {
                const Task *task;
                int core;
                Work work;
                std::unique_ptr<RunProcess> process;
                double start;
            };

            void openJournal(JournalHeader header);
            void start(const Task &task);
            bool finish(Active &active);
            void waitForOutput() const;
            double secondsLeft() const;

            const RunOptions &options_;
            std::deque<int> cores_;
            std::deque<const Task *> pending_;
            std::unique_ptr<RunJournal> journal_;
            std::vector<Active> active_;
            std::unique_ptr<Progress> progress_;
            /* Total seconds and number of the finished runs of each group. */
            std::map<std::string, std::pair<double, unsigned int>> durations_;
            double lastEnd_{0.0};
        };

        Execution::Execution(JournalHeader header, const std::vector<Task> &tasks, const RunOptions &options)
          : options_(options)
        {
            if (options_.jobs == 0)
            {
                throw InputError("--jobs 0: a campaign needs at least one run at a time");
            }
            cores_ = coresFor(options_);
            for (const std::size_t index : shareOf(tasks.size(), options_.shard, options_.shards))
            {
                pending_.push_back(&tasks[index]);
            }
            const std::size_t total = pending_.size();
            openJournal(std::move(header));
            progress_ =
                std::make_unique<Progress>(options_.progress, options_.terminal, total, total - pending_.size());
        }

        /* Keeps only those tasks pending whose runs are not in the journal. */
        void Execution::openJournal(JournalHeader header)
        {
            const std::filesystem::path &file = options_.journal;
            header.start = wallClock();
            header.shard =
                options_.shards > 1 ? std::to_string(options_.shard) + "/" + std::to_string(options_.shards) : "";
            std::error_code failed;
            if (!options_.overwrite && std::filesystem::file_size(file, failed) > 0 && !failed)
            {
                const Json key = pending_.empty() ? Json::object() : pending_.front()->key;
                std::set<std::string> done;
                std::size_t runs = 0;
                const auto isDone = [&](const Task *task) { return done.count(keyOf(task->key, key)) > 0; };
                journal_ = std::make_unique<RunJournal>(file,
                                                        [&](const Json &record, std::size_t)
                                                        {
                                                            done.insert(keyOf(record, key));
                                                            ++runs;
                                                        });
                const bool same =
                    journal_->header().campaign == header.campaign && journal_->header().shard == header.shard;
                if (options_.resume && !same)
                {
                    throw InputError(file.string() +
                                     ": these runs are of another campaign, so it cannot be resumed: the "
                                     "config, a file that it names or the program has changed; --overwrite "
                                     "discards them");
                }
                if (options_.resume)
                {
                    pending_.erase(std::remove_if(pending_.begin(), pending_.end(), isDone), pending_.end());
                    return;
                }
                if (!same || !std::all_of(pending_.begin(), pending_.end(), isDone))
                {
                    throw InputError(file.string() + ": has " + std::to_string(runs) +
                                     " runs of an interrupted campaign; --resume continues it, --overwrite discards "
                                     "them");
                }
                journal_.reset();
            }
            journal_ = std::make_unique<RunJournal>(file, std::move(header));
        }

        RunsMade Execution::run()
        {
            const InterruptionNote note;
            lastEnd_ = monotonicSeconds();
            while (interruption == 0 && (!pending_.empty() || !active_.empty()))
            {
                while (!pending_.empty() && !cores_.empty())
                {
                    start(*pending_.front());
                    pending_.pop_front();
                }
                waitForOutput();
                active_.erase(
                    std::remove_if(active_.begin(), active_.end(), [this](Active &run) { return finish(run); }),
                    active_.end());
                if (!active_.empty() && progress_->isDue())
                {
                    progress_->running(active_.front().task->name, secondsLeft());
                }
            }
            RunsMade made;
            made.missing = pending_.size() + active_.size();
            made.interruptedBy = made.missing > 0 ? static_cast<int>(interruption) : 0;
            active_.clear();
            progress_->close();
            made.header = journal_->header();
            return made;
        }

        void Execution::start(const Task &task)
        {
            Active active{&task, cores_.front(), task.makeWork(), nullptr, monotonicSeconds()};
            active.process =
                std::make_unique<RunProcess>(active.work.body, active.work.limits, active.work.state, active.core);
            cores_.pop_front();
            active_.push_back(std::move(active));
        }

        bool Execution::finish(Active &active)
        {
            const RunProcess &process = *active.process;
            if (!active.process->update())
            {
                return false;
            }
            if (process.refused())
            {
                throw InputError(process.lastLine());
            }
            RunReport report = active.work.report(process);
            Json record = active.task->key;
            record.update(report.record);

            const double now = monotonicSeconds();
            auto &duration = durations_[active.task->group];
            duration.first += now - active.start;
            ++duration.second;
            journal_->append(std::move(record), now - lastEnd_);
            lastEnd_ = now;
            progress_->finished(active.task->name, report.text, report.failed);
            cores_.push_back(active.core);
            return true;
        }

        void Execution::waitForOutput() const
        {
            std::vector<const RunProcess *> processes;
            processes.reserve(active_.size());
            for (const Active &active : active_)
            {
                processes.push_back(active.process.get());
            }
            RunProcess::waitForOutput(processes, 0.01);
        }

        double Execution::secondsLeft() const
        {
            const auto expected = [this](const Task &task)
            {
                const auto found = durations_.find(task.group);
                return found == durations_.end() ? task.expected : found->second.first / found->second.second;
            };
            double seconds = 0.0;
            for (const Task *task : pending_)
            {
                seconds += expected(*task);
            }
            for (const Active &active : active_)
            {
                seconds += std::max(0.0, expected(*active.task) - (monotonicSeconds() - active.start));
            }
            return seconds / options_.jobs;
        }
    }  // namespace

    RunsMade makeRuns(JournalHeader header, const std::vector<Task> &tasks, const RunOptions &options)
    {
        return Execution(std::move(header), tasks, options).run();
    }

    std::vector<std::size_t> shareOf(std::size_t count, unsigned int shard, unsigned int shards)
    {
        std::vector<std::size_t> indices;
        for (std::size_t index = shard - 1; index < count; index += shards)
        {
            indices.push_back(index);
        }
        return indices;
    }
}  // namespace ompl_mfa::campaign
