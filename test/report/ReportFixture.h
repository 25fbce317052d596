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

#ifndef OMPL_MFA_TEST_REPORT_REPORT_FIXTURE_
#define OMPL_MFA_TEST_REPORT_REPORT_FIXTURE_

#include <string>
#include <utility>
#include <vector>

#include "report/Results.h"

namespace ompl_mfa::test
{
    /** \brief A run with a path of cost \e cost at \e time. */
    inline report::RunResult solvedAt(double time, double cost)
    {
        report::RunResult run;
        run.solved = true;
        run.firstSolution = time;
        run.finalCost = cost;
        run.trace = {{time, cost}};
        return run;
    }

    /** \brief An experiment of 1 s in which each planner has a path of its cost in all of \e runs runs, at its time. */
    inline report::Experiment experimentOf(
        const std::string &name, const std::vector<std::pair<std::string, std::pair<double, double>>> &planners,
        std::size_t runs = 9)
    {
        report::Experiment experiment;
        experiment.name = name;
        experiment.timeLimit = 1.0;
        for (const auto &[planner, run] : planners)
        {
            experiment.planners.push_back(
                {planner, std::vector<report::RunResult>(runs, solvedAt(run.first, run.second))});
        }
        return experiment;
    }
}  // namespace ompl_mfa::test

#endif
