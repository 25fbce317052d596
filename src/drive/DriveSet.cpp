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

#include "drive/DriveSet.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <ompl/base/ScopedState.h>

#include "benchmark/ProblemSpace.h"
#include "ompl_mfa/InputError.h"

namespace ompl_mfa::drive
{
    namespace
    {
        constexpr double PI = 3.14159265358979323846;

        /* Valid poses, uniformly distributed on the map. */
        class RandomPoses
        {
        public:
            RandomPoses(const benchmark::ProblemFactory &factory, std::uint32_t seed)
              : factory_(factory)
              , si_(factory.create()->getSpaceInformation())
              , random_(seed)
            {
            }

            benchmark::ConfigPose draw()
            {
                constexpr int ATTEMPTS = 1000000;
                const maps::GridMap &map = factory_.map()->map();
                const benchmark::StateSpaceKind kind = factory_.config().problem.space;
                for (int i = 0; i < ATTEMPTS; ++i)
                {
                    const Eigen::Vector2d place = map.toWorld(
                        {uniform(static_cast<double>(map.width())), uniform(static_cast<double>(map.height()))});
                    benchmark::ConfigPose pose;
                    pose.x = place.x();
                    pose.y = place.y();
                    if (kind != benchmark::StateSpaceKind::R2)
                    {
                        pose.theta = uniform(2.0 * PI) - PI;
                    }
                    pose.origin = "--drives";
                    if (si_->isValid(benchmark::makeState(si_->getStateSpace(), kind, pose).get()))
                    {
                        return pose;
                    }
                }
                throw InputError("--drives: of a million random poses none is valid");
            }

        private:
            double uniform(double end)
            {
                // the standard's distributions are not the same everywhere
                return end * (static_cast<double>(random_()) / 4294967296.0);
            }

            const benchmark::ProblemFactory &factory_;
            ompl::base::SpaceInformationPtr si_;
            std::mt19937 random_;
        };
    }  // namespace

    std::vector<DriveProblem> randomProblems(const benchmark::ProblemFactory &factory, std::size_t count,
                                             std::uint32_t seed, double seconds)
    {
        constexpr double APART = 0.2;
        constexpr std::size_t ATTEMPTS = 10;
        const double least = APART * factory.map()->map().bounds().diagonal().norm();
        RandomPoses poses(factory, seed);
        benchmark::ProblemFactory drawn = factory;
        std::vector<DriveProblem> problems;
        std::size_t attempts = 0;
        while (problems.size() < count)
        {
            DriveProblem problem{poses.draw(), poses.draw(), 0.0};
            if (std::hypot(problem.start.x - problem.goal.x, problem.start.y - problem.goal.y) < least)
            {
                continue;
            }
            if (++attempts > ATTEMPTS * count)
            {
                throw InputError("--drives: of " + std::to_string(ATTEMPTS * count) + " random pairs only " +
                                 std::to_string(problems.size()) + " are connected by a path");
            }
            drawn.setStartAndGoal(problem.start, problem.goal);
            problem.optimum = omniscientLength(drawn, seconds);
            if (std::isfinite(problem.optimum))
            {
                problems.push_back(problem);
            }
        }
        return problems;
    }

    void DriveSummary::add(const DriveResult &result, double optimum)
    {
        ++drives;
        collisions += result.status == DriveStatus::Collision ? 1 : 0;
        blockages += result.blockages;
        repairTimes.insert(repairTimes.end(), result.repairTimes.begin(), result.repairTimes.end());
        if (result.status != DriveStatus::Arrived)
        {
            return;
        }
        ++arrived;
        if (std::isfinite(optimum) && optimum > 0.0)
        {
            ratios.push_back(result.driven / optimum);
        }
    }

    double quantile(std::vector<double> values, double part)
    {
        if (values.empty())
        {
            return std::numeric_limits<double>::quiet_NaN();
        }
        std::sort(values.begin(), values.end());
        const double rank = std::ceil(part * static_cast<double>(values.size()));
        return values[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
    }
}  // namespace ompl_mfa::drive
