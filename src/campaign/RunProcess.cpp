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

#include "campaign/RunProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <locale>
#include <new>
#include <system_error>
#include <utility>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::campaign
{
    namespace
    {
        constexpr int EXCEPTION_STATUS = 100;
        constexpr int OUT_OF_MEMORY_STATUS = 101;
        constexpr int INPUT_ERROR_STATUS = 102;
        constexpr std::size_t CONSOLE_KEPT = 4096;
        constexpr double MEGABYTE = 1024.0 * 1024.0;

        [[noreturn]] void failWith(const char *what)
        {
            throw std::system_error(errno, std::generic_category(), what);
        }

        /* The parent process enforces a limit on resident memory, but polls it only at intervals. This limit catches
           faster growth, and memory that is reserved but never touched. */
        void limitAllocation(double megabytes)
        {
            std::ifstream status("/proc/self/status");
            std::string word;
            double present = 0.0;
            while (status >> word)
            {
                if (word == "VmData:")
                {
                    status >> present;
                    break;
                }
            }
            const double allowed = present * 1024.0 + (1.5 * megabytes + 512.0) * MEGABYTE;
            const rlimit limit{static_cast<rlim_t>(allowed), static_cast<rlim_t>(allowed)};
            setrlimit(RLIMIT_DATA, &limit);
        }

        void writeAll(int file, const std::string &text)
        {
            std::size_t written = 0;
            while (written < text.size())
            {
                const ssize_t count = ::write(file, text.data() + written, text.size() - written);
                if (count < 0 && errno != EINTR)
                {
                    return;
                }
                written += count > 0 ? static_cast<std::size_t>(count) : 0;
            }
        }

        void bindToCore(int core)
        {
            cpu_set_t cores;
            CPU_ZERO(&cores);
            CPU_SET(static_cast<std::size_t>(core), &cores);
            sched_setaffinity(0, sizeof(cores), &cores);
        }

        void enterChild(pid_t parent, int console, double megabytes, int core)
        {
            prctl(PR_SET_PDEATHSIG, SIGKILL);
            if (getppid() != parent)
            {
                _exit(EXCEPTION_STATUS);
            }
            setpgid(0, 0);
            if (core != RunProcess::ANY_CORE)
            {
                bindToCore(core);
            }
            for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD})
            {
                ::signal(number, SIG_DFL);
            }
            const int nothing = open("/dev/null", O_RDONLY);
            dup2(nothing, STDIN_FILENO);
            dup2(console, STDOUT_FILENO);
            dup2(console, STDERR_FILENO);
            const rlimit noCore{0, 0};
            setrlimit(RLIMIT_CORE, &noCore);
            limitAllocation(megabytes);
            // OMPL and planners format values for the log with streams and std::to_string(). This also sets the C
            // library's locale, as the classic locale has a name.
            std::locale::global(std::locale::classic());
        }

        /* Ends without destructors, so that memory corrupted by the planner cannot lose an existing result. */
        [[noreturn]] void runChild(const RunProcess::Body &body, int resultPipe)
        {
            int status = 0;
            try
            {
                writeAll(resultPipe, body());
            }
            catch (const InputError &error)
            {
                std::cerr << error.what() << std::endl;
                status = INPUT_ERROR_STATUS;
            }
            catch (const std::bad_alloc &)
            {
                status = OUT_OF_MEMORY_STATUS;
            }
            catch (const std::exception &error)
            {
                std::cerr << error.what() << std::endl;
                status = EXCEPTION_STATUS;
            }
            catch (...)
            {
                status = EXCEPTION_STATUS;
            }
            std::cout.flush();
            std::fflush(nullptr);
            _exit(status);
        }

        RunTermination terminationOf(int exitStatus)
        {
            switch (exitStatus)
            {
                case 0:
                    return RunTermination::Returned;
                case OUT_OF_MEMORY_STATUS:
                    return RunTermination::MemoryLimit;
                case EXCEPTION_STATUS:
                case INPUT_ERROR_STATUS:
                    return RunTermination::Exception;
                default:
                    return RunTermination::Exited;
            }
        }

        void openPipe(int ends[2])
        {
            if (pipe2(ends, O_CLOEXEC) != 0)
            {
                failWith("pipe");
            }
            fcntl(ends[0], F_SETFL, O_NONBLOCK);
        }

        void readAvailable(int file, std::string &text)
        {
            char buffer[65536];
            ssize_t count = 0;
            while ((count = ::read(file, buffer, sizeof(buffer))) > 0)
            {
                text.append(buffer, static_cast<std::size_t>(count));
            }
        }

        /* 0 if there is no such clock. */
        double secondsOf(clockid_t clock)
        {
            timespec now{};
            clock_gettime(clock, &now);
            return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
        }
    }  // namespace

    double monotonicSeconds()
    {
        return secondsOf(CLOCK_MONOTONIC);
    }

    void startSolving(RunState &state)
    {
        state.residentAtStart = residentMemory(getpid());
        state.processorAtStart = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
        state.solveStart = monotonicSeconds();
        state.phase = RunPhase::Solving;
    }

    std::uint64_t residentMemory(pid_t pid)
    {
        std::ifstream statm("/proc/" + std::to_string(pid) + "/statm");
        std::uint64_t size = 0;
        std::uint64_t resident = 0;
        statm >> size >> resident;
        return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    }

    std::string describeTermination(RunTermination termination, int signal)
    {
        switch (termination)
        {
            case RunTermination::Returned:
                return "returned";
            case RunTermination::Exception:
                return "threw an exception";
            case RunTermination::Exited:
                return "ended its process";
            case RunTermination::Signal:
                return "ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
            case RunTermination::TimeLimit:
                return "killed at its time limit";
            case RunTermination::MemoryLimit:
                return "killed at its memory limit";
            default:
                return "not over";
        }
    }

    RunProcess::RunProcess(const Body &body, const RunLimits &limits, std::shared_ptr<const RunState> state, int core)
      : limits_(limits)
      , state_(std::move(state))
    {
        int result[2];
        int console[2];
        openPipe(result);
        openPipe(console);
        std::cout.flush();
        std::cerr.flush();
        std::fflush(nullptr);
        phaseStart_ = monotonicSeconds();
        const pid_t parent = getpid();
        pid_ = fork();
        if (pid_ < 0)
        {
            failWith("fork");
        }
        if (pid_ == 0)
        {
            enterChild(parent, console[1], limits_.memory, core);
            runChild(body, result[1]);
        }
        setpgid(pid_, pid_);
        ::close(result[1]);
        ::close(console[1]);
        resultPipe_ = result[0];
        consolePipe_ = console[0];
    }

    RunProcess::~RunProcess()
    {
        if (pid_ > 0)
        {
            killProcess(RunTermination::Unknown);
            waitpid(pid_, nullptr, 0);
        }
        close();
    }

    bool RunProcess::update()
    {
        if (termination_ != RunTermination::Unknown)
        {
            return true;
        }
        readPipes();
        enforceLimits();
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) != pid_)
        {
            return false;
        }
        // Children that a planner left behind must not outlive its run.
        ::kill(-pid_, SIGKILL);
        pid_ = -1;
        readPipes();
        close();
        phaseEnd_ = monotonicSeconds();
        if (WIFSIGNALED(status))
        {
            signal_ = WTERMSIG(status);
            termination_ = killedFor_ != RunTermination::Unknown ? killedFor_ : RunTermination::Signal;
        }
        else
        {
            exitStatus_ = WEXITSTATUS(status);
            termination_ = terminationOf(exitStatus_);
            // A planner that calls exit(0) has not returned a result.
            if (termination_ == RunTermination::Returned && result_.empty())
            {
                termination_ = RunTermination::Exited;
            }
        }
        return true;
    }

    void RunProcess::wait()
    {
        while (!update())
        {
            waitForOutput({this}, 0.01);
        }
    }

    void RunProcess::waitForOutput(const std::vector<const RunProcess *> &processes, double seconds)
    {
        std::vector<pollfd> files;
        files.reserve(processes.size());
        for (const RunProcess *process : processes)
        {
            files.push_back({process->resultPipe_, POLLIN, 0});
        }
        poll(files.data(), files.size(), static_cast<int>(seconds * 1000.0));
    }

    RunTermination RunProcess::termination() const
    {
        return termination_;
    }

    bool RunProcess::refused() const
    {
        return termination_ == RunTermination::Exception && exitStatus_ == INPUT_ERROR_STATUS;
    }

    int RunProcess::signal() const
    {
        return signal_;
    }

    int RunProcess::exitStatus() const
    {
        return exitStatus_;
    }

    const std::string &RunProcess::result() const
    {
        return result_;
    }

    std::string RunProcess::console() const
    {
        const std::size_t first = console_.find_first_not_of(" \t\r\n");
        return first == std::string::npos ? std::string()
                                          : console_.substr(first, console_.find_last_not_of(" \t\r\n") - first + 1);
    }

    std::string RunProcess::lastLine() const
    {
        const std::string text = console();
        return text.substr(text.find_last_of('\n') + 1);
    }

    double RunProcess::phaseTime() const
    {
        return (termination_ == RunTermination::Unknown ? monotonicSeconds() : phaseEnd_) - phaseStart_;
    }

    const RunState &RunProcess::state() const
    {
        return *state_;
    }

    void RunProcess::readPipes()
    {
        readAvailable(resultPipe_, result_);
        readAvailable(consolePipe_, console_);
        if (console_.size() > CONSOLE_KEPT)
        {
            console_.erase(0, console_.size() - CONSOLE_KEPT);
        }
    }

    void RunProcess::enforceLimits()
    {
        const double now = monotonicSeconds();
        const RunPhase phase = state_->phase;
        if (phase != seenPhase_)
        {
            seenPhase_ = phase;
            phaseStart_ = phase == RunPhase::Solving ? state_->solveStart.load() : now;
        }
        const double allowed = phase == RunPhase::Preparing ? limits_.prepare
                               : phase == RunPhase::Solving ? limits_.solve
                                                            : limits_.finish;
        const bool solves = phase != RunPhase::Preparing && std::isfinite(limits_.processor);
        if (now - phaseStart_ > allowed || (solves && processorTime() - state_->processorAtStart > limits_.processor))
        {
            killProcess(RunTermination::TimeLimit);
        }
        // OMPL stops a planner at the limit itself; this check is for planners that do not evaluate their termination
        // condition.
        const double slack = (0.1 * limits_.memory + 16.0) * MEGABYTE;
        const double resident = static_cast<double>(residentMemory(pid_));
        if (resident > static_cast<double>(state_->residentAtStart) + limits_.memory * MEGABYTE + slack)
        {
            killProcess(RunTermination::MemoryLimit);
        }
    }

    double RunProcess::processorTime() const
    {
        clockid_t clock{};
        return clock_getcpuclockid(pid_, &clock) == 0 ? secondsOf(clock) : 0.0;
    }

    void RunProcess::killProcess(RunTermination reason)
    {
        if (killedFor_ == RunTermination::Unknown)
        {
            killedFor_ = reason;
        }
        ::kill(-pid_, SIGKILL);
        ::kill(pid_, SIGKILL);
    }

    void RunProcess::close()
    {
        for (int *file : {&resultPipe_, &consolePipe_})
        {
            if (*file >= 0)
            {
                ::close(*file);
            }
            *file = -1;
        }
    }
}  // namespace ompl_mfa::campaign
