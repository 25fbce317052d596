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

#include "benchmark/ConfigKeys.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include <boost/algorithm/string/join.hpp>

#include "benchmark/ArmConfig.h"
#include "benchmark/FileNames.h"
#include "benchmark/MapKeys.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        constexpr std::uint64_t LARGEST_WHOLE = std::numeric_limits<std::uint32_t>::max();

        /* Conversion of a text to a value and back, and a description of the accepted values. */
        template <typename Value>
        struct ValueType
        {
            std::string accepted;
            std::function<Value(const ConfigEntry &)> read;
            std::function<std::string(const Value &)> write;
        };

        ValueType<double> number(const std::string &accepted, bool (*isAccepted)(double))
        {
            return {accepted,
                    [accepted, isAccepted](const ConfigEntry &entry)
                    {
                        double value = 0.0;
                        if (!text::readNumber(entry.value, value) || !std::isfinite(value) || !isAccepted(value))
                        {
                            failAt(entry, "expected " + accepted);
                        }
                        return value;
                    },
                    [](double value) { return text::numberText(value); }};
        }

        ValueType<double> finite()
        {
            return number("a finite number", [](double) { return true; });
        }

        ValueType<double> positive()
        {
            return number("a number above 0", [](double value) { return value > 0.0; });
        }

        template <typename Value = unsigned int>
        ValueType<Value> whole(std::uint64_t last)
        {
            return {"a whole number from 1 to " + std::to_string(last),
                    [last](const ConfigEntry &entry) { return static_cast<Value>(wholeValue(entry, 1, last)); },
                    [](Value value) { return std::to_string(value); }};
        }

        ValueType<bool> onOff()
        {
            return {"one of 0, 1, false, true, no, yes, off, on", switchValue,
                    [](bool value) { return value ? "yes" : "no"; }};
        }

        template <typename Value>
        using Words = std::vector<std::pair<std::string, Value>>;

        template <typename Value>
        std::string wordOf(const Words<Value> &words, Value value)
        {
            return std::find_if(words.begin(), words.end(), [value](const auto &word) { return word.second == value; })
                ->first;
        }

        template <typename Value>
        ValueType<Value> oneOf(const Words<Value> &words)
        {
            std::vector<std::string> names;
            for (const auto &word : words)
            {
                names.push_back(word.first);
            }
            return {"one of " + boost::algorithm::join(names, ", "),
                    [words, names](const ConfigEntry &entry) { return words[choiceValue(entry, names)].second; },
                    [words](Value value) { return wordOf(words, value); }};
        }

        /* A text that is not checked before its use. */
        ValueType<ConfigEntry> file(const std::string &accepted)
        {
            return {accepted, [](const ConfigEntry &entry) { return entry; },
                    [](const ConfigEntry &entry) { return entry.value; }};
        }

        template <typename Place, typename Value>
        void assign(Place &place, const Value &value, const ConfigEntry & /*entry*/)
        {
            place = value;
        }

        template <typename Value>
        void assign(Given<Value> &place, const Value &value, const ConfigEntry &entry)
        {
            place = {value, entry};
        }

        template <typename Value>
        void assign(std::optional<Given<Value>> &place, const Value &value, const ConfigEntry &entry)
        {
            place = Given<Value>{value, entry};
        }

        /* Reference to a value in a config: a member, or the result of a function of the config and the key's index. */
        template <typename Config, typename Member>
        decltype(auto) placeIn(Config &config, Member member, std::size_t index)
        {
            if constexpr (std::is_member_object_pointer_v<Member>)
            {
                static_cast<void>(index);
                return (config.*member);
            }
            else
            {
                return member(config, index);
            }
        }

        /* The rows of one section. */
        template <typename Config>
        class Rows
        {
        public:
            template <typename Value, typename Member>
            void add(const std::vector<std::string> &keys, const ValueType<Value> &type, Member member,
                     const std::string &fallback, const std::string &meaning)
            {
                rows_.push_back({keys, type.accepted, fallback, meaning,
                                 [read = type.read, member](Config &config, std::size_t index, const ConfigEntry &entry)
                                 { assign(placeIn(config, member, index), read(entry), entry); }});
            }

            /* The fallback is the value in a new Config. */
            template <typename Value, typename Member>
            void add(const std::string &key, const ValueType<Value> &type, Member member, const std::string &meaning)
            {
                add({key}, type, member, type.write(Config().*member), meaning);
            }

            void add(ConfigRow<Config> row)
            {
                rows_.push_back(std::move(row));
            }

            void add(const std::vector<ConfigRow<Config>> &rows)
            {
                rows_.insert(rows_.end(), rows.begin(), rows.end());
            }

            std::vector<ConfigRow<Config>> take()
            {
                return std::move(rows_);
            }

        private:
            std::vector<ConfigRow<Config>> rows_;
        };

        ConfigPose &poseOf(ProblemConfig &problem, std::size_t index)
        {
            return index == 0 ? problem.start : problem.goal;
        }

        double &positionOf(ProblemConfig &problem, std::size_t index)
        {
            ConfigPose &pose = poseOf(problem, index / 2);
            return index % 2 == 0 ? pose.x : pose.y;
        }

        double &heightOf(ProblemConfig &problem, std::size_t index)
        {
            return poseOf(problem, index).z;
        }

        double &angleOf(ProblemConfig &problem, std::size_t index)
        {
            return poseOf(problem, index).theta;
        }

        double &axisOf(ProblemConfig &problem, std::size_t index)
        {
            return poseOf(problem, index / 3).axis[index % 3];
        }

        double &volumeEnd(ProblemConfig &problem, std::size_t index)
        {
            if (!problem.volume)
            {
                problem.volume.emplace();
            }
            return (index < 3 ? problem.volume->min : problem.volume->max)[index % 3];
        }

        ConfigRow<ProblemConfig> nameRow()
        {
            const std::string accepted = "a file's name of at most " + std::to_string(LONGEST_NAME) +
                                         " bytes, without / and control characters, not . or ..";
            return {{"name"},
                    accepted,
                    "the config's name without its ending",
                    "name of the experiment and of its log",
                    [accepted](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                    {
                        if (!isFileName(entry.value))
                        {
                            failAt(entry, "the log has this name; expected " + accepted);
                        }
                        problem.name = entry.value;
                    }};
        }

        ConfigRow<ProblemConfig> robotRow()
        {
            return {{"robot"},
                    "a mesh or planning scene, a .urdf file, or one of point, disc, sphere, footprint",
                    "required",
                    "what moves",
                    [](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                    {
                        problem.robot = entry;
                        problem.robotKind = entry.value == "point"       ? RobotKind::Point
                                            : entry.value == "disc"      ? RobotKind::Disc
                                            : entry.value == "sphere"    ? RobotKind::Sphere
                                            : entry.value == "footprint" ? RobotKind::Footprint
                                            : isArmFile(entry.value)     ? RobotKind::Arm
                                                                         : RobotKind::File;
                    }};
        }

        ConfigRow<ProblemConfig> weightRow()
        {
            static constexpr ObjectiveKind TERMS[] = {ObjectiveKind::Length, ObjectiveKind::MechanicalWork,
                                                      ObjectiveKind::Proximity, ObjectiveKind::ClearanceCost,
                                                      ObjectiveKind::Smoothness};
            return {{"objective.weight.length", "objective.weight.mechanical_work", "objective.weight.proximity",
                     "objective.weight.clearance_cost", "objective.weight.smoothness"},
                    positive().accepted,
                    "not in the sum",
                    "weight of this term of a weighted sum, which has at least one",
                    [](ProblemConfig &problem, std::size_t index, const ConfigEntry &entry)
                    { problem.objectiveWeights.emplace_back(TERMS[index], positive().read(entry)); }};
        }

        void addGeometry(Rows<ProblemConfig> &rows)
        {
            rows.add({"start.x", "start.y", "goal.x", "goal.y"}, finite(), positionOf, "required without a scenario",
                     "position of the robot's reference point, see Spaces");
            rows.add({"start.z", "goal.z"}, finite(), heightOf, "the problem is planar", "its height");
            rows.add({"start.axis.x", "start.axis.y", "start.axis.z", "goal.axis.x", "goal.axis.y", "goal.axis.z"},
                     finite(), axisOf, "the robot does not turn in space",
                     "the axis that theta turns about, of any length");
            rows.add({"start.theta", "goal.theta"}, finite(), angleOf, "the robot does not turn",
                     "orientation, radians");
            rows.add("threshold", number("a number of at least 0", [](double value) { return value >= 0.0; }),
                     &ProblemConfig::threshold, "distance at which a state counts as the goal");
            rows.add({"statespace"},
                     oneOf<StateSpaceKind>({{"dubins", StateSpaceKind::Dubins},
                                            {"dubinssymmetric", StateSpaceKind::DubinsSymmetric},
                                            {"reedsshepp", StateSpaceKind::ReedsShepp}}),
                     &ProblemConfig::space, "none", "a car's motions, for x, y, theta");
            rows.add("turningradius", positive(), &ProblemConfig::turningRadius, "turning radius of a car");
            rows.add({"rotation_weight"}, positive(), &ProblemConfig::rotationWeight, "OMPL's: 0.5 and 1",
                     "weight of the rotation in the distance, and so in the path length, of SE(2) and SE(3)");
            rows.add({"volume.min.x", "volume.min.y", "volume.min.z", "volume.max.x", "volume.max.y", "volume.max.z"},
                     finite(), volumeEnd, "the world's box, enlarged to hold start and goal",
                     "bounds of x, y (and z); all of them or none");
        }

        void addObjective(Rows<ProblemConfig> &rows)
        {
            rows.add({"objective"},
                     oneOf<ObjectiveKind>({{"length", ObjectiveKind::Length},
                                           {"max_min_clearance", ObjectiveKind::MaxMinClearance},
                                           {"mechanical_work", ObjectiveKind::MechanicalWork},
                                           {"clearance_cost", ObjectiveKind::ClearanceCost},
                                           {"weighted", ObjectiveKind::Weighted}}),
                     &ProblemConfig::objective, "none, see below", "what the planners optimize");
            rows.add({"objective.threshold"}, finite(), &ProblemConfig::objectiveThreshold,
                     "the objective's own: the best possible", "cost at which an optimizing planner may stop");
            rows.add(weightRow());
            const auto atLeast0 = number("a number of at least 0", [](double value) { return value >= 0.0; });
            rows.add("objective.cost_scaling_factor", atLeast0, &ProblemConfig::costScalingFactor,
                     "how fast clearance_cost falls with the distance from obstacles, per world unit");
            rows.add({"objective.inscribed_radius"}, atLeast0, &ProblemConfig::inscribedRadius, "the robot's",
                     "distance up to which clearance_cost is highest");
            rows.add("objective.cost_penalty", atLeast0, &ProblemConfig::costPenalty,
                     "what a path at that distance costs per length, in addition to 1");
        }

        /* A number of the drive's settings, whose default is that of a new config. */
        void addDriveNumber(Rows<ProblemConfig> &rows, const std::string &key, double DriveConfig::*member,
                            const std::string &meaning)
        {
            rows.add(
                {key},
                positive(), [member](ProblemConfig & problem, std::size_t) -> auto & { return problem.drive.*member; },
                text::numberText(DriveConfig().*member), meaning);
        }

        void addDrive(Rows<ProblemConfig> &rows)
        {
            rows.add(
                {"known_map"}, file("a map (.yaml, .map) of the size of the world's"),
                [](ProblemConfig & problem, std::size_t) -> auto & { return problem.drive.knownMap; },
                "nothing is known", "what the robot knows of the map before it drives");
            addDriveNumber(rows, "sensor.range", &DriveConfig::range, "how far its lidar sees");
            rows.add(
                {"sensor.rays"}, whole(100000),
                [](ProblemConfig & problem, std::size_t) -> auto & { return problem.drive.rays; },
                std::to_string(DriveConfig().rays), "rays of its lidar, all around");
            addDriveNumber(rows, "drive.speed", &DriveConfig::speed, "world units per second");
            addDriveNumber(rows, "drive.period", &DriveConfig::period, "seconds between two scans");
            addDriveNumber(rows, "drive.replan_time", &DriveConfig::replanTime, "seconds of planning in each period");
            addDriveNumber(rows, "drive.patience", &DriveConfig::patience,
                           "seconds of planning without a path after which the robot gives up");
            addDriveNumber(rows, "drive.time_limit", &DriveConfig::timeLimit, "seconds that the robot may drive");
        }

        const Words<SamplerKind> SAMPLERS = {{"uniform", SamplerKind::Uniform},
                                             {"gaussian", SamplerKind::Gaussian},
                                             {"obstacle_based", SamplerKind::ObstacleBased},
                                             {"max_clearance", SamplerKind::MaxClearance},
                                             {"bridge_test", SamplerKind::BridgeTest}};
    }  // namespace

    const std::vector<ConfigRow<ProblemConfig>> &problemRows()
    {
        static const auto ROWS = []
        {
            using collision::MeshInterior;
            using collision::MotionValidation;
            Rows<ProblemConfig> rows;
            rows.add(nameRow());
            rows.add({"world"},
                     file("a mesh, a planning scene (.yaml, .scene), an OctoMap (.bt, .ot) or a map (.yaml, .map)"),
                     &ProblemConfig::world, "an empty world", "the obstacles");
            rows.add(unknownCellsRow());
            rows.add(robotRow());
            rows.add({"robot.radius"}, positive(), &ProblemConfig::robotRadius, "required for these",
                     "radius of a disc or sphere");
            rows.add(footprintRows());
            rows.add(scenarioRows());
            for (const ConfigRow<ProblemConfig> &row : armRows())
            {
                rows.add(row);
            }
            addGeometry(rows);
            addObjective(rows);
            rows.add({"motion_validation"},
                     oneOf<MotionValidation>(
                         {{"discrete", MotionValidation::Discrete}, {"continuous", MotionValidation::Continuous}}),
                     &ProblemConfig::motionValidation, "discrete; on a map continuous",
                     "whether motions are checked at states, as OMPL does, or as a whole");
            rows.add("mesh_interior",
                     oneOf<MeshInterior>({{"free", MeshInterior::Free}, {"solid", MeshInterior::Solid}}),
                     &ProblemConfig::meshInterior,
                     "the inside of a mesh, free as in OMPL.app; solid meshes have to be closed");
            addDrive(rows);
            return rows.take();
        }();
        return ROWS;
    }

    const std::vector<ConfigRow<ContextConfig>> &contextRows()
    {
        static const auto ROWS = []
        {
            Rows<ContextConfig> rows;
            rows.add({"sampler"}, oneOf(SAMPLERS), &ContextConfig::sampler, "uniform", "how valid states are sampled");
            rows.add({"nr_attempts"}, whole(LARGEST_WHOLE), &ContextConfig::attempts, "the sampler's",
                     "how often the sampler tries to find a state");
            rows.add({"standard_deviation"}, positive(), &ContextConfig::standardDeviation, "the sampler's",
                     "of the distance between two states, for gaussian and bridge_test");
            rows.add({"nr_improve_attempts"}, whole(LARGEST_WHOLE), &ContextConfig::improveAttempts, "the sampler's",
                     "how often max_clearance tries to find more clearance");
            rows.add({"longest_valid_segment_fraction"},
                     number("a number above 0 and below 1",
                            [](double value)
                            {
                                constexpr double EPSILON = std::numeric_limits<double>::epsilon();
                                return value >= EPSILON && value <= 1.0 - EPSILON;
                            }),
                     &ContextConfig::longestValidSegmentFraction, "0.01",
                     "resolution of discrete validation, as a part of the space's extent");
            rows.add({"valid_segment_count_factor"}, whole(LARGEST_WHOLE), &ContextConfig::validSegmentCountFactor, "1",
                     "multiplies the number of states that are checked on a motion");
            rows.add(
                {"projection.cellsize.0", "projection.cellsize.1", "projection.cellsize.2"}, positive(),
                [](ContextConfig & context, std::size_t index) -> auto & { return context.cellSizes[index]; },
                "a twentieth of the bounds", "cells of the position, for planners with a grid");
            rows.add({"projection.cellsize_factor"}, positive(), &ContextConfig::cellSizeFactor, "1",
                     "multiplies these sizes");
            return rows.take();
        }();
        return ROWS;
    }

    const std::vector<ConfigRow<CampaignConfig>> &campaignRows()
    {
        static const auto ROWS = []
        {
            Rows<CampaignConfig> rows;
            rows.add("time_limit",
                     number("a number above 0, at most " + text::numberText(LONGEST_TIME_LIMIT),
                            [](double value) { return value > 0.0 && value <= LONGEST_TIME_LIMIT; }),
                     &CampaignConfig::timeLimit, "seconds per run");
            rows.add("mem_limit", positive(), &CampaignConfig::memoryLimit, "megabytes per run");
            rows.add("run_count", whole(1000000), &CampaignConfig::runCount, "runs of each planner");
            rows.add({{"output"},
                      "a folder; ~/ at its beginning is the home folder, and no folder may be called ~",
                      "beside the config",
                      "folder of the log",
                      [](CampaignConfig &campaign, std::size_t, const ConfigEntry &entry) {
                          campaign.output =
                              writtenPath(entry.value, entry.origin + ": " + entry.key + " = " + entry.value);
                      }});
            rows.add("save_paths",
                     oneOf<SavePaths>(
                         {{"none", SavePaths::None}, {"all", SavePaths::All}, {"shortest", SavePaths::Shortest}}),
                     &CampaignConfig::savePaths, "which paths are written beside the log, see below");
            rows.add("simplify", onOff(), &CampaignConfig::simplify, "whether paths are simplified after the run");
            rows.add("seed", whole<std::uint_fast32_t>(LARGEST_WHOLE), &CampaignConfig::seed, "seed of the campaign");
            rows.add({"progress_interval"},
                     number("a number of at least " + text::numberText(SHORTEST_PROGRESS_INTERVAL) +
                                ", and of a millionth of time_limit",
                            [](double value) { return value >= SHORTEST_PROGRESS_INTERVAL; }),
                     &CampaignConfig::progressInterval,
                     text::numberText(CampaignConfig().progressInterval) +
                         ", or a 100000th of time_limit where that is more",
                     "seconds between two samples of a planner's progress");
            rows.add({"iteration_limit"}, whole<std::uint64_t>(LARGEST_WHOLE), &CampaignConfig::iterationLimit, "none",
                     "number of evaluations of the termination condition after which a run is stopped");
            return rows.take();
        }();
        return ROWS;
    }

    std::string samplerName(SamplerKind sampler)
    {
        return wordOf(SAMPLERS, sampler);
    }
}  // namespace ompl_mfa::benchmark
