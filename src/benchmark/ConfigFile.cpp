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

#include "ompl_mfa/benchmark/ConfigFile.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <set>

#include <boost/algorithm/string.hpp>

#include "benchmark/FileNames.h"
#include "collision/ResourceFolders.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

namespace ompl_mfa
{
    namespace
    {
        using Section = std::map<std::string, ConfigEntry>;

        const std::vector<std::string> PROBLEM_KEYS = {"name",
                                                       "world",
                                                       "robot",
                                                       "robot.radius",
                                                       "statespace",
                                                       "turningradius",
                                                       "rotation_weight",
                                                       "start.x",
                                                       "start.y",
                                                       "start.z",
                                                       "start.axis.x",
                                                       "start.axis.y",
                                                       "start.axis.z",
                                                       "start.theta",
                                                       "goal.x",
                                                       "goal.y",
                                                       "goal.z",
                                                       "goal.axis.x",
                                                       "goal.axis.y",
                                                       "goal.axis.z",
                                                       "goal.theta",
                                                       "threshold",
                                                       "volume.min.x",
                                                       "volume.min.y",
                                                       "volume.min.z",
                                                       "volume.max.x",
                                                       "volume.max.y",
                                                       "volume.max.z",
                                                       "objective",
                                                       "objective.threshold",
                                                       "motion_validation",
                                                       "mesh_interior"};

        const std::vector<std::string> OBJECTIVES = {"length", "max_min_clearance", "mechanical_work", "weighted"};

        const std::vector<std::string> WEIGHTED_OBJECTIVES = {"length", "mechanical_work", "proximity"};

        const std::vector<std::string> CONTEXT_KEYS = {"sampler",
                                                       "longest_valid_segment_fraction",
                                                       "valid_segment_count_factor",
                                                       "projection.cellsize_factor",
                                                       "projection.cellsize.0",
                                                       "projection.cellsize.1",
                                                       "projection.cellsize.2",
                                                       "nr_attempts",
                                                       "standard_deviation",
                                                       "nr_improve_attempts"};

        const std::vector<std::string> BENCHMARK_KEYS = {"time_limit", "mem_limit",         "run_count",
                                                         "output",     "save_paths",        "simplify",
                                                         "seed",       "progress_interval", "iteration_limit"};

        const std::string WEIGHT_PREFIX = "objective.weight.";

        bool contains(const std::vector<std::string> &names, const std::string &name)
        {
            return std::find(names.begin(), names.end(), name) != names.end();
        }

        std::vector<std::string> problemKeys()
        {
            std::vector<std::string> keys = PROBLEM_KEYS;
            for (const auto &name : WEIGHTED_OBJECTIVES)
                keys.push_back(WEIGHT_PREFIX + name);
            keys.insert(keys.end(), CONTEXT_KEYS.begin(), CONTEXT_KEYS.end());
            return keys;
        }

        const ConfigEntry *find(const Section &section, const std::string &key)
        {
            const auto found = section.find(key);
            return found == section.end() ? nullptr : &found->second;
        }

        void insertOnce(Section &section, const std::string &key, const ConfigEntry &entry)
        {
            const auto [place, inserted] = section.emplace(key, entry);
            if (!inserted)
                failAt(entry, "the key is already set at " + place->second.origin);
        }

        double realOr(const Section &section, const std::string &key, double fallback)
        {
            const ConfigEntry *entry = find(section, key);
            return entry ? realValue(*entry) : fallback;
        }

        /* Reads one file; the members are what its lines said so far. */
        class ConfigParser
        {
        public:
            explicit ConfigParser(const std::filesystem::path &file)
            {
                config_.file = file;
            }

            BenchmarkConfig parse(std::istream &in)
            {
                for (const auto &entry : readConfigLines(in, config_.file.string()))
                    sort(entry);
                if (!pendingContext_.empty())
                    failAt(pendingContext_.front(), "no planner follows that this setting could be for");
                readProblem();
                readCampaign();
                namePlanners();
                return std::move(config_);
            }

        private:
            void sort(const ConfigEntry &entry)
            {
                const auto dot = entry.key.find('.');
                const std::string section = entry.key.substr(0, dot);
                const std::string key = dot == std::string::npos ? "" : entry.key.substr(dot + 1);
                if (section == "problem" && !key.empty())
                    sortProblem(key, entry);
                else if (section == "benchmark" && !key.empty())
                {
                    if (!contains(BENCHMARK_KEYS, key))
                        failAt(entry, "unknown key" + suggestion(key, BENCHMARK_KEYS));
                    insertOnce(benchmark_, key, entry);
                }
                else if (section == "planner" && !key.empty())
                    sortPlanner(key, entry);
                else
                    failAt(entry, "the key belongs to no section; sections are [problem], [benchmark] and [planner]");
            }

