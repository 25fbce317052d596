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

/* One planner with several threads: the same search, faster. */

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "path/SlowProblem.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        /* The wall problem with slow state checks; threads share whole motions or single states. */
        class ParallelPlanning : public ::testing::TestWithParam<std::tuple<test::PlannerVariant, bool>>
        {
        protected:
            ParallelPlanning()
            {
                ob::ScopedState<> start(problem_.si);
                ob::ScopedState<> goal(problem_.si);
                start = std::vector<double>{1.0, 1.0};
                goal = std::vector<double>{9.0, 1.0};
                pdef_->setStartAndGoalStates(start, goal);
            }

            std::shared_ptr<MFA> planner(unsigned int threads) const
            {
                auto result = test::makePlanner(problem_.si, std::get<0>(GetParam()));
                test::set(*result, "threads", std::to_string(threads));
                pdef_->clearSolutionPaths();
                result->setProblemDefinition(pdef_);
                return result;
            }

            /* All costs that a run publishes, and its counts at the end. */
            std::vector<double> run(unsigned int threads, std::uint64_t calls) const
            {
                const auto mfa = planner(threads);
                std::vector<double> result;
                pdef_->setIntermediateSolutionCallback([&](const ob::Planner *, const std::vector<const ob::State *> &,
                                                           const ob::Cost cost) { result.push_back(cost.value()); });
                mfa->solve(test::afterCalls(calls));
                EXPECT_TRUE(pdef_->getSolutionPath()->check());
                pdef_->setIntermediateSolutionCallback({});
                result.push_back(static_cast<double>(mfa->evaluations()));
                result.push_back(static_cast<double>(mfa->iterations()));
                for (const auto &share : mfa->shares())
                {
                    result.push_back(share.second);
                }
                return result;
            }

            std::atomic<bool> refusesHelpers_{false};
            std::atomic<double> top_{6.0};  ///< of the wall
            std::thread::id caller_{std::this_thread::get_id()};
            test::SlowProblem problem_{test::realVectorSpace(2, 0.0, 10.0), std::get<1>(GetParam()),
                                       std::chrono::microseconds(5),
                                       [this](const ob::State *state)
                                       {
                                           if (refusesHelpers_ && std::this_thread::get_id() != caller_)
                                           {
                                               throw std::domain_error("a checker for one thread");
                                           }
                                           const double x = test::coordinate(state, 0);
                                           return x <= 4.5 || x >= 5.5 || test::coordinate(state, 1) >= top_;
                                       }};
            ob::ProblemDefinitionPtr pdef_{std::make_shared<ob::ProblemDefinition>(problem_.si)};
        };

        struct CaseName
        {
            std::string operator()(const ::testing::TestParamInfo<std::tuple<test::PlannerVariant, bool>> &run) const
            {
                const auto [engine, wholeMotions] = run.param;
                return std::string(engine == test::PlannerVariant::Paper ? "Paper" : "Default") +
                       (wholeMotions ? "WholeMotions" : "States");
            }
        };

        INSTANTIATE_TEST_SUITE_P(Planner, ParallelPlanning,
                                 ::testing::Combine(::testing::Values(test::PlannerVariant::Default,
                                                                      test::PlannerVariant::Paper),
                                                    ::testing::Bool()),
                                 CaseName());

        TEST_P(ParallelPlanning, ARunIsTheSameWithAnyNumberOfThreads)
        {
            const std::vector<double> one = run(1, 2500);
            EXPECT_EQ(problem_.mostInside, 1U);
            EXPECT_GT(one.size(), 8U);
            EXPECT_EQ(run(3, 2500), one);
            EXPECT_EQ(run(3, 2500), one);
            EXPECT_EQ(run(2, 2500), one);
            EXPECT_LE(problem_.mostInside, 3U);
        }

        TEST_P(ParallelPlanning, SoIsARunInAWorldThatChanges)
        {
            const auto costs = [this](unsigned int threads)
            {
                std::vector<double> result;
                const auto mfa = planner(threads);
                for (const double top : {6.0, 7.0, 4.0})
                {
                    top_ = top;
                    mfa->validityChanged();
                    pdef_->clearSolutionPaths();
                    mfa->solve(test::afterCalls(1500));
                    result.push_back(mfa->bestCost());
                    result.push_back(static_cast<double>(mfa->evaluations()));
                    EXPECT_TRUE(pdef_->hasExactSolution());
                    EXPECT_TRUE(pdef_->getSolutionPath()->check());
                }
                return result;
            };
            const std::vector<double> one = costs(1);
            EXPECT_EQ(costs(2), one);
            EXPECT_EQ(costs(3), one);
        }

        TEST_P(ParallelPlanning, SeveralThreadsAreInTheCheckerAtOnce)
        {
            const auto enough = ob::PlannerTerminationCondition([this] { return problem_.mostInside > 1; });
            planner(4)->solve(ob::plannerOrTerminationCondition(enough, ob::timedPlannerTerminationCondition(60.0)));
            EXPECT_GT(problem_.mostInside, 1U);
            EXPECT_LE(problem_.mostInside, 4U);
        }

        TEST_P(ParallelPlanning, AnExceptionOfTheCheckerReachesTheCallerOfSolve)
        {
            const auto mfa = planner(3);
            refusesHelpers_ = true;
            EXPECT_THROW(mfa->solve(ob::timedPlannerTerminationCondition(60.0)), std::domain_error);
            refusesHelpers_ = false;
            mfa->clear();
            pdef_->clearSolutionPaths();
            EXPECT_EQ(mfa->solve(test::untilExact(pdef_)), ob::PlannerStatus::EXACT_SOLUTION);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
