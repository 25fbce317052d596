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
#include <chrono>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalLazySamples.h>

#include "benchmark/ProblemSpace.h"
#include "cli/Commands.h"
#include "cli/JsonDocument.h"
#include "cli/RobotOptions.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "ompl_mfa/collision/PlanarOutline.h"
#include "text/NumberText.h"

namespace ompl_mfa::cli
{
    namespace
    {
        namespace ob = ompl::base;
        using benchmark::BenchmarkConfig;
        using benchmark::ProblemFactory;

        /* Significant digits of printed numbers. */
        constexpr int DIGITS = 6;
        constexpr int CHECK_TIME_DIGITS = 2;

        struct Options
        {
            std::string file;
            RobotOptions robot;
            bool json{false};
        };

        /** \brief The straight motion from start to goal. */
        struct StraightMotion
        {
            bool free{false};
            /** \brief Fraction of the motion that is known to be free, in [0, 1]. */
            double freeFraction{0.0};
            double length{0.0};
        };

        /** \brief Whether a goal state is known; for a goal that is a pose of an arm, one may not have been found. */
        bool hasGoalState(const ompl::geometric::SimpleSetup &setup)
        {
            const auto *lazy = dynamic_cast<const ob::GoalLazySamples *>(setup.getGoal().get());
            return lazy == nullptr || lazy->hasStates();
        }

        StraightMotion straightMotion(const ompl::geometric::SimpleSetup &setup)
        {
            const auto &si = setup.getSpaceInformation();
            const ob::State *start = setup.getProblemDefinition()->getStartState(0);
            if (!hasGoalState(setup))
            {
                return {};
            }
            ob::ScopedState<> goalState(setup.getStateSpace());
            setup.getGoal()->as<ob::GoalSampleableRegion>()->sampleGoal(goalState.get());
            const ob::State *goal = goalState.get();
            std::pair<ob::State *, double> lastValid(nullptr, 0.0);
            StraightMotion motion;
            motion.free = si->checkMotion(start, goal, lastValid);
            motion.freeFraction = motion.free ? 1.0 : lastValid.second;
            motion.length = si->distance(start, goal);
            return motion;
        }

        /** \brief Microseconds for the check of a valid state: the minimum over several rounds of uniform states, as
            other programs can only slow a round down. */
        double stateCheckTime(const ompl::base::SpaceInformation &si)
        {
            constexpr unsigned int STATES = 200;
            constexpr unsigned int ROUNDS = 10;
            constexpr double SHORTEST_ROUND = 1e-3;
            std::vector<ob::State *> states(STATES);
            si.allocStates(states);
            const auto sampler = si.allocStateSampler();
            // a planner checks far more valid states than invalid ones
            for (ob::State *state : states)
            {
                constexpr unsigned int TRIES = 100;
                for (unsigned int i = 0; i == 0 || (i < TRIES && !si.isValid(state)); ++i)
                {
                    sampler->sampleUniform(state);
                }
            }
            double best = std::numeric_limits<double>::infinity();
            for (unsigned int round = 0; round < ROUNDS; ++round)
            {
                std::size_t checks = 0;
                double seconds = 0.0;
                const auto begin = std::chrono::steady_clock::now();
                while (seconds < SHORTEST_ROUND)
                {
                    for (const ob::State *state : states)
                    {
                        si.isValid(state);
                    }
                    checks += STATES;
                    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
                }
                best = std::min(best, seconds / static_cast<double>(checks));
            }
            si.freeStates(states);
            return 1e6 * best;
        }

        /** \brief Makes and sets up every planner of the config, to find errors before a campaign. */
        void checkPlanners(const ProblemFactory &factory)
        {
            for (const auto &spec : factory.config().planners)
            {
                const auto setup = factory.create(spec);
                try
                {
                    setup->setup();
                }
                catch (const std::exception &error)
                {
                    throw InputError(spec.origin + ": planner '" + spec.type +
                                     "' cannot be set up for this problem: " + error.what());
                }
            }
        }

        nlohmann::json describeBox(const fcl::AABBd &box)
        {
            return {{"min", {box.min_[0], box.min_[1], box.min_[2]}}, {"max", {box.max_[0], box.max_[1], box.max_[2]}}};
        }

