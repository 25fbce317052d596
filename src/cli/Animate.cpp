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
#include "cli/JsonDocument.h"
#include "cli/PlannerChoice.h"
#include "cli/ShellWord.h"
#include "cli/SwarmPage.h"
#include "cli/SwarmRecording.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "report/WebPage.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        struct Options
        {
            std::string config;
            std::string output;
            std::vector<std::string> planners{"fa_paper", "mfa_paper"};
            std::uint32_t seed{0};
            std::uint32_t generations{50};
            bool json{false};
        };

        std::string commandOf(const Options &options)
        {
            std::string planners;
            for (const std::string &planner : options.planners)
            {
                planners += (planners.empty() ? "" : ",") + planner;
            }
            return "ompl_mfa animate " + shellWord(options.config) + " --output " + shellWord(options.output) +
                   " --planner " + shellWord(planners) + " --seed " + std::to_string(options.seed) + " --generations " +
                   std::to_string(options.generations);
        }

        bool endsWith(const std::string &text, const std::string &end)
        {
            return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
        }

        void printJson(const Options &options, const std::vector<SwarmRecording> &recordings)
        {
            nlohmann::json document{{"output", options.output}, {"seed", options.seed}};
            for (const SwarmRecording &recording : recordings)
            {
                const SwarmFrame &last = recording.frames.back();
                document["planners"].push_back(
                    {{"planner", recording.planner},
                     {"fireflies", last.paths.size()},
                     {"generations", last.generation},
                     {"valid", std::count_if(last.paths.begin(), last.paths.end(),
                                             [](const SwarmPath &path) { return path.valid; })},
                     {"best_cost", last.best.points.empty() ? nlohmann::json() : nlohmann::json(last.best.cost)}});
            }
            printDocument(document);
        }

        void animate(Options options, bool seedGiven)
        {
            const std::string origin = "--output " + options.output;
            const bool isPicture = endsWith(lowerCase(options.output), ".svg");
            if (!isPicture && !endsWith(lowerCase(options.output), ".html"))
            {
                throw InputError(origin + ": the file name has to end with .html or .svg");
            }
            const benchmark::ProblemFactory factory(benchmark::readBenchmarkConfig(options.config));
            if (!seedGiven)
            {
                options.seed = static_cast<std::uint32_t>(factory.config().benchmark.seed);
            }
            benchmark::setRandomSeed(options.seed);
            const PlanarProblem problem = planarProblem(factory);
            std::vector<SwarmRecording> recordings;
            for (const std::string &planner : options.planners)
            {
                recordings.push_back(
                    recordSwarm(factory, choosePlanner(factory.config(), planner), options.seed, options.generations));
            }
            const std::string content =
                isPicture ? swarmPicture(problem, recordings) : swarmPage(problem, recordings, commandOf(options));
            report::writeText(benchmark::writtenPath(options.output, origin).string(), content, origin);
            if (options.json)
            {
                printJson(options, recordings);
                return;
            }
            const text::PlainNumbers plainNumbers(std::cout);
            for (const SwarmRecording &recording : recordings)
            {
                const SwarmFrame &last = recording.frames.back();
                std::cout << recording.planner << ": " << last.paths.size() << " fireflies, " << last.generation
                          << " generations, best cost "
                          << (last.best.points.empty() ? "none" : text::numberText(last.best.cost, 5)) << std::endl;
            }
        }
    }  // namespace

    void addAnimateCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("animate", "Show the swarms of planners side by side over generations");
        command->add_option("FILE", options->config, "A .cfg file of a planar problem")->required();
        command
            ->add_option("--output,-o", options->output, "A page with controls (.html) or an animated picture (.svg)")
            ->required();
        command
            ->add_option("--planner", options->planners,
                         "Names or types of planners with swarms, as for 'plan', separated by commas")
            ->delimiter(',')
            ->capture_default_str();
        auto *seed = command->add_option("--seed", options->seed, "The config's seed if not given")
                         ->check(CLI::Range(std::uint32_t{1}, std::numeric_limits<std::uint32_t>::max()));
        command->add_option("--generations", options->generations, "Generations to show")
            ->check(CLI::Range(1, 1000))
            ->capture_default_str();
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options, seed] { animate(*options, seed->count() > 0); });
    }
}  // namespace ompl_mfa::cli
