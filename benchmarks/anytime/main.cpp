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

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include "anytime/Campaign.h"
#include "anytime/PlannerText.h"
#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

namespace anytime = ompl_mfa::anytime;

namespace
{
    constexpr int SIGNAL_STATUS = 128;

    struct Options
    {
        std::string worlds;
        std::vector<std::string> generated;
        std::vector<std::filesystem::path> configs;
        std::string planners{"mfa,peers"};
        std::uint32_t seeds{15};
        double time{2.0};
        std::string clock{"cpu"};
        unsigned int jobs{1};
        std::filesystem::path runs{"anytime-runs.jsonl"};
        std::filesystem::path csv;
        std::filesystem::path markdown;
        std::filesystem::path results;
        std::string curves;
        bool fresh{false};
        bool updateReferences{false};
    };

    void list()
    {
        for (const auto &world : anytime::allWorlds())
        {
            std::cout << world.name << '\n';
        }
        std::cout << "\nfamilies of generated worlds, each with seeds from 1 to 4294967295:\n";
        for (const auto &family : anytime::generatedFamilies())
        {
            std::cout << family << '\n';
        }
        std::cout << "\nplanners, as PLANNER[:KEY=VALUE,...]:";
        for (const auto &name : ompl_mfa::benchmark::plannerNames())
        {
            std::cout << ' ' << name;
        }
        std::cout << "\npeers:";
        for (const auto &name : anytime::peers())
        {
            std::cout << ' ' << name;
        }
        std::cout << '\n';
    }

    void printOptima(const Options &options)
    {
        for (const auto &world : anytime::selectWorlds(options.worlds, options.generated, options.configs))
        {
            if (!world.optimum)
            {
                continue;
            }
            const nlohmann::ordered_json reference{{"world", world.name},
                                                   {"cost", world.optimum()},
                                                   {"source", "exact"},
                                                   {"path", nlohmann::json::array()}};
            std::cout << reference << '\n';
        }
    }

    /* Replaces this process by report.py, which needs Debian's python3-scipy. */
    [[noreturn]] void report(const Options &options)
    {
        const std::string script = OMPL_MFA_SOURCE_DIR "/benchmarks/anytime/report.py";
        std::vector<std::string> arguments{"/usr/bin/python3",
                                           script,
                                           options.runs.string(),
                                           "--clock",
                                           options.clock,
                                           "--worlds",
                                           anytime::namePattern(options.worlds, options.generated, options.configs)};
        if (!options.csv.empty())
        {
            arguments.insert(arguments.end(), {"--csv", options.csv.string()});
        }
        if (!options.markdown.empty())
        {
            arguments.insert(arguments.end(), {"--markdown", options.markdown.string()});
        }
        if (!options.results.empty())
        {
            arguments.insert(arguments.end(), {"--results", options.results.string()});
        }
        if (!options.curves.empty())
        {
            arguments.insert(arguments.end(), {"--curves", options.curves});
        }
        if (options.updateReferences)
        {
            arguments.emplace_back("--update-references");
        }
        std::vector<char *> pointers;
        pointers.reserve(arguments.size() + 1);
        for (std::string &argument : arguments)
        {
            pointers.push_back(argument.data());
        }
        pointers.push_back(nullptr);
        std::cout << std::flush;
        execv(pointers.front(), pointers.data());
        throw ompl_mfa::InputError("/usr/bin/python3: cannot be run; the report needs python3 with python3-scipy");
    }

    void run(const Options &options)
    {
        const anytime::CampaignRequest request{
            anytime::selectWorlds(options.worlds, options.generated, options.configs),
            anytime::splitPlanners(options.planners), options.seeds, options.time,
            options.clock == "cpu" ? anytime::Clock::CPU : anytime::Clock::Wall};
        ompl_mfa::campaign::RunOptions runs;
        runs.journal = options.runs;
        runs.jobs = options.jobs;
        runs.overwrite = options.fresh;
        runs.progress = &std::cerr;
        runs.terminal = isatty(STDERR_FILENO) != 0;
        const ompl_mfa::campaign::RunsMade made = anytime::runCampaign(request, runs);
        if (made.interruptedBy != 0)
        {
            std::cerr << "stopped with " << made.missing << " runs to go; the same command, without --fresh, continues"
                      << std::endl;
            throw CLI::RuntimeError(SIGNAL_STATUS + made.interruptedBy);
        }
        report(options);
    }