        /** \brief A planar robot moves at z = 0 and does not collide with a world at other heights. */
        std::vector<std::string> warnings(const ProblemFactory &factory)
        {
            if (factory.arm() != nullptr)
            {
                return {};
            }
            const benchmark::ProblemConfig &problem = factory.config().problem;
            const auto &objects = factory.world().objects();
            const fcl::AABBd robot = factory.robot().bounds();
            const bool isReached =
                std::any_of(objects.begin(), objects.end(),
                            [&robot](const collision::CollisionObject &object)
                            { return collision::reachesHeights(object, robot.min_[2], robot.max_[2]); });
            if (benchmark::positionDimension(problem.space) == 3 || objects.empty() || isReached)
            {
                return {};
            }
            const auto number = [](double value) { return text::numberText(value, DIGITS); };
            const fcl::AABBd world = factory.world().bounds();
            return {problem.world->origin + ": problem.world = " + problem.world->value +
                    ": nothing of it reaches the " + "heights of the planar robot, z = " + number(robot.min_[2]) +
                    " to " + number(robot.max_[2]) +
                    ", so that there is nothing to collide with; the world's box is from z = " + number(world.min_[2]) +
                    " to " + number(world.max_[2])};
        }

        nlohmann::json describeBody(const collision::RigidBody &robot)
        {
            return {{"robot_radius", robot.radius()},
                    {"robot_box", describeBox(robot.bounds())},
                    {"robot_skipped_faces", robot.skippedFaces()}};
        }

        nlohmann::json describeArm(const robots::RobotProblem &arm)
        {
            nlohmann::json joints = nlohmann::json::array();
            for (const std::size_t joint : arm.robot().group)
            {
                joints.push_back(arm.robot().model->joints()[joint].name);
            }
            return {{"group", arm.groupName()},
                    {"joints", joints},
                    {"attached_objects", arm.robot().scene->attached.size()},
                    {"checked_link_pairs", arm.collision().checkedPairs().size()},
                    {"checked_obstacle_pairs", arm.collision().checkedObstacles().size()}};
        }

        nlohmann::json describeMap(const ProblemFactory &factory)
        {
            if (factory.map() == nullptr)
            {
                return {};
            }
            const maps::GridMap &map = factory.map()->map();
            const auto count = [&map](maps::Cell cell)
            { return std::count(map.cells().begin(), map.cells().end(), cell); };
            return {{"width", map.width()},
                    {"height", map.height()},
                    {"resolution", map.frame().resolution},
                    {"free_cells", count(maps::Cell::Free)},
                    {"occupied_cells", count(maps::Cell::Occupied)},
                    {"unknown_cells", count(maps::Cell::Unknown)}};
        }

        nlohmann::json worldBox(const ProblemFactory &factory)
        {
            if (factory.map() != nullptr)
            {
                const Eigen::AlignedBox2d box = factory.map()->map().bounds();
                return {{"min", {box.min().x(), box.min().y(), 0.0}}, {"max", {box.max().x(), box.max().y(), 0.0}}};
            }
            return factory.world().objects().empty() ? nlohmann::json() : describeBox(factory.world().bounds());
        }

        nlohmann::json describe(const ProblemFactory &factory, const ompl::geometric::SimpleSetup &setup)
        {
            const BenchmarkConfig &config = factory.config();
            const StraightMotion motion = straightMotion(setup);
            nlohmann::json planners = nlohmann::json::array();
            for (const auto &spec : config.planners)
            {
                planners.push_back({{"type", spec.type}, {"name", spec.name}});
            }
            nlohmann::json description = {
                {"problem", config.problem.name},
                {"space", benchmark::spaceName(config.problem.space)},
                {"world", config.problem.world ? nlohmann::json(config.problem.world->value) : nlohmann::json()},
                {"obstacles", factory.world().objects().size()},
                {"robot", config.problem.robot.value},
                {"world_box", worldBox(factory)},
                {"map", describeMap(factory)},
                {"problems", std::max<std::size_t>(1, factory.problems().size())},
                {"world_skipped_faces", factory.world().skippedFaces()},
                {"state_check_time", stateCheckTime(*setup.getSpaceInformation())},
                {"warnings", warnings(factory)},
                {"start_valid", true},
                {"goal_valid", hasGoalState(setup)},
                {"straight_motion",
                 {{"free", motion.free}, {"free_fraction", motion.freeFraction}, {"length", motion.length}}},
                {"planners", planners}};
            description.update(factory.arm() != nullptr ? describeArm(*factory.arm()) : describeBody(factory.robot()));
            return description;
        }

        std::string boxText(const nlohmann::json &box)
        {
            const auto corner = [](const nlohmann::json &point)
            {
                const auto number = [&point](int axis) { return text::numberText(point[axis].get<double>(), DIGITS); };
                return "(" + number(0) + ", " + number(1) + ", " + number(2) + ")";
            };
            return box.is_null() ? "none" : corner(box["min"]) + " to " + corner(box["max"]);
        }

