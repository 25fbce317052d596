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

#include "report/Results.h"

#include <algorithm>
#include <cmath>

#include "text/NumberText.h"

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        std::string textOf(const RecordedRun &run, const std::string &name)
        {
            const auto found = run.values.find(name);
            return found == run.values.end() ? "" : found->second;
        }

        /* Infinite if the run does not have the value, or if it is not finite. */
        double numberOf(const RecordedRun &run, const std::string &name)
        {
            double value = NEVER;
            return text::readNumber(textOf(run, name), value) && std::isfinite(value) ? value : NEVER;
        }

        bool isTrue(const RecordedRun &run, const std::string &name, bool unknown)
        {
            const double value = numberOf(run, name);
            return std::isfinite(value) ? value != 0.0 : unknown;
        }

        double lastCost(const RecordedRun &run)
        {
            for (auto sample = run.progress.rbegin(); sample != run.progress.rend(); ++sample)
            {
                if (std::isfinite(sample->second))
                {
                    return sample->second;
                }
            }
            return NEVER;
        }

        double finalCost(const RecordedRun &run)
        {
            const double last = lastCost(run);
            for (const double cost :
                 {numberOf(run, "path_cost"), last, numberOf(run, "best_cost"), numberOf(run, "solution_length")})
            {
                if (std::isfinite(cost))
                {
                    return cost;
                }
            }
            return NEVER;
        }

        double firstSolution(const RecordedRun &run)
        {
            const double recorded = numberOf(run, "time_to_first_solution");
            if (std::isfinite(recorded))
            {
                return recorded;
            }
            const auto sample = std::find_if(run.progress.begin(), run.progress.end(),
                                             [](const auto &entry) { return std::isfinite(entry.second); });
            return sample != run.progress.end() ? sample->first : numberOf(run, "time");
        }
    }  // namespace

    double RunResult::costAt(double time) const
    {
        const auto later = std::upper_bound(trace.begin(), trace.end(), time,
                                            [](double when, const auto &entry) { return when < entry.first; });
        return later == trace.begin() ? NEVER : std::prev(later)->second;
    }

    double RunResult::timeTo(double cost) const
    {
        const auto reached =
            std::find_if(trace.begin(), trace.end(), [cost](const auto &entry) { return entry.second <= cost; });
        return reached == trace.end() ? NEVER : reached->first;
    }

    RunResult makeRunResult(const RecordedRun &recorded, double timeLimit)
    {
        RunResult result;
        result.run = textOf(recorded, "run");
        result.seed = textOf(recorded, "seed");
        result.ended = isTrue(recorded, "termination", false);
        result.solved = isTrue(recorded, "solved", false) && !isTrue(recorded, "approximate_solution", false) &&
                        isTrue(recorded, "correct_solution", true) && !result.ended;
        const double last = timeLimit > 0.0 ? 1.1 * timeLimit + 0.05 : NEVER;
        const double cost = finalCost(recorded);
        const double first = firstSolution(recorded);
        result.solved = result.solved && first <= last && std::isfinite(cost);
        if (!result.solved)
        {
            return result;
        }
        result.firstSolution = first;
        for (const auto &[time, value] : recorded.progress)
        {
            const double reached = std::max(value, cost);
            if (std::isfinite(value) && time <= last && (result.trace.empty() || reached < result.trace.back().second))
            {
                result.trace.emplace_back(std::max(time, first), reached);
            }
        }
        const double returned = std::max(first, numberOf(recorded, "time"));
        if ((result.trace.empty() || result.trace.back().second > cost) && returned <= last)
        {
            result.trace.emplace_back(result.trace.empty() ? returned : std::max(returned, result.trace.back().first),
                                      cost);
        }
        result.finalCost = result.trace.empty() ? NEVER : result.trace.back().second;
        return result;
    }
}  // namespace ompl_mfa::report
