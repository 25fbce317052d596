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

#include "cli/SwarmRecording.h"

#include <algorithm>
#include <limits>

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Time.h>

#include "benchmark/ProblemSpace.h"
#include "cli/ProblemPicture.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/collision/StatePlacement.h"
#include "ompl_mfa/planner/MFA.h"

namespace ompl_mfa::cli
{
    namespace
    {
        namespace ob = ompl::base;
        namespace og = ompl::geometric;

        /* Points of a path in a space whose motions are curves. */
        constexpr unsigned int CURVE_POINTS = 40;
        constexpr double LONGEST_SECONDS = 60.0;

        /* The swarm's paths after a generation, as the planner has them. */
        struct Snapshot
        {
            std::uint64_t generation;
            std::vector<og::PathGeometric> paths;
        };

        collision::Polygon pointsOf(og::PathGeometric path, const collision::StatePlacement &placement)
        {
            if (!placement.interpolatesStraight())
            {
                path.interpolate(CURVE_POINTS);
            }
            collision::Polygon points;
            for (const ob::State *state : path.getStates())
            {
                fcl::Transform3d placed;
                placement.place(state, 0, placed);
                points.emplace_back(placed.translation().head<2>());
            }
            return points;
        }

        double distance(const SwarmPath &a, const SwarmPath &b)
        {
            if (a.points.size() != b.points.size())
            {
                return std::numeric_limits<double>::max();
            }
            double sum = 0.0;
            for (std::size_t i = 0; i < a.points.size(); ++i)
            {
                sum += (a.points[i] - b.points[i]).squaredNorm();
            }
            return sum;
        }

        /* Sorts \e paths so that each has the place of the nearest one of \e before that is not taken. */
        std::vector<SwarmPath> followed(const std::vector<SwarmPath> &before, std::vector<SwarmPath> paths)
        {
            for (std::size_t i = 0; i < std::min(before.size(), paths.size()); ++i)
            {
                const auto nearest = std::min_element(paths.begin() + static_cast<std::ptrdiff_t>(i), paths.end(),
                                                      [&](const SwarmPath &a, const SwarmPath &b)
                                                      { return distance(before[i], a) < distance(before[i], b); });
                std::swap(paths[i], *nearest);
            }
            return paths;
        }

        std::vector<collision::Polygon> robotOutlines(const benchmark::ProblemFactory &factory, const ob::State *state,
                                                      const collision::StatePlacement &placement)
        {
            const fcl::AABBd box = factory.robot().bounds();
            fcl::Transform3d placed;
            placement.place(state, 0, placed);
            std::vector<collision::Polygon> outlines;
            for (const auto &shape : factory.robot().shapes())
            {
                const collision::CollisionObject object{"robot", shape.geometry, placed * shape.pose};
                for (const auto &outline : collision::planarOutline(object, box.min_[2], box.max_[2]))
                {
                    outlines.push_back(outline);
                }
            }
            return outlines;
        }

        /* Runs \e planner and keeps its swarm after each generation. */
        std::vector<Snapshot> observe(MFA &planner, std::uint64_t generations)
        {
            std::vector<Snapshot> snapshots;
            const ompl::time::point start = ompl::time::now();
            const ob::PlannerTerminationCondition finished(
                [&]
                {
                    const std::uint64_t generation = planner.iterations();
                    if (snapshots.empty() || snapshots.back().generation != generation)
                    {
                        const std::vector<og::PathGeometric> paths = planner.getSwarmPaths();
                        if (!paths.empty())
                        {
                            snapshots.push_back({generation, paths});
                        }
                    }
                    return generation >= generations ||
                           ompl::time::seconds(ompl::time::now() - start) > LONGEST_SECONDS;
                });
            planner.solve(finished);
            return snapshots;
        }

        SwarmFrame frameOf(const Snapshot &snapshot, const og::SimpleSetup &setup,
                           const collision::StatePlacement &placement, const SwarmFrame *before)
        {
            ob::OptimizationObjectivePtr objective = setup.getOptimizationObjective();
            if (!objective)
            {
                objective = std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation());
            }
            SwarmFrame frame;
            frame.generation = snapshot.generation;
            if (before != nullptr)
            {
                frame.best = before->best;
            }
            for (const og::PathGeometric &path : snapshot.paths)
            {
                const SwarmPath drawn{pointsOf(path, placement), path.check(), path.cost(objective).value()};
                if (drawn.valid && (frame.best.points.empty() ||
                                    objective->isCostBetterThan(ob::Cost(drawn.cost), ob::Cost(frame.best.cost))))
                {
                    frame.best = drawn;
                }
                frame.paths.push_back(drawn);
            }
            if (before != nullptr)
            {
                frame.paths = followed(before->paths, frame.paths);
            }
            return frame;
        }
    }  // namespace

    PlanarProblem planarProblem(const benchmark::ProblemFactory &factory)
    {
        const auto &config = factory.config();
        if (benchmark::positionDimension(config.problem.space) != 2)
        {
            throw InputError(config.problem.name + ": is not planar; only planar problems can be animated");
        }
        const og::SimpleSetupPtr setup = factory.create();
        const collision::StatePlacement placement(setup->getStateSpace());
        const ob::RealVectorBounds bounds = positionBounds(*setup->getStateSpace());
        const fcl::AABBd box = factory.robot().bounds();
        PlanarProblem problem;
        problem.name = config.problem.name;
        problem.lower = {bounds.low[0], bounds.low[1]};
        problem.upper = {bounds.high[0], bounds.high[1]};
        for (const auto &object : factory.world().objects())
        {
            for (const auto &outline : collision::planarOutline(object, box.min_[2], box.max_[2]))
            {
                problem.obstacles.push_back(outline);
            }
        }
        problem.start = robotOutlines(factory, setup->getProblemDefinition()->getStartState(0), placement);
        if (const auto *goal = dynamic_cast<const ob::GoalState *>(setup->getGoal().get()))
        {
            problem.goal = robotOutlines(factory, goal->getState(), placement);
        }
        return problem;
    }

    SwarmRecording recordSwarm(const benchmark::ProblemFactory &factory, const benchmark::PlannerSpec &spec,
                               std::uint32_t seed, std::uint64_t generations)
    {
        const og::SimpleSetupPtr setup = factory.create(spec.context);
        const ob::PlannerPtr planner = benchmark::createPlanner(setup->getSpaceInformation(), spec);
        auto *mfa = dynamic_cast<MFA *>(planner.get());
        if (mfa == nullptr)
        {
            throw InputError("--planner " + spec.name + ": has no swarm; accepted are mfa, mfa_paper, fa_paper");
        }
        benchmark::seedPlanner(*planner, seed);
        setup->setPlanner(planner);
        setup->setup();
        const std::vector<Snapshot> snapshots = observe(*mfa, generations);
        if (snapshots.empty())
        {
            throw InputError("--planner " + spec.name +
                             ": showed no swarm, as if the straight motion from start to goal is free");
        }
        SwarmRecording recording;
        recording.planner = spec.name;
        const collision::StatePlacement placement(setup->getStateSpace());
        for (const og::PathGeometric &slice : mfa->getSlicePaths())
        {
            const collision::Polygon ends = pointsOf(slice, placement);
            recording.slices.emplace_back(ends.front(), ends.back());
        }
        for (const Snapshot &snapshot : snapshots)
        {
            recording.frames.push_back(
                frameOf(snapshot, *setup, placement, recording.frames.empty() ? nullptr : &recording.frames.back()));
        }
        return recording;
    }
}  // namespace ompl_mfa::cli
