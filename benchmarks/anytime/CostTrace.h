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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_COST_TRACE_
#define OMPL_MFA_BENCHMARKS_ANYTIME_COST_TRACE_

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include <ompl/base/Planner.h>

#include "anytime/World.h"

namespace ompl_mfa::anytime
{
    /** \brief Clock of a time limit. */
    enum class Clock
    {
        CPU,  ///< processor time of the run, independent of other programs
        Wall
    };

    /** \brief "cpu" or "wall". */
    std::string clockName(Clock clock);

    /** \brief Seconds since an arbitrary time in the past. */
    double wallTime();

    /** \brief Seconds of processor time of this process, summed over its threads. */
    double cpuTime();

    /** \brief A better path: time since the start of the planner (seconds), cost, and number of states checked so
        far. */
    struct Improvement
    {
        double wall;
        double cpu;
        double cost;
        std::uint64_t checks;
    };

    /** \brief Improvements of one run. Of constant size and without pointers, for memory shared by two processes, so
        that it survives a crash of the writer. */
    struct ImprovementLog
    {
        static constexpr std::uint32_t CAPACITY = 20000;

        std::atomic<std::uint32_t> count{0};
        Improvement entries[CAPACITY]{};
    };

    /** \brief Traces the cost of a planner's best path while it runs: with the callback for intermediate solutions and,
        for planners without it, by polling the progress property `best cost` every 0.2 ms, both when the planner
        evaluates its termination condition and, like OMPL's Benchmark, from a thread. */
    class CostTrace
    {
    public:
        /** \brief Registers the callback in the problem definition and starts the thread and the clocks. \e limit is in
            seconds on \e clock. */
        CostTrace(const Problem &problem, const ompl::base::Planner &planner, Clock clock, double limit,
                  ImprovementLog &log);
        ~CostTrace();
        CostTrace(const CostTrace &) = delete;
        CostTrace &operator=(const CostTrace &) = delete;

        /** \brief The planner's termination condition: true once the limit has passed. */
        bool expired();

        /** \brief Stops polling. */
        void stop();

        /** \brief Logs \e cost if it is an improvement. */
        void offer(double cost);

        /** \brief Number of times the cost was polled. */
        std::uint64_t looks() const
        {
            return looks_;
        }

        /** \brief Longest time between two polls in processor seconds, once stopped. */
        double longestGap() const
        {
            return longestGap_;
        }

    private:
        void watch();
        void look();
        void readBestCost();
        void readClocks();

        const Problem &problem_;
        Clock clock_;
        double limit_;
        ImprovementLog &log_;
        ompl::base::Planner::PlannerProgressProperty bestCost_;
        double wallStart_{0.0};
        double cpuStart_{0.0};
        double best_;
        std::mutex mutex_;
        std::atomic<bool> expired_{false};
        std::atomic<bool> stopped_{false};
        std::atomic<bool> watching_{false};
        std::atomic<bool> started_{false};
        std::atomic<double> nextLook_{0.0};
        std::mutex lookMutex_;
        std::uint64_t looks_{0};
        double lastLook_{0.0};
        double longestGap_{0.0};
        std::thread watcher_;
    };
}  // namespace ompl_mfa::anytime

#endif