    void addReportOptions(CLI::App &command, Options &options)
    {
        command.add_option("--runs", options.runs, "file of the runs")->capture_default_str();
        command.add_option("--clock", options.clock, "which time is measured: cpu does not depend on other programs")
            ->check(CLI::IsMember({"cpu", "wall"}))
            ->capture_default_str();
        command.add_option("--csv", options.csv, "write one row per world and planner to this file");
        command.add_option("--markdown", options.markdown, "write the tables to this file");
        auto *results = command.add_option("--results", options.results,
                                           "write planners.csv, worlds.csv, summary.csv and curves.csv to this folder");
        command.add_option("--curves", options.curves, "regular expression that selects the worlds of curves.csv")
            ->needs(results);
    }

    void addWorldOption(CLI::App &command, Options &options)
    {
        command.add_option("--worlds", options.worlds, "regular expression that selects worlds; all if not given");
    }

    void addWorldOptions(CLI::App &command, Options &options)
    {
        command.add_option(
            "--worlds", options.worlds,
            "regular expression that selects worlds; all, or none with --generated or --configs, if not given");
        command.add_option("--generated", options.generated,
                           "worlds of any seed, such as random_boxes_8d_101 arm_7_{11..15}; `list` has the families");
        command.add_option("--configs", options.configs, "config files of problems, each a world named by its stem")
            ->check(CLI::ExistingFile);
    }

    int parseAndRun(int argc, char **argv)
    {
        CLI::App app("Cost over time of MFA and its peers, one process a run");
        app.require_subcommand(1);
        Options options;
        app.add_subcommand("list", "names of worlds and planners")->callback(list);
        auto *optima = app.add_subcommand("optima", "exact optima of the worlds that have one, a JSON object a line");
        addWorldOptions(*optima, options);
        optima->callback([&options] { printOptima(options); });
        auto *running = app.add_subcommand("run", "make the runs that are missing, then report");
        addWorldOptions(*running, options);
        addReportOptions(*running, options);
        running->add_option("--planners", options.planners, "PLANNER[:KEY=VALUE,...],...; `peers` stands for all peers")
            ->capture_default_str();
        running->add_option("--seeds", options.seeds, "runs per world and planner")
            ->check(CLI::Range(1, 1000000))
            ->capture_default_str();
        running->add_option("--time", options.time, "seconds per run")
            ->check(CLI::PositiveNumber)
            ->capture_default_str();
        running->add_option("--jobs", options.jobs, "runs at a time, one per core")->capture_default_str();
        running->add_flag("--fresh", options.fresh, "discard the runs of the file first");
        running->callback([&options] { run(options); });
        auto *reporting = app.add_subcommand("report", "statistics of the runs made so far");
        addWorldOption(*reporting, options);
        addReportOptions(*reporting, options);
        reporting->add_flag("--update-references", options.updateReferences,
                            "store the best paths found in benchmarks/anytime/references.jsonl");
        reporting->callback([&options] { report(options); });
        CLI11_PARSE(app, argc, argv);
        return 0;
    }
}  // namespace

int main(int argc, char **argv)
{
    try
    {
        return parseAndRun(argc, argv);
    }
    catch (const ompl_mfa::InputError &error)
    {
        std::cerr << "ompl_mfa_anytime: " << error.what() << '\n';
        return 2;
    }
    catch (const std::exception &error)
    {
        std::cerr << "ompl_mfa_anytime: " << error.what() << '\n';
        return 1;
    }
}
