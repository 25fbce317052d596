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

#include "report/ReportPage.h"

#include <algorithm>
#include <cmath>

#include "report/Diagrams.h"
#include "report/EmbeddedTexts.h"
#include "report/ReportTables.h"
#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::report
{
    namespace
    {
        using nlohmann::json;

        constexpr double PERCENT = 100.0;
        /* Significant digits of the plots' data. */
        constexpr int PLOT_DIGITS = 6;

        /* A number for a plot; null if it is not finite. */
        json plotted(double value)
        {
            double rounded = 0.0;
            text::readNumber(text::numberText(value, PLOT_DIGITS), rounded);
            return std::isfinite(value) ? json(rounded) : json();
        }

        json plotted(const Estimate &estimate, double unit)
        {
            return {plotted(estimate.lower * unit), plotted(estimate.value * unit), plotted(estimate.upper * unit)};
        }

        /* All planners of the report; the place of a planner determines its colour in all plots. */
        std::vector<std::string> plannersOf(const Report &report)
        {
            std::vector<std::string> names;
            for (const ExperimentSummary &summary : report.summaries)
            {
                for (const PlannerSummary &planner : summary.planners)
                {
                    if (std::find(names.begin(), names.end(), planner.name) == names.end())
                    {
                        names.push_back(planner.name);
                    }
                }
            }
            return names;
        }

        json curvesData(const ExperimentSummary &summary)
        {
            json solved = json::array();
            json cost = json::array();
            for (std::size_t i = 0; i < summary.planners.front().curve.size(); ++i)
            {
                const json time = plotted(summary.planners.front().curve[i].time);
                solved.push_back({time});
                cost.push_back({time});
                for (const PlannerSummary &planner : summary.planners)
                {
                    solved.back().push_back(plotted(planner.curve[i].solved, PERCENT));
                    cost.back().push_back(plotted(planner.curve[i].cost, 1.0));
                }
            }
            return {{"solved", solved}, {"cost", cost}};
        }

        /* First solution and final cost of all runs: time, place of the planner, cost. */
        json runsData(const Experiment &experiment)
        {
            json runs = json::array();
            for (std::size_t place = 0; place < experiment.planners.size(); ++place)
            {
                for (const RunResult &run : experiment.planners[place].runs)
                {
                    if (std::isfinite(run.firstSolution) && std::isfinite(run.finalCost))
                    {
                        runs.push_back({plotted(run.firstSolution), place, plotted(run.finalCost)});
                    }
                }
            }
            return runs;
        }

        json pageData(const Report &report)
        {
            const std::vector<std::string> names = plannersOf(report);
            json planners = json::array();
            for (std::size_t i = 0; i < names.size(); ++i)
            {
                const LineLook look = lineLook(i);
                planners.push_back({{"name", names[i]}, {"colour", look.colour}, {"pattern", look.pattern}});
            }
            json experiments = json::array();
            for (std::size_t i = 0; i < report.summaries.size(); ++i)
            {
                const ExperimentSummary &summary = report.summaries[i];
                json own = json::array();
                for (const PlannerSummary &planner : summary.planners)
                {
                    own.push_back(planner.name);
                }
                json data = curvesData(summary);
                data["name"] = summary.name;
                data["planners"] = own;
                data["best"] = plotted(summary.bestCost);
                data["runs"] = runsData(report.experiments[i]);
                experiments.push_back(data);
            }
            json profiles = json::array();
            for (const PerformanceProfile &profile : report.comparison.profiles)
            {
                json rows = json::array();
                for (std::size_t i = 0; i < profile.factors.size(); ++i)
                {
                    rows.push_back({plotted(profile.factors[i])});
                    for (const std::vector<double> &shares : profile.shares)
                    {
                        rows.back().push_back(plotted(shares[i] * PERCENT));
                    }
                }
                profiles.push_back({{"level", profile.level}, {"rows", rows}});
            }
            return {{"planners", planners},
                    {"experiments", experiments},
                    {"profiles", profiles},
                    {"compared", report.comparison.planners}};
        }

        std::string plot(const std::string &kind, std::size_t place, const std::string &caption)
        {
            return "<figure><figcaption>" + escaped(caption) + "</figcaption><div class=\"plot\" data-plot=\"" + kind +
                   "\" data-place=\"" + std::to_string(place) + "\"></div><div class=\"values\"></div></figure>\n";
        }

        /* A row of the list of facts; nothing for an empty value. */
        std::string fact(const std::string &name, const std::string &value)
        {
            return value.empty() ? "" : "<dt>" + name + "</dt><dd>" + escaped(value) + "</dd>\n";
        }

        std::string facts(const Experiment &experiment, const ExperimentSummary &summary)
        {
            std::string files;
            for (const std::string &file : experiment.files)
            {
                files += (files.empty() ? "" : ", ") + file;
            }
            std::size_t most = 0;
            for (const PlannerSummary &planner : summary.planners)
            {
                most = std::max(most, planner.runs);
            }
            const std::string best = std::isfinite(summary.bestCost)
                                         ? text::numberText(summary.bestCost, PLOT_DIGITS) +
                                               (summary.isReference ? " (given)" : " (of these runs)")
                                         : "none";
            return "<dl>" + fact("results", files) + fact("started", experiment.start) +
                   fact("program", experiment.version) + fact("machine", experiment.host) +
                   fact("processor", experiment.cpu) + fact("objective", experiment.objective) +
                   fact("time limit", text::numberText(experiment.timeLimit, PLOT_DIGITS) + " s per run") +
                   fact("memory limit", text::numberText(experiment.memoryLimit, PLOT_DIGITS) + " MB per run") +
                   fact("base seed", experiment.seed) + fact("runs", std::to_string(most) + " per planner") +
                   fact("best known cost", best) + "</dl>\n";
        }

        std::string experimentSection(const Report &report, std::size_t place)
        {
            const Experiment &experiment = report.experiments[place];
            const ExperimentSummary &summary = report.summaries[place];
            std::string html = "<section id=\"experiment-" + std::to_string(place) + "\"><h2>" +
                               escaped(experiment.name) + "</h2>\n" + facts(experiment, summary) +
                               "<div class=\"plots\">\n" + plot("solved", place, "Success over time") +
                               plot("cost", place, "Median cost over time") +
                               plot("runs", place, "Runs: first solution and final cost") + "</div>\n" + "<noscript>" +
                               curvesTable(summary) + "</noscript>\n" + resultsTable(summary);
            if (summary.planners.size() > 1)
            {
                html += ratiosTable(summary);
            }
            const double coverage = lowestCoverage(summary);
            if (coverage < CONFIDENCE)
            {
                html +=
                    "<p class=\"warning\">With so few runs some intervals, which are the range of all runs, cover "
                    "with only " +
                    significant(PERCENT * coverage, 3) + " %.</p>\n";
            }
            return html + "</section>\n";
        }

        std::string comparisonSection(const Report &report)
        {
            const Comparison &comparison = report.comparison;
            if (comparison.planners.empty())
            {
                return "";
            }
            std::string html = "<section id=\"all\"><h2>All " + std::to_string(report.summaries.size()) +
                               " experiments</h2>\n<div class=\"plots\">\n";
            for (std::size_t i = 0; i < comparison.profiles.size(); ++i)
            {
                const PerformanceProfile &profile = comparison.profiles[i];
                html += plot("profile", i,
                             "Performance profile: " + profile.level + ", " + std::to_string(profile.experiments) +
                                 " experiments");
            }
            html += "</div>\n<div class=\"plots\">\n";
            for (const Ranking &ranking : comparison.rankings)
            {
                html += "<figure><figcaption>Mean ranks: " + escaped(ranking.measure) + "</figcaption>" +
                        rankDiagram(comparison, ranking) + ranksTable(comparison, ranking) + "</figure>\n";
            }
            return html + "</div>\n</section>\n";
        }

        std::string picturesSection(const Report &report)
        {
            if (report.pictures.empty())
            {
                return "";
            }
            std::string html = "<section id=\"pictures\"><h2>Pictures</h2>\n<div class=\"plots\">\n";
            for (const ReportPicture &picture : report.pictures)
            {
                html += "<figure><figcaption>" + escaped(picture.caption) + "</figcaption><img src=\"" +
                        picture.address + "\" alt=\"" + escaped(picture.caption) + "\"></figure>\n";
            }
            return html + "</div>\n</section>\n";
        }

        std::string legend(const std::vector<std::string> &planners)
        {
            std::string html = "<fieldset class=\"legend\"><legend>Planners</legend>\n";
            for (std::size_t i = 0; i < planners.size(); ++i)
            {
                const LineLook look = lineLook(i);
                std::string pattern;
                for (const int length : look.pattern)
                {
                    pattern += (pattern.empty() ? "" : " ") + std::to_string(length);
                }
                html += "<label><input type=\"checkbox\" checked value=\"" + escaped(planners[i]) +
                        "\"><svg width=\"30\" height=\"10\" aria-hidden=\"true\"><line x1=\"1\" y1=\"5\" x2=\"29\" "
                        "y2=\"5\" stroke=\"" +
                        look.colour + "\" stroke-width=\"3\" stroke-dasharray=\"" + pattern + "\"/></svg>" +
                        escaped(planners[i]) + "</label>\n";
            }
            return html +
                   "<label class=\"axis\">Cost axis <select id=\"cost-axis\"><option value=\"excess\">% above the best "
                   "known, logarithmic</option><option value=\"cost\">cost</option></select></label>"
                   "<span class=\"hint\">Drag in a plot to zoom, double-click to zoom out.</span></fieldset>\n";
        }

        std::string contents(const Report &report)
        {
            std::string html = "<nav>";
            if (!report.comparison.planners.empty())
            {
                html += "<a href=\"#all\">all experiments</a> ";
            }
            for (std::size_t i = 0; i < report.experiments.size(); ++i)
            {
                html += "<a href=\"#experiment-" + std::to_string(i) + "\">" + escaped(report.experiments[i].name) +
                        "</a> ";
            }
            return html + (report.pictures.empty() ? "" : "<a href=\"#pictures\">pictures</a> ") +
                   "<a href=\"#method\">method</a></nav>\n";
        }

        std::string methodSection(const Report &report)
        {
            return "<section id=\"method\"><h2>Method</h2>\n<ul>\n"
                   "<li>A run is <b>solved</b> if the planner returned an exact path that passed OMPL's check. Runs "
                   "that crashed or were ended from outside count as not solved.</li>\n"
                   "<li><b>Times</b> are wall-clock seconds since the start of <code>solve()</code>. A cost is reached "
                   "at the first progress sample that shows it, so times to a quality are as exact as the interval "
                   "between samples. A planner that publishes no best cost has its path's cost from its return on. "
                   "Costs are minimised and those of paths before simplification.</li>\n"
                   "<li><b>Medians</b> are over all runs; a run that does not get there counts as infinite (∞). Their "
                   "<b>95 % intervals</b> are from the r-th smallest to the r-th largest run, with the largest r for "
                   "which the binomial distribution gives a coverage of at least 95 %, whatever the distribution of "
                   "times and costs. With fewer than six runs they are the range of all runs, which covers less. Bands "
                   "hold at each time separately, not for the whole curve.</li>\n"
                   "<li><b>Shares of solved runs</b> have the exact interval of Clopper and Pearson.</li>\n"
                   "<li><b>10 %</b>, 5 %, 1 %, 0.1 %: a cost at most this much above the best known one, which is the "
                   "lowest of these runs or, if lower, the one given.</li>\n"
                   "<li><b>Speed</b>: the best other planner is chosen by its median, which favours it. Its median is "
                   "divided by the planner's own. One that does not get there counts with the time limit, so that "
                   "&lt; and &gt; mark bounds. The interval joins those of both medians, each with a coverage of at "
                   "least √0.95; it is wider than necessary.</li>\n"
                   "<li><b>Performance profile</b>: the share of the experiments in which a planner's median time is "
                   "at most the factor times the best planner's. Experiments where no planner gets there are left "
                   "out.</li>\n"
                   "<li><b>Mean ranks</b> over experiments, of medians; equal ones share a rank. Bars join planners "
                   "whose mean ranks differ by at most Nemenyi's critical difference (5 %). The tables have Friedman's "
                   "test, and Wilcoxon's signed-rank test against the first, of logarithms of medians, exact, "
                   "corrected "
                   "for all pairs by Holm's method.</li>\n"
                   "</ul>\n<p>Made by</p><pre>" +
                   escaped(report.command) +
                   "</pre>\n<p class=\"small\">Plots by dygraphs (https://dygraphs.com), copyright Dan Vanderkam and "
                   "others, MIT licence.</p></section>\n";
        }
    }  // namespace

    std::string reportPage(const Report &report)
    {
        WebPage page;
        page.title = report.title;
        page.body = "<header><h1>" + escaped(report.title) + "</h1>\n" + contents(report) + "</header>\n<main>\n" +
                    "<noscript><style>.plot, .legend { display: none; }</style><p>The plots need scripts. Tables of "
                    "the curves stand in their places.</p></noscript>\n" +
                    legend(plannersOf(report)) + comparisonSection(report);
        for (std::size_t i = 0; i < report.experiments.size(); ++i)
        {
            page.body += experimentSection(report, i);
        }
        page.body += picturesSection(report) + methodSection(report) + "</main>";
        page.data = pageData(report);
        page.styles = {DYGRAPH_STYLE, PAGE_STYLE};
        page.scripts = {DYGRAPH_SCRIPT, REPORT_SCRIPT};
        return htmlOf(page);
    }
}  // namespace ompl_mfa::report
