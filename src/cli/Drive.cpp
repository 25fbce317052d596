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

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/FileNames.h"
#include "cli/Commands.h"
#include "cli/DrivePage.h"
#include "cli/JsonDocument.h"
#include "cli/NumberOption.h"
#include "cli/PlannerChoice.h"
#include "cli/ShellWord.h"
#include "drive/DriveSet.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        using drive::DriveProblem;
        using drive::DriveResult;
        using drive::DriveSummary;

        constexpr double MEDIAN = 0.5;
        constexpr double NEARLY_ALL = 0.99;
        const char *const ACCEPTED_TIME = "a number from 0 to 1e9 (seconds)";

        struct Options
        {
            std::string config;
            std::vector<std::string> planners{"mfa"};
            std::uint32_t seed{0};
            std::uint32_t drives{0};
            double optimumTime{2.0};
            std::string csv;
            std::string animation;
            bool json{false};
        };

        /* A planner's drive between one start and goal. */
        struct Driven
        {
            std::string planner;
            std::size_t number;
            double optimum;
            DriveResult result;
        };

        std::string commandOf(const Options &options)
        {
            return "ompl_mfa drive " + shellWord(options.config) + " --planner " + shellWord(options.planners.front()) +
                   " --seed " + std::to_string(options.seed) + " --animation " + shellWord(options.animation);
        }

        std::vector<benchmark::PlannerSpec> chooseAll(const benchmark::BenchmarkConfig &config, const Options &options)
        {
            std::vector<benchmark::PlannerSpec> specs;
            for (const std::string &planner : options.planners)
            {
                specs.push_back(choosePlanner(config, planner));
            }
            return specs;
        }

        void requireDrivable(const benchmark::ProblemFactory &factory, const Options &options)
        {
            const benchmark::ProblemConfig &problem = factory.config().problem;
            if (factory.map() == nullptr)
            {
                throw InputError(options.config +
                                 ": a robot drives on a map; problem.world is to be a .yaml of "
                                 "map_server or a .map");
            }
            if (problem.motionValidation && problem.motionValidation->value != collision::MotionValidation::Continuous)
            {
                benchmark::failAt(problem.motionValidation->entry, "a robot that drives needs continuous");
            }
            if (options.drives == 0 && factory.problems().size() > 1)
            {
                throw InputError(options.config + ": stands for " + std::to_string(factory.problems().size()) +
                                 " problems; select one by problem.scenario.index, or give --drives");
            }
            if (!(options.optimumTime >= 0.0 && options.optimumTime <= benchmark::LONGEST_TIME_LIMIT))
            {
                throw InputError("--optimum-time " + text::numberText(options.optimumTime) + ": expected " +
                                 ACCEPTED_TIME);
            }
            if (options.drives > 0 && options.optimumTime == 0.0)
            {
                throw InputError(
                    "--optimum-time 0: --drives needs a time above 0 to find out which goals can be "
                    "reached");
            }
            if (!options.animation.empty() && (options.drives > 0 || options.planners.size() > 1))
            {
                throw InputError("--animation " + options.animation +
                                 ": shows the drive of one planner, without "
                                 "--drives");
            }
        }

        nlohmann::json timesOf(const std::vector<double> &times)
        {
            return {{"count", times.size()},
                    {"median", finiteOrNull(drive::quantile(times, MEDIAN))},
                    {"quantile_99", finiteOrNull(drive::quantile(times, NEARLY_ALL))},
                    {"longest", finiteOrNull(drive::quantile(times, 1.0))}};
        }

        nlohmann::json toJson(const Driven &driven)
        {
            const DriveResult &result = driven.result;
            return {{"planner", driven.planner},
                    {"drive", driven.number},
                    {"status", drive::statusText(result.status)},
                    {"length", result.driven},
                    {"optimum", finiteOrNull(driven.optimum)},
                    {"duration", result.duration},
                    {"periods", result.periods.size()},
                    {"blockages", result.blockages},
                    {"improvements", result.improvements},
                    {"time_to_first_path",
                     result.periods.empty() ? nlohmann::json() : finiteOrNull(result.periods.front().pathTime)},
                    {"repair_times", timesOf(result.repairTimes)}};
        }

        nlohmann::json toJson(const DriveSummary &summary)
        {
            return {{"planner", summary.name},
                    {"drives", summary.drives},
                    {"arrived", summary.arrived},
                    {"collisions", summary.collisions},
                    {"blockages", summary.blockages},
                    {"length_ratio",
                     {{"median", finiteOrNull(drive::quantile(summary.ratios, MEDIAN))},
                      {"longest", finiteOrNull(drive::quantile(summary.ratios, 1.0))}}},
                    {"repair_times", timesOf(summary.repairTimes)}};
        }

        void printJson(const Options &options, const std::vector<Driven> &all,
                       const std::vector<DriveSummary> &summaries)
        {
            nlohmann::json document{{"config", options.config}, {"seed", options.seed}};
            for (const Driven &driven : all)
            {
                document["drives"].push_back(toJson(driven));
            }
            for (const DriveSummary &summary : summaries)
            {
                document["planners"].push_back(toJson(summary));
            }
            printDocument(document);
        }

        std::string orNone(double value, int digits = 4)
        {
            return std::isfinite(value) ? text::numberText(value, digits) : "none";
        }

        void printText(const Driven &driven)
        {
            const DriveResult &result = driven.result;
            const text::PlainNumbers plainNumbers(std::cout);
            constexpr int DIGITS = 6;
            std::cout << "planner                  " << driven.planner << "\n"
                      << "status                   " << drive::statusText(result.status) << "\n"
                      << "driven length            " << orNone(result.driven, DIGITS) << "\n"
                      << "optimum, all known       " << orNone(driven.optimum, DIGITS) << "\n"
                      << "duration                 " << orNone(result.duration, DIGITS) << " s, "
                      << result.periods.size() << " periods\n"
                      << "path blocked             " << result.blockages << " times\n"
                      << "path again after         " << orNone(drive::quantile(result.repairTimes, MEDIAN))
                      << " s (median), " << orNone(drive::quantile(result.repairTimes, NEARLY_ALL)) << " s (99 %), "
                      << orNone(drive::quantile(result.repairTimes, 1.0)) << " s (longest)\n"
                      << "better path              " << result.improvements << " times" << std::endl;
        }

        void printTable(const std::vector<DriveSummary> &summaries)
        {
            const std::vector<std::string> head = {"planner",          "drives",  "arrived",      "collisions",
                                                   "length / optimum", "blocked", "path again s", "99 %",
                                                   "longest"};
            std::vector<std::vector<std::string>> rows = {head};
            for (const DriveSummary &summary : summaries)
            {
                rows.push_back({summary.name, std::to_string(summary.drives), std::to_string(summary.arrived),
                                std::to_string(summary.collisions), orNone(drive::quantile(summary.ratios, MEDIAN)),
                                std::to_string(summary.blockages),
                                orNone(drive::quantile(summary.repairTimes, MEDIAN), 3),
                                orNone(drive::quantile(summary.repairTimes, NEARLY_ALL), 3),
                                orNone(drive::quantile(summary.repairTimes, 1.0), 3)});
            }
            std::vector<std::size_t> widths(head.size(), 0);
            for (const auto &row : rows)
            {
                for (std::size_t i = 0; i < row.size(); ++i)
                {
                    widths[i] = std::max(widths[i], row[i].size());
                }
            }
            for (const auto &row : rows)
            {
                for (std::size_t i = 0; i < row.size(); ++i)
                {
                    const std::string space(widths[i] - row[i].size(), ' ');
                    std::cout << (i == 0 ? row[i] + space : "  " + space + row[i]);
                }
                std::cout << std::endl;
            }
        }

        std::string csvOf(const std::vector<Driven> &all)
        {
            std::string content = "planner,drive,time,x,y,yaw,driven,new_cells,blocked,path_time,path_length\n";
            const auto number = [](double value) { return std::isfinite(value) ? text::numberText(value) : ""; };
            for (const Driven &driven : all)
            {
                for (const drive::DrivePeriod &period : driven.result.periods)
                {
                    content += driven.planner + "," + std::to_string(driven.number) + "," + number(period.time) + "," +
                               number(period.pose.position.x()) + "," + number(period.pose.position.y()) + "," +
                               number(period.pose.yaw) + "," + number(period.driven) + "," +
                               std::to_string(period.newCells) + "," + (period.isBlocked ? "1" : "0") + "," +
                               number(period.pathTime) + "," + number(period.pathLength) + "\n";
                }
            }
            return content;
        }

        std::vector<DriveProblem> problemsOf(const benchmark::ProblemFactory &factory, const Options &options)
        {
            if (options.drives > 0)
            {
                return drive::randomProblems(factory, options.drives, options.seed, options.optimumTime);
            }
            const double optimum = options.optimumTime > 0.0 ? drive::omniscientLength(factory, options.optimumTime)
                                                             : std::numeric_limits<double>::infinity();
            return {{factory.config().problem.start, factory.config().problem.goal, optimum}};
        }

        void prepareFile(std::string &file, const std::string &option)
        {
            if (!file.empty())
            {
                const std::string origin = option + " " + file;
                file = benchmark::writtenPath(file, origin).string();
                // known before the drives
                report::writeText(file, "", origin);
            }
        }

        void driveAll(Options options, bool seedGiven)
        {
            benchmark::ProblemFactory factory(benchmark::readBenchmarkConfig(options.config));
            if (!seedGiven)
            {
                options.seed = static_cast<std::uint32_t>(factory.config().benchmark.seed);
            }
            requireDrivable(factory, options);
            const auto specs = chooseAll(factory.config(), options);
            const std::optional<maps::GridMap> known = drive::loadKnownMap(factory);
            const std::string command = commandOf(options);
            benchmark::setRandomSeed(options.seed);
            factory.create();
            prepareFile(options.csv, "--csv");
            prepareFile(options.animation, "--animation");

            std::vector<Driven> all;
            std::vector<DriveSummary> summaries;
            summaries.reserve(specs.size());
            for (const auto &spec : specs)
            {
                summaries.emplace_back(spec.name);
            }
            std::size_t number = 0;
            for (const DriveProblem &problem : problemsOf(factory, options))
            {
                factory.setStartAndGoal(problem.start, problem.goal);
                for (std::size_t i = 0; i < specs.size(); ++i)
                {
                    all.push_back({specs[i].name, number, problem.optimum,
                                   drive::drive(factory, known, specs[i], !options.animation.empty())});
                    summaries[i].add(all.back().result, problem.optimum);
                }
                ++number;
            }
            if (!options.csv.empty())
            {
                report::writeText(options.csv, csvOf(all), "--csv " + options.csv);
            }
            if (!options.animation.empty())
            {
                report::writeText(options.animation,
                                  drivePage(factory, known, all.front().result, all.front().planner, command),
                                  "--animation " + options.animation);
            }
            if (options.json)
            {
                printJson(options, all, summaries);
            }
            else if (all.size() == 1)
            {
                printText(all.front());
            }
            else
            {
                printTable(summaries);
            }
            if (std::any_of(all.begin(), all.end(),
                            [](const Driven &driven) { return driven.result.status != drive::DriveStatus::Arrived; }))
            {
                throw CLI::RuntimeError(1);
            }
        }
    }  // namespace

    void addDriveCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("drive", "Let a robot drive on a map that it knows only in part");
        command->add_option("FILE", options->config, "A .cfg file whose world is a map")->required();
        command
            ->add_option("--planner", options->planners,
                         "Names or types of planners, as for 'plan', separated by commas; each drives alone")
            ->delimiter(',')
            ->capture_default_str();
        auto *seed = command->add_option("--seed", options->seed, "The config's seed if not given")
                         ->check(CLI::Range(std::uint32_t{1}, std::numeric_limits<std::uint32_t>::max()));
        command->add_option("--drives", options->drives, "Drive between so many random starts and goals")
            ->check(CLI::Range(1, 100000));
        addNumberOption(*command, "--optimum-time", options->optimumTime,
                        "Seconds to plan on the true map, for comparison; 0: not at all", ACCEPTED_TIME)
            ->capture_default_str();
        command->add_option("--csv", options->csv, "Write a line for each period to this file");
        command->add_option("--animation", options->animation, "Write a page that shows the drive to this .html file");
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options, seed] { driveAll(*options, seed->count() > 0); });
    }
}  // namespace ompl_mfa::cli
