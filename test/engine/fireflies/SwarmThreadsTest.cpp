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

/* An idle swarm, read by several threads at once. */

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/fireflies/Swarm.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        TEST(SwarmThreads, PathsAreThoseOfTheirFireflies)
        {
            constexpr Eigen::Index SIZE = 8;
            const auto problem = test::freeProblem();
            const auto &space = problem->si->getStateSpace();
            path::PathEvaluator evaluator(problem->si,
                                          std::make_shared<ob::PathLengthOptimizationObjective>(problem->si));
            FireflyOptimizer::Settings settings;
            settings.populationSize = SIZE;
            Swarm swarm(SliceFrame::straight(std::make_shared<const path::StateChart>(space),
                                             problem->state({1.0, 1.0}).get(), problem->state({9.0, 1.0}).get(), 13),
                        Swarm::Coordinates::Modes, evaluator, settings, 3,
                        [](const path::Waypoints &, const Brightness &) {});
            swarm.step([] { return false; });
            std::vector<path::Waypoints> alone(SIZE, path::Waypoints(space));
            for (Eigen::Index i = 0; i < SIZE; ++i)
            {
                swarm.pathOf(i, alone[static_cast<std::size_t>(i)]);
            }
            std::atomic<unsigned int> wrong{0};
            std::vector<std::thread> threads;
            for (int thread = 0; thread < 4; ++thread)
            {
                threads.emplace_back(
                    [&, thread]
                    {
                        path::Waypoints path(space);
                        for (Eigen::Index n = thread; n < 8000; ++n)
                        {
                            swarm.pathOf(n % SIZE, path);
                            const path::Waypoints &expected = alone[static_cast<std::size_t>(n % SIZE)];
                            for (std::size_t k = 0; k < path.size(); ++k)
                            {
                                if (!space->equalStates(path[k], expected[k]))
                                {
                                    ++wrong;
                                }
                            }
                        }
                    });
            }
            for (auto &thread : threads)
            {
                thread.join();
            }
            EXPECT_EQ(wrong, 0U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
