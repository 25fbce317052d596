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

#include "report/ReportTables.h"

#include <algorithm>
#include <cmath>

#include "report/WebPage.h"

namespace ompl_mfa::report
{
    namespace
    {
        using nlohmann::json;

        constexpr double MILLISECONDS = 1e3;
        constexpr double PERCENT = 1e2;
        constexpr int DIGITS = 3;
        constexpr int COST_DIGITS = 5;

        json finite(double value)
        {
            return std::isfinite(value) ? json(value) : json();
        }

        json toJson(const Estimate &estimate)
        {
            return {{"value", finite(estimate.value)},
                    {"lower", finite(estimate.lower)},
                    {"upper", finite(estimate.upper)},
                    {"coverage", estimate.coverage}};
        }

        json toJson(const PlannerSummary &planner)
        {
            json levels = json::array();
            for (std::size_t i = 0; i < planner.levels.size(); ++i)
            {
                const LevelTime &entry = planner.levels[i];
                const char *const bounds[] = {"at most", "", "at least"};
                levels.push_back({{"level", LEVELS[i].name},
                                  {"reached", entry.reached},
                                  {"time", toJson(entry.time)},
                                  {"best_peer", entry.peer.empty() ? json() : json(entry.peer)},
                                  {"speed", entry.isCompared ? toJson(entry.speed) : json()},
                                  {"speed_is", bounds[entry.bound + 1]}});
            }
            return {{"planner", planner.name},
                    {"runs", planner.runs},
                    {"solved", planner.solved},
                    {"ended_from_outside", planner.ended},
                    {"success", toJson(planner.success)},
                    {"final_cost", toJson(planner.finalCost)},
                    {"levels", levels}};
        }

        json toJson(const Comparison &comparison)
        {
            json rankings = json::array();
            for (const Ranking &ranking : comparison.rankings)
            {
                json planners = json::array();
                for (std::size_t i = 0; i < ranking.order.size(); ++i)
                {
                    planners.push_back({{"planner", comparison.planners[ranking.order[i]]},
                                        {"mean_rank", ranking.test.meanRanks[ranking.order[i]]},
                                        {"p_against_best", ranking.againstBest[i]}});
                }
                rankings.push_back({{"measure", ranking.measure},
                                    {"friedman_statistic", ranking.test.statistic},
                                    {"friedman_p", ranking.test.pValue},
                                    {"critical_difference", ranking.criticalDifference},
                                    {"planners", planners}});
            }
            json profiles = json::array();
            for (const PerformanceProfile &profile : comparison.profiles)
            {
                json shares = json::object();
                for (std::size_t i = 0; i < comparison.planners.size(); ++i)
                {
                    shares[comparison.planners[i]] = profile.shares[i];
                }
                profiles.push_back({{"level", profile.level},
                                    {"experiments", profile.experiments},
                                    {"factors", profile.factors},
                                    {"shares", shares}});
            }
            return {{"rankings", rankings}, {"profiles", profiles}};
        }

        std::string interval(const Estimate &estimate, double unit, int digits)
        {
            return "<span class=\"interval\">[" + significant(estimate.lower * unit, digits) + ", " +
                   significant(estimate.upper * unit, digits) + "]</span>";
        }

        std::string estimateCell(const Estimate &estimate, double unit, int digits)
        {
            if (!std::isfinite(estimate.value) && !std::isfinite(estimate.lower))
            {
                return "<td>-</td>";
            }
            return "<td>" + significant(estimate.value * unit, digits) + " " + interval(estimate, unit, digits) +
                   "</td>";
        }

        std::string levelHeads(const std::string &unit)
        {
            std::string heads;
            for (const Level &level : LEVELS)
            {
                heads += "<th scope=\"col\">" + std::string(level.name) + unit + "</th>";
            }
            return heads;
        }

        std::string rowBegin(const std::string &planner)
        {
            return "<tr><th scope=\"row\">" + escaped(planner) + "</th>";
        }

        std::string ratioCell(const LevelTime &entry)
        {
            if (!entry.isCompared)
            {
                return "<td>-</td>";
            }
            const char *const bounds[] = {"&lt; ", "", "&gt; "};
            return "<td" + std::string(entry.bound >= 0 && entry.speed.lower > 1.0 ? " class=\"ahead\"" : "") + ">" +
                   bounds[entry.bound + 1] + significant(entry.speed.value, DIGITS) + " " +
                   interval(entry.speed, 1.0, DIGITS) + "<br><span class=\"peer\">" +
                   (entry.peer.empty() ? "no other" : escaped(entry.peer)) + "</span></td>";
        }
    }  // namespace

