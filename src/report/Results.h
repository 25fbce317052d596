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

#ifndef OMPL_MFA_REPORT_RESULTS_
#define OMPL_MFA_REPORT_RESULTS_

#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ompl_mfa::report
{
    /** \brief One run of a planner. Times are in seconds since the start of solve(), costs in the unit of the
        objective; both are infinite if they do not exist. */
    struct RunResult
    {
        /** \brief Number and seed of the run as text; empty if unknown. */
        std::string run;
        std::string seed;
        /** \brief Whether the planner returned an exact path that is valid. */
        bool solved{false};
        /** \brief Whether the planner did not return by itself: it crashed, or was ended from outside. */
        bool ended{false};
        double firstSolution{std::numeric_limits<double>::infinity()};
        double finalCost{std::numeric_limits<double>::infinity()};
        /** \brief Times and the costs reached then: times increase, costs decrease and end with finalCost. */
        std::vector<std::pair<double, double>> trace;

        /** \brief The cost reached by \e time. */
        double costAt(double time) const;

        /** \brief When the cost was first at most \e cost. */
        double timeTo(double cost) const;
    };

    /** \brief The runs of a planner in an experiment. */
    struct PlannerResults
    {
        std::string name;
        std::vector<RunResult> runs;
    };

    /** \brief The results of one problem. */
    struct Experiment
    {
        std::string name;
        /** \brief The files that it was read from. */
        std::vector<std::string> files;
        std::string version;
        std::string host;
        std::string cpu;
        std::string start;
        std::string seed;
        std::string objective;
        /** \brief Seconds per run. */
        double timeLimit{0.0};
        /** \brief Megabytes per run. */
        double memoryLimit{0.0};
        std::vector<PlannerResults> planners;
    };

    /** \brief What logs and databases record of a run. */
    struct RecordedRun
    {
        /** \brief Values by their names in databases, such as path_cost; what is unknown is missing or empty. */
        std::map<std::string, std::string> values;
        /** \brief Times and best costs of the progress, in the order of time; costs may be infinite or NaN. */
        std::vector<std::pair<double, double>> progress;
    };

    /** \brief The result of \e recorded.

        A run is solved if it has an exact path that passed OMPL's check. Its final cost is, in this order, that of the
        returned path, the last best cost, the length of the returned path. Its first solution is at the recorded
        `time_to_first_solution`, else the first sample with a finite best cost, else when the planner returned.
        Samples cheaper than the returned path count with the latter's cost, samples later than 1.1 times \e timeLimit
        plus 50 ms not at all. */
    RunResult makeRunResult(const RecordedRun &recorded, double timeLimit);
}  // namespace ompl_mfa::report

#endif
