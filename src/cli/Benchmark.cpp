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

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/FileNames.h"
#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "cli/NumberOption.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {

        constexpr int SIGNAL_STATUS = 128;
        /* Value of the property `termination`. */
        const char *const RETURNED = "0";
        constexpr double LONGEST_GRACE = 1e9;
        const char *const ACCEPTED_GRACE = "a number from 0 to 1e9 (seconds)";

        struct Options
        {
            std::string config;
            std::string output;
            std::string shard;
            std::string database;
            benchmark::CampaignOptions campaign;
            bool quiet{false};
            bool json{false};
        };

        /** \brief The runs of one planner, in numbers. */
        struct PlannerSummary
        {
            std::string name;
            std::size_t runs{0};
            std::size_t solved{0};
            /** \brief Runs that did not return normally. */
            std::size_t ended{0};
            std::vector<double> firstSolutions;
            std::vector<double> costs;
            std::vector<double> simplifiedCosts;
        };

        /** \brief A run of a campaign over a set of problems. */
        struct SetRun
        {
            std::string problem;
            bool isSolved{false};
            /** \brief Seconds, and costs; infinite if there is no exact solution. */
            double firstSolution{INFINITY};
            double cost{INFINITY};
            /** \brief Of the scenario. */
            double octileLength{NAN};
        };

        /** \brief All runs of one planner over a set of problems. Quantiles are infinite where they are of runs without
            a solution. */
        struct SetSummary
        {
            std::string name;
            std::size_t runs{0};
            std::size_t solved{0};
            double firstSolutionMedian{NAN};
            double firstSolution95{NAN};
            /** \brief The cost relative to the least of any run of any planner on the same problem, and to the octile
                length. */
            double toBestMedian{NAN};
            double toBest95{NAN};
            double toOctileMedian{NAN};
        };

        std::string propertyOf(const benchmark::LogProperties &run, const std::string &property)
        {
            const auto found = run.find(property);
            return found == run.end() ? "" : found->second;
        }

        void addFinite(std::vector<double> &values, const benchmark::LogProperties &run, const std::string &property)
        {
            double value = 0.0;
            if (text::readNumber(propertyOf(run, property), value) && std::isfinite(value))
            {
                values.push_back(value);
            }
        }

        double numberOf(const benchmark::LogProperties &run, const std::string &property, double missing)
        {
            double value = 0.0;
            return text::readNumber(propertyOf(run, property), value) && std::isfinite(value) ? value : missing;
        }

        SetRun setRunOf(const benchmark::LogProperties &run)
        {
            SetRun result;
            result.problem = propertyOf(run, "problem INTEGER");
            result.isSolved = propertyOf(run, "solved BOOLEAN") == "1";
            result.octileLength = numberOf(run, "octile length REAL", NAN);
            if (result.isSolved)
            {
                result.firstSolution = numberOf(run, "time to first solution REAL", INFINITY);
                result.cost = numberOf(run, "path cost REAL", INFINITY);
            }
            return result;
        }

        /** \brief The smallest value that at least this share of the values does not exceed. */
        double quantile(std::vector<double> values, double share)
        {
            if (values.empty())
            {
                return NAN;
            }
            std::sort(values.begin(), values.end());
            const double rank = std::ceil(share * static_cast<double>(values.size()));
            return values[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
        }

        SetSummary summarizeSet(const std::string &name, const std::vector<SetRun> &runs,
                                const std::map<std::string, double> &best)
        {
            constexpr double MOST = 0.95;
            SetSummary summary;
            summary.name = name;
            summary.runs = runs.size();
            std::vector<double> times;
            std::vector<double> toBest;
            std::vector<double> toOctile;
            for (const SetRun &run : runs)
            {
                summary.solved += run.isSolved ? 1 : 0;
                times.push_back(run.firstSolution);
                const double least = best.at(run.problem);
                // start and goal may be the same cell
                toBest.push_back(run.cost == least && run.isSolved ? 1.0 : run.cost / least);
                if (run.octileLength > 0.0)
                {
                    toOctile.push_back(run.cost / run.octileLength);
                }
            }
            summary.firstSolutionMedian = quantile(times, 0.5);
            summary.firstSolution95 = quantile(times, MOST);
            summary.toBestMedian = quantile(toBest, 0.5);
            summary.toBest95 = quantile(toBest, MOST);
            summary.toOctileMedian = quantile(toOctile, 0.5);
            return summary;
        }

        std::string nameOf(const benchmark::PlannerLog &planner)
        {
            return planner.name.substr(planner.name.find('_') + 1);
        }

        /** \brief Empty for a campaign of a single problem. */
        std::vector<SetSummary> summarizeSets(const benchmark::BenchmarkLog &log)
        {
            std::vector<std::vector<SetRun>> runs;
            std::map<std::string, double> best;
            for (const auto &planner : log.planners)
            {
                runs.emplace_back();
                for (const auto &run : planner.runs)
                {
                    runs.back().push_back(setRunOf(run));
                    const SetRun &made = runs.back().back();
                    double &least = best.try_emplace(made.problem, INFINITY).first->second;
                    least = std::min(least, made.cost);
                }
            }
            if (best.empty() || best.begin()->first.empty())
            {
                return {};
            }
            std::vector<SetSummary> summaries;
            for (std::size_t i = 0; i < runs.size(); ++i)
            {
                summaries.push_back(summarizeSet(nameOf(log.planners[i]), runs[i], best));
            }
            return summaries;
        }

        std::vector<PlannerSummary> summarize(const benchmark::BenchmarkLog &log)
        {
            std::vector<PlannerSummary> summaries;
            for (const auto &planner : log.planners)
            {
                PlannerSummary summary;
                summary.name = nameOf(planner);
                for (const auto &run : planner.runs)
                {
                    ++summary.runs;
                    summary.solved += propertyOf(run, "solved BOOLEAN") == "1" ? 1 : 0;
                    summary.ended += propertyOf(run, "termination ENUM") == RETURNED ? 0 : 1;
                    addFinite(summary.firstSolutions, run, "time to first solution REAL");
                    addFinite(summary.costs, run, "path cost REAL");
                    addFinite(summary.simplifiedCosts, run, "simplified path cost REAL");
                }
                summaries.push_back(summary);
            }
            return summaries;
        }

        double median(std::vector<double> values)
        {
            if (values.empty())
            {
                return NAN;
            }
            std::sort(values.begin(), values.end());
            return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
        }

        double mean(const std::vector<double> &values)
        {
            double sum = 0.0;
            for (const double value : values)
            {
                sum += value;
            }
            return values.empty() ? NAN : sum / static_cast<double>(values.size());
        }

        std::string cell(double value)
        {
            return std::isfinite(value) ? text::numberText(value, 4) : "-";
        }

        void printTable(const std::vector<PlannerSummary> &summaries)
        {
            std::printf("%-20s %6s %7s %7s %16s %12s %12s\n", "planner", "runs", "solved", "killed", "first solution s",
                        "mean cost", "simplified");
            for (const auto &summary : summaries)
            {
                std::printf("%-20s %6zu %7zu %7zu %16s %12s %12s\n", summary.name.c_str(), summary.runs, summary.solved,
                            summary.ended, cell(median(summary.firstSolutions)).c_str(),
                            cell(mean(summary.costs)).c_str(), cell(mean(summary.simplifiedCosts)).c_str());
            }
        }

        void printSetTable(const std::vector<SetSummary> &summaries)
        {
            std::printf("%-20s %6s %9s %16s %12s %14s %12s %14s\n", "planner", "runs", "solved %", "first solution s",
                        "95 % s", "cost / best", "95 %", "cost / octile");
            for (const auto &summary : summaries)
            {
                const double share =
                    summary.runs == 0 ? NAN
                                      : 100.0 * static_cast<double>(summary.solved) / static_cast<double>(summary.runs);
                std::printf("%-20s %6zu %9s %16s %12s %14s %12s %14s\n", summary.name.c_str(), summary.runs,
                            cell(share).c_str(), cell(summary.firstSolutionMedian).c_str(),
                            cell(summary.firstSolution95).c_str(), cell(summary.toBestMedian).c_str(),
                            cell(summary.toBest95).c_str(), cell(summary.toOctileMedian).c_str());
            }
        }

        void addSets(const std::vector<SetSummary> &sets, nlohmann::json &planners)
        {
            for (std::size_t i = 0; i < sets.size(); ++i)
            {
                planners[i]["first_solution_set_median"] = finiteOrNull(sets[i].firstSolutionMedian);
                planners[i]["first_solution_set_95"] = finiteOrNull(sets[i].firstSolution95);
                planners[i]["cost_to_best_median"] = finiteOrNull(sets[i].toBestMedian);
                planners[i]["cost_to_best_95"] = finiteOrNull(sets[i].toBest95);
                planners[i]["cost_to_octile_median"] = finiteOrNull(sets[i].toOctileMedian);
            }
        }

        void printJson(const std::string &log, const std::vector<PlannerSummary> &summaries,
                       const std::vector<SetSummary> &sets)
        {
            nlohmann::json document{{"log", log}, {"planners", nlohmann::json::array()}};
            for (const auto &summary : summaries)
            {
                document["planners"].push_back({{"planner", summary.name},
                                                {"runs", summary.runs},
                                                {"solved", summary.solved},
                                                {"ended_from_outside", summary.ended},
                                                {"first_solution_median", finiteOrNull(median(summary.firstSolutions))},
                                                {"cost_mean", finiteOrNull(mean(summary.costs))},
                                                {"simplified_cost_mean", finiteOrNull(mean(summary.simplifiedCosts))}});
            }
            addSets(sets, document["planners"]);
            printDocument(document);
        }

        void readShard(const std::string &text, benchmark::CampaignOptions &options)
        {
            if (text.empty())
            {
                return;
            }
            const std::size_t slash = text.find('/');
            if (slash == std::string::npos || !text::readNumber(text.substr(0, slash), options.shard) ||
                !text::readNumber(text.substr(slash + 1), options.shards) || options.shard < 1 ||
                options.shard > options.shards)
            {
                throw InputError("--shard " + text + ": accepted is I/N with 1 <= I <= N, such as 2/8");
            }
        }

        void runBenchmark(Options options, bool graceGiven)
        {
            readShard(options.shard, options.campaign);
            if (graceGiven && !(options.campaign.grace >= 0.0 && options.campaign.grace <= LONGEST_GRACE))
            {
                throw InputError("--grace " + text::numberText(options.campaign.grace) + ": expected " +
                                 ACCEPTED_GRACE);
            }
            const benchmark::BenchmarkConfig config = benchmark::readBenchmarkConfig(options.config);
            const benchmark::Campaign campaign = benchmark::makeCampaign(config);
            campaign.validate();
            options.campaign.database = benchmark::writtenPath(options.database, "--database " + options.database);
            options.campaign.log = options.output.empty()
                                       ? benchmark::logFile(config, options.campaign.shard, options.campaign.shards)
                                       : benchmark::writtenPath(options.output, "--output " + options.output);
            options.campaign.progress = options.quiet ? nullptr : &std::cerr;
            options.campaign.terminal = isatty(STDERR_FILENO) != 0;

            const benchmark::CampaignResult result = campaign.run(options.campaign);
            const auto summaries = summarize(result.log);
            const auto sets = summarizeSets(result.log);
            if (options.json)
            {
                printJson(options.campaign.log.string(), summaries, sets);
            }
            else if (!sets.empty())
            {
                printSetTable(sets);
            }
            else
            {
                printTable(summaries);
            }
            std::cerr << "log: " << options.campaign.log.string() << std::endl;
            if (result.interruptedBy != 0)
            {
                std::cerr << "stopped with " << result.missing << " runs to go; --resume continues" << std::endl;
                throw CLI::RuntimeError(SIGNAL_STATUS + result.interruptedBy);
            }
        }
    }  // namespace

    void addBenchmarkCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("benchmark", "Run the planners of an OMPL benchmark config and write a log");
        command->add_option("config", options->config, "OMPL benchmark config (.cfg)")->required();
        command->add_option("--output", options->output, "The log; without it NAME.log where benchmark.output says");
        command->add_option("--database", options->database,
                            "Add the runs to this SQLite database for Planner Arena, which may hold other campaigns");
        command->add_option("--jobs", options->campaign.jobs, "Runs at the same time")
            ->check(CLI::Range(1, 4096))
            ->capture_default_str();
        command->add_option("--shard", options->shard,
                            "Make only part I of N, as I/N; 'ompl_mfa merge' joins the parts");
        auto *grace = addNumberOption(*command, "--grace", options->campaign.grace,
                                      "Seconds after the time limit at which a planner that has not returned is killed "
                                      "(default: 1 and a tenth of the limit)",
                                      ACCEPTED_GRACE);
        auto *resume =
            command->add_flag("--resume", options->campaign.resume, "Make only the runs that an earlier call did not");
        command->add_flag("--overwrite", options->campaign.overwrite, "Drop the runs of an interrupted campaign")
            ->excludes(resume);
        command->add_flag("--quiet", options->quiet, "Show no progress");
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options, grace] { runBenchmark(*options, grace->count() > 0); });
    }
}  // namespace ompl_mfa::cli
