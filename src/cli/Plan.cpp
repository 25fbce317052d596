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

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "benchmark/FileNames.h"
#include "benchmark/MeasuredPlanner.h"
#include "cli/Canvas.h"
#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "cli/NumberOption.h"
#include "cli/PathFile.h"
#include "cli/PlannerChoice.h"
#include "cli/ProblemPicture.h"
#include "cli/RobotOptions.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "ompl_mfa/planner/MFA.h"
#include "ompl_mfa/robots/JointTrajectory.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;
        using benchmark::PlannerSpec;
        using benchmark::ProblemFactory;

        const char *const ACCEPTED_TIME = "a number above 0 and at most 1e9 (seconds)";
        const char *const ACCEPTED_SPACING = "a number above 0 (world units)";

        struct Options
        {
            std::string file;
            RobotOptions robot;
            std::string planner{"mfa"};
            double time{0.0};
            std::uint32_t seed{0};
            std::uint64_t iterations{0};
            std::vector<std::string> parameters;
            bool simplify{false};
            std::string picture;
            std::string path;
            double spacing{0.0};
            std::size_t problem{0};
            bool json{false};
        };

        /** \brief Result of a run. Costs and times are infinite if they do not exist. */
        struct Result
        {
            std::string status;
            bool exact{false};
            bool valid{false};
            double cost{std::numeric_limits<double>::infinity()};
            double unsimplifiedCost{std::numeric_limits<double>::infinity()};
            double length{std::numeric_limits<double>::infinity()};
            double timeToFirstSolution{std::numeric_limits<double>::infinity()};
            double time{0.0};
            double simplificationTime{0.0};
            std::size_t states{0};
            std::string evaluations;
            std::string iterations;
            std::uint64_t checkedStates{0};
            std::uint64_t checkedMotions{0};
        };

        void overrideParameter(PlannerSpec &spec, const std::string &text)
        {
            const auto equals = text.find('=');
            if (equals == std::string::npos)
            {
                throw InputError("--parameter " + text + ": expected NAME=VALUE");
            }
            const benchmark::ConfigEntry entry{trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)),
                                               "--parameter"};
            for (auto &parameter : spec.parameters)
            {
                if (lowerCase(parameter.key) == lowerCase(entry.key))
                {
                    parameter = entry;
                    return;
                }
            }
            spec.parameters.push_back(entry);
        }

        bool hasParameter(const PlannerSpec &spec, const std::string &name)
        {
            return std::any_of(spec.parameters.begin(), spec.parameters.end(),
                               [&name](const auto &parameter) { return lowerCase(parameter.key) == name; });
        }

        double costOf(const og::SimpleSetup &setup)
        {
            const auto &objective = setup.getOptimizationObjective();
            const og::PathGeometric &path = setup.getSolutionPath();
            return objective ? path.cost(objective).value() : path.length();
        }

        std::string progressProperty(const ob::Planner &planner, const std::string &name)
        {
            const auto &properties = planner.getPlannerProgressProperties();
            const auto found = properties.find(name);
            return found == properties.end() ? "" : found->second();
        }

        /** \brief One planner on one problem. */
        class PlanRun
        {
        public:
            PlanRun(const ProblemFactory &factory, const PlannerSpec &spec, const Options &options)
              : options_(options)
              , setup_(factory.create(spec.context))
            {
                const auto &si = setup_->getSpaceInformation();
                planner_ = benchmark::createPlanner(si, spec);
                if (!hasParameter(spec, "seed"))
                {
                    benchmark::seedPlanner(*planner_, options.seed);
                }
                measured_ = std::make_shared<benchmark::MeasuredPlanner>(
                    planner_, state_,
                    benchmark::MeasuredPlanner::Settings{options.time, ONLY_AT_FIRST, options.iterations, {}});
                setup_->setPlanner(measured_);
            }

            Result solve()
            {
                Result result;
                const ob::PlannerStatus status = setup_->solve(options_.time);
                result.time = measured_->time();
                result.status = status.asString();
                result.exact = status == ob::PlannerStatus::EXACT_SOLUTION;
                result.timeToFirstSolution = state_.firstSolution.load();
                result.checkedStates = measured_->collisionChecks();
                result.checkedMotions = measured_->motionChecks();
                result.evaluations = progressProperty(*planner_, "evaluations INTEGER");
                result.iterations = progressProperty(*planner_, "iterations INTEGER");
                if (setup_->haveSolutionPath())
                {
                    measurePath(result);
                }
                return result;
            }

            const og::SimpleSetup &setup() const
            {
                return *setup_;
            }

            const ob::Planner &planner() const
            {
                return *planner_;
            }

        private:
            /* Progress samples are not needed: the time of the first solution is measured independently of them. */
            static constexpr double ONLY_AT_FIRST = benchmark::LONGEST_TIME_LIMIT;

            void measurePath(Result &result)
            {
                result.unsimplifiedCost = costOf(*setup_);
                if (options_.simplify && result.exact)
                {
                    const ompl::time::point start = ompl::time::now();
                    setup_->simplifySolution();
                    result.simplificationTime = ompl::time::seconds(ompl::time::now() - start);
                }
                const og::PathGeometric &path = setup_->getSolutionPath();
                result.cost = costOf(*setup_);
                result.length = path.length();
                result.states = path.getStateCount();
                result.valid = path.check();
            }

            const Options &options_;
            benchmark::RunState state_;
            og::SimpleSetupPtr setup_;
            ob::PlannerPtr planner_;
            std::shared_ptr<benchmark::MeasuredPlanner> measured_;
        };

        /** \brief Called before the planner runs, so that its result is not lost to a missing folder. */
        void requireWritable(const std::string &option, const std::filesystem::path &file)
        {
            if (file.empty())
            {
                return;
            }
            const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
            if (std::filesystem::is_directory(file) || !std::filesystem::is_directory(folder) ||
                access(std::filesystem::exists(file) ? file.c_str() : folder.c_str(), W_OK) != 0)
            {
                throw InputError(option + " " + file.string() +
                                 ": cannot be written; a file in an existing, writable folder is accepted");
            }
        }

        /** \brief Writes the path of an arm as a timed trajectory if the file is .csv or .yaml; false otherwise. */
        bool writeTrajectory(const ProblemFactory &factory, const og::PathGeometric &path, const std::string &file)
        {
            const std::string extension = lowerCase(std::filesystem::path(file).extension().string());
            const bool csv = extension == ".csv";
            if (factory.arm() == nullptr || !(csv || extension == ".yaml" || extension == ".yml"))
            {
                return false;
            }
            std::ofstream out(file);
            out.imbue(std::locale::classic());
            const auto trajectory = robots::timedPath(*factory.arm(), path);
            csv ? robots::writeCsv(trajectory, out) : robots::writeYaml(trajectory, out);
            out.close();
            if (!out)
            {
                throw InputError("--path " + file + ": cannot be written");
            }
            return true;
        }

        /** \brief The problem of the scenario that the options name, or its only one; null if there is no scenario. */
        const maps::ScenarioProblem *selectProblem(ProblemFactory &factory, const Options &options, bool isGiven)
        {
            const auto &problems = factory.problems();
            const std::string option = "--problem " + std::to_string(options.problem);
            if (problems.empty())
            {
                if (isGiven)
                {
                    throw InputError(option + ": " + options.file + " is a single problem, without a scenario");
                }
                return nullptr;
            }
            const std::string accepted = "expected one of " + std::to_string(problems.front().index) + " to " +
                                         std::to_string(problems.back().index);
            if (!isGiven && problems.size() > 1)
            {
                throw InputError(options.file + ": stands for " + std::to_string(problems.size()) +
                                 " problems; give one of them by --problem, " + accepted);
            }
            const std::size_t first = problems.front().index;
            const std::size_t number = isGiven ? options.problem - first : 0;
            if (isGiven && (options.problem < first || number >= problems.size()))
            {
                throw InputError(option + ": " + accepted);
            }
            factory.select(number);
            return &problems[number];
        }

        /** \brief Where a path is to be written with states at a spacing that is not given: a cell, or a hundredth of
            the path. */
        double usualSpacing(const ProblemFactory &factory, const og::PathGeometric &path)
        {
            constexpr double PARTS = 100.0;
            const double spacing =
                factory.map() != nullptr ? factory.map()->map().frame().resolution : path.length() / PARTS;
            return spacing > 0.0 ? spacing : 1.0;
        }

        std::string titleOf(const ProblemFactory &factory, const maps::ScenarioProblem *problem)
        {
            return factory.config().problem.name +
                   (problem != nullptr ? ", problem " + std::to_string(problem->index) : std::string());
        }

        void draw(const ProblemFactory &factory, const PlanRun &run, const Result &result, const Options &options,
                  const std::string &title)
        {
            PictureContent content;
            content.title = title + ", " + run.planner().getName();
            if (const auto *mfa = dynamic_cast<const MFA *>(&run.planner()))
            {
                content.swarm = mfa->getSwarmPaths();
                content.slices = mfa->getSlicePaths();
            }
            if (run.setup().haveSolutionPath())
            {
                content.best.push_back(run.setup().getSolutionPath());
                content.title += ", cost " + text::numberText(result.cost, 5) + (result.exact ? "" : " (approximate)");
            }
            drawProblem(factory, run.setup(), content, options.picture);
        }

        nlohmann::json count(const std::string &text)
        {
            return text.empty() ? nlohmann::json() : nlohmann::json(std::stoull(text));
        }

        void printJson(const ProblemFactory &factory, const PlannerSpec &spec, const Options &options,
                       const Result &result, const maps::ScenarioProblem *problem)
        {
            const nlohmann::json document = {
                {"problem", factory.config().problem.name},
                {"scenario_index", problem != nullptr ? nlohmann::json(problem->index) : nlohmann::json()},
                {"octile_length", problem != nullptr ? nlohmann::json(problem->octileLength) : nlohmann::json()},
                {"planner", spec.type},
                {"name", spec.name},
                {"seed", options.seed},
                {"status", result.status},
                {"cost", finiteOrNull(result.cost)},
                {"unsimplified_cost", finiteOrNull(result.unsimplifiedCost)},
                {"length", finiteOrNull(result.length)},
                {"valid", result.valid},
                {"time_to_first_solution", finiteOrNull(result.timeToFirstSolution)},
                {"time", result.time},
                {"simplification_time", result.simplificationTime},
                {"states", result.states},
                {"evaluations", count(result.evaluations)},
                {"iterations", count(result.iterations)},
                {"checked_states", result.checkedStates},
                {"checked_motions", result.checkedMotions}};
            printDocument(document);
        }

        void printText(const PlannerSpec &spec, const Options &options, const Result &result, const std::string &title)
        {
            const auto orNone = [](double value, const std::string &unit)
            { return std::isfinite(value) ? text::numberText(value, 7) + unit : std::string("none"); };
            const text::PlainNumbers plainNumbers(std::cout);
            std::cout << "problem                  " << title << "\n"
                      << "planner                  " << spec.name << ", seed " << options.seed << "\n"
                      << "status                   " << result.status << "\n"
                      << "cost                     " << orNone(result.cost, "");
            if (options.simplify)
            {
                std::cout << " (" << orNone(result.unsimplifiedCost, "") << " before simplification)";
            }
            std::cout << "\ntime to first solution   " << orNone(result.timeToFirstSolution, " s") << "\n"
                      << "time                     " << orNone(result.time, " s") << "\n"
                      << "states                   " << result.states << "\n"
                      << "evaluations              "
                      << (result.evaluations.empty() ? "not counted" : result.evaluations)
                      << "\nchecked states, motions  " << result.checkedStates << ", " << result.checkedMotions
                      << std::endl;
        }

        /** \brief Which options were given. */
        struct Presence
        {
            bool time;
            bool seed;
            bool spacing;
            bool problem;
        };

        void plan(Options options, const Presence &given)
        {
            ProblemFactory factory(readProblem(options.file, options.robot));
            const maps::ScenarioProblem *problem = selectProblem(factory, options, given.problem);
            const std::string title = titleOf(factory, problem);
            const benchmark::CampaignConfig &benchmark = factory.config().benchmark;
            if (!given.seed)
            {
                options.seed = static_cast<std::uint32_t>(benchmark.seed);
            }
            if (!given.time)
            {
                options.time = benchmark.timeLimit;
            }
            if (!(options.time > 0.0 && options.time <= benchmark::LONGEST_TIME_LIMIT))
            {
                throw InputError("--time " + text::numberText(options.time) + ": expected " + ACCEPTED_TIME);
            }
            if (given.spacing && !(options.spacing > 0.0 && std::isfinite(options.spacing)))
            {
                throw InputError("--spacing " + text::numberText(options.spacing) + ": expected " + ACCEPTED_SPACING);
            }
            options.picture = benchmark::writtenPath(options.picture, "--picture " + options.picture).string();
            options.path = benchmark::writtenPath(options.path, "--path " + options.path).string();
            if (!options.picture.empty())
            {
                pictureFormat(options.picture);
                if (factory.arm() != nullptr)
                {
                    throw InputError("--picture " + options.picture + ": there are no pictures of arms");
                }
            }
            requireWritable("--picture", options.picture);
            requireWritable("--path", options.path);
            PlannerSpec spec = choosePlanner(factory.config(), options.planner);
            for (const auto &parameter : options.parameters)
            {
                overrideParameter(spec, parameter);
            }

            benchmark::setRandomSeed(options.seed);
            PlanRun run(factory, spec, options);
            if (factory.arm() == nullptr)
            {
                requirePathFormat(pathFormat(options.path), *run.setup().getStateSpace(), options.path);
            }
            const Result result = run.solve();
            if (!options.path.empty() && run.setup().haveSolutionPath())
            {
                const og::PathGeometric &path = run.setup().getSolutionPath();
                if (!writeTrajectory(factory, path, options.path))
                {
                    writePath(path, options.path, given.spacing ? options.spacing : usualSpacing(factory, path));
                }
            }
            if (!options.picture.empty())
            {
                draw(factory, run, result, options, title);
            }
            if (options.json)
            {
                printJson(factory, spec, options, result, problem);
            }
            else
            {
                printText(spec, options, result, title);
            }
            if (!result.exact)
            {
                throw CLI::RuntimeError(1);
            }
        }
    }  // namespace

    void addPlanCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("plan", "Solve the problem of a benchmark config, or of a robot arm, once");
        command->add_option("FILE", options->file, "A .cfg file; not with --robot");
        addRobotOptions(*command, options->robot);
        command
            ->add_option("--planner", options->planner,
                         "Name or type of a planner of the config, which keeps its parameters there, or any other type")
            ->capture_default_str();
        auto *time = addNumberOption(*command, "--time", options->time, "Seconds; the config's time_limit if not given",
                                     ACCEPTED_TIME);
        auto *seed = command->add_option("--seed", options->seed, "The config's seed if not given")
                         ->check(CLI::Range(std::uint32_t{1}, std::numeric_limits<std::uint32_t>::max()));
        command->add_option("--iterations", options->iterations,
                            "Stop when the planner has asked this often whether to stop; a run that ends so repeats "
                            "exactly");
        command->add_option("--parameter", options->parameters, "NAME=VALUE of the planner, overriding the config");
        command->add_flag("--simplify", options->simplify, "Simplify the path as OMPL's SimpleSetup does");
        command->add_option("--picture", options->picture, "Draw world and paths in this .svg, .png or .pdf file");
        command->add_option("--path", options->path,
                            "Write the path to this file: .csv (x,y,yaw), .yaml (as nav_msgs/Path), of an arm a timed "
                            "trajectory, or else a state a line");
        auto *spacing = addNumberOption(*command, "--spacing", options->spacing,
                                        "Largest distance between the states of a .csv or .yaml path; a cell of the "
                                        "map or a hundredth of the path if not given",
                                        ACCEPTED_SPACING);
        auto *problem = command->add_option("--problem", options->problem,
                                            "Index of a problem of the config's scenario, which may have several");
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback(
            [options, time, seed, spacing, problem] {
                plan(*options, {time->count() > 0, seed->count() > 0, spacing->count() > 0, problem->count() > 0});
            });
    }
}  // namespace ompl_mfa::cli
