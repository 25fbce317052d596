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

/* Time of one state check of an arm: the picker of the repository and, if OMPL_MFA_ARMS_DIR names the folder of the
   shared arms, Panda in three scenes, as meshes and as balls. The states are free and lie along short motions. */

#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "ompl_mfa/robots/RobotProblem.h"

namespace
{
    namespace fs = std::filesystem;
    using ompl_mfa::robots::Joint;
    using ompl_mfa::robots::RobotFiles;
    using ompl_mfa::robots::RobotProblem;

    RobotFiles filesOf(const fs::path &folder, const std::string &robot, const fs::path &problems, bool ofBalls)
    {
        RobotFiles files;
        files.robot = folder / (robot + (ofBalls ? "_spherized.urdf" : ".urdf"));
        files.semantics = folder / (robot + ".srdf");
        files.scene = problems / "scene0001.yaml";
        files.request = problems / "request0001.yaml";
        return files;
    }

    std::vector<std::vector<double>> freeStates(const RobotProblem &problem)
    {
        constexpr std::size_t COUNT = 2000;
        constexpr std::size_t MOTION = 16;
        constexpr double STEP = 0.01;
        std::mt19937 random(1);
        std::vector<std::vector<double>> states;
        std::vector<double> state(problem.robot().group.size());
        for (std::size_t i = 0; states.size() < COUNT; ++i)
        {
            for (std::size_t k = 0; k < state.size(); ++k)
            {
                const Joint &joint = problem.robot().model->joints()[problem.robot().group[k]];
                state[k] = i % MOTION == 0 ? std::uniform_real_distribution<>(joint.lower, joint.upper)(random)
                                           : state[k] + STEP;
            }
            if (!problem.collision().collides(state.data()))
            {
                states.push_back(state);
            }
        }
        return states;
    }

    void checkStates(benchmark::State &state, const RobotFiles &files, std::size_t atOnce)
    {
        const RobotProblem problem(files);
        const std::vector<std::vector<double>> states = freeStates(problem);
        std::vector<const double *> pointers;
        for (const auto &one : states)
        {
            pointers.push_back(one.data());
        }
        std::size_t next = 0;
        for (auto _ : state)
        {
            benchmark::DoNotOptimize(problem.collision().anyCollides(pointers.data() + next, atOnce));
            next = (next + atOnce) % (pointers.size() - atOnce + 1);
        }
        state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * atOnce));
    }

    void add(const std::string &name, const fs::path &folder, const std::string &robot, const fs::path &problems)
    {
        for (const bool ofBalls : {false, true})
        {
            for (const std::size_t atOnce : {1, 16})
            {
                const RobotFiles files = filesOf(folder, robot, problems, ofBalls);
                const std::string title = name + (ofBalls ? "/balls" : "/shapes") + "/" + std::to_string(atOnce);
                benchmark::RegisterBenchmark(
                    title.c_str(), [files, atOnce](benchmark::State &state) { checkStates(state, files, atOnce); });
            }
        }
    }
}  // namespace

int main(int argc, char **argv)
{
    const fs::path own = fs::path(OMPL_MFA_SOURCE_DIR) / "benchmarks/arms";
    add("picker", own / "picker", "picker", own / "problems");
    if (const char *arms = std::getenv("OMPL_MFA_ARMS_DIR"))
    {
        const fs::path panda = fs::path(arms) / "panda";
        for (const std::string set : {"box", "bookshelf_small", "cage"})
        {
            add("panda_" + set, panda, "panda", panda / "problems" / (set + "_panda"));
        }
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