            void sortProblem(const std::string &key, const ConfigEntry &entry)
            {
                if (key == "control")
                    failAt(entry, "control-based problems are not supported; remove the key to plan geometrically");
                const bool isWeight = boost::starts_with(key, WEIGHT_PREFIX) &&
                                      contains(WEIGHTED_OBJECTIVES, key.substr(WEIGHT_PREFIX.size()));
                if (contains(CONTEXT_KEYS, key))
                {
                    insertOnce(problem_, key, entry);
                    config_.problem.context.push_back({key, entry.value, entry.origin});
                }
                else if (isWeight || contains(PROBLEM_KEYS, key))
                {
                    if (entry.value.empty())
                        failAt(entry, "the value is missing");
                    insertOnce(problem_, key, entry);
                }
                else
                    failAt(entry, "unknown key" + suggestion(key, problemKeys()));
                if (isWeight)
                    config_.problem.objectiveWeights.emplace_back(key.substr(WEIGHT_PREFIX.size()),
                                                                  positiveValue(entry));
            }

            void sortPlanner(const std::string &key, const ConfigEntry &entry)
            {
                const auto dot = key.find('.');
                const std::string type = key.substr(0, dot);
                if (type == "problem" && dot != std::string::npos)
                {
                    const ConfigEntry setting{key.substr(dot + 1), entry.value, entry.origin};
                    if (setting.key == "objective")
                        failAt(entry, "all planners share one objective; set problem.objective");
                    if (!contains(CONTEXT_KEYS, setting.key))
                        failAt(entry, "unknown key" + suggestion(setting.key, CONTEXT_KEYS));
                    addOnce(config_.planners.empty() ? pendingContext_ : config_.planners[last_].context, setting);
                    return;
                }
                requireKnownPlanner(type, entry.origin);
                if (dot == std::string::npos)
                {
                    if (!entry.value.empty())
                        failAt(entry, "a planner instance takes no value; write '" + type + "='");
                    addPlanner(type, entry.origin);
                }
                else
                    addParameter(type, {key.substr(dot + 1), entry.value, entry.origin});
            }

            void addPlanner(const std::string &type, const std::string &origin)
            {
                PlannerSpec spec;
                spec.type = type;
                spec.origin = origin;
                spec.context.swap(pendingContext_);
                last_ = config_.planners.size();
                config_.planners.push_back(spec);
            }

            /* A parameter goes to the last instance of its type, as in OMPL.app, or makes one. */
            void addParameter(const std::string &type, const ConfigEntry &parameter)
            {
                auto spec = std::find_if(config_.planners.rbegin(), config_.planners.rend(),
                                         [&type](const PlannerSpec &planner) { return planner.type == type; });
                if (spec == config_.planners.rend())
                {
                    addPlanner(type, parameter.origin);
                    spec = config_.planners.rbegin();
                }
                last_ = static_cast<std::size_t>(config_.planners.rend() - spec) - 1;
                if (parameter.key == "name")
                    namePlanner(*spec, parameter);
                else
                    addOnce(spec->parameters, parameter);
            }

            static void namePlanner(PlannerSpec &spec, const ConfigEntry &parameter)
            {
                const std::string &name = parameter.value;
                if (name.empty())
                    failAt(parameter, "a planner's name cannot be empty");
                if (hasControlCharacter(name) || fileNamePart(name).size() > LONGEST_NAME)
                {
                    failAt(parameter,
                           "accepted is a name without control characters, of at most 100 bytes, of which "
                           "'/' and '%' take three");
                }
                if (!spec.name.empty())
                    failAt(parameter, "this planner is already named '" + spec.name + "'");
                spec.name = name;
            }

            static void addOnce(std::vector<ConfigEntry> &entries, const ConfigEntry &entry)
            {
                for (const auto &other : entries)
                    if (other.key == entry.key)
                        failAt(entry, "the key is already set at " + other.origin);
                entries.push_back(entry);
            }

