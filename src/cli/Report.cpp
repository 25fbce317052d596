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

#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/FileNames.h"
#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "cli/ShellWord.h"
#include "ompl_mfa/InputError.h"
#include "report/Analysis.h"
#include "report/ReportPage.h"
#include "report/ReportTables.h"
#include "report/ResultsReader.h"
#include "report/WebPage.h"
#include "text/NearestName.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        constexpr double UNKNOWN = std::numeric_limits<double>::infinity();

        struct Options
        {
            std::vector<std::string> results;
            std::string output;
            std::string title;
            std::vector<std::string> references;
            std::vector<std::string> pictures;
            bool json{false};
        };

        /* Costs by the names of experiments. */
        std::map<std::string, double> readReferences(const std::vector<std::string> &texts,
                                                     const std::vector<report::Experiment> &experiments)
        {
            std::vector<std::string> names;
            names.reserve(experiments.size());
            for (const report::Experiment &experiment : experiments)
            {
                names.push_back(experiment.name);
            }
            std::map<std::string, double> references;
            for (const std::string &text : texts)
            {
                const std::size_t equals = text.rfind('=');
                double cost = 0.0;
                if (equals == std::string::npos || !text::readNumber(text.substr(equals + 1), cost) ||
                    !std::isfinite(cost))
                {
                    throw InputError("--reference " + text + ": expected EXPERIMENT=COST");
                }
                text::requireKnown("experiment", text.substr(0, equals), names);
                references[text.substr(0, equals)] = cost;
            }
            return references;
        }

        std::string commandOf(const Options &options)
        {
            std::string command = "ompl_mfa report";
            for (const std::string &file : options.results)
            {
                command += " " + shellWord(file);
            }
            command += " --output " + shellWord(options.output);
            command += options.title.empty() ? "" : " --title " + shellWord(options.title);
            for (const std::string &reference : options.references)
            {
                command += " --reference " + shellWord(reference);
            }
            for (const std::string &picture : options.pictures)
            {
                command += " --picture " + shellWord(picture);
            }
            return command;
        }

        report::Report makeReport(const Options &options)
        {
            report::Report made;
            made.experiments = report::readResults(options.results);
            const auto references = readReferences(options.references, made.experiments);
            for (const report::Experiment &experiment : made.experiments)
            {
                const auto reference = references.find(experiment.name);
                made.summaries.push_back(
                    report::summarize(experiment, reference == references.end() ? UNKNOWN : reference->second));
            }
            made.comparison = report::compare(made.summaries);
            for (const std::string &picture : options.pictures)
            {
                made.pictures.push_back({std::filesystem::path(picture).stem().string(),
                                         report::pictureAddress(picture, "--picture " + picture)});
            }
            made.title = !options.title.empty() ? options.title
                         : made.experiments.size() == 1
                             ? "Benchmark of " + made.experiments.front().name
                             : "Benchmark of " + std::to_string(made.experiments.size()) + " problems";
            made.command = commandOf(options);
            return made;
        }

        void writeReport(const Options &options)
        {
            if (options.output.empty() && !options.json)
            {
                throw InputError("--output is required, or --json for the tables only");
            }
            const report::Report made = makeReport(options);
            if (!options.output.empty())
            {
                const std::string origin = "--output " + options.output;
                report::writeText(benchmark::writtenPath(options.output, origin).string(), report::reportPage(made),
                                  origin);
            }
            if (options.json)
            {
                printDocument(report::tablesAsJson(made.experiments, made.summaries, made.comparison));
                return;
            }
            std::size_t runs = 0;
            for (const report::ExperimentSummary &summary : made.summaries)
            {
                for (const report::PlannerSummary &planner : summary.planners)
                {
                    runs += planner.runs;
                }
            }
            const text::PlainNumbers plainNumbers(std::cout);
            std::cout << options.output << ": " << runs << " runs in " << made.experiments.size() << " experiments"
                      << std::endl;
        }
    }  // namespace

    void addReportCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command =
            app.add_subcommand("report", "Show results of benchmarks on one page with plots and statistics");
        command
            ->add_option("RESULTS", options->results,
                         "Journals of 'ompl_mfa benchmark', logs with their journals, or SQLite databases of "
                         "ompl_benchmark_statistics")
            ->required();
        command->add_option("--output,-o", options->output, "The page (.html), which needs no other file");
        command->add_option("--title", options->title, "Title of the page");
        command->add_option("--reference", options->references,
                            "EXPERIMENT=COST: a cost known from elsewhere, such as the exact optimum; may be repeated");
        command->add_option("--picture", options->pictures, "Pictures (.svg, .png) to show on the page");
        command->add_flag("--json", options->json, "Print the computed tables as one JSON document");
        command->callback([options] { writeReport(*options); });
    }
}  // namespace ompl_mfa::cli