    json tablesAsJson(const std::vector<Experiment> &experiments, const std::vector<ExperimentSummary> &summaries,
                      const Comparison &comparison)
    {
        json tables{{"experiments", json::array()}, {"comparison", toJson(comparison)}};
        for (std::size_t i = 0; i < experiments.size(); ++i)
        {
            const Experiment &experiment = experiments[i];
            const ExperimentSummary &summary = summaries[i];
            json planners = json::array();
            for (const PlannerSummary &planner : summary.planners)
            {
                planners.push_back(toJson(planner));
            }
            tables["experiments"].push_back({{"experiment", experiment.name},
                                             {"files", experiment.files},
                                             {"version", experiment.version},
                                             {"host", experiment.host},
                                             {"cpu", experiment.cpu},
                                             {"start", experiment.start},
                                             {"seed", experiment.seed},
                                             {"objective", experiment.objective},
                                             {"time_limit", experiment.timeLimit},
                                             {"best_cost", finite(summary.bestCost)},
                                             {"best_cost_is_reference", summary.isReference},
                                             {"planners", planners}});
        }
        return tables;
    }

    std::string resultsTable(const ExperimentSummary &summary)
    {
        std::string html =
            "<div class=\"wide\"><table><caption>Success, final cost, and time to each quality in "
            "ms: medians with 95 % intervals</caption><thead><tr><th scope=\"col\">planner</th>"
            "<th scope=\"col\">solved</th><th scope=\"col\">success [%]</th>"
            "<th scope=\"col\">final cost</th>" +
            levelHeads(" [ms]") + "</tr></thead><tbody>\n";
        for (const PlannerSummary &planner : summary.planners)
        {
            html += rowBegin(planner.name) + "<td>" + std::to_string(planner.solved) + " of " +
                    std::to_string(planner.runs) +
                    (planner.ended > 0 ? ", " + std::to_string(planner.ended) + " crashed or were ended" : "") +
                    "</td>" + estimateCell(planner.success, PERCENT, DIGITS) +
                    estimateCell(planner.finalCost, 1.0, COST_DIGITS);
            for (const LevelTime &entry : planner.levels)
            {
                html += estimateCell(entry.time, MILLISECONDS, DIGITS);
            }
            html += "</tr>\n";
        }
        return html + "</tbody></table></div>\n";
    }

    std::string ratiosTable(const ExperimentSummary &summary)
    {
        std::string html =
            "<div class=\"wide\"><table><caption>Speed: median time of the best other planner divided by "
            "that of this one, with 95 % intervals; bold where the interval is above 1</caption>"
            "<thead><tr><th scope=\"col\">planner</th>" +
            levelHeads("") + "</tr></thead><tbody>\n";
        for (const PlannerSummary &planner : summary.planners)
        {
            html += rowBegin(planner.name);
            for (const LevelTime &entry : planner.levels)
            {
                html += ratioCell(entry);
            }
            html += "</tr>\n";
        }
        return html + "</tbody></table></div>\n";
    }

    std::string curvesTable(const ExperimentSummary &summary)
    {
        constexpr std::size_t COLUMNS = 8;
        const std::vector<CurvePoint> &times = summary.planners.front().curve;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < COLUMNS; ++i)
        {
            places.push_back(i * (times.size() - 1) / (COLUMNS - 1));
        }
        std::string html =
            "<div class=\"wide\"><table><caption>Runs solved and median cost over time</caption>"
            "<thead><tr><th scope=\"col\">planner</th>";
        for (const std::size_t place : places)
        {
            html += "<th scope=\"col\">" + significant(times[place].time, DIGITS) + " s</th>";
        }
        html += "</tr></thead><tbody>\n";
        for (const PlannerSummary &planner : summary.planners)
        {
            html += rowBegin(planner.name);
            for (const std::size_t place : places)
            {
                const CurvePoint &point = planner.curve[place];
                html += "<td>" + significant(point.solved.value * PERCENT, DIGITS) + " %, " +
                        (std::isfinite(point.cost.value) ? significant(point.cost.value, COST_DIGITS) : "-") + "</td>";
            }
            html += "</tr>\n";
        }
        return html + "</tbody></table></div>\n";
    }

    std::string ranksTable(const Comparison &comparison, const Ranking &ranking)
    {
        std::string html = "<div class=\"wide\"><table><caption>" + escaped(ranking.measure) +
                           ": mean ranks; Friedman's test p = " + significant(ranking.test.pValue, 2) +
                           ", critical difference " + significant(ranking.criticalDifference, DIGITS) +
                           "</caption><thead><tr><th scope=\"col\">planner</th><th scope=\"col\">mean rank</th>"
                           "<th scope=\"col\">p against the first</th></tr></thead><tbody>\n";
        for (std::size_t i = 0; i < ranking.order.size(); ++i)
        {
            const std::size_t planner = ranking.order[i];
            html += rowBegin(comparison.planners[planner]) + "<td>" +
                    significant(ranking.test.meanRanks[planner], DIGITS) + "</td><td>" +
                    (i == 0 ? "-" : significant(ranking.againstBest[i], 2)) + "</td></tr>\n";
        }
        return html + "</tbody></table></div>\n";
    }

    double lowestCoverage(const ExperimentSummary &summary)
    {
        double lowest = 1.0;
        for (const PlannerSummary &planner : summary.planners)
        {
            lowest = std::min(lowest, planner.finalCost.coverage);
            for (const LevelTime &entry : planner.levels)
            {
                lowest = entry.isCompared ? std::min(lowest, entry.speed.coverage) : lowest;
            }
        }
        return lowest;
    }
}  // namespace ompl_mfa::report
