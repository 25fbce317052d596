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
            for (const auto &parameter : ompl_mfa::plannerParameters(name))
            {
                parameters.push_back({{"name", parameter.name},
                                      {"type", parameter.type},
                                      {"range", parameter.range},
                                      {"default", parameter.defaultValue}});
            }
            planners.push_back({{"name", name}, {"title", ompl_mfa::plannerTitle(name)}, {"parameters", parameters}});
        }
        ompl_mfa::cli::printDocument({{"planners", planners}});
    }

    void printTable(const std::vector<std::string> &names)
    {
        for (const auto &name : names)
        {
            std::cout << name << " (" << ompl_mfa::plannerTitle(name) << ")\n";
            for (const auto &parameter : ompl_mfa::plannerParameters(name))
                std::cout << "    " << std::left << std::setw(36) << parameter.name << std::setw(10) << parameter.type
                          << std::setw(18) << parameter.defaultValue << parameter.range << "\n";
        }
    }

    void listPlanners(const Options &options)
    {
        for (const auto &name : options.names)
            ompl_mfa::requireKnownPlanner(name, "planners");
        // BIT* warns about some of its parameters whenever they are read
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
        const auto names = options.names.empty() ? ompl_mfa::plannerNames() : options.names;
        if (options.json)
            printJson(names);
        else
            printTable(names);
    }
}  // namespace

void ompl_mfa::cli::addPlannersCommand(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    auto *command =
        app.add_subcommand("planners", "List planners with their parameters: type, default and range of each");
    command->add_option("NAME", options->names, "Only these planners");
    command->add_flag("--json", options->json, "Print one JSON document");
    command->callback([options] { listPlanners(*options); });
}
