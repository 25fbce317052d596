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

#include "benchmark/MapKeys.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using Entries = std::map<std::string, ConfigEntry>;

        const ConfigEntry *find(const Entries &entries, const std::string &key)
        {
            const auto found = entries.find(key);
            return found == entries.end() ? nullptr : &found->second;
        }

        /* The parts of a list in brackets, "[a, [b, c]]", without its brackets; false if it is not one. */
        bool splitList(const std::string &text, std::vector<std::string> &parts)
        {
            const std::string list = trimmed(text);
            if (list.size() < 2 || list.front() != '[' || list.back() != ']')
            {
                return false;
            }
            int depth = 0;
            std::size_t begin = 1;
            for (std::size_t i = 1; i < list.size(); ++i)
            {
                const bool isEnd = i + 1 == list.size();
                if (depth == 0 && (list[i] == ',' || isEnd))
                {
                    parts.push_back(trimmed(list.substr(begin, i - begin)));
                    begin = i + 1;
                }
                depth += list[i] == '[' ? 1 : list[i] == ']' ? -1 : 0;
            }
            return depth == -1;
        }

        bool readCorners(const std::string &text, FootprintCorners &corners)
        {
            std::vector<std::string> points;
            if (!splitList(text, points))
            {
                return false;
            }
            for (const std::string &point : points)
            {
                std::vector<std::string> numbers;
                std::array<double, 2> corner{};
                if (!splitList(point, numbers) || numbers.size() != corner.size() ||
                    !text::readNumber(numbers[0], corner[0]) || !text::readNumber(numbers[1], corner[1]) ||
                    !std::isfinite(corner[0]) || !std::isfinite(corner[1]))
                {
                    return false;
                }
                corners.push_back(corner);
            }
            return true;
        }

        bool readIndices(const std::string &text, ScenarioIndices &indices)
        {
            if (text == "all")
            {
                indices = {};
                return true;
            }
            const std::size_t dash = text.find('-');
            const std::string last = dash == std::string::npos ? text : trimmed(text.substr(dash + 1));
            return text::readNumber(trimmed(text.substr(0, dash)), indices.first) &&
                   text::readNumber(last, indices.last) && indices.first <= indices.last;
        }
    }  // namespace

    ConfigRow<ProblemConfig> unknownCellsRow()
    {
        return {{"map.unknown"},
                "one of occupied, free",
                "occupied",
                "whether the robot may enter the unknown cells of a map",
                [](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                {
                    const bool isFree = choiceValue(entry, {"occupied", "free"}) == 1;
                    problem.unknownCells = {{isFree ? maps::UnknownCells::Free : maps::UnknownCells::Occupied, entry}};
                }};
    }

    std::vector<ConfigRow<ProblemConfig>> footprintRows()
    {
        const std::string corners = "[[x, y], [x, y], [x, y], ...], the corners of a simple polygon";
        const std::string padding = "a number of at least 0";
        return {{{"robot.footprint"},
                 corners,
                 "required for a footprint",
                 "the robot's outline about its reference point; it looks along x",
                 [corners](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                 {
                     problem.footprint.emplace();
                     problem.footprint->entry = entry;
                     if (!readCorners(entry.value, problem.footprint->value))
                     {
                         failAt(entry, "expected " + corners);
                     }
                 }},
                {{"robot.padding"},
                 padding,
                 text::numberText(ProblemConfig().padding),
                 "distance by which a footprint is enlarged",
                 [padding](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                 {
                     if (!text::readNumber(entry.value, problem.padding) || !std::isfinite(problem.padding) ||
                         problem.padding < 0.0)
                     {
                         failAt(entry, "expected " + padding);
                     }
                 }}};
    }

    std::vector<ConfigRow<ProblemConfig>> scenarioRows()
    {
        const std::string indices = "a whole number from 0, a range such as 10-19, or all";
        return {{{"scenario"},
                 "a MovingAI scenario (.scen) for the map",
                 "none",
                 "gives starts and goals: the config stands for a set of problems",
                 [](ProblemConfig &problem, std::size_t, const ConfigEntry &entry) { problem.scenario = entry; }},
                {{"scenario.index"},
                 indices,
                 "all",
                 "which problems of the scenario, counted from 0",
                 [indices](ProblemConfig &problem, std::size_t, const ConfigEntry &entry)
                 {
                     problem.scenarioIndices.entry = entry;
                     if (!readIndices(entry.value, problem.scenarioIndices.value))
                     {
                         failAt(entry, "expected " + indices);
                     }
                 }}};
    }

    void checkRobotKeys(const Entries &entries, const ProblemConfig &problem, const std::string &file)
    {
        const RobotKind kind = problem.robotKind;
        const ConfigEntry *robot = find(entries, "robot");
        if (robot == nullptr)
        {
            throw InputError(file +
                             ": problem.robot is missing; give a mesh, scene or .urdf file, point, disc, sphere "
                             "or footprint");
        }
        const bool isRound = kind == RobotKind::Disc || kind == RobotKind::Sphere;
        const ConfigEntry *radius = find(entries, "robot.radius");
        if (isRound && radius == nullptr)
        {
            failAt(*robot, "a " + robot->value + " needs problem.robot.radius");
        }
        if (radius != nullptr && !isRound)
        {
            failAt(*radius, "only 'robot = disc' and 'robot = sphere' have a radius");
        }
        if (kind == RobotKind::Footprint && !problem.footprint)
        {
            failAt(*robot, "a footprint needs problem.robot.footprint");
        }
        for (const char *key : {"robot.footprint", "robot.padding"})
        {
            const ConfigEntry *entry = find(entries, key);
            if (entry != nullptr && kind != RobotKind::Footprint)
            {
                failAt(*entry, "only 'robot = footprint' has it");
            }
        }
    }

    void checkScenarioKeys(const Entries &entries)
    {
        const bool hasScenario = find(entries, "scenario") != nullptr;
        const ConfigEntry *index = find(entries, "scenario.index");
        if (index != nullptr && !hasScenario)
        {
            failAt(*index, "an index needs problem.scenario");
        }
        for (const char *key : {"start.x", "start.y", "start.z", "goal.x", "goal.y", "goal.z"})
        {
            const ConfigEntry *entry = find(entries, key);
            if (entry != nullptr && hasScenario)
            {
                failAt(*entry, "the scenario gives the positions of start and goal; remove one of them");
            }
        }
    }

    void checkClearanceCostKeys(const Entries &entries, const ProblemConfig &problem)
    {
        const bool isTerm = std::any_of(problem.objectiveWeights.begin(), problem.objectiveWeights.end(),
                                        [](const auto &term) { return term.first == ObjectiveKind::ClearanceCost; });
        for (const char *key :
             {"objective.cost_scaling_factor", "objective.inscribed_radius", "objective.cost_penalty"})
        {
            const ConfigEntry *entry = find(entries, key);
            if (entry != nullptr && !isTerm && problem.objective != ObjectiveKind::ClearanceCost)
            {
                failAt(*entry, "only clearance_cost has it, as the objective or with a weight");
            }
        }
    }
}  // namespace ompl_mfa::benchmark
