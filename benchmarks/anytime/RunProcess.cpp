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

#include "anytime/RunProcess.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <new>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        [[maybe_unused]] constexpr rlim_t MEMORY_LIMIT = rlim_t{4} << 30;

        constexpr int EXIT_EXCEPTION = 3;
        constexpr int EXIT_OUT_OF_MEMORY = 4;

        std::shared_ptr<RunResult> makeSharedResult()
        {
            void *memory = mmap(nullptr, sizeof(RunResult), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
            if (memory == MAP_FAILED)
                throw std::runtime_error(std::string("no memory to share with a run: ") + std::strerror(errno));
            return {new (memory) RunResult, [](RunResult *result) { munmap(result, sizeof(RunResult)); }};
        }

        /* The process dies with its parent, leaves no core, and is quiet. */
        void prepareProcess(int core, int errors)
        {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            const rlimit noCore{0, 0};
            setrlimit(RLIMIT_CORE, &noCore);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
            // sanitizers reserve far more addresses than they use
            const rlimit memory{MEMORY_LIMIT, MEMORY_LIMIT};
            setrlimit(RLIMIT_AS, &memory);
#endif
            cpu_set_t cores;
            CPU_ZERO(&cores);
            CPU_SET(core, &cores);
            sched_setaffinity(0, sizeof(cores), &cores);
            const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
            dup2(nowhere, STDOUT_FILENO);
            dup2(errors, STDERR_FILENO);
        }

        /* What a process that aborts has to say: failed assertions, uncaught exceptions. */
        std::string lastLine(int file)
        {
            char text[4096];
            const off_t size = lseek(file, 0, SEEK_END);
            const off_t first = std::max<off_t>(0, size - static_cast<off_t>(sizeof(text)));
            const ssize_t count = pread(file, text, sizeof(text), first);
            std::string tail(text, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
            tail.erase(tail.find_last_not_of('\n') + 1);
            return tail.substr(tail.find_last_of('\n') + 1);
        }

        void note(RunResult &result, const char *text)
        {
            std::strncpy(result.note, text, sizeof(result.note) - 1);
        }

        int guarded(const RunBody &body, const RunRequest &request, RunResult &result)
        {
            try
            {
                body(request, result);
                return 0;
            }
            catch (const InputError &error)
            {
                result.stage = Stage::BAD_REQUEST;
                note(result, error.what());
                return EXIT_EXCEPTION;
            }
            catch (const std::bad_alloc &)
            {
                return EXIT_OUT_OF_MEMORY;
            }
            catch (const std::exception &error)
            {
                note(result, error.what());
                return EXIT_EXCEPTION;
            }
        }
    }  // namespace

    RunProcess::RunProcess(const RunRequest &request, int core, const RunBody &body)
      : request_(request)
      , result_(makeSharedResult())
      , errors_(memfd_create("stderr of a run", MFD_CLOEXEC))
      , started_(wallTime())
    {
        pid_ = fork();
        if (pid_ < 0)
            throw std::runtime_error(std::string("no process for a run: ") + std::strerror(errno));
        if (pid_ == 0)
            startChild(core, body);
    }

    RunProcess::RunProcess(RunProcess &&other) noexcept
      : request_(std::move(other.request_))
      , result_(std::move(other.result_))
      , errors_(std::exchange(other.errors_, -1))
      , started_(other.started_)
      , pid_(std::exchange(other.pid_, -1))
      , killed_(other.killed_)
      , status_(std::move(other.status_))
    {
    }

    RunProcess::~RunProcess()
    {
        if (pid_ > 0)
        {
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
        if (errors_ >= 0)
            close(errors_);
    }

    void RunProcess::startChild(int core, const RunBody &body)
    {
        prepareProcess(core, errors_);
        // no destructor of the parent's objects may run here, and planners that crash in theirs have done their run
        _exit(guarded(body, request_, *result_));
    }

    bool RunProcess::finished()
    {
        if (pid_ <= 0)
            return true;
        int waitStatus = 0;
        if (waitpid(pid_, &waitStatus, WNOHANG) == pid_)
        {
            pid_ = -1;
            readStatus(waitStatus);
            note_ = result_->note[0] != '\0' ? result_->note : lastLine(errors_);
            return true;
        }
        if (!killed_ && isOverdue())
        {
            killed_ = true;
            kill(pid_, SIGKILL);
        }
        return false;
    }

    bool RunProcess::isOverdue() const
    {
        const double grace = 1.5 * request_.timeLimit + 1.0;
        if (wallTime() - started_ > 6.0 * request_.timeLimit + 30.0)
            return true;
        if (result_->stage == Stage::PREPARING)
            return false;
        clockid_t clock{};
        timespec time{};
        if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0)
            return false;
        const double cpu = static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        return cpu - result_->cpuBefore > grace;
    }

    void RunProcess::readStatus(int waitStatus)
    {
        if (result_->stage == Stage::BAD_REQUEST)
            status_ = "bad request";
        else if (killed_)
            status_ = "killed";
        else if (WIFSIGNALED(waitStatus))
            status_ = std::string("signal ") + sigabbrev_np(WTERMSIG(waitStatus));
        else if (WEXITSTATUS(waitStatus) == EXIT_OUT_OF_MEMORY)
            status_ = "out of memory";
        else if (WEXITSTATUS(waitStatus) != 0)
            status_ = "exception";
        else
            status_ = "returned";
    }
}  // namespace ompl_mfa::anytime
