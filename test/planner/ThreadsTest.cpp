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

/* Several threads: two planners on one space information, and a planner that is read while it plans. */

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        class Threads : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Threads,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Threads, TwoPlannersShareOneSpaceInformation)
        {
            std::vector<std::thread> threads;
            std::atomic<int> solved{0};
            for (unsigned int i = 0; i < 2; ++i)
            {
                threads.emplace_back(
                    [this, i, &solved]
                    {
                        const auto pdef = std::make_shared<ob::ProblemDefinition>(problem_->si);
                        pdef->setStartAndGoalStates(problem_->state({1.0, 1.0 + i}), problem_->state({9.0, 1.0}));
                        for (unsigned int run = 0; run < 3; ++run)
                        {
                            const auto planner = test::makePlanner(problem_->si, GetParam(), 10 * i + run + 1);
                            planner->setProblemDefinition(pdef);
                            planner->solve(test::afterCalls(2000));
                            pdef->clearSolutionPaths();
                            if (planner->solve(test::untilExact(pdef)) == ob::PlannerStatus::EXACT_SOLUTION &&
                                pdef->getSolutionPath()->check())
                            {
                                ++solved;
                            }
                            pdef->clearSolutionPaths();
                        }
                    });
            }
            for (auto &thread : threads)
            {
                thread.join();
            }
            EXPECT_EQ(solved, 6);
        }

        TEST_P(Threads, ProgressMayBeWatchedWhileItPlans)
        {
            const auto planner = problem_->planner(GetParam());
            planner->setup();
            std::atomic<bool> done{false};
            std::atomic<unsigned int> watched{0};
            std::thread watcher(
                [&]
                {
                    double best = std::numeric_limits<double>::infinity();
                    while (!done)
                    {
                        for (const auto &[name, property] : planner->getPlannerProgressProperties())
                        {
                            EXPECT_FALSE(property().empty()) << name;
                        }
                        const double cost = planner->bestCost();
                        EXPECT_LE(cost, best);
                        best = cost;
                        ++watched;
                    }
                });
            planner->solve(ob::PlannerTerminationCondition([&watched, ptc = test::afterCalls(3000)]
                                                           { return ptc() && watched > 10; }));
            done = true;
            watcher.join();
        }

        TEST_P(Threads, PlannerDataMayBeAskedForWhileItPlans)
        {
            const auto planner = problem_->planner(GetParam());
            planner->setup();
            std::atomic<bool> done{false};
            std::atomic<unsigned int> asked{0};
            std::thread watcher(
                [&]
                {
                    while (!done)
                    {
                        ob::PlannerData data(problem_->si);
                        planner->getPlannerData(data);
                        data.decoupleFromPlanner();
                        for (unsigned int i = 0; i < data.numVertices(); ++i)
                        {
                            EXPECT_TRUE(problem_->si->satisfiesBounds(data.getVertex(i).getState()));
                        }
                        planner->getSwarmPaths();
                        planner->getSlicePaths();
                        if (data.numVertices() > 0)
                        {
                            ++asked;
                        }
                    }
                });
            // answered during the search, not only at its end
            const auto enough = ob::PlannerTerminationCondition([&asked] { return asked >= 3; });
            planner->solve(ob::plannerOrTerminationCondition(enough, ob::timedPlannerTerminationCondition(60.0)));
            EXPECT_GE(asked, 3U);
            done = true;
            watcher.join();
        }
    }  // namespace
}  // namespace ompl_mfa::planner
