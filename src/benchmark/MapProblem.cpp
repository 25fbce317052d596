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

#include "benchmark/MapProblem.h"

#include <algorithm>
#include <cmath>

#include "benchmark/ProblemSpace.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/maps/MapFile.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        void requireNoMapKeys(const ProblemConfig &problem)
        {
            const std::string fault = "the world is no map; expected a .yaml of map_server or a .map";
            if (problem.unknownCells)
            {
                failAt(problem.unknownCells->entry, fault);
            }
            if (problem.scenario)
            {
                failAt(*problem.scenario, fault);
            }
            if (problem.footprint)
            {
                failAt(problem.robot, fault);
            }
        }
    }  // namespace

    std::shared_ptr<const maps::ObstacleGrid> loadMapOf(const BenchmarkConfig &config)
    {
        const ProblemConfig &problem = config.problem;
        const std::filesystem::path file = problem.world ? findResource(config, *problem.world) : "";
        if (!problem.world || !maps::isMapFile(file))
        {
            requireNoMapKeys(problem);
            return nullptr;
        }
        if (positionDimension(problem.space) != 2)
        {
            failAt(*problem.world, "a map is planar; start and goal have x, y or x, y, theta");
        }
        try
        {
            const maps::UnknownCells unknown =
                problem.unknownCells ? problem.unknownCells->value : maps::UnknownCells::Occupied;
            return std::make_shared<maps::ObstacleGrid>(maps::loadMap(file), unknown);
        }
        catch (const InputError &error)
        {
            failAt(*problem.world, error.what());
        }
    }

    maps::Footprint makeFootprint(const ProblemConfig &problem)
    {
        switch (problem.robotKind)
        {
            case RobotKind::Point:
                return maps::Footprint::point();
            case RobotKind::Disc:
                return maps::Footprint::disc(problem.robotRadius);
            case RobotKind::Footprint:
                break;
            case RobotKind::File:
            case RobotKind::Sphere:
            case RobotKind::Arm:
                failAt(problem.robot, "on a map the robot is one of point, disc, footprint");
        }
        maps::Footprint::Polygon corners;
        for (const auto &corner : problem.footprint->value)
        {
            corners.emplace_back(corner[0], corner[1]);
        }
        try
        {
            return maps::Footprint::polygon(corners, problem.padding);
        }
        catch (const InputError &error)
        {
            failAt(problem.footprint->entry, error.what());
        }
    }

    std::vector<maps::ScenarioProblem> loadScenarioOf(const BenchmarkConfig &config, const maps::ObstacleGrid &grid)
    {
        const ProblemConfig &problem = config.problem;
        if (!problem.scenario)
        {
            return {};
        }
        std::vector<maps::ScenarioProblem> problems;
        try
        {
            problems = maps::loadScenario(findResource(config, *problem.scenario), grid.map(),
                                          findResource(config, *problem.world));
        }
        catch (const InputError &error)
        {
            failAt(*problem.scenario, error.what());
        }
        const ScenarioIndices &indices = problem.scenarioIndices.value;
        const std::size_t end = problems.size();
        const bool isOpen = indices.last == ScenarioIndices().last;
        if (indices.first >= end || (!isOpen && indices.last >= end))
        {
            failAt(problem.scenarioIndices.entry,
                   "the scenario has the problems 0 to " + std::to_string(problems.size() - 1));
        }
        return {problems.begin() + static_cast<std::ptrdiff_t>(indices.first),
                isOpen ? problems.end() : problems.begin() + static_cast<std::ptrdiff_t>(indices.last) + 1};
    }

    std::string describeCell(const maps::ObstacleGrid &grid, const ConfigPose &pose)
    {
        const maps::GridMap &map = grid.map();
        const Eigen::Vector2d position = map.toGrid({pose.x, pose.y});
        const auto x = static_cast<std::int64_t>(std::floor(position.x()));
        const auto y = static_cast<std::int64_t>(std::floor(position.y()));
        if (x < 0 || y < 0 || x >= static_cast<std::int64_t>(map.width()) ||
            y >= static_cast<std::int64_t>(map.height()))
        {
            return "outside of the map";
        }
        const bool isUnknown =
            map.cell(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) == maps::Cell::Unknown;
        return isUnknown && grid.isOccupied(x, y) ? "in unknown space; problem.map.unknown = free admits it" : "";
    }
}  // namespace ompl_mfa::benchmark
