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

#include "anytime/PlannerRun.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "anytime/PlannerText.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "path/FineChecks.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::anytime
{
    namespace
    {
        bool joinsStartAndGoal(const Problem &problem, og::PathGeometric &path)
        {
            if (path.getStateCount() == 0)
            {
                return false;
            }
            const auto &space = problem.si->getStateSpace();
            const double tolerance = 1e-9 * space->getMaximumExtent();
            return space->distance(path.getState(0), problem.pdef->getStartState(0)) <= tolerance &&
                   problem.pdef->getGoal()->isSatisfied(path.getState(path.getStateCount() - 1));
        }

        void timePathCheck(const Problem &problem, const og::PathGeometric &path, RunResult &result)
        {
            constexpr int REPETITIONS = 5;
            result.pathCheck = std::numeric_limits<double>::infinity();
            const std::uint64_t before = problem.checker->checks();
            for (int i = 0; i < REPETITIONS; ++i)
            {
                const double start = cpuTime();
                for (std::size_t k = 1; k < path.getStateCount(); ++k)
                {
                    problem.si->checkMotion(path.getState(k - 1), path.getState(k));
                }
                result.pathCheck = std::min(result.pathCheck, cpuTime() - start);
            }
            result.pathChecks = (problem.checker->checks() - before) / REPETITIONS;
        }

        void storePath(const Problem &problem, const og::PathGeometric &path, RunResult &result)
        {
            result.path.resize(path.getStateCount());
            for (std::size_t i = 0; i < path.getStateCount(); ++i)
            {
                problem.si->getStateSpace()->copyToReals(result.path[i], path.getState(i));
            }
        }

        void checkPath(const Problem &problem, RunResult &result)
        {
            result.solved = problem.pdef->hasExactSolution();
            if (!result.solved)
            {
                return;
            }
            const auto path = std::dynamic_pointer_cast<og::PathGeometric>(problem.pdef->getSolutionPath());
            result.valid = path->check() && joinsStartAndGoal(problem, *path);
            result.strict = result.valid && path::isValidAt(*problem.si, path->getStates(), STRICTNESS);
            result.cost = path->cost(problem.pdef->getOptimizationObjective()).value();
            storePath(problem, *path, result);
            timePathCheck(problem, *path, result);
        }
    }  // namespace

    RunResult runPlanner(const RunRequest &request, RunMemory &memory)
    {
        ompl::msg::noOutputHandler();
        ompl::RNG::setSeed(request.seed);
        const Problem problem = request.world->make();
        const ob::PlannerPtr planner = benchmark::createPlanner(problem.si, parsePlanner(request.planner));
        planner->setProblemDefinition(problem.pdef);
        const std::uint64_t checksBefore = problem.checker->checks();
        campaign::startSolving(memory);
        const double wallBefore = wallTime();
        const double cpuBefore = cpuTime();
        RunResult result;
        CostTrace trace(problem, *planner, request.clock, request.timeLimit, memory.log);
        planner->setup();
        planner->solve(ob::PlannerTerminationCondition([&trace] { return trace.expired(); }));
        result.wall = wallTime() - wallBefore;
        result.cpu = cpuTime() - cpuBefore;
        result.checks = problem.checker->checks() - checksBefore;
        trace.stop();
        result.longestGap = trace.longestGap();
        result.looks = trace.looks();
        memory.phase = campaign::RunPhase::Finishing;
        checkPath(problem, result);
        return result;
    }
}  // namespace ompl_mfa::anytime
