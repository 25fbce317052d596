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

#include "anytime/CostTrace.h"

#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace ob = ompl::base;

namespace ompl_mfa::anytime
{
    namespace
    {
        /* A planner that only reports a cost set by the test. */
        class ShowingPlanner : public ob::Planner
        {
        public:
            explicit ShowingPlanner(const ob::SpaceInformationPtr &si)
              : Planner(si, "Showing")
            {
                addPlannerProgressProperty("best cost DOUBLE", [this] { return std::to_string(cost); });
            }

            ob::PlannerStatus solve(const ob::PlannerTerminationCondition &) override
            {
                return ob::PlannerStatus::TIMEOUT;
            }

            std::atomic<double> cost{std::numeric_limits<double>::infinity()};
        };

        Problem emptyProblem()
        {
            return makeProblem(Eigen::Vector2d::Zero(), Eigen::Vector2d::Ones(), Eigen::Vector2d(0.1, 0.5),
                               Eigen::Vector2d(0.9, 0.5), 0.01, [](const double *) { return true; });
        }

        void waitForCount(const ImprovementLog &log, std::uint32_t count)
        {
            const double start = wallTime();
            while (log.count < count && wallTime() < start + 20.0)
            {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            ASSERT_EQ(log.count, count);
        }
    }  // namespace

    TEST(CostTrace, ReadsTheCostThatAPlannerShows)
    {
        const auto problem = emptyProblem();
        ShowingPlanner planner(problem.si);
        const auto log = std::make_unique<ImprovementLog>();
        CostTrace trace(problem, planner, Clock::Wall, 100.0, *log);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        EXPECT_EQ(log->count, 0U) << "an infinite cost is no improvement";
        planner.cost = 3.0;
        waitForCount(*log, 1);
        planner.cost = 2.0;
        waitForCount(*log, 2);
        planner.cost = 2.5;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        trace.stop();
        ASSERT_EQ(log->count, 2U) << "a worse cost is no improvement";
        EXPECT_EQ(log->entries[0].cost, 3.0);
        EXPECT_EQ(log->entries[1].cost, 2.0);
        EXPECT_LT(log->entries[0].wall, log->entries[1].wall);
        EXPECT_GT(trace.looks(), 2U);
    }

    TEST(CostTrace, HearsTheCallbackAtOnceAndCountsChecks)
    {
        const auto problem = emptyProblem();
        const ShowingPlanner planner(problem.si);
        const auto log = std::make_unique<ImprovementLog>();
        {
            const CostTrace trace(problem, planner, Clock::CPU, 100.0, *log);
            problem.si->checkMotion(problem.pdef->getStartState(0), problem.pdef->getStartState(0));
            const std::uint64_t checks = problem.checker->checks();
            problem.pdef->getIntermediateSolutionCallback()(&planner, {}, ob::Cost(1.5));
            ASSERT_EQ(log->count, 1U);
            EXPECT_EQ(log->entries[0].cost, 1.5);
            EXPECT_EQ(log->entries[0].checks, checks);
            EXPECT_GT(checks, 0U);
        }
        EXPECT_FALSE(problem.pdef->getIntermediateSolutionCallback()) << "the callback was removed";
    }

    TEST(CostTrace, ExpiresByItsClock)
    {
        const auto problem = emptyProblem();
        const ShowingPlanner planner(problem.si);
        const auto log = std::make_unique<ImprovementLog>();
        CostTrace wall(problem, planner, Clock::Wall, 0.02, *log);
        CostTrace cpu(problem, planner, Clock::CPU, 20.0, *log);
        EXPECT_FALSE(cpu.expired());
        std::this_thread::sleep_for(std::chrono::milliseconds(25));
        EXPECT_TRUE(wall.expired());
        EXPECT_FALSE(cpu.expired()) << "sleeping takes no processor time";
    }
}  // namespace ompl_mfa::anytime
