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
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <ompl/util/Console.h>
#include <CLI/CLI.hpp>

#include "ompl_mfa/InputError.h"
#include "paper/Study.h"
#include "text/NearestName.h"

namespace
{
    constexpr int SIGNAL_STATUS = 128;

    int run(int argc, char **argv)
    {
        ompl_mfa::paper::StudyOptions options;
        CLI::App app{"The runs of the paper's study, as CSV files", "ompl_mfa_paper_study"};
        app.add_option("--world", options.worldFile, "benchmarks/worlds/paper_scene.yaml")->required();
        app.add_option("--output", options.outputFolder, "Folder of the CSV files")->required();
        app.add_option("--paper-runs", options.paperRuns, "Runs on the paper's scene")->check(CLI::Range(2, 1000));
        app.add_option("--seeded-runs", options.seededRuns, "Runs on each seeded scene")->check(CLI::Range(2, 1000));
        app.add_option("--function-runs", options.functionRuns, "Runs on each function")->check(CLI::Range(2, 1000));
        app.add_option("--jobs", options.jobs, "Runs at the same time")->check(CLI::Range(1, 256));
        app.add_option("--slice-runs", options.sliceRuns, "Runs for each number of slices")->check(CLI::Range(2, 1000));
        std::vector<std::string> parts{"scenes", "planner", "paths", "slices", "functions"};
        app.add_option("--parts", parts, "What to run: scenes, planner, paths, slices, functions")->delimiter(',');
        auto *resume = app.add_flag("--resume", options.resume, "Make only the runs that an earlier call did not");
        app.add_flag("--overwrite", options.overwrite, "Drop the runs of an interrupted study")->excludes(resume);
        CLI11_PARSE(app, argc, argv);
        ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
        std::filesystem::create_directories(options.outputFolder);
        const std::vector<std::pair<std::string, void (*)(const ompl_mfa::paper::StudyOptions &)>> steps{
            {"scenes", ompl_mfa::paper::writeScenes},
            {"planner", ompl_mfa::paper::studyPlanner},
            {"paths", ompl_mfa::paper::studyPaths},
            {"slices", ompl_mfa::paper::studySlices},
            {"functions", ompl_mfa::paper::studyFunctions}};
        for (const auto &part : parts)
        {
            ompl_mfa::text::requireKnown("part", part, {"scenes", "planner", "paths", "slices", "functions"});
        }
        for (const auto &step : steps)
        {
            if (std::find(parts.begin(), parts.end(), step.first) == parts.end())
            {
                continue;
            }
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
    catch (const ompl_mfa::paper::Interrupted &interrupted)
    {
        std::fputs(interrupted.what(), stderr);
        std::fputs("\n", stderr);
        return SIGNAL_STATUS + interrupted.signal();
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
