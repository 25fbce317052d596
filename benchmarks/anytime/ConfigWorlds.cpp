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

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "anytime/WorldList.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ob = ompl::base;

namespace ompl_mfa::anytime
{
    namespace
    {
        /* The objective is always path length, regardless of the config. */
        Problem makeConfigProblem(const std::filesystem::path &file)
        {
            const auto setup = benchmark::ProblemFactory(benchmark::readBenchmarkConfig(file)).create();
            const auto &pdef = setup->getProblemDefinition();
            const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(setup->getSpaceInformation());
            length->setCostThreshold(ob::Cost(0.0));
            pdef->setOptimizationObjective(length);
            return countChecks(setup->getSpaceInformation(), pdef);
        }

        bool isRigidBody(const std::filesystem::path &file)
        {
            const benchmark::StateSpaceKind kind = benchmark::readBenchmarkConfig(file).problem.space;
            return kind == benchmark::StateSpaceKind::SE2 || kind == benchmark::StateSpaceKind::SE3;
        }

        World namedWorld(const std::filesystem::path &file, const std::string &prefix)
        {
            const std::string name = prefix + file.stem().string();
            return {name, name, [file] { return makeConfigProblem(file); }, {}};
        }
    }  // namespace

    World configWorld(const std::filesystem::path &file)
    {
        benchmark::readBenchmarkConfig(file);
        return namedWorld(file, "");
    }

    std::vector<World> configWorlds(const std::filesystem::path &folder, const std::string &prefix)
    {
        std::vector<World> worlds;
        if (!std::filesystem::is_directory(folder))
        {
            return worlds;
        }
        for (const auto &entry : std::filesystem::directory_iterator(folder))
        {
            if (entry.path().extension() == ".cfg" && isRigidBody(entry.path()))
            {
                worlds.push_back(namedWorld(entry.path(), prefix));
            }
        }
        std::sort(worlds.begin(), worlds.end(), [](const World &a, const World &b) { return a.name < b.name; });
        return worlds;
    }

    std::vector<World> omplAppWorlds(const std::filesystem::path &folder)
    {
        std::vector<World> worlds;
        for (const char *name : {"2D/Barriers", "2D/RandomPolygons_planar", "3D/cubicles", "3D/Easy", "3D/Twistycool"})
        {
            const std::filesystem::path file = folder / (std::string(name) + ".cfg");
            if (std::filesystem::is_regular_file(file))
            {
                worlds.push_back(namedWorld(file, "omplapp_"));
            }
        }
        return worlds;
    }
}  // namespace ompl_mfa::anytime
