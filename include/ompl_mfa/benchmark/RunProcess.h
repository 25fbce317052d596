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

#ifndef OMPL_MFA_BENCHMARK_RUN_PROCESS_
#define OMPL_MFA_BENCHMARK_RUN_PROCESS_

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "ompl_mfa/Export.h"

namespace ompl_mfa
{
    /** \brief What a run is doing; each phase has its own time limit. */
    enum class RunPhase : int
    {
        PREPARING,  ///< making the problem and the planner
        SOLVING,    ///< inside the planner's solve()
        FINISHING   ///< simplifying and measuring the path
    };

    /** \brief Memory shared by the process of a run, which writes it, and the process that watches the run. What stands
        here survives a crash of the run. */
    struct RunState
    {
        std::atomic<RunPhase> phase{RunPhase::PREPARING};
        /** \brief Start of solve(), seconds of the monotonic clock. */
        std::atomic<double> solveStart{0.0};
        /** \brief When the first solution was seen, seconds after solveStart; infinite before. */
        std::atomic<double> firstSolution{std::numeric_limits<double>::infinity()};
        /** \brief The last best cost that the planner reported; infinite before the first solution. */
        std::atomic<double> bestCost{std::numeric_limits<double>::infinity()};
        /** \brief Calls of the state validity checker so far. */
        std::atomic<std::uint64_t> collisionChecks{0};
        /** \brief Resident memory of the process when solve() began, bytes. */
        std::atomic<std::uint64_t> residentAtStart{0};
    };

    /** \brief How a run came to its end. */
    enum class RunTermination : int
    {
        RETURNED,      ///< the planner returned and its run was measured
        EXCEPTION,     ///< the planner threw
        EXITED,        ///< the process ended itself
        SIGNAL,        ///< a signal ended the process: a crash or an abort
        TIME_LIMIT,    ///< killed: a phase took longer than it may
        MEMORY_LIMIT,  ///< killed: more memory than it may use, or an allocation failed
        UNKNOWN        ///< not over
    };

    /** \brief Limits of a run, enforced from outside its process. */
    struct RunLimits
    {
        /** \brief Seconds that the phases may take. */
        double prepare{120.0};
        double solve{5.0};
        double finish{120.0};
        /** \brief Megabytes (2^20 bytes) that solve() may add to what the process occupied before it. */
        double memory{4096.0};
    };

    /** \brief A function that runs in a process of its own, under limits, and hands a text back.

        The process is a fork of the calling one, which must have a single thread. It dies with its parent, leaves no
        core file, reads nothing, and what it prints is kept back. Its locale is "C", whatever that of the caller. */
    class OMPL_MFA_EXPORT RunProcess
    {
    public:
        /** \brief The work of the process. An exception that it throws is the end of the run. */
        using Body = std::function<std::string(RunState &)>;

        /** \brief Starts the process. Throws std::system_error when the system has no process or pipe left. */
        RunProcess(const Body &body, const RunLimits &limits);

        /** \brief Kills the process if it is still there. */
        ~RunProcess();

        RunProcess(const RunProcess &) = delete;
        RunProcess &operator=(const RunProcess &) = delete;

        /** \brief Reads what the process wrote and enforces its limits. Returns true once it is over. */
        bool update();

        /** \brief As update() until the process is over. */
        void wait();

        /** \brief Waits until something can be read from the process, at most \e seconds. */
        void waitForOutput(double seconds) const;

        /** \brief UNKNOWN as long as update() has not returned true. */
        RunTermination termination() const;

        /** \brief The signal that ended the process, 0 if none did. */
        int signal() const;

        /** \brief The exit status of the process, 0 if a signal ended it. */
        int exitStatus() const;

        /** \brief What Body returned; empty unless the run RETURNED. */
        const std::string &result() const;

        /** \brief The end of what the process printed, at most 4 KiB, without surrounding white space. */
        std::string console() const;

        /** \brief The time since the start of the present phase, or of the last one, seconds. */
        double phaseTime() const;

        const RunState &state() const;

        /** \brief Exit status with which a body that threw InputError ends. */
        static constexpr int INPUT_ERROR_STATUS = 102;

    private:
        void readPipes();
        void enforceLimits();
        void killProcess(RunTermination reason);
        void close();

        RunLimits limits_;
        RunState *state_{nullptr};
        pid_t pid_{-1};
        int resultPipe_{-1};
        int consolePipe_{-1};
        std::string result_;
        std::string console_;
        RunPhase seenPhase_{RunPhase::PREPARING};
        double phaseStart_{0.0};
        double phaseEnd_{0.0};
        RunTermination killedFor_{RunTermination::UNKNOWN};
        RunTermination termination_{RunTermination::UNKNOWN};
        int signal_{0};
        int exitStatus_{0};
    };

    /** \brief Seconds of the monotonic clock, the same for all processes of the machine. */
    OMPL_MFA_EXPORT double monotonicSeconds();

    /** \brief Resident memory of process \e pid in bytes; 0 when there is no such process. */
    OMPL_MFA_EXPORT std::uint64_t residentMemory(pid_t pid);
}  // namespace ompl_mfa

#endif
