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
#include <map>
#include <set>
#include <utility>

#include <boost/algorithm/string.hpp>

#include "benchmark/ArmConfig.h"
#include "benchmark/ConfigKeys.h"
#include "benchmark/FileNames.h"
#include "benchmark/MapKeys.h"
#include "benchmark/ProblemSpace.h"
#include "collision/ResourceFolders.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "text/NearestName.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using Section = std::map<std::string, ConfigEntry>;

        const ConfigEntry *find(const Section &section, const std::string &key)
        {
            const auto found = section.find(key);
            return found == section.end() ? nullptr : &found->second;
        }

        void insertOnce(Section &section, const std::string &key, const ConfigEntry &entry)
        {
            const auto [place, inserted] = section.emplace(key, entry);
            if (!inserted)
            {
                failAt(entry, "the key is already set at " + place->second.origin);
            }
        }

        /* Reads one file; the members hold what has been read so far. */
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
                {
                    sort(entry);
                }
                if (!pendingSection_.empty())
                {
                    failAt(pendingSection_.begin()->second, "no planner follows that this setting could be for");
                }
                checkProblem();
                checkCampaign();
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
                {
                    sortProblem(key, entry);
                }
                else if (section == "benchmark" && !key.empty())
                {
                    set(campaignRows(), key, entry, benchmark_, config_.benchmark);
                }
                else if (section == "planner" && !key.empty())
                {
                    sortPlanner(key, entry);
                }
                else
                {
                    failAt(entry, "the key belongs to no section; sections are [problem], [benchmark] and [planner]");
                }
            }

            template <typename Config>
            static void set(const std::vector<ConfigRow<Config>> &rows, const std::string &key,
                            const ConfigEntry &entry, Section &section, Config &config)
            {
                insertOnce(section, key, entry);
                if (!setValue(rows, key, entry, config))
                {
                    failAt(entry, "unknown key" + text::suggestion(key, keysOf(rows)));
                }
            }

            void sortProblem(const std::string &key, const ConfigEntry &entry)
            {
                if (key == "control")
                {
                    failAt(entry, "control-based problems are not supported; remove the key to plan geometrically");
                }
                std::vector<std::string> keys = keysOf(problemRows());
                for (const auto &contextKey : keysOf(contextRows()))
                {
                    keys.push_back(contextKey);
                }
                if (std::find(keys.begin(), keys.end(), key) == keys.end())
                {
                    failAt(entry, "unknown key" + text::suggestion(key, keys));
                }
                if (entry.value.empty())
                {
                    failAt(entry, "the value is missing");
                }
                insertOnce(problem_, key, entry);
                if (!setValue(contextRows(), key, entry, config_.problem.context))
                {
                    setValue(problemRows(), key, entry, config_.problem);
                }
            }

            void sortPlanner(const std::string &key, const ConfigEntry &entry)
            {
                const auto dot = key.find('.');
                const std::string type = key.substr(0, dot);
                if (type == "problem" && dot != std::string::npos)
                {
                    const std::string setting = key.substr(dot + 1);
                    if (setting == "objective")
                    {
                        failAt(entry, "all planners share one objective; set problem.objective");
                    }
                    if (config_.planners.empty())
                    {
                        set(contextRows(), setting, entry, pendingSection_, pendingContext_);
                    }
                    else
                    {
                        set(contextRows(), setting, entry, contexts_[last_], config_.planners[last_].context);
                    }
                    return;
                }
                requireKnownPlanner(type, entry.origin);
                if (dot == std::string::npos)
                {
                    if (!entry.value.empty())
                    {
                        failAt(entry, "a planner instance takes no value; write '" + type + "='");
                    }
                    addPlanner(type, entry.origin);
                }
                else
                {
                    addParameter(type, {key.substr(dot + 1), entry.value, entry.origin});
                }
            }

            void addPlanner(const std::string &type, const std::string &origin)
            {
                PlannerSpec spec;
                spec.type = type;
                spec.origin = origin;
                spec.context = std::exchange(pendingContext_, {});
                contexts_.push_back(std::exchange(pendingSection_, {}));
                last_ = config_.planners.size();
                config_.planners.push_back(spec);
            }

            /* A parameter belongs to the last instance of its type, as in OMPL.app; if there is none, one is made. */
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
                {
                    namePlanner(*spec, parameter);
                }
                else
                {
                    addOnce(spec->parameters, parameter);
                }
            }

            static void namePlanner(PlannerSpec &spec, const ConfigEntry &parameter)
            {
                const std::string &name = parameter.value;
                if (name.empty())
                {
                    failAt(parameter, "a planner's name cannot be empty");
                }
                if (hasControlCharacter(name) || fileNamePart(name).size() > LONGEST_NAME)
                {
                    failAt(parameter,
                           "accepted is a name without control characters, of at most 100 bytes, of which "
                           "'/' and '%' take three");
                }
                if (!spec.name.empty())
                {
                    failAt(parameter, "this planner is already named '" + spec.name + "'");
                }
                spec.name = name;
            }

            static void addOnce(std::vector<ConfigEntry> &entries, const ConfigEntry &entry)
            {
                for (const auto &other : entries)
                {
                    if (other.key == entry.key)
                    {
                        failAt(entry, "the key is already set at " + other.origin);
                    }
                }
                entries.push_back(entry);
            }

            /* Planner Arena groups runs by the planner's name, so names have to be unique. */
            void namePlanners()
            {
                std::map<std::string, std::string> origins;
                for (const auto &spec : config_.planners)
                {
                    if (!spec.name.empty() && !origins.emplace(spec.name, spec.origin).second)
                    {
                        throw InputError(spec.origin + ": two planners are named '" + spec.name + "', here and at " +
                                         origins[spec.name] + "; every planner needs its own name");
                    }
                }
                for (auto &spec : config_.planners)
                {
                    const std::string title = plannerTitle(spec.type);
                    for (unsigned int number = 1; spec.name.empty(); ++number)
                    {
                        const std::string name = number == 1 ? title : title + "-" + std::to_string(number);
                        if (origins.emplace(name, spec.origin).second)
                        {
                            spec.name = name;
                        }
                    }
                }
            }

            void checkProblem()
            {
                if (!find(problem_, "name"))
                {
                    const ConfigEntry name{"problem.name", config_.file.stem().string(), config_.file.string()};
                    setValue(problemRows(), "name", name, config_.problem);
                }
                checkScenarioKeys(problem_);
                checkArmKeys(problem_, config_.problem);
                if (config_.problem.robotKind == RobotKind::Arm)
                {
                    checkRobotKeys(problem_, config_.problem, config_.file.string());
                    config_.problem.space = StateSpaceKind::Joints;
                    checkObjective();
                    return;
                }
                checkPose("start", config_.problem.start);
                checkPose("goal", config_.problem.goal);
                checkSpace();
                checkRobotKeys(problem_, config_.problem, config_.file.string());
                checkVolume();
                checkObjective();
            }

            void checkPose(const std::string &which, ConfigPose &pose) const
            {
                if (config_.problem.scenario)
                {
                    pose.origin = config_.problem.scenario->origin;
                    return;
                }
                for (const char *key : {".x", ".y"})
                {
                    if (!find(problem_, which + key))
                    {
                        throw InputError(config_.file.string() + ": problem." + which + key + " is missing");
                    }
                }
                pose.origin = problem_.at(which + ".x").origin;
            }

            std::set<std::string> poseKeys(const std::string &which) const
            {
                std::set<std::string> keys;
                if (config_.problem.scenario)
                {
                    keys = {"x", "y"};
                }
                for (const auto &[key, entry] : problem_)
                {
                    if (boost::starts_with(key, which + "."))
                    {
                        keys.insert(key.substr(which.size() + 1));
                    }
                }
                return keys;
            }

            void checkSpace()
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
                const ConfigEntry *car = find(problem_, "statespace");
                if (car && kind->second != StateSpaceKind::SE2)
                {
                    failAt(*car, "a car's state is x, y, theta");
                }
                if (!car)
                {
                    problem.space = kind->second;
                }
                if (problem.space == StateSpaceKind::SE3)
                {
                    for (const ConfigPose *pose : {&problem.start, &problem.goal})
                    {
                        if (pose->theta != 0.0 && pose->axis[0] == 0.0 && pose->axis[1] == 0.0 && pose->axis[2] == 0.0)
                        {
                            throw InputError(pose->origin + ": the rotation axis is (0, 0, 0); give a direction");
                        }
                    }
                }
                const ConfigEntry *radius = find(problem_, "turningradius");
                if (radius && !car)
                {
                    failAt(*radius, "only 'statespace = dubins', 'dubinssymmetric' or 'reedsshepp' turns on a radius");
                }
                const ConfigEntry *weight = find(problem_, "rotation_weight");
                if (weight && problem.space != StateSpaceKind::SE2 && problem.space != StateSpaceKind::SE3)
                {
                    failAt(*weight, "only SE2 and SE3 weight their rotation");
                }
            }

            void checkVolume()
            {
                std::optional<ConfigVolume> &volume = config_.problem.volume;
                std::string missing;
                unsigned int given = 0;
                const std::string axes = std::string("xyz").substr(0, positionDimension(config_.problem.space));
                for (const char axis : axes)
                {
                    for (const std::string end : {"volume.min.", "volume.max."})
                    {
                        const ConfigEntry *entry = find(problem_, end + axis);
                        if (!entry)
                        {
                            missing += " problem." + end + axis;
                            continue;
                        }
                        volume->origin = entry->origin;
                        ++given;
                    }
                }
                if (given == 0)
                {
                    // the height of a planar problem bounds nothing
                    volume.reset();
                    return;
                }
                if (!missing.empty())
                {
                    throw InputError(volume->origin + ": the volume is incomplete:" + missing +
                                     " missing; give all of it, or nothing to plan in the world's box");
                }
                for (std::size_t i = 0; i < axes.size(); ++i)
                {
                    if (volume->min[i] >= volume->max[i])
                    {
                        failAt(problem_.at(std::string("volume.max.") + axes[i]),
                               "expected more than problem.volume.min." + std::string(1, axes[i]));
                    }
                }
            }

            void checkObjective()
            {
                ProblemConfig &problem = config_.problem;
                if (const ConfigEntry *objective = find(problem_, "objective"))
                {
                    problem.objectiveOrigin = objective->origin;
                }
                checkClearanceCostKeys(problem_, problem);
                const ConfigEntry *threshold = find(problem_, "objective.threshold");
                const bool isWeighted = problem.objective == ObjectiveKind::Weighted;
                if (threshold && !problem.objective)
                {
                    failAt(*threshold, "a threshold needs problem.objective");
                }
                if (isWeighted == !problem.objectiveWeights.empty())
                {
                    return;
                }
                const std::string prefix = "objective.weight.";
                std::string keys;
                for (const auto &key : keysOf(problemRows()))
                {
                    if (!boost::starts_with(key, prefix))
                    {
                        continue;
                    }
                    keys += (keys.empty() ? "problem." : ", problem.") + key;
                    if (const ConfigEntry *weight = find(problem_, key))
                    {
                        failAt(*weight, "weights need 'objective = weighted'");
                    }
                }
                failAt(problem_.at("objective"), "a weighted objective needs one of " + keys);
            }

            /* Bounds the memory of a run's samples, which are continued to the time limit if the planner returns
               early. */
            void checkCampaign()
            {
                constexpr double USUAL_SAMPLES = 1e5;
                constexpr double MOST_SAMPLES = 1e6;
                CampaignConfig &benchmark = config_.benchmark;
                const ConfigEntry *interval = find(benchmark_, "progress_interval");
                if (!interval)
                {
                    benchmark.progressInterval =
                        std::max(benchmark.progressInterval, benchmark.timeLimit / USUAL_SAMPLES);
                }
                else if (benchmark.progressInterval < benchmark.timeLimit / MOST_SAMPLES)
                {
                    failAt(*interval, "expected at least a millionth of the time_limit");
                }
            }

            BenchmarkConfig config_;
            Section problem_;
            Section benchmark_;
            /* Context given before the first planner, to which it belongs. */
            ContextConfig pendingContext_;
            Section pendingSection_;
            /* The entries of the context of each planner. */
            std::vector<Section> contexts_;
            /* Index of the planner of the latest line, to which context belongs. */
            std::size_t last_{0};
        };
    }  // namespace

    BenchmarkConfig readBenchmarkConfig(const std::filesystem::path &file)
    {
        std::ifstream in(file);
        if (!in || std::filesystem::is_directory(file))
        {
            throw InputError(file.string() + ": cannot be read; expected a benchmark config");
        }
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
        {
            places.push_back(folder / entry.value);
        }
        std::string sought;
        for (const auto &place : places)
        {
            if (std::filesystem::is_regular_file(place))
            {
                return place;
            }
            sought += (sought.empty() ? "" : ", ") + place.string();
        }
        failAt(entry, "no such file; sought " + sought +
                          " (OMPL_MFA_RESOURCE_DIR may name further folders, separated by colons)");
    }
}  // namespace ompl_mfa::benchmark
