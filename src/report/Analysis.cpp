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

#include "report/Analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_mfa::report
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();
        constexpr int CURVE_POINTS = 160;
        /* The first time of a curve, in parts of the time limit, if no run has a path earlier. */
        constexpr double EARLIEST = 0.01;

        /* The times of all runs to the level. */
        std::vector<double> levelTimes(const PlannerResults &planner, const Level &level, double bestCost)
        {
            std::vector<double> times;
            for (const RunResult &run : planner.runs)
            {
                const bool isFirst = level.excess == 0.0;
                // parts of a best cost that is not positive have no meaning
                const double target = bestCost > 0.0 ? bestCost * (1.0 + level.excess) : -NEVER;
                times.push_back(isFirst ? run.firstSolution : run.timeTo(target));
            }
            return times;
        }

        double bestCostOf(const Experiment &experiment)
        {
            double best = NEVER;
            for (const PlannerResults &planner : experiment.planners)
            {
                for (const RunResult &run : planner.runs)
                {
                    best = std::min(best, run.finalCost);
                }
            }
            return best;
        }

        double timeLimitOf(const Experiment &experiment)
        {
            double limit = experiment.timeLimit;
            for (const PlannerResults &planner : experiment.planners)
            {
                for (const RunResult &run : planner.runs)
                {
                    if (experiment.timeLimit <= 0.0 && !run.trace.empty())
                    {
                        limit = std::max(limit, run.trace.back().first);
                    }
                }
            }
            return limit > 0.0 ? limit : 1.0;
        }

        /* Times from the first path of any run to the limit, at equal ratios. */
        std::vector<double> curveTimes(const Experiment &experiment, double limit)
        {
            double first = EARLIEST * limit;
            for (const PlannerResults &planner : experiment.planners)
            {
                for (const RunResult &run : planner.runs)
                {
                    first = run.firstSolution > 0.0 ? std::min(first, run.firstSolution) : first;
                }
            }
            std::vector<double> times;
            for (int i = 0; i <= CURVE_POINTS; ++i)
            {
                times.push_back(first * std::pow(limit / first, static_cast<double>(i) / CURVE_POINTS));
            }
            times.back() = limit;
            return times;
        }

        std::vector<CurvePoint> curveOf(const PlannerResults &planner, const std::vector<double> &times)
        {
            std::vector<CurvePoint> curve;
            for (const double time : times)
            {
                std::vector<double> costs;
                std::size_t solved = 0;
                for (const RunResult &run : planner.runs)
                {
                    costs.push_back(run.costAt(time));
                    solved += run.firstSolution <= time ? 1 : 0;
                }
                curve.push_back({time, proportionEstimate(solved, planner.runs.size(), CONFIDENCE),
                                 medianEstimate(costs, CONFIDENCE)});
            }
            return curve;
        }

        PlannerSummary summarizePlanner(const PlannerResults &planner, const std::vector<double> &times)
        {
            PlannerSummary summary;
            summary.name = planner.name;
            summary.runs = planner.runs.size();
            std::vector<double> costs;
            for (const RunResult &run : planner.runs)
            {
                summary.solved += run.solved ? 1 : 0;
                summary.ended += run.ended ? 1 : 0;
                costs.push_back(run.finalCost);
            }
            summary.success = proportionEstimate(summary.solved, summary.runs, CONFIDENCE);
            summary.finalCost = medianEstimate(costs, CONFIDENCE);
            summary.curve = curveOf(planner, times);
            return summary;
        }

        /* Adds the times to one level and, where a planner gets there, the ratios to the best of the others. */
        void addLevel(const Experiment &experiment, const Level &level, ExperimentSummary &summary)
        {
            std::vector<std::vector<double>> times;
            std::vector<double> medians;
            for (const PlannerResults &planner : experiment.planners)
            {
                times.push_back(levelTimes(planner, level, summary.bestCost));
                medians.push_back(median(times.back()));
            }
            for (std::size_t own = 0; own < times.size(); ++own)
            {
                LevelTime entry;
                entry.time = medianEstimate(times[own], CONFIDENCE);
                entry.reached = static_cast<std::size_t>(
                    std::count_if(times[own].begin(), times[own].end(), [](double time) { return time < NEVER; }));
                std::size_t peer = own == 0 ? 1 : 0;
                for (std::size_t other = 0; other < times.size(); ++other)
                {
                    peer = other != own && medians[other] < medians[peer] ? other : peer;
                }
                if (times.size() > 1 && (medians[own] < NEVER || medians[peer] < NEVER))
                {
                    entry.isCompared = true;
                    entry.peer = medians[peer] < NEVER ? experiment.planners[peer].name : "";
                    entry.speed = medianRatio(times[peer], times[own], summary.timeLimit, CONFIDENCE);
                    entry.bound = medians[own] == NEVER ? -1 : (medians[peer] == NEVER ? 1 : 0);
                }
                summary.planners[own].levels.push_back(entry);
            }
        }

        const PlannerSummary &plannerOf(const ExperimentSummary &experiment, const std::string &name)
        {
            return *std::find_if(experiment.planners.begin(), experiment.planners.end(),
                                 [&name](const PlannerSummary &planner) { return planner.name == name; });
        }

        std::vector<std::string> commonPlanners(const std::vector<ExperimentSummary> &experiments)
        {
            std::vector<std::string> names;
            for (const PlannerSummary &planner : experiments.front().planners)
            {
                const auto hasIt = [&planner](const ExperimentSummary &experiment)
                {
                    return std::any_of(experiment.planners.begin(), experiment.planners.end(),
                                       [&planner](const PlannerSummary &other) { return other.name == planner.name; });
                };
                if (std::all_of(experiments.begin(), experiments.end(), hasIt))
                {
                    names.push_back(planner.name);
                }
            }
            return names;
        }

        /* For each experiment a value for each planner. */
        using Scores = std::vector<std::vector<double>>;

        PerformanceProfile profileOf(const std::string &level, const Scores &times)
        {
            PerformanceProfile profile;
            profile.level = level;
            std::vector<std::vector<double>> factors(times.front().size());
            for (const std::vector<double> &experiment : times)
            {
                const double best = *std::min_element(experiment.begin(), experiment.end());
                if (!(best < NEVER))
                {
                    continue;
                }
                ++profile.experiments;
                for (std::size_t i = 0; i < experiment.size(); ++i)
                {
                    const double factor = experiment[i] == best ? 1.0 : experiment[i] / best;
                    factors[i].push_back(factor);
                    if (factor < NEVER)
                    {
                        profile.factors.push_back(factor);
                    }
                }
            }
            std::sort(profile.factors.begin(), profile.factors.end());
            profile.factors.erase(std::unique(profile.factors.begin(), profile.factors.end()), profile.factors.end());
            for (const std::vector<double> &own : factors)
            {
                profile.shares.emplace_back();
                for (const double factor : profile.factors)
                {
                    const auto within =
                        std::count_if(own.begin(), own.end(), [factor](double value) { return value <= factor; });
                    profile.shares.back().push_back(static_cast<double>(within) /
                                                    static_cast<double>(profile.experiments));
                }
            }
            return profile;
        }

        /* The p-values of all pairs of planners, corrected, as a matrix. The differences are of logarithms, since the
           experiments have different scales. */
        std::vector<std::vector<double>> pairwise(const Scores &scores)
        {
            const std::size_t count = scores.front().size();
            std::vector<double> values;
            for (std::size_t a = 0; a < count; ++a)
            {
                for (std::size_t b = a + 1; b < count; ++b)
                {
                    std::vector<double> differences;
                    for (const std::vector<double> &experiment : scores)
                    {
                        const double x = experiment[a];
                        const double y = experiment[b];
                        differences.push_back(x == y ? 0.0 : (x > 0.0 && y > 0.0 ? std::log(x) - std::log(y) : x - y));
                    }
                    values.push_back(signedRankPValue(differences));
                }
            }
            const std::vector<double> corrected = holmCorrected(values);
            std::vector<std::vector<double>> matrix(count, std::vector<double>(count, 1.0));
            std::size_t pair = 0;
            for (std::size_t a = 0; a < count; ++a)
            {
                for (std::size_t b = a + 1; b < count; ++b)
                {
                    matrix[a][b] = matrix[b][a] = corrected[pair++];
                }
            }
            return matrix;
        }

        Ranking rankingOf(const std::string &measure, const Scores &scores)
        {
            Ranking ranking;
            ranking.measure = measure;
            ranking.test = friedman(scores);
            ranking.criticalDifference = criticalDifference(scores.front().size(), scores.size(), 1.0 - CONFIDENCE);
            for (std::size_t i = 0; i < scores.front().size(); ++i)
            {
                ranking.order.push_back(i);
            }
            std::stable_sort(ranking.order.begin(), ranking.order.end(),
                             [&ranking](std::size_t a, std::size_t b)
                             { return ranking.test.meanRanks[a] < ranking.test.meanRanks[b]; });
            const std::vector<double> against = pairwise(scores)[ranking.order.front()];
            for (const std::size_t planner : ranking.order)
            {
                ranking.againstBest.push_back(against[planner]);
            }
            return ranking;
        }

        template <typename Value>
        Scores scoresOf(const std::vector<ExperimentSummary> &experiments, const std::vector<std::string> &planners,
                        const Value &value)
        {
            Scores scores;
            for (const ExperimentSummary &experiment : experiments)
            {
                scores.emplace_back();
                for (const std::string &planner : planners)
                {
                    scores.back().push_back(value(plannerOf(experiment, planner)));
                }
            }
            return scores;
        }
    }  // namespace

    ExperimentSummary summarize(const Experiment &experiment, double reference)
    {
        ExperimentSummary summary;
        summary.name = experiment.name;
        summary.bestCost = bestCostOf(experiment);
        summary.isReference = reference < summary.bestCost;
        summary.bestCost = std::min(summary.bestCost, reference);
        summary.timeLimit = timeLimitOf(experiment);
        const std::vector<double> times = curveTimes(experiment, summary.timeLimit);
        for (const PlannerResults &planner : experiment.planners)
        {
            summary.planners.push_back(summarizePlanner(planner, times));
        }
        for (const Level &level : LEVELS)
        {
            addLevel(experiment, level, summary);
        }
        return summary;
    }

    Comparison compare(const std::vector<ExperimentSummary> &experiments)
    {
        Comparison comparison;
        if (experiments.size() < 2)
        {
            return comparison;
        }
        const std::vector<std::string> planners = commonPlanners(experiments);
        if (planners.size() < 2)
        {
            return comparison;
        }
        comparison.planners = planners;
        for (std::size_t level = 0; level < LEVELS.size(); ++level)
        {
            const Scores times =
                scoresOf(experiments, planners,
                         [level](const PlannerSummary &planner) { return planner.levels[level].time.value; });
            const PerformanceProfile profile = profileOf(LEVELS[level].name, times);
            if (profile.experiments > 0)
            {
                comparison.profiles.push_back(profile);
                comparison.rankings.push_back(
                    rankingOf(level == 0 ? "time to the first path" : "time to " + profile.level, times));
            }
        }
        comparison.rankings.push_back(rankingOf(
            "final cost",
            scoresOf(experiments, planners, [](const PlannerSummary &planner) { return planner.finalCost.value; })));
        return comparison;
    }
}  // namespace ompl_mfa::report