            /* Planner Arena groups runs by the planner's name: two planners with one name would become one. */
            void namePlanners()
            {
                std::map<std::string, std::string> origins;
                for (const auto &spec : config_.planners)
                {
                    if (!spec.name.empty() && !origins.emplace(spec.name, spec.origin).second)
                        throw InputError(spec.origin + ": two planners are named '" + spec.name + "', here and at " +
                                         origins[spec.name] + "; every planner needs its own name");
                }
                for (auto &spec : config_.planners)
                {
                    const std::string title = plannerTitle(spec.type);
                    for (unsigned int number = 1; spec.name.empty(); ++number)
                    {
                        const std::string name = number == 1 ? title : title + "-" + std::to_string(number);
                        if (origins.emplace(name, spec.origin).second)
                            spec.name = name;
                    }
                }
            }

            void readProblem()
            {
                ProblemConfig &problem = config_.problem;
                const ConfigEntry *name = find(problem_, "name");
                problem.name = name ? name->value : config_.file.stem().string();
                if (!isFileName(problem.name))
                {
                    failAt(name ? *name : ConfigEntry{"problem.name", problem.name, config_.file.string()},
                           "the log has this name; accepted is a file's name of at most 100 bytes, without '/' and "
                           "control characters, not '.' or '..'");
                }
                if (const ConfigEntry *world = find(problem_, "world"))
                    problem.world = *world;
                problem.start = readPose("start");
                problem.goal = readPose("goal");
                readSpace();
                readRobot();
                readVolume();
                readObjective();
                problem.threshold = realOr(problem_, "threshold", problem.threshold);
                if (problem.threshold < 0.0)
                    failAt(problem_.at("threshold"), "expected a number of at least 0");
                readMotionValidation();
                if (const ConfigEntry *interior = find(problem_, "mesh_interior"))
                    problem.meshInterior =
                        static_cast<collision::MeshInterior>(choiceValue(*interior, {"free", "solid"}));
            }

            void readMotionValidation()
            {
                const ConfigEntry *validation = find(problem_, "motion_validation");
                if (!validation)
                    return;
                if (choiceValue(*validation, {"discrete", "continuous"}) == 0)
                    return;
                const StateSpaceKind space = config_.problem.space;
                if (space == StateSpaceKind::DUBINS || space == StateSpaceKind::DUBINS_SYMMETRIC ||
                    space == StateSpaceKind::REEDS_SHEPP)
                    failAt(*validation, "the motions of Dubins and Reeds-Shepp cars are curved; expected discrete");
                config_.problem.motionValidation = collision::MotionValidation::Continuous;
            }

            ConfigPose readPose(const std::string &which) const
            {
                ConfigPose pose;
                for (const char *key : {".x", ".y"})
                    if (!find(problem_, which + key))
                        throw InputError(config_.file.string() + ": problem." + which + key + " is missing");
                pose.origin = problem_.at(which + ".x").origin;
                pose.x = realOr(problem_, which + ".x", 0.0);
                pose.y = realOr(problem_, which + ".y", 0.0);
                pose.z = realOr(problem_, which + ".z", 0.0);
                pose.theta = realOr(problem_, which + ".theta", 0.0);
                pose.axis[0] = realOr(problem_, which + ".axis.x", 0.0);
                pose.axis[1] = realOr(problem_, which + ".axis.y", 0.0);
                pose.axis[2] = realOr(problem_, which + ".axis.z", find(problem_, which + ".axis.x") ? 0.0 : 1.0);
                return pose;
            }

            std::set<std::string> poseKeys(const std::string &which) const
            {
                std::set<std::string> keys;
                for (const auto &[key, entry] : problem_)
                    if (boost::starts_with(key, which + "."))
                        keys.insert(key.substr(which.size() + 1));
                return keys;
            }

            void readSpace()
            {
                static const std::map<std::set<std::string>, StateSpaceKind> KINDS = {
                    {{"x", "y"}, StateSpaceKind::R2},
                    {{"x", "y", "z"}, StateSpaceKind::R3},
                    {{"x", "y", "theta"}, StateSpaceKind::SE2},
                    {{"x", "y", "z", "axis.x", "axis.y", "axis.z", "theta"}, StateSpaceKind::SE3}};
                ProblemConfig &problem = config_.problem;
                const std::set<std::string> startKeys = poseKeys("start");
                const std::set<std::string> goalKeys = poseKeys("goal");
                const auto kind = KINDS.find(startKeys);
                if (kind == KINDS.end() || startKeys != goalKeys)
                {
                    throw InputError(problem.start.origin + ": start has (" + boost::algorithm::join(startKeys, ", ") +
                                     ") and goal has (" + boost::algorithm::join(goalKeys, ", ") +
                                     "); both are to have x, y (a planar point or disc), x, y, theta (SE2), x, y, z "
                                     "(a point or ball in space) or x, y, z, axis.x, axis.y, axis.z, theta (SE3)");
                }
                problem.space = kind->second;
                if (problem.space == StateSpaceKind::SE3)
                {
                    for (const ConfigPose *pose : {&problem.start, &problem.goal})
                        if (pose->theta != 0.0 && pose->axis[0] == 0.0 && pose->axis[1] == 0.0 && pose->axis[2] == 0.0)
                            throw InputError(pose->origin + ": the rotation axis is (0, 0, 0); give a direction");
                }
                readCurvedSpace();
                if (const ConfigEntry *weight = find(problem_, "rotation_weight"))
                {
                    if (problem.space != StateSpaceKind::SE2 && problem.space != StateSpaceKind::SE3)
                        failAt(*weight, "only SE2 and SE3 weight their rotation");
                    problem.rotationWeight = positiveValue(*weight);
                }
            }

