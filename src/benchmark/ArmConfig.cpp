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

#include "benchmark/ArmConfig.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using Row = ConfigRow<ProblemConfig>;

        Row textRow(const std::string &key, const std::string &accepted, const std::string &fallback,
                    const std::string &meaning, std::optional<ConfigEntry> ArmConfig::*place)
        {
            return {{key},
                    accepted,
                    fallback,
                    meaning,
                    [place](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                    { problem.arm.*place = entry; }};
        }

        double positive(const std::string &text, const ConfigEntry &entry, const std::string &accepted)
        {
            double value = 0.0;
            if (!text::readNumber(trimmed(text), value) || !std::isfinite(value) || value <= 0.0)
            {
                failAt(entry, "expected " + accepted);
            }
            return value;
        }

        Row stepRow()
        {
            const std::string accepted = "a number above 0";
            return {{"robot.step"},
                    accepted,
                    text::numberText(ArmConfig().step) + ", unless longest_valid_segment_fraction is given",
                    "longest step between two states of a motion that are checked, in joint space: radians or metres",
                    [accepted](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                    { problem.arm.step = positive(entry.value, entry, accepted); }};
        }

        Row weightsRow()
        {
            const std::string accepted = "a number above 0 for each joint of the group, separated by commas";
            return {{"robot.weights"},
                    accepted,
                    "1 for each joint",
                    "factors for the distance of each joint, and so for the path length",
                    [accepted](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                    {
                        std::istringstream list(entry.value);
                        for (std::string part; std::getline(list, part, ',');)
                        {
                            problem.arm.weights.push_back(positive(part, entry, accepted));
                        }
                    }};
        }

        Row paddingRow()
        {
            const std::string accepted = "a finite number";
            return {{"robot.link_padding"},
                    accepted,
                    "0",
                    "metres by which every link is enlarged, besides what the scene says",
                    [accepted](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                    {
                        double value = 0.0;
                        if (!text::readNumber(entry.value, value) || !std::isfinite(value))
                        {
                            failAt(entry, "expected " + accepted);
                        }
                        problem.arm.padding = value;
                    }};
        }

        std::vector<std::filesystem::path> packageFolders(const BenchmarkConfig &config)
        {
            std::vector<std::filesystem::path> folders;
            std::istringstream list(config.problem.arm.packages ? config.problem.arm.packages->value : "");
            for (std::string name; std::getline(list, name, ':');)
            {
                if (name.empty())
                {
                    continue;
                }
                const std::filesystem::path beside = config.file.parent_path() / name;
                folders.push_back(std::filesystem::is_directory(name) ? std::filesystem::path(name) : beside);
                if (!std::filesystem::is_directory(folders.back()))
                {
                    failAt(*config.problem.arm.packages, "'" + name + "' is no folder");
                }
            }
            return folders;
        }

        std::filesystem::path optionalFile(const BenchmarkConfig &config, const std::optional<ConfigEntry> &entry)
        {
            return entry ? findResource(config, *entry) : std::filesystem::path();
        }
    }  // namespace

    std::vector<Row> armRows()
    {
        return {textRow("robot.semantics", "an SRDF file", "no groups; only links that a joint connects may touch",
                        "groups of joints, named states and pairs of links that may touch, of an arm",
                        &ArmConfig::semantics),
                textRow("robot.group", "the name of a group", "that of the request, or the only one, or all joints",
                        "the joints that move", &ArmConfig::group),
                textRow("robot.packages", "folders, separated by colons", "the folder of the robot",
                        "where the meshes of package:// are searched", &ArmConfig::packages),
                textRow("robot.request", "a motion plan request (.yaml)", "none",
                        "start and goal of an arm, as in MoveIt", &ArmConfig::request),
                textRow("start", "the name of a group state, or a number for each joint, separated by commas",
                        "that of the request, or the scene's state", "start of an arm", &ArmConfig::start),
                textRow("goal", "the name of a group state, or a number for each joint, separated by commas",
                        "that of the request", "goal of an arm", &ArmConfig::goal),
                stepRow(),
                weightsRow(),
                paddingRow()};
    }

    bool isArmFile(const std::string &robot)
    {
        const std::string extension = lowerCase(std::filesystem::path(robot).extension().string());
        return extension == ".urdf" || extension == ".xacro";
    }

    void checkArmKeys(const std::map<std::string, ConfigEntry> &section, const ProblemConfig &problem)
    {
        const bool isArm = problem.robotKind == RobotKind::Arm;
        const std::vector<std::string> armKeys = keysOf(armRows());
        for (const auto &[key, entry] : section)
        {
            const bool isForArms = std::find(armKeys.begin(), armKeys.end(), key) != armKeys.end();
            if (isForArms && !isArm)
            {
                failAt(entry, "only arms have this; for one, robot is a .urdf file");
            }
            static const std::vector<std::string> COMMON{
                "name", "world", "robot", "threshold", "objective", "objective.", "motion_validation"};
            const auto isCommon = [&key = key](const std::string &common)
            { return key == common || (common.back() == '.' && key.rfind(common, 0) == 0); };
            if (isArm && !isForArms && std::none_of(COMMON.begin(), COMMON.end(), isCommon))
            {
                const std::vector<std::string> context = keysOf(contextRows());
                if (std::find(context.begin(), context.end(), key) == context.end())
                {
                    failAt(entry, "arms do not have this");
                }
            }
        }
    }

    std::vector<std::filesystem::path> armFiles(const BenchmarkConfig &config)
    {
        const ArmConfig &arm = config.problem.arm;
        std::vector<std::filesystem::path> files{findResource(config, config.problem.robot)};
        for (const auto &entry : {arm.semantics, config.problem.world, arm.request})
        {
            if (entry)
            {
                files.push_back(findResource(config, *entry));
            }
        }
        return files;
    }

    std::shared_ptr<const robots::RobotProblem> loadArm(const BenchmarkConfig &config)
    {
        const ArmConfig &arm = config.problem.arm;
        robots::RobotFiles files;
        files.robot = findResource(config, config.problem.robot);
        files.semantics = optionalFile(config, arm.semantics);
        files.scene = optionalFile(config, config.problem.world);
        files.request = optionalFile(config, arm.request);
        files.packages = packageFolders(config);
        files.group = arm.group ? arm.group->value : "";
        files.start = arm.start ? arm.start->value : "";
        files.goal = arm.goal ? arm.goal->value : "";
        files.weights = arm.weights;
        files.padding = arm.padding;
        return std::make_shared<robots::RobotProblem>(files);
    }

    ompl::geometric::SimpleSetupPtr makeArmSetup(const robots::RobotProblem &arm, const robots::JointSpace &joints,
                                                 const ProblemConfig &problem, const ContextConfig &context)
    {
        auto setup = std::make_shared<ompl::geometric::SimpleSetup>(joints.space());
        if (!context.longestValidSegmentFraction)
        {
            constexpr double LARGEST = 0.5;
            joints.space()->setLongestValidSegmentFraction(
                std::min(LARGEST, problem.arm.step / joints.space()->getMaximumExtent()));
        }
        arm.setChecks(
            setup->getSpaceInformation(), joints,
            problem.motionValidation ? problem.motionValidation->value : collision::MotionValidation::Discrete);
        return setup;
    }
}  // namespace ompl_mfa::benchmark
