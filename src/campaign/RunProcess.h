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
    /** \brief What a run is doing; each phase has its own time limit. */
    enum class RunPhase : int
    {
        Preparing,  ///< making what is to be solved, and with what
        Solving,    ///< the work that is measured
        Finishing   ///< looking at what came out
    };

    /** \brief Memory shared by the process of a run, which writes it, and the process that watches the run. What a run
        wants to outlive its crash is in a struct derived from this one: see makeShared(). */
    struct RunState
    {
        std::atomic<RunPhase> phase{RunPhase::Preparing};
        /** \brief When RunPhase::Solving began, seconds of the monotonic clock. */
        std::atomic<double> solveStart{0.0};
        /** \brief Processor time of the process when RunPhase::Solving began, seconds. */
        std::atomic<double> processorAtStart{0.0};
        /** \brief Resident memory of the process when RunPhase::Solving began, bytes. */
        std::atomic<std::uint64_t> residentAtStart{0};
    };

    /** \brief Called in the process of a run: notes time and memory, from which its limits count, and begins
     * RunPhase::Solving.
     */
    OMPL_MFA_EXPORT void startSolving(RunState &state);

    /** \brief How a run came to its end. */
    enum class RunTermination : int
    {
        Returned,     ///< it handed back a text
        Exception,    ///< it threw
        Exited,       ///< the process ended itself
        Signal,       ///< a signal ended the process: a crash or an abort
        TimeLimit,    ///< killed: a phase took longer than it may
        MemoryLimit,  ///< killed: more memory than it may use, or an allocation failed
        Unknown       ///< not over
    };

    /** \brief \e termination in words, such as "ended by signal 11 (Segmentation fault)"; \e signal counts for that. */
    OMPL_MFA_EXPORT std::string describeTermination(RunTermination termination, int signal);

    /** \brief Limits of a run, enforced from outside its process. */
    struct RunLimits
    {
        /** \brief Seconds that the phases may take. */
        double prepare{120.0};
        double solve{5.0};
        double finish{120.0};
        /** \brief Seconds of processor time that the process may take from the start of RunPhase::Solving to its end.
         */
        double processor{std::numeric_limits<double>::infinity()};
        /** \brief Megabytes (2^20 bytes) that RunPhase::Solving may add to what the process occupied before it. */
        double memory{4096.0};
    };

    /** \brief A function that runs in a process of its own, under limits, and hands a text back.

        The process is a fork of the calling one, which must have a single thread. It dies with its parent, leaves no
        core file, reads nothing, and what it prints is kept back. Its locale is "C", whatever that of the caller. */
    class OMPL_MFA_EXPORT RunProcess
    {
    public:
        /** \brief The work of the process. An exception that it throws is the end of the run. */
        using Body = std::function<std::string()>;

        /** \brief The process may run on any core. */
        static constexpr int ANY_CORE = -1;

        /** \brief Starts the process. \e state is what \e body writes and the limits are read from; \e core is the
            one core that it is bound to, as sched_setaffinity() numbers them. Throws std::system_error when the system
            has no process or pipe left. */
        RunProcess(const Body &body, const RunLimits &limits, std::shared_ptr<const RunState> state,
                   int core = ANY_CORE);

        /** \brief Kills the process if it is still there. */
        ~RunProcess();

        RunProcess(const RunProcess &) = delete;
        RunProcess &operator=(const RunProcess &) = delete;

        /** \brief Reads what the process wrote and enforces its limits. Returns true once it is over. */
        bool update();

        /** \brief As update() until the process is over. */
        void wait();

        /** \brief Waits until something can be read from one of \e processes, at most \e seconds. */
        static void waitForOutput(const std::vector<const RunProcess *> &processes, double seconds);

        /** \brief RunTermination::Unknown as long as update() has not returned true. */
        RunTermination termination() const;

        /** \brief Whether the process ended because its body threw InputError: what it was asked for cannot be had. */
        bool refused() const;

        /** \brief The signal that ended the process, 0 if none did. */
        int signal() const;

        /** \brief The exit status of the process, 0 if a signal ended it. */
        int exitStatus() const;

        /** \brief What Body returned; empty unless termination() is RunTermination::Returned. */
        const std::string &result() const;

        /** \brief The end of what the process printed, at most 4 KiB, without surrounding white space. The message of
            an exception is the last that is printed. */
        std::string console() const;

        /** \brief The last line of console(). */
        std::string lastLine() const;

        /** \brief The time since the start of the present phase, or of the last one, seconds. */
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

    /** \brief Resident memory of process \e pid in bytes; 0 when there is no such process. */
    OMPL_MFA_EXPORT std::uint64_t residentMemory(pid_t pid);
}  // namespace ompl_mfa::campaign

#endif