            void readCurvedSpace()
            {
                ProblemConfig &problem = config_.problem;
                const ConfigEntry *radius = find(problem_, "turningradius");
                const ConfigEntry *space = find(problem_, "statespace");
                if (space)
                {
                    const StateSpaceKind kinds[] = {StateSpaceKind::DUBINS, StateSpaceKind::DUBINS_SYMMETRIC,
                                                    StateSpaceKind::REEDS_SHEPP};
                    const auto kind = kinds[choiceValue(*space, {"dubins", "dubinssymmetric", "reedsshepp"})];
                    if (problem.space != StateSpaceKind::SE2)
                        failAt(*space, "a car's state is x, y, theta");
                    problem.space = kind;
                }
                if (radius && !space)
                    failAt(*radius, "only 'statespace = dubins', 'dubinssymmetric' or 'reedsshepp' turns on a radius");
                if (radius)
                    problem.turningRadius = positiveValue(*radius);
            }

            void readRobot()
            {
                ProblemConfig &problem = config_.problem;
                const ConfigEntry *robot = find(problem_, "robot");
                if (!robot)
                    throw InputError(config_.file.string() +
                                     ": problem.robot is missing; give a mesh or scene file, point, disc or sphere");
                problem.robot = *robot;
                const bool isRound = robot->value == "disc" || robot->value == "sphere";
                const ConfigEntry *radius = find(problem_, "robot.radius");
                if (isRound && !radius)
                    failAt(*robot, "a " + robot->value + " needs problem.robot.radius");
                if (radius && !isRound)
                    failAt(*radius, "only 'robot = disc' and 'robot = sphere' have a radius");
                if (radius)
                    problem.robotRadius = positiveValue(*radius);
            }

            void readVolume()
            {
                const bool isSpatial =
                    config_.problem.space == StateSpaceKind::R3 || config_.problem.space == StateSpaceKind::SE3;
                const std::string axes = isSpatial ? "xyz" : "xy";
                ConfigVolume volume;
                std::string missing;
                unsigned int given = 0;
                for (std::size_t i = 0; i < axes.size(); ++i)
                {
                    for (const char *end : {"min", "max"})
                    {
                        const std::string key = std::string("volume.") + end + "." + axes[i];
                        const ConfigEntry *entry = find(problem_, key);
                        if (!entry)
                        {
                            missing += " problem." + key;
                            continue;
                        }
                        (*end == 'm' && end[1] == 'i' ? volume.min : volume.max)[i] = realValue(*entry);
                        volume.origin = entry->origin;
                        ++given;
                    }
                }
                if (given == 0)
                    return;
                if (!missing.empty())
                    throw InputError(volume.origin + ": the volume is incomplete:" + missing +
                                     " missing; give all of it, or nothing to plan in the world's box");
                for (std::size_t i = 0; i < axes.size(); ++i)
                {
                    if (volume.min[i] >= volume.max[i])
                        failAt(problem_.at(std::string("volume.max.") + axes[i]),
                               "expected more than problem.volume.min." + std::string(1, axes[i]));
                }
                config_.problem.volume = volume;
            }

