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

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/CampaignMerge.h"
#include "benchmark/FileNames.h"
#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"
#include "ompl_mfa/benchmark/ResultsDatabase.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        struct Options
        {
            std::vector<std::string> parts;
            std::string output;
            std::string database;
            bool allowMissing{false};
            bool json{false};
        };

        void printJson(const Options &options, const benchmark::BenchmarkLog &merged)
        {
            nlohmann::json document{
                {"log", options.output}, {"parts", options.parts.size()}, {"planners", nlohmann::json::array()}};
            for (const auto &planner : merged.planners)
            {
                document["planners"].push_back(
                    {{"planner", planner.name.substr(planner.name.find('_') + 1)}, {"runs", planner.runs.size()}});
            }
            printDocument(document);
        }

        void merge(Options options)
        {
            options.output = benchmark::writtenPath(options.output, "--output " + options.output).string();
            const benchmark::BenchmarkLog merged =
                benchmark::mergeCampaign(options.parts, options.output, options.allowMissing);
            if (!options.database.empty())
            {
                benchmark::addToDatabase(benchmark::writtenPath(options.database, "--database " + options.database),
                                         merged);
            }
            if (options.json)
            {
                printJson(options, merged);
                return;
            }
            std::size_t runs = 0;
            for (const auto &planner : merged.planners)
            {
                runs += planner.runs.size();
            }
            const text::PlainNumbers plainNumbers(std::cout);
            std::cout << options.output << ": " << runs << " runs of " << merged.planners.size() << " planners from "
                      << options.parts.size() << " parts" << std::endl;
        }
    }  // namespace

    void addMergeCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("merge", "Join the parts of a campaign into one log");
        command
            ->add_option("parts", options->parts,
                         "Logs of 'ompl_mfa benchmark --shard I/N', with their journals, or the journals")
            ->required();
        command->add_option("--output", options->output, "The log that is written, with its journal")->required();
        command->add_option("--database", options->database, "Add the runs to this SQLite database for Planner Arena");
        command->add_flag("--allow-missing", options->allowMissing, "Join the parts even when runs are missing");
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options] { merge(*options); });
    }
}  // namespace ompl_mfa::cli
