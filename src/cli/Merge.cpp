#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/FileNames.h"
#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/BenchmarkLog.h"
#include "text/NumberText.h"

namespace
{
    struct Options
    {
        std::vector<std::string> parts;
        std::string output;
        bool allowMissing{false};
        bool json{false};
    };

    void printJson(const Options &options, const ompl_mfa::BenchmarkLog &merged)
    {
        nlohmann::json document{
            {"log", options.output}, {"parts", options.parts.size()}, {"planners", nlohmann::json::array()}};
        for (const auto &planner : merged.planners)
        {
            document["planners"].push_back(
                {{"planner", planner.name.substr(planner.name.find('_') + 1)}, {"runs", planner.runs.size()}});
        }
        ompl_mfa::cli::printDocument(document);
    }

    void merge(Options options)
    {
        options.output = ompl_mfa::writtenPath(options.output, "--output " + options.output).string();
        std::vector<ompl_mfa::BenchmarkLog> logs;
        logs.reserve(options.parts.size());
        for (const auto &part : options.parts)
            logs.push_back(ompl_mfa::readBenchmarkLog(std::filesystem::path(part)));
        const ompl_mfa::BenchmarkLog merged = ompl_mfa::mergeBenchmarkLogs(logs, options.parts, options.allowMissing);
        ompl_mfa::writeBenchmarkLog(std::filesystem::path(options.output), merged);
        if (options.json)
        {
            printJson(options, merged);
            return;
        }
        std::size_t runs = 0;
        for (const auto &planner : merged.planners)
            runs += planner.runs.size();
        const ompl_mfa::PlainNumbers plainNumbers(std::cout);
        std::cout << options.output << ": " << runs << " runs of " << merged.planners.size() << " planners from "
                  << logs.size() << " parts" << std::endl;
    }
}  // namespace

void ompl_mfa::cli::addMergeCommand(CLI::App &app)
{
    const auto options = std::make_shared<Options>();
    auto *command = app.add_subcommand("merge", "Join the logs of the parts of a campaign into one");
    command->add_option("parts", options->parts, "Logs of 'ompl_mfa benchmark --shard I/N'")->required();
    command->add_option("--output", options->output, "The log that is written")->required();
    command->add_flag("--allow-missing", options->allowMissing, "Join the parts even when runs are missing");
    command->add_flag("--json", options->json, "Print one JSON document");
    command->callback([options] { merge(*options); });
}