            void readObjective()
            {
                ProblemConfig &problem = config_.problem;
                const ConfigEntry *objective = find(problem_, "objective");
                const ConfigEntry *threshold = find(problem_, "objective.threshold");
                const bool isWeighted = objective && lowerCase(objective->value) == "weighted";
                if (objective)
                    problem.objective = {"objective", OBJECTIVES[choiceValue(*objective, OBJECTIVES)],
                                         objective->origin};
                if (threshold && !objective)
                    failAt(*threshold, "a threshold needs problem.objective");
                if (threshold)
                    problem.objectiveThreshold = realValue(*threshold);
                if (isWeighted && problem.objectiveWeights.empty())
                    failAt(*objective, "a weighted objective needs one of problem.objective.weight." +
                                           boost::algorithm::join(WEIGHTED_OBJECTIVES, ", problem.objective.weight."));
                if (!isWeighted && !problem.objectiveWeights.empty())
                    failAt(problem_.at(WEIGHT_PREFIX + problem.objectiveWeights.front().first),
                           "weights need 'objective = weighted'");
            }

            void readCampaign()
            {
                CampaignConfig &benchmark = config_.benchmark;
                const auto given = [this](const std::string &key) { return find(benchmark_, key); };
                if (const ConfigEntry *entry = given("time_limit"))
                    benchmark.timeLimit = positiveValue(*entry);
                if (benchmark.timeLimit > LONGEST_TIME_LIMIT)
                    failAt(benchmark_.at("time_limit"), "expected at most 1e9 (seconds)");
                if (const ConfigEntry *entry = given("mem_limit"))
                    benchmark.memoryLimit = positiveValue(*entry);
                if (const ConfigEntry *entry = given("run_count"))
                    benchmark.runCount = static_cast<unsigned int>(wholeValue(*entry, 1, 1000000));
                if (const ConfigEntry *entry = given("output"))
                {
                    benchmark.output =
                        writtenPath(entry->value, entry->origin + ": " + entry->key + " = " + entry->value);
                }
                if (const ConfigEntry *entry = given("save_paths"))
                    benchmark.savePaths = static_cast<SavePaths>(choiceValue(*entry, {"none", "all", "shortest"}));
                if (const ConfigEntry *entry = given("simplify"))
                    benchmark.simplify = switchValue(*entry);
                if (const ConfigEntry *entry = given("seed"))
                    benchmark.seed = wholeValue(*entry, 1, std::numeric_limits<std::uint32_t>::max());
                readProgressInterval();
                if (const ConfigEntry *entry = given("iteration_limit"))
                    benchmark.iterationLimit = wholeValue(*entry, 1, std::numeric_limits<std::uint32_t>::max());
            }

            /* A run keeps its samples, and those of a planner that returns early go on to the time limit. */
            void readProgressInterval()
            {
                constexpr double SHORTEST = 0.001;
                constexpr double USUAL_SAMPLES = 1e5;
                constexpr double MOST_SAMPLES = 1e6;
                CampaignConfig &benchmark = config_.benchmark;
                const ConfigEntry *entry = find(benchmark_, "progress_interval");
                if (!entry)
                {
                    benchmark.progressInterval =
                        std::max(benchmark.progressInterval, benchmark.timeLimit / USUAL_SAMPLES);
                    return;
                }
                benchmark.progressInterval = positiveValue(*entry);
                if (benchmark.progressInterval < std::max(SHORTEST, benchmark.timeLimit / MOST_SAMPLES))
                    failAt(*entry, "expected at least 0.001 (seconds), and a millionth of the time_limit");
            }

            BenchmarkConfig config_;
            Section problem_;
            Section benchmark_;
            /* Context written before the first planner; it is that planner's. */
            std::vector<ConfigEntry> pendingContext_;
            /* Index of the planner that the latest line was about; context goes to it. */
            std::size_t last_{0};
        };
    }  // namespace

    BenchmarkConfig readBenchmarkConfig(const std::filesystem::path &file)
    {
        std::ifstream in(file);
        if (!in || std::filesystem::is_directory(file))
            throw InputError(file.string() + ": cannot be read; expected a benchmark config");
        return parseBenchmarkConfig(in, file);
    }

    BenchmarkConfig parseBenchmarkConfig(std::istream &in, const std::filesystem::path &file)
    {
        return ConfigParser(file).parse(in);
    }

    std::filesystem::path findResource(const BenchmarkConfig &config, const ConfigEntry &entry)
    {
        std::vector<std::filesystem::path> places = {entry.value, config.file.parent_path() / entry.value};
        for (const auto &folder : collision::resourceFolders())
            places.push_back(folder / entry.value);
        std::string sought;
        for (const auto &place : places)
        {
            if (std::filesystem::is_regular_file(place))
                return place;
            sought += (sought.empty() ? "" : ", ") + place.string();
        }
        failAt(entry, "no such file; sought " + sought +
                          " (OMPL_MFA_RESOURCE_DIR may name further folders, separated by colons)");
    }
}  // namespace ompl_mfa
