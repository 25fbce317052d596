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

#include "planner/SearchLock.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <limits>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalLazySamples.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        using namespace std::chrono_literals;

        TEST(SearchLock, ReadersReadBetweenTheStepsOfASearch)
        {
            SearchLock lock;
            int a = 0;
            int b = 0;
            std::atomic<bool> done{false};
            std::atomic<unsigned int> reads{0};
            std::vector<std::thread> readers;
            for (unsigned int i = 0; i < 3; ++i)
            {
                readers.emplace_back(
                    [&]
                    {
                        while (!done)
                        {
                            const SearchLock::Reader reader(lock);
                            EXPECT_EQ(a, b);
                            ++reads;
                        }
                    });
            }
            {
                const SearchLock::Search search(lock);
                // the search does not end before readers came, and they do not block it
                for (int i = 0; i < 1000 || reads < 1000; ++i)
                {
                    ++a;
                    std::this_thread::yield();
                    ++b;
                    lock.letReadersIn();
                }
            }
            done = true;
            for (auto &reader : readers)
            {
                reader.join();
            }
            EXPECT_GE(a, 1000);
        }

        TEST(SearchLock, TheSearchingThreadReadsWithoutWaiting)
        {
            SearchLock lock;
            const SearchLock::Search search(lock);
            const SearchLock::Reader reader(lock);
            const SearchLock::Reader again(lock);
            lock.letReadersIn();
        }

        TEST(SearchLock, ThreadsThatDoNotSearchLetNobodyIn)
        {
            SearchLock lock;
            const SearchLock::Search search(lock);
            auto other = std::async(std::launch::async, [&] { lock.letReadersIn(); });
            EXPECT_EQ(other.wait_for(20s), std::future_status::ready);
        }

        TEST(SearchLock, AReleasedLockIsOpenToReaders)
        {
            SearchLock lock;
            const SearchLock::Search search(lock);
            {
                const SearchLock::Release release(lock);
                auto other = std::async(std::launch::async, [&] { const SearchLock::Reader reader(lock); });
                EXPECT_EQ(other.wait_for(20s), std::future_status::ready);
                const SearchLock::Reader own(lock);
            }
            const SearchLock::Reader reader(lock);
        }

        std::size_t verticesOf(const ob::Planner &planner, const ob::SpaceInformationPtr &si)
        {
            ob::PlannerData data(si);
            planner.getPlannerData(data);
            return data.numVertices();
        }

        class SolveLock : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::shared_ptr<MFA> planner_ = problem_->planner(GetParam());
        };

        INSTANTIATE_TEST_SUITE_P(Planner, SolveLock,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(SolveLock, ACallbackMayWaitForAThreadThatAsksForPlannerData)
        {
            std::atomic<bool> waitedInVain{false};
            std::atomic<unsigned int> asked{0};
            std::vector<std::future<std::size_t>> answers;
            problem_->pdef->setIntermediateSolutionCallback(
                [&](const ob::Planner *planner, const std::vector<const ob::State *> &, const ob::Cost)
                {
                    answers.push_back(
                        std::async(std::launch::async, [this, planner] { return verticesOf(*planner, problem_->si); }));
                    if (answers.back().wait_for(5s) != std::future_status::ready)
                    {
                        waitedInVain = true;
                    }
                    ++asked;
                });
            planner_->solve(test::untilExact(problem_->pdef));
            EXPECT_GT(asked, 0U);
            EXPECT_FALSE(waitedInVain);
        }

        TEST_P(SolveLock, PlannerDataMayBeAskedForWhileItWaitsForAGoal)
        {
            std::atomic<bool> open{false};
            const auto goal = std::make_shared<ob::GoalLazySamples>(
                problem_->si,
                [&](const ob::GoalLazySamples *, ob::State *state)
                {
                    while (!open)
                    {
                        std::this_thread::sleep_for(1ms);
                    }
                    problem_->si->copyState(state, problem_->state({9.0, 1.0}).get());
                    return true;
                });
            problem_->pdef->setGoal(goal);
            auto answer = std::async(std::launch::async,
                                     [this]
                                     {
                                         std::this_thread::sleep_for(50ms);
                                         return verticesOf(*planner_, problem_->si);
                                     });
            bool answered = false;
            std::thread opener(
                [&]
                {
                    answered = answer.wait_for(10s) == std::future_status::ready;
                    open = true;
                });
            const auto status = planner_->solve(test::untilExact(problem_->pdef));
            opener.join();
            goal->stopSampling();
            EXPECT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(answered);
        }

        TEST_P(SolveLock, AReaderWaitsForNoMoreThanACheckOrTwo)
        {
            // each state takes 1 ms: waiting for a whole turn, hundreds of states, would take far longer
            std::atomic<std::uint64_t> checks{0};
            test::PlanningProblem slow(test::realVectorSpace(2, 0.0, 10.0),
                                       [&](const ob::State *s)
                                       {
                                           std::this_thread::sleep_for(1ms);
                                           ++checks;
                                           return test::coordinate(s, 0) <= 4.5 || test::coordinate(s, 0) >= 5.5 ||
                                                  test::coordinate(s, 1) >= 6.0;
                                       },
                                       {1.0, 1.0}, {9.0, 1.0});
            const auto planner = slow.planner(GetParam());
            planner->setup();
            std::atomic<bool> done{false};
            std::vector<std::uint64_t> waited;
            std::thread reader(
                [&]
                {
                    while (waited.size() < 20)
                    {
                        std::this_thread::sleep_for(3ms);
                        const std::uint64_t before = checks;
                        verticesOf(*planner, slow.si);
                        waited.push_back(checks - before);
                    }
                    done = true;
                });
            planner->solve(ob::PlannerTerminationCondition([&] { return done.load(); }));
            reader.join();
            // a motion from end to end of the square has 142 states
            std::sort(waited.begin(), waited.end());
            EXPECT_LE(waited[waited.size() / 2], 100U);
            EXPECT_LE(waited.back(), 300U);
        }

        TEST_P(SolveLock, TheConditionMayAskForPlannerData)
        {
            std::size_t vertices = 0;
            planner_->solve(ob::PlannerTerminationCondition(
                [&, ptc = test::afterCalls(500)]
                {
                    vertices = verticesOf(*planner_, problem_->si);
                    return ptc();
                }));
            EXPECT_GE(vertices, GetParam() == test::PlannerVariant::Paper ? 0U : 2U);
        }

        TEST_P(SolveLock, AConditionIsNotAskedOnceSolveHasReturned)
        {
            // solve() returns early without a valid goal, or with an exception of the checker
            struct Broken
            {
            };
            bool broken = false;
            test::PlanningProblem problem(test::realVectorSpace(2, 0.0, 10.0),
                                          [&](const ob::State *)
                                          {
                                              if (broken)
                                              {
                                                  throw Broken();
                                              }
                                              return true;
                                          },
                                          {1.0, 1.0}, {9.0, 1.0});
            const auto planner = problem.planner(GetParam());
            bool dead = false;
            bool askedDead = false;
            const auto ptc = ob::PlannerTerminationCondition(
                [&]
                {
                    askedDead = askedDead || dead;
                    broken = true;
                    return false;
                });
            EXPECT_THROW(planner->solve(ptc), Broken);
            dead = true;
            broken = false;
            EXPECT_EQ(planner->solve(test::untilExact(problem.pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_FALSE(askedDead);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
