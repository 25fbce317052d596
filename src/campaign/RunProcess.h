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

#ifndef OMPL_MFA_CAMPAIGN_RUN_PROCESS_
#define OMPL_MFA_CAMPAIGN_RUN_PROCESS_

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "campaign/SharedMemory.h"
#include "ompl_mfa/Export.h"

namespace ompl_mfa::campaign
{
    /** \brief Phase of a run; each phase has its own time limit. */
    enum class RunPhase : int
    {
        Preparing,  ///< making the problem and the planner
        Solving,    ///< the measured work
        Finishing   ///< evaluating the result
    };

    /** \brief Memory shared by the process of a run, which writes it, and its parent. Data that must survive a crash
        are stored in a derived struct, see makeShared(). */
    struct RunState
    {
        std::atomic<RunPhase> phase{RunPhase::Preparing};
        /** \brief Start of RunPhase::Solving, seconds of the monotonic clock. */
        std::atomic<double> solveStart{0.0};
        /** \brief Processor time of the process when RunPhase::Solving began, seconds. */
        std::atomic<double> processorAtStart{0.0};
        /** \brief Resident memory of the process when RunPhase::Solving began, bytes. */
        std::atomic<std::uint64_t> residentAtStart{0};
    };

    /** \brief Called in the process of a run: begins RunPhase::Solving and stores time and memory, to which its limits
        are relative. */
    OMPL_MFA_EXPORT void startSolving(RunState &state);

    /** \brief How a run ended. */
    enum class RunTermination : int
    {
        Returned,     ///< it returned a text
        Exception,    ///< it threw
        Exited,       ///< the process ended itself
        Signal,       ///< a signal ended the process: a crash or an abort
        TimeLimit,    ///< killed: a phase exceeded its time limit
        MemoryLimit,  ///< killed at its memory limit, or an allocation failed
        Unknown       ///< still running
    };

    /** \brief \e termination in words, such as "ended by signal 11 (Segmentation fault)", for which \e signal is
        used. */
    OMPL_MFA_EXPORT std::string describeTermination(RunTermination termination, int signal);

    /** \brief Limits of a run, enforced by the parent process. */
    struct RunLimits
    {
        /** \brief Maximum seconds of the phases. */
        double prepare{120.0};
        double solve{5.0};
        double finish{120.0};
        /** \brief Maximum processor time of RunPhase::Solving, seconds. */
        double processor{std::numeric_limits<double>::infinity()};
        /** \brief Megabytes (2^20 bytes) by which resident memory may grow in RunPhase::Solving. */
        double memory{4096.0};
    };

    /** \brief Runs a function in a separate process, under limits, and returns its text.

        The process is forked from the calling one, which must be single-threaded. It is killed if its parent ends,
        leaves no core file, and has an empty standard input; its output is captured. Its locale is "C". */
    class OMPL_MFA_EXPORT RunProcess
    {
    public:
        /** \brief The work of the process. An exception ends the run. */
        using Body = std::function<std::string()>;

        /** \brief The process may run on any core. */
        static constexpr int ANY_CORE = -1;

        /** \brief Starts the process. \e state is written by \e body and read to enforce the limits; \e core is the
            core to bind it to, as numbered by sched_setaffinity(). Throws std::system_error if no process or pipe can
            be created. */
        RunProcess(const Body &body, const RunLimits &limits, std::shared_ptr<const RunState> state,
                   int core = ANY_CORE);

        /** \brief Kills the process if it is still running. */
        ~RunProcess();

        RunProcess(const RunProcess &) = delete;
        RunProcess &operator=(const RunProcess &) = delete;

        /** \brief Reads the output of the process and enforces its limits. Returns true once it has ended. */
        bool update();

        /** \brief Calls update() until the process has ended. */
        void wait();

        /** \brief Waits until one of \e processes has output, at most \e seconds. */
        static void waitForOutput(const std::vector<const RunProcess *> &processes, double seconds);

        /** \brief RunTermination::Unknown until update() has returned true. */
        RunTermination termination() const;

        /** \brief Whether the process ended because its body threw InputError. */
        bool refused() const;

        /** \brief The signal that ended the process, 0 if none did. */
        int signal() const;

        /** \brief The exit status of the process, 0 if a signal ended it. */
        int exitStatus() const;

        /** \brief The text returned by Body; empty unless termination() is RunTermination::Returned. */
        const std::string &result() const;

        /** \brief The last output of the process, at most 4 KiB, without surrounding white space. The message of an
            exception is printed last. */
        std::string console() const;

        /** \brief The last line of console(). */
        std::string lastLine() const;

        /** \brief Seconds since the start of the current phase, or of the last one. */
        double phaseTime() const;

        const RunState &state() const;

    private:
        void readPipes();
        void enforceLimits();
        double processorTime() const;
        void killProcess(RunTermination reason);
        void close();

        RunLimits limits_;
        std::shared_ptr<const RunState> state_;
        pid_t pid_{-1};
        int resultPipe_{-1};
        int consolePipe_{-1};
        std::string result_;
        std::string console_;
        RunPhase seenPhase_{RunPhase::Preparing};
        double phaseStart_{0.0};
        double phaseEnd_{0.0};
        RunTermination killedFor_{RunTermination::Unknown};
        RunTermination termination_{RunTermination::Unknown};
        int signal_{0};
        int exitStatus_{0};
    };

    /** \brief Seconds of the monotonic clock, the same for all processes of the machine. */
    OMPL_MFA_EXPORT double monotonicSeconds();

    /** \brief Resident memory of process \e pid in bytes; 0 if there is no such process. */
    OMPL_MFA_EXPORT std::uint64_t residentMemory(pid_t pid);
}  // namespace ompl_mfa::campaign

#endif
