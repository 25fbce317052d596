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

#include "cli/RobotOptions.h"

#include <optional>

#include "benchmark/ArmConfig.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::cli
{
    namespace
    {
        using benchmark::ConfigEntry;

        std::optional<ConfigEntry> entryOf(const std::string &option, const std::string &value)
        {
            return value.empty() ? std::nullopt : std::make_optional(ConfigEntry{option, value, "command line"});
        }

        std::string joined(const std::vector<std::string> &folders)
        {
            std::string text;
            for (const std::string &folder : folders)
            {
                text += (text.empty() ? "" : ":") + folder;
            }
            return text;
        }

        benchmark::BenchmarkConfig configOf(const RobotOptions &options)
        {
            if (!benchmark::isArmFile(options.robot))
            {
                throw InputError("--robot " + options.robot + ": expected a .urdf file");
            }
            benchmark::BenchmarkConfig config;
            benchmark::ProblemConfig &problem = config.problem;
            const std::filesystem::path named = options.request.empty() ? options.robot : options.request;
            problem.name = named.stem().string();
            problem.robotKind = benchmark::RobotKind::Arm;
            problem.space = benchmark::StateSpaceKind::Joints;
            problem.robot = *entryOf("--robot", options.robot);
            problem.world = entryOf("--scene", options.scene);
            problem.arm.semantics = entryOf("--semantics", options.semantics);
            problem.arm.group = entryOf("--group", options.group);
            problem.arm.request = entryOf("--request", options.request);
            problem.arm.start = entryOf("--start", options.start);
            problem.arm.goal = entryOf("--goal", options.goal);
            problem.arm.packages = entryOf("--packages", joined(options.packages));
            return config;
        }
    }  // namespace

    void addRobotOptions(CLI::App &command, RobotOptions &options)
    {
        command.add_option("--robot", options.robot, "URDF file of an arm, in place of a .cfg file");
        command.add_option("--semantics", options.semantics, "SRDF file of the arm");
        command.add_option("--group", options.group, "Group of joints that move; the request's if not given");
        command.add_option("--scene", options.scene, "MoveIt planning scene (.yaml)");
        command.add_option("--request", options.request, "MoveIt motion plan request (.yaml)");
        command.add_option("--start", options.start, "Start in place of the request's: a group state or joint values");
        command.add_option("--goal", options.goal, "Goal in place of the request's: a group state or joint values");
        command.add_option("--packages", options.packages, "Folders in which package:// is searched");
    }

    benchmark::BenchmarkConfig readProblem(const std::string &file, const RobotOptions &options)
    {
        const std::pair<const char *, bool> others[] = {
            {"--semantics", !options.semantics.empty()}, {"--group", !options.group.empty()},
            {"--scene", !options.scene.empty()},         {"--request", !options.request.empty()},
            {"--start", !options.start.empty()},         {"--goal", !options.goal.empty()},
            {"--packages", !options.packages.empty()}};
        if (!options.robot.empty())
        {
            if (!file.empty())
            {
                throw InputError(file + ": either a .cfg file or --robot is accepted");
            }
            return configOf(options);
        }
        for (const auto &[option, isGiven] : others)
        {
            if (isGiven)
            {
                throw InputError(std::string(option) + " needs --robot");
            }
        }
        if (file.empty())
        {
            throw InputError("FILE is required, or --robot; run with --help for more information");
        }
        return benchmark::readBenchmarkConfig(file);
    }
}  // namespace ompl_mfa::cli
