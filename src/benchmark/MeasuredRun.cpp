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

#include "benchmark/MeasuredRun.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <memory>
#include <sstream>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/RandomNumbers.h>
#include <ompl/util/String.h>

#include "benchmark/MeasuredPlanner.h"
#include "benchmark/PathMetrics.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
namespace ot = ompl::tools;

namespace ompl_mfa::benchmark
{
    namespace
    {
        double pathCost(const og::SimpleSetup &setup)
        {
            const ob::OptimizationObjectivePtr &objective = setup.getOptimizationObjective();
            const og::PathGeometric &path = setup.getSolutionPath();
            return objective ? path.cost(objective).value() : path.length();
        }

        /* Properties of the current path that OMPL's Benchmark does not record. */
        ot::Benchmark::RunProperties pathProperties(const std::string &prefix, const og::SimpleSetup &setup)
        {
            const PathMetrics metrics = measurePath(setup.getSolutionPath());
            return {{prefix + "path cost REAL", ompl::toString(pathCost(setup))},
                    {prefix + "minimum clearance REAL", ompl::toString(metrics.minimumClearance)},
                    {prefix + "resampled smoothness REAL", ompl::toString(metrics.smoothness)}};
        }

        /* Renames the properties of an approximate solution, so that its length is not averaged with those of exact
           solutions. */
        void setApartApproximateSolution(ot::Benchmark::RunProperties &run)
        {
            for (const std::string prefix : {"solution ", "simplified solution "})
            {
                for (const char *property : {"length REAL", "smoothness REAL", "clearance REAL", "segments INTEGER"})
                {
                    auto found = run.extract(prefix + property);
                    if (found)
                    {
                        found.key() = "approximate " + prefix + property;
                        run.insert(std::move(found));
                    }
                }
            }
        }

        void addMeasurements(const MeasuredPlanner &planner, const RunState &state, ot::Benchmark::RunProperties &run)
        {
            run["time REAL"] = ompl::toString(planner.time());
            run["collision checks INTEGER"] = std::to_string(planner.collisionChecks());
            run["motion checks INTEGER"] = std::to_string(planner.motionChecks());
            run["time to first solution REAL"] = ompl::toString(state.firstSolution.load());
            run["final best cost REAL"] = ompl::toString(state.bestCost.load());
            if (planner.threw())
            {
                run["status ENUM"] = std::to_string(static_cast<int>(ob::PlannerStatus::CRASH));
            }
        }

        void keepPath(const og::SimpleSetup &setup, RunRecord &record)
        {
            std::ostringstream matrix;
            matrix.imbue(std::locale::classic());
            setup.getSolutionPath().printAsMatrix(matrix);
            record.path = matrix.str();
            record.pathCost = pathCost(setup);
        }

        void measureSolution(const og::SimpleSetup &setup, const RunSettings &settings, RunRecord &record,
                             ot::Benchmark::RunProperties &run)
        {
            if (!setup.haveExactSolutionPath())
            {
                setApartApproximateSolution(run);
                return;
            }
            if (settings.simplify)
            {
                run.merge(pathProperties("simplified ", setup));
            }
            if (settings.keepPath)
            {
                keepPath(setup, record);
            }
        }

        ot::Benchmark::Request requestOf(const RunSettings &settings)
        {
            ot::Benchmark::Request request(settings.timeLimit, settings.memoryLimit, 1);
            request.displayProgress = false;
            request.saveConsoleOutput = false;
            request.simplify = settings.simplify;
            return request;
        }

        void takeExperiment(const ot::Benchmark::CompleteExperiment &experiment, bool seeded, RunRecord &record)
        {
            const auto &planner = experiment.planners.at(0);
            record.planner = planner.name;
            record.common = LogProperties(planner.common.begin(), planner.common.end());
            if (seeded)
            {
                record.common.erase("seed");
            }
            record.setup = experiment.setupInfo;
            for (const auto &run : planner.runs)
            {
                for (const auto &property : run)
                {
                    record.properties.insert({logPropertyName(property.first), property.second});
                }
            }
        }
    }  // namespace

    RunRecord measureRun(const ProblemAllocator &makeProblem, const ob::PlannerAllocator &makePlanner,
                         const RunSettings &settings, std::uint32_t seed, RunState &state)
    {
        ompl::RNG::setSeed(seed);
        const og::SimpleSetupPtr setup = makeProblem();
        const ob::SpaceInformationPtr &si = setup->getSpaceInformation();
        const ob::PlannerPtr inner = makePlanner(si);
        // a seeded planner reads no clock, which is needed only if the run has to be repeatable
        const bool seeded = settings.iterationLimit > 0 && inner->params().hasParam("seed");
        if (seeded)
        {
            seedPlanner(*inner, seed);
        }

        RunRecord record;
        record.seed = seed;
        ot::Benchmark::RunProperties unsimplified;
        MeasuredPlanner::Settings measuring{settings.timeLimit, settings.progressInterval, settings.iterationLimit, {}};
        measuring.solved = [&]
        {
            if (setup->haveExactSolutionPath())
            {
                unsimplified = pathProperties("", *setup);
            }
        };
        const auto planner = std::make_shared<MeasuredPlanner>(inner, state, measuring);
        ot::Benchmark benchmark(*setup, "run");
        benchmark.addPlanner(planner);
        benchmark.setPostRunEvent(
            [&](const ob::PlannerPtr &, ot::Benchmark::RunProperties &run)
            {
                addMeasurements(*planner, state, run);
                run.merge(unsimplified);
                measureSolution(*setup, settings, record, run);
            });
        benchmark.benchmark(requestOf(settings));

        takeExperiment(benchmark.getRecordedExperimentData(), seeded, record);
        record.progressNames = planner->progressNames();
        record.progress = planner->progress();
        record.termination = planner->threw() ? RunTermination::Exception : RunTermination::Returned;
        return record;
    }
}  // namespace ompl_mfa::benchmark
