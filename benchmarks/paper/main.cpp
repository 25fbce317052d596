#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>
#include <CLI/CLI.hpp>

#include "ompl_mfa/InputError.h"
#include "paper/Study.h"
#include "text/NearestName.h"

namespace
{
    int run(int argc, char **argv)
    {
        ompl_mfa::paper::StudyOptions options;
        CLI::App app{"The runs of the paper's study, as CSV files", "ompl_mfa_paper_study"};
        app.add_option("--world", options.worldFile, "benchmarks/worlds/paper_scene.yaml")->required();
        app.add_option("--output", options.outputFolder, "Folder of the CSV files")->required();
        app.add_option("--paper-runs", options.paperRuns, "Runs on the paper's scene")->check(CLI::Range(2, 1000));
        app.add_option("--seeded-runs", options.seededRuns, "Runs on each seeded scene")->check(CLI::Range(2, 1000));
        app.add_option("--function-runs", options.functionRuns, "Runs on each function")->check(CLI::Range(2, 1000));
        app.add_option("--threads", options.threads, "Threads")->check(CLI::Range(1, 256));
        app.add_option("--slice-runs", options.sliceRuns, "Runs for each number of slices")->check(CLI::Range(2, 1000));
        std::vector<std::string> parts{"scenes", "planner", "paths", "slices", "functions"};
        app.add_option("--parts", parts, "What to run: scenes, planner, paths, slices, functions")->delimiter(',');
        CLI11_PARSE(app, argc, argv);
        ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
        ompl::RNG::setSeed(1);
        std::filesystem::create_directories(options.outputFolder);
        const std::vector<std::pair<std::string, void (*)(const ompl_mfa::paper::StudyOptions &)>> steps{
            {"scenes", ompl_mfa::paper::writeScenes},
            {"planner", ompl_mfa::paper::studyPlanner},
            {"paths", ompl_mfa::paper::studyPaths},
            {"slices", ompl_mfa::paper::studySlices},
            {"functions", ompl_mfa::paper::studyFunctions}};
        for (const auto &part : parts)
            ompl_mfa::requireKnown("part", part, {"scenes", "planner", "paths", "slices", "functions"});
        for (const auto &step : steps)
        {
            if (std::find(parts.begin(), parts.end(), step.first) == parts.end())
                continue;
            std::cerr << "study: " << step.first << std::endl;
            step.second(options);
        }
        return 0;
    }
}  // namespace

int main(int argc, char **argv)
{
    try
    {
        return run(argc, argv);
    }
    catch (const ompl_mfa::InputError &error)
    {
        std::fputs(error.what(), stderr);
        std::fputs("\n", stderr);
        return 2;
    }
    catch (const std::exception &error)
    {
        std::fputs(error.what(), stderr);
        std::fputs("\n", stderr);
        return 1;
    }
}
