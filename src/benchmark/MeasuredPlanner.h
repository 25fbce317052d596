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
#include <mutex>
#include <string>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/StateValidityChecker.h>

#include "benchmark/RunState.h"
#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"

namespace ompl_mfa
{
    /** \brief Counts the calls of any validity checker where the watching process sees them. Thread-safe where the
       checker is. */
    class OMPL_MFA_EXPORT WatchedValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief Counts calls of \e checker in \e state. */
        WatchedValidityChecker(const ompl::base::SpaceInformationPtr &si, ompl::base::StateValidityCheckerPtr checker,
                               RunState &state);

        bool isValid(const ompl::base::State *state) const override;
        bool isValid(const ompl::base::State *state, double &distance) const override;
        bool isValid(const ompl::base::State *state, double &distance, ompl::base::State *validState,
                     bool &validStateAvailable) const override;
        double clearance(const ompl::base::State *state) const override;
        double clearance(const ompl::base::State *state, ompl::base::State *validState,
                         bool &validStateAvailable) const override;

    private:
        ompl::base::StateValidityCheckerPtr checker_;
        RunState &run_;
    };

    /** \brief A planner as a benchmark sees it: passes everything on to the planner that it holds and measures solve().

        OMPL's Benchmark looks at a planner's progress every so often, but at one fixed distance for the whole run, and
        not when the planner returns. This class looks every millisecond for the first tenth of a second and then at the
        interval asked for, once more at the end, and continues the series of a planner that returns early up to the
        time limit with its last values: curves of several runs are then means over the same runs at every time. A
        planner that publishes no best cost gets one, known from the moment that it returns. */
    class OMPL_MFA_EXPORT MeasuredPlanner : public ompl::base::Planner
    {
    public:
        struct Settings
        {
            /** \brief Seconds. OMPL's Benchmark only looks every 0.1 s whether they are over. */
            double timeLimit{5.0};
            /** \brief Seconds between two samples of the progress properties after the first tenth of a second. */
            double progressInterval{0.01};
            /** \brief How often the termination condition may be evaluated before it stops the planner; 0: no limit. */
            std::uint64_t iterationLimit{0};
        };

        MeasuredPlanner(ompl::base::PlannerPtr planner, RunState &run, const Settings &settings);

        /** \brief Copies what has been sampled in solve(), strictly increasing in time. */
        std::vector<ProgressSample> progress() const;

        /** \brief "words TYPE" for each value of a sample. */
        std::vector<std::string> progressNames() const;

        /** \brief Whether the planner's solve() threw. */
        bool threw() const;

        /** \brief Calls of the validity checker in solve(). */
        std::uint64_t collisionChecks() const;

        /** \brief Motions that were checked in solve(). */
        std::uint64_t motionChecks() const;

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
        void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
        void setup() override;
        void clear() override;
        void clearQuery() override;
        void checkValidity() override;
        void getPlannerData(ompl::base::PlannerData &graph) const override;
        void printProperties(std::ostream &out) const override;
        void printSettings(std::ostream &out) const override;

    private:
        ompl::base::PlannerStatus solveLimited(const ompl::base::PlannerTerminationCondition &ptc);
        void sampleUntilSolved();
        void sample(bool keep);
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
        bool threw_{false};
        std::uint64_t collisionChecks_{0};
        std::uint64_t motionChecks_{0};
    };
}  // namespace ompl_mfa

#endif