        std::string skippedText(const nlohmann::json &faces)
        {
            return faces == 0 ? "" : ", " + std::to_string(faces.get<std::size_t>()) + " points and lines passed over";
        }

        /* The rest of the line of the robot, and further lines about it. */
        std::string robotText(const nlohmann::json &description)
        {
            if (!description.contains("joints"))
            {
                return ", radius " + text::numberText(description["robot_radius"].get<double>(), DIGITS) +
                       skippedText(description["robot_skipped_faces"]) + "\nrobot box  " +
                       boxText(description["robot_box"]) + "\n";
            }
            const auto number = [&description](const char *key)
            { return std::to_string(description[key].get<std::size_t>()); };
            const std::string group = description["group"].get<std::string>();
            return ", " + std::to_string(description["joints"].size()) + " joints" +
                   (group.empty() ? "" : " of the group " + oneLine(group)) + "\nchecked    " +
                   number("checked_link_pairs") + " pairs of links, " + number("checked_obstacle_pairs") +
                   " of links and obstacles; " + number("attached_objects") + " attached objects\n";
        }

        std::string obstaclesText(const nlohmann::json &description)
        {
            const nlohmann::json &map = description["map"];
            if (map.is_null())
            {
                return std::to_string(description["obstacles"].get<std::size_t>()) + " obstacles";
            }
            const auto number = [&map](const char *key) { return text::numberText(map[key].get<double>()); };
            return number("width") + " x " + number("height") + " cells of " + number("resolution") + ", " +
                   number("occupied_cells") + " occupied, " + number("unknown_cells") + " unknown";
        }

        void printText(const nlohmann::json &description)
        {
            const auto &motion = description["straight_motion"];
            const text::PlainNumbers plainNumbers(std::cout);
            std::cout << std::setprecision(DIGITS);
            std::cout << "problem    " << description["problem"].get<std::string>() << "\n"
                      << "space      " << description["space"].get<std::string>() << "\n"
                      << "world      "
                      << (description["world"].is_null() ? "empty" : oneLine(description["world"].get<std::string>()))
                      << ", " << obstaclesText(description) << skippedText(description["world_skipped_faces"]) << "\n"
                      << "world box  " << boxText(description["world_box"]) << "\n"
                      << "robot      " << oneLine(description["robot"].get<std::string>()) << robotText(description)
                      << (description["problems"] == 1
                              ? std::string("start      valid\ngoal       ") +
                                    (description["goal_valid"].get<bool>() ? "valid\n" : "no state found yet\n")
                              : "problems   " + std::to_string(description["problems"].get<std::size_t>()) +
                                    ", start and goal of each valid\n")
                      << "straight   ";
            if (motion["free"].get<bool>())
            {
                std::cout << "free, length " << motion["length"].get<double>() << "\n";
            }
            else
            {
                std::cout << "blocked after " << motion["free_fraction"].get<double>() << " of length "
                          << motion["length"].get<double>() << "\n";
            }
            std::cout << "check      " << std::setprecision(CHECK_TIME_DIGITS)
                      << description["state_check_time"].get<double>()
                      << " microseconds a state; for planners of this project with a seed: mfa.state_check_time="
                      << description["state_check_time"].get<double>() << "\n";
            std::cout << "planners   " << description["planners"].size() << "\n";
        }

        void check(const Options &options)
        {
            ProblemFactory factory(readProblem(options.file, options.robot));
            benchmark::setRandomSeed(factory.config().benchmark.seed);
            // the last one first, so that the first one remains selected
            for (std::size_t number = factory.problems().size(); number-- > 0;)
            {
                factory.select(number);
                factory.create();
            }
            const auto setup = factory.create();
            checkPlanners(factory);
            const nlohmann::json description = describe(factory, *setup);
            for (const auto &warning : description["warnings"])
            {
                std::cerr << "warning: " << oneLine(warning.get<std::string>()) << std::endl;
            }
            if (options.json)
            {
                printDocument(description);
            }
            else
            {
                printText(description);
            }
        }
    }  // namespace

    void addCheckCommand(CLI::App &app)
    {
        const auto options = std::make_shared<Options>();
        auto *command = app.add_subcommand("check", "Validate a benchmark config without running it");
        command->add_option("FILE", options->file, "A .cfg file; not with --robot");
        addRobotOptions(*command, options->robot);
        command->add_flag("--json", options->json, "Print one JSON document");
        command->callback([options] { check(*options); });
    }
}  // namespace ompl_mfa::cli
