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

/* Termination conditions of any kind, evaluated often and obeyed at once. Latency is counted in state checks, not in
   time, so that it does not depend on the machine. */

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <tuple>

#include <gtest/gtest.h>

#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/base/terminationconditions/CostConvergenceTerminationCondition.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        class Termination : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            /* State checks of a motion across the whole space, both ends included. */
            std::uint64_t longestMotion() const
            {
                const auto &space = *problem_->si->getStateSpace();
                return static_cast<std::uint64_t>(space.getMaximumExtent() / space.getLongestValidSegmentLength()) + 2;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Termination,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Termination, AConditionThatIsTrueAlreadyEndsTheSearchBeforeAnyMotionIsChecked)
        {
            const auto planner = problem_->planner(GetParam());
            EXPECT_EQ(planner->solve(ob::PlannerTerminationCondition([] { return true; })), ob::PlannerStatus::TIMEOUT);
            EXPECT_EQ(problem_->counted.motions, 0U);
            EXPECT_FALSE(problem_->pdef->hasSolution());
            EXPECT_EQ(planner->solve(0.0), ob::PlannerStatus::TIMEOUT);
            EXPECT_EQ(problem_->counted.motions, 0U);
        }

        TEST_P(Termination, NoTimeAtAllStillReportsAnEarlierSolution)
        {
            const auto planner = problem_->planner(GetParam());
            ASSERT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            const double cost = planner->bestCost();
            problem_->pdef->clearSolutionPaths();
            EXPECT_EQ(planner->solve(0.0), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(problem_->reportedCost(), cost);
        }

        TEST_P(Termination, AfterTheConditionTurnsTrueNoMoreThanOneMotionIsChecked)
        {
            for (const std::uint64_t calls : {1U, 2U, 3U, 5U, 10U, 50U, 100U, 500U, 1000U, 3000U})
            {
                const auto planner = problem_->planner(GetParam());
                std::uint64_t asked = 0;
                std::uint64_t statesThen = 0;
                const ob::PlannerTerminationCondition ptc(
                    [&]
                    {
                        if (++asked == calls)
                        {
                            statesThen = problem_->counted.states;
                        }
                        return asked >= calls;
                    });
                planner->solve(ptc);
                ASSERT_GE(asked, calls);
                EXPECT_LE(problem_->counted.states - statesThen, longestMotion()) << "after " << calls << " calls";
            }
        }

        TEST_P(Termination, TheConditionIsEvaluatedAtEveryPathEvaluation)
        {
            const auto planner = problem_->planner(GetParam());
            std::uint64_t statesBefore = 0;
            std::uint64_t most = 0;
            std::uint64_t asked = 0;
            const ob::PlannerTerminationCondition ptc(
                [&]
                {
                    most = std::max<std::uint64_t>(most, problem_->counted.states - statesBefore);
                    statesBefore = problem_->counted.states;
                    return ++asked > 20000;
                });
            planner->solve(ptc);
            EXPECT_GT(asked, 20000U);
            // a motion check, and the count of the invalid states on the motion if that failed
            EXPECT_LE(most, 3 * longestMotion());
        }

        TEST_P(Termination, AGoalThatIsSearchedForStopsAsWell)
        {
            problem_->pdef->setGoal(
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({5.0, 1.0}).get(), 0.1));
            const auto planner = problem_->planner(GetParam());
            std::uint64_t statesThen = 0;
            std::uint64_t asked = 0;
            const ob::PlannerTerminationCondition ptc(
                [&]
                {
                    if (++asked == 500)
                    {
                        statesThen = problem_->counted.states;
                    }
                    return asked >= 500;
                });
            // the target is inside the wall
            const ob::PlannerStatus status = planner->solve(ptc);
            EXPECT_NE(status, ob::PlannerStatus::EXACT_SOLUTION);
            ASSERT_GE(asked, 500U);
            EXPECT_LE(problem_->counted.states - statesThen, longestMotion());
        }

        /* An integral that counts its computations. */
        class CountedIntegral : public ob::StateCostIntegralObjective
        {
        public:
            explicit CountedIntegral(const ob::SpaceInformationPtr &si)
              : StateCostIntegralObjective(si, true)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(1.0 + test::coordinate(state, 1));
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                ++computed;
                return StateCostIntegralObjective::motionCost(from, to);
            }

            mutable std::uint64_t computed{0};
        };

        TEST_P(Termination, AfterTheConditionTurnsTrueNoMotionIsCheckedAndCostedMoreThanOnce)
        {
            const auto objective = std::make_shared<CountedIntegral>(problem_->si);
            problem_->pdef->setOptimizationObjective(objective);
            unsigned int turned = 0;
            for (std::uint64_t calls = 1; calls <= 20000; calls += 1 + calls / 20)
            {
                problem_->pdef->clearSolutionPaths();
                const auto planner = problem_->planner(GetParam(), static_cast<std::uint32_t>(calls));
                std::uint64_t asked = 0;
                std::uint64_t statesThen = 0;
                std::uint64_t costsThen = 0;
                const ob::PlannerTerminationCondition ptc(
                    [&]
                    {
                        // before this evaluation there may be a motion check or a motion cost
                        if (++asked == calls)
                        {
                            statesThen = problem_->counted.states;
                            costsThen = objective->computed;
                        }
                        return asked >= calls;
                    });
                planner->solve(ptc);
                ASSERT_GE(asked, calls);
                ++turned;
                EXPECT_LE(objective->computed - costsThen, 0U) << "after " << calls << " calls";
                EXPECT_LE(problem_->counted.states - statesThen, longestMotion()) << "after " << calls << " calls";
            }
            EXPECT_GT(turned, 100U);
        }

        TEST_P(Termination, NoTwoCostsOfMotionsAreComputedBetweenTwoLooksAtTheCondition)
        {
            const auto objective = std::make_shared<CountedIntegral>(problem_->si);
            problem_->pdef->setOptimizationObjective(objective);
            const auto planner = problem_->planner(GetParam());
            std::uint64_t asked = 0;
            std::uint64_t before = 0;
            std::uint64_t most = 0;
            const ob::PlannerTerminationCondition ptc(
                [&]
                {
                    most = std::max(most, objective->computed - before);
                    before = objective->computed;
                    return ++asked > 200000;
                });
            planner->solve(ptc);
            EXPECT_GT(objective->computed, 10000U);
            EXPECT_EQ(most, 1U);
        }

        TEST_P(Termination, AConditionMayTurnTrueInAnotherThread)
        {
            problem_ = test::closedProblem();
            const auto planner = problem_->planner(GetParam());
            std::atomic<bool> stop{false};
            std::thread other(
                [&stop]
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(30));
                    stop = true;
                });
            std::uint64_t statesThen = 0;
            const ob::PlannerTerminationCondition ptc(
                [&]
                {
                    if (!stop)
                    {
                        statesThen = problem_->counted.states;
                    }
                    return stop.load();
                });
            planner->solve(ptc);
            EXPECT_TRUE(stop);
            other.join();
            EXPECT_LE(problem_->counted.states - statesThen, 4 * longestMotion());
        }

        TEST_P(Termination, TerminateFromOutsideIsObeyed)
        {
            problem_ = test::closedProblem();
            const auto planner = problem_->planner(GetParam());
            // a planner that ignores the condition ends as well, a minute later
            const ob::PlannerTerminationCondition late = ob::timedPlannerTerminationCondition(60.0);
            const ob::PlannerTerminationCondition ptc([&late] { return late(); });
            std::atomic<bool> asked{false};
            std::atomic<std::uint64_t> statesThen{0};
            std::thread other(
                [&]
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(30));
                    asked = true;
                    ptc.terminate();
                    statesThen = problem_->counted.states.load();
                });
            planner->solve(ptc);
            EXPECT_TRUE(asked) << "nothing else may end this search";
            other.join();
            EXPECT_FALSE(late());
            const std::uint64_t states = problem_->counted.states;
            EXPECT_LE(states - std::min<std::uint64_t>(statesThen, states), 4 * longestMotion());
        }

        /* A swarm of the largest size: its moves take longer than a motion check. */
        TEST_P(Termination, TheConditionIsEvaluatedWhileALargeSwarmMoves)
        {
            constexpr std::uint64_t SIZE = 1500;
            const auto objective = std::make_shared<CountedIntegral>(problem_->si);
            problem_->pdef->setOptimizationObjective(objective);
            const auto planner = problem_->planner(test::PlannerVariant::Paper);
            test::set(*planner, "population_size", std::to_string(SIZE));
            test::set(*planner, "variant", GetParam() == test::PlannerVariant::Paper ? "mfa" : "fa");
            std::uint64_t computed = 0;
            std::uint64_t asked = 0;
            std::uint64_t most = 0;
            const ob::PlannerTerminationCondition ptc(
                [&]
                {
                    asked = objective->computed == computed ? asked + 1 : 1;
                    computed = objective->computed;
                    most = std::max(most, asked);
                    return planner->iterations() > 0;
                });
            planner->solve(ptc);
            EXPECT_GT(planner->iterations(), 0U);
            // between the costs of two paths each firefly moves toward every brighter one, in five coordinates
            EXPECT_GE(most, SIZE * (SIZE - 1) / 2 * 5 / 8192);
            EXPECT_GE(planner->evaluations(), 2 * SIZE - 1);
        }

        TEST_P(Termination, IterationsCanBeLimited)
        {
            const auto planner = problem_->planner(GetParam());
            ob::IterationTerminationCondition iterations(500);
            const ob::PlannerTerminationCondition limit = iterations;
            // counted here because newer OMPL counts in the copy that the cast makes
            unsigned int asked = 0;
            planner->solve(ob::PlannerTerminationCondition(
                [&]
                {
                    ++asked;
                    return limit();
                }));
            EXPECT_GE(asked, 500U);
            EXPECT_LE(asked, 520U) << "evaluated repeatedly after it was true";
        }

        TEST_P(Termination, CostConvergenceEndsTheSearch)
        {
            const auto planner = problem_->planner(GetParam());
            ob::CostConvergenceTerminationCondition converged(problem_->pdef, 3, 0.2);
            const auto ptc = ob::plannerOrTerminationCondition(converged, ob::timedPlannerTerminationCondition(60.0));
            EXPECT_EQ(planner->solve(ptc), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(converged());
            problem_->pdef->setIntermediateSolutionCallback({});
        }
    }  // namespace
}  // namespace ompl_mfa::planner
