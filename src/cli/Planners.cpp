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

#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <ompl/util/Console.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

namespace ompl_mfa::cli
{
    namespace
    {
        struct Options
        {
            std::vector<std::string> names;
            bool json{false};
        };

        void printJson(const std::vector<std::string> &names)
        {
            nlohmann::json planners = nlohmann::json::array();
            for (const auto &name : names)
            {
                nlohmann::json parameters = nlohmann::json::array();
                for (const auto &parameter : benchmark::plannerParameters(name))
                {
                    parameters.push_back({{"name", parameter.name},
                                          {"type", parameter.type},
                                          {"range", parameter.range},
                                          {"default", parameter.defaultValue}});
                }
                planners.push_back(
                    {{"name", name}, {"title", benchmark::plannerTitle(name)}, {"parameters", parameters}});
            }
            printDocument({{"planners", planners}});
        }

        void printTable(const std::vector<std::string> &names)
        {
            for (const auto &name : names)
            {
                std::cout << name << " (" << benchmark::plannerTitle(name) << ")\n";
                for (const auto &parameter : benchmark::plannerParameters(name))
                {
                    std::cout << "    " << std::left << std::setw(36) << parameter.name << std::setw(10)
                              << parameter.type << std::setw(18) << parameter.defaultValue << parameter.range << "\n";
                }
            }
        }

        void listPlanners(const Options &options)
        {
            for (const auto &name : options.names)
            {
                benchmark::requireKnownPlanner(name, "planners");
            }
            // BIT* logs warnings when some of its parameters are read
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            const auto names = options.names.empty() ? benchmark::plannerNames() : options.names;
            if (options.json)
            {
                printJson(names);
            }
            else
            {
                printTable(names);
            }
        }
    }  // namespace

    void addPlannersCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command =
            app.add_subcommand("planners", "List planners with their parameters: type, default and range of each");
        command->add_option("NAME", options->names, "Only these planners");
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options] { listPlanners(*options); });
    }
}  // namespace ompl_mfa::cli
