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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_RUN_PROCESS_
#define OMPL_MFA_BENCHMARKS_ANYTIME_RUN_PROCESS_

#include <functional>
#include <memory>
#include <string>

#include <sys/types.h>

#include "anytime/PlannerRun.h"

namespace ompl_mfa::anytime
{
    /** \brief Executed in the process of the run. */
    using RunBody = std::function<void(const RunRequest &, RunResult &)>;

    /** \brief One run in a process of its own, bound to one core, so that planners with several threads get no more
        than the others. The process may crash, hang or eat memory: what it logged until then can be read. */
    class RunProcess
    {
    public:
        /** \brief Forks. \e core is a number as sched_setaffinity() takes it. Throws std::runtime_error where the
            system refuses. */
        RunProcess(const RunRequest &request, int core, const RunBody &body = runPlanner);

        /** \brief Kills the process if it still lives. */
        ~RunProcess();

        RunProcess(RunProcess &&other) noexcept;
        RunProcess &operator=(RunProcess &&) = delete;
        RunProcess(const RunProcess &) = delete;
        RunProcess &operator=(const RunProcess &) = delete;

        const RunRequest &request() const
        {
            return request_;
        }

        /** \brief Whether the process has ended; kills it when it is far beyond its time limit: half as much again and
            one second of its clock, six times and half a minute of the wall clock. */
        bool finished();

        /** \brief After the end: `returned`; `killed` (it did not return by itself); `signal NAME`; `exception` or
            `out of memory`, thrown by the planner; `bad request`. */
        const std::string &status() const
        {
            return status_;
        }

        /** \brief After the end: what an exception said, or the last line of the process' standard error. */
        const std::string &note() const
        {
            return note_;
        }

        const RunResult &result() const
        {
            return *result_;
        }

    private:
        void startChild(int core, const RunBody &body);
        bool isOverdue() const;
        void readStatus(int waitStatus);

        RunRequest request_;
        std::shared_ptr<RunResult> result_;
        int errors_{-1};
        double started_{0.0};
        pid_t pid_{-1};
        bool killed_{false};
        std::string status_;
        std::string note_;
    };
}  // namespace ompl_mfa::anytime

#endif
