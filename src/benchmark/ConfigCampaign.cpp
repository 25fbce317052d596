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
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <sstream>

#include "benchmark/ArmConfig.h"
#include "benchmark/FileNames.h"
#include "ompl_mfa/benchmark/Campaign.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        std::string fileText(const std::filesystem::path &file)
        {
            std::ifstream in(file, std::ios::binary);
            return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        }

        /* The texts of the config, the world and the robot, so that a campaign with a changed mesh counts as a
           different one (the meshes of an arm, which its URDF file names, are not included); of a map the cells, which
           are in several files. */
        std::string identityOf(const BenchmarkConfig &config, const maps::ObstacleGrid *map)
        {
            std::string identity = fileText(config.file);
            if (config.problem.robotKind == RobotKind::Arm)
            {
                for (const std::filesystem::path &file : armFiles(config))
                {
                    identity += fileText(file);
                }
                return identity;
            }
            if (config.problem.world)
            {
                identity += fileText(findResource(config, *config.problem.world));
            }
            if (map != nullptr)
            {
                const std::vector<maps::Cell> &cells = map->map().cells();
                std::transform(cells.begin(), cells.end(), std::back_inserter(identity),
                               [](maps::Cell cell) { return static_cast<char>(cell); });
            }
            if (config.problem.scenario)
            {
                identity += fileText(findResource(config, *config.problem.scenario));
            }
            if (config.problem.robotKind == RobotKind::File)
            {
                identity += fileText(findResource(config, config.problem.robot));
            }
            return identity;
        }

        /* The problems of a scenario, and runCount of each; nothing for a single problem. */
        void addProblems(const ProblemFactory &factory, CampaignDescription &description)
        {
            const auto &problems = factory.problems();
            if (problems.empty())
            {
                return;
            }
            const std::uint64_t runs = std::uint64_t{description.runCount} * problems.size();
            if (runs > std::numeric_limits<unsigned int>::max())
            {
                failAt(*factory.config().problem.scenario,
                       "benchmark.run_count runs of each of the " + std::to_string(problems.size()) +
                           " problems are more than " + std::to_string(std::numeric_limits<unsigned int>::max()));
            }
            description.runCount = static_cast<unsigned int>(runs);
            for (const maps::ScenarioProblem &problem : problems)
            {
                description.problems.push_back({{"problem INTEGER", std::to_string(problem.index)},
                                                {"octile length REAL", text::numberText(problem.octileLength)}});
            }
        }

        void refuseSeeds(const BenchmarkConfig &config)
        {
            for (const PlannerSpec &planner : config.planners)
            {
                for (const ConfigEntry &parameter : planner.parameters)
                {
                    if (parameter.key == "seed")
                    {
                        failAt(parameter, "a campaign gives each run its own seed; benchmark.seed sets the first one");
                    }
                }
            }
        }
    }  // namespace

    Campaign makeCampaign(const BenchmarkConfig &config)
    {
        refuseSeeds(config);
        CampaignDescription description;
        description.name = config.problem.name;
        description.settings.timeLimit = config.benchmark.timeLimit;
        description.settings.memoryLimit = config.benchmark.memoryLimit;
        description.settings.progressInterval = config.benchmark.progressInterval;
        description.settings.iterationLimit = config.benchmark.iterationLimit;
        description.settings.simplify = config.benchmark.simplify;
        description.runCount = config.benchmark.runCount;
        description.seed = config.benchmark.seed;
        description.savePaths = config.benchmark.savePaths;
        const auto factory = std::make_shared<ProblemFactory>(config);
        description.identity = identityOf(config, factory->map());
        addProblems(*factory, description);
        for (const PlannerSpec &planner : config.planners)
        {
            description.planners.push_back({planner.name,
                                            [factory, planner](std::size_t problem)
                                            {
                                                if (factory->problems().empty())
                                                {
                                                    return factory->create(planner.context);
                                                }
                                                ProblemFactory selected(*factory);
                                                selected.select(problem);
                                                return selected.create(planner.context);
                                            },
                                            [planner](const ompl::base::SpaceInformationPtr &si)
                                            { return createPlanner(si, planner); }});
        }
        return Campaign(std::move(description));
    }

    std::filesystem::path logFile(const BenchmarkConfig &config, unsigned int shard, unsigned int shards)
    {
        std::filesystem::path folder = config.file.parent_path();
        if (!config.benchmark.output.empty())
        {
            folder = config.benchmark.output;
        }
        std::string name = fileNamePart(config.problem.name);
        if (shards > 1)
        {
            name += "." + std::to_string(shard) + "-of-" + std::to_string(shards);
        }
        return folder / (name + ".log");
    }
}  // namespace ompl_mfa::benchmark
