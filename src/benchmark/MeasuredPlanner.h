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

#ifndef OMPL_MFA_BENCHMARK_MEASURED_PLANNER_
#define OMPL_MFA_BENCHMARK_MEASURED_PLANNER_

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>

#include "benchmark/RunState.h"
#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"

namespace ompl_mfa::benchmark
{
    /** \brief Decorator for a planner in a benchmark: measures one solve() of it.

        OMPL's Benchmark samples a planner's progress at a fixed interval during the whole run, and not when the planner
        returns. This class declares no progress properties to it and samples them itself: every millisecond for the
        first tenth of a second, then at the given interval, and once more at the end. It continues the series of a
        planner that returns early with its last values up to the time limit, so that means over several runs include
        the same runs at every time. A planner that publishes no best cost gets one from its return on.

        It overrides those functions called by Benchmark and SimpleSetup that the base class cannot answer; parameters,
        specs and name are copied. clear() is not passed on, as solve() is called once only. */
    class OMPL_MFA_EXPORT MeasuredPlanner : public ompl::base::Planner
    {
    public:
        struct Settings
        {
            /** \brief Seconds. OMPL's Benchmark checks its time limit only every 0.1 s. */
            double timeLimit{5.0};
            /** \brief Seconds between two samples of the progress properties after the first tenth of a second. */
            double progressInterval{0.01};
            /** \brief How often the termination condition may be evaluated before it stops the planner; 0: no limit. */
            std::uint64_t iterationLimit{0};
            /** \brief Called at the end of solve(), after time has been measured, unless the planner threw: Benchmark
                simplifies the path before its post-run event. Memory that it leaves allocated counts in Benchmark's
                `memory REAL`. May be empty. */
            std::function<void()> solved;
        };

        /** \brief Makes the space information of \e planner count the calls of its validity checker in \e run. */
        MeasuredPlanner(ompl::base::PlannerPtr planner, RunState &run, const Settings &settings);

        /** \brief A copy of the samples taken in solve(), strictly increasing in time. */
        std::vector<ProgressSample> progress() const;

        /** \brief "words TYPE" for each value of a sample. */
        std::vector<std::string> progressNames() const;

        /** \brief Seconds that the planner's solve() took. */
        double time() const;

        /** \brief Whether the planner's solve() threw. */
        bool threw() const;

        /** \brief Calls of the validity checker in solve(). */
        std::uint64_t collisionChecks() const;

        /** \brief Motions checked in solve(). */
        std::uint64_t motionChecks() const;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;

        /** \brief Passes the problem on and sets up the planner. */
        void setup() override;

        /** \brief The planner's graph. */
        void getPlannerData(ompl::base::PlannerData &graph) const override;

    private:
        ompl::base::PlannerStatus solveLimited(const ompl::base::PlannerTerminationCondition &ptc);
        void sampleUntilSolved();
        void sample(double time, bool keep);
        double sampleTime(std::size_t index) const;
        void finishProgress();

        ompl::base::PlannerPtr planner_;
        RunState &run_;
        Settings settings_;
        std::vector<std::string> names_;
        std::vector<ompl::base::Planner::PlannerProgressProperty> properties_;
        bool publishesCost_{false};
        std::vector<ProgressSample> samples_;
        std::mutex solvedMutex_;
        std::condition_variable solvedCondition_;
        bool solved_{false};
        double time_{0.0};
        bool threw_{false};
        std::uint64_t collisionChecks_{0};
        std::uint64_t motionChecks_{0};
    };
}  // namespace ompl_mfa::benchmark

#endif
