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

/* Paths that hold at a finer resolution than that at which the search checks motions. */

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/MotionValidator.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr unsigned int STRICTNESS = 8;

        /* Discs in the square [0, 10]^2, around which the shortest path winds. */
        bool outsideDiscs(const ob::State *state)
        {
            const double x = test::coordinate(state, 0);
            const double y = test::coordinate(state, 1);
            return std::hypot(x - 3.0, y - 2.0) > 1.5 && std::hypot(x - 5.0, y - 5.5) > 1.5 &&
                   std::hypot(x - 7.5, y - 2.5) > 1.2 && std::hypot(x - 5.2, y - 1.0) > 0.6;
        }

        std::unique_ptr<test::PlanningProblem> discProblem(double resolution = 0.02)
        {
            auto problem =
                std::make_unique<test::PlanningProblem>(test::realVectorSpace(2, 0.0, 10.0), outsideDiscs,
                                                        std::vector<double>{0.5, 1.0}, std::vector<double>{9.5, 1.5});
            problem->si->setStateValidityCheckingResolution(resolution);
            problem->si->setup();
            return problem;
        }

        /* A wall without a gap that is thinner than the distance of two checked states. */
        std::unique_ptr<test::PlanningProblem> thinWallProblem(double y = 1.0)
        {
            auto problem = std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, 0.0, 10.0),
                [](const ob::State *s) { return std::abs(test::coordinate(s, 0) - 5.0) > 0.03; },
                std::vector<double>{1.0, 1.0}, std::vector<double>{9.0, y});
            problem->si->setStateValidityCheckingResolution(0.02);
            problem->si->setup();
            return problem;
        }

        /* A height of the goal at which a state of the straight motion is within the wall. */
        double blockedHeight()
        {
            double y = 0.5;
            for (; y < 9.5; y += 0.05)
            {
                const auto problem = thinWallProblem(y);
                const auto *goal = problem->pdef->getGoal()->as<ob::GoalState>()->getState();
                if (!problem->si->checkMotion(problem->pdef->getStartState(0), goal))
                {
                    break;
                }
            }
            return y;
        }

        bool holdsAt(const test::PlanningProblem &problem, unsigned int factor)
        {
            const auto &space = problem.si->getStateSpace();
            space->setValidSegmentCountFactor(factor);
            const bool holds = problem.path().check();
            space->setValidSegmentCountFactor(1);
            return holds;
        }

        std::shared_ptr<MFA> planner(const test::PlanningProblem &problem, unsigned int strictness, std::uint32_t seed,
                                     test::PlannerVariant variant = test::PlannerVariant::Default)
        {
            auto result = problem.planner(variant, seed);
            result->setStrictness(strictness);
            return result;
        }

        TEST(Strictness, FinalPathsHoldAtAFinerResolution)
        {
            unsigned int lax = 0;
            double excess = 0.0;
            for (std::uint32_t seed = 1; seed <= 10; ++seed)
            {
                double costs[2];
                for (const bool strict : {false, true})
                {
                    const auto problem = discProblem();
                    const auto mfa = planner(*problem, strict ? STRICTNESS : 1, seed);
                    ASSERT_EQ(mfa->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
                    EXPECT_TRUE(problem->path().check());
                    EXPECT_EQ(problem->reportedCost(), mfa->bestCost());
                    EXPECT_DOUBLE_EQ(problem->path().length(), mfa->bestCost());
                    costs[strict ? 1 : 0] = mfa->bestCost();
                    lax += !strict && holdsAt(*problem, STRICTNESS) ? 1 : 0;
                    for (const unsigned int factor : {1U, 2U, 4U, STRICTNESS})
                    {
                        EXPECT_TRUE(!strict || holdsAt(*problem, factor)) << seed << ", " << factor;
                    }
                }
                excess += (costs[1] / costs[0] - 1.0) / 10.0;
            }
            EXPECT_LE(lax, 5U) << "the problem does not need strictness";
            EXPECT_LT(excess, 0.005);
        }

        TEST(Strictness, ItsPathsBendAroundACornerOnly)
        {
            // the excess over the optimum is small
            for (std::uint32_t seed = 1; seed <= 5; ++seed)
            {
                const auto problem = test::wallProblem();
                const auto mfa = planner(*problem, STRICTNESS, seed);
                ASSERT_EQ(mfa->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_TRUE(holdsAt(*problem, STRICTNESS)) << seed;
                EXPECT_LT(mfa->bestCost(), 1.01 * test::wallOptimum()) << seed;
            }
        }

        TEST(Strictness, OtherFactorsHoldToo)
        {
            for (const unsigned int strictness : {2U, 3U, 5U, 16U})
            {
                const auto problem = discProblem();
                const auto mfa = planner(*problem, strictness, 4);
                ASSERT_EQ(mfa->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_TRUE(holdsAt(*problem, strictness)) << strictness;
            }
        }

        TEST(Strictness, PublishedCostsImproveAndTheLastPathIsTheSolution)
        {
            for (std::uint32_t seed = 1; seed <= 5; ++seed)
            {
                const auto problem = discProblem();
                const auto mfa = planner(*problem, STRICTNESS, seed);
                double last = std::numeric_limits<double>::infinity();
                problem->pdef->setIntermediateSolutionCallback(
                    [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
                    {
                        EXPECT_LT(cost.value(), last);
                        last = cost.value();
                        EXPECT_EQ(mfa->bestCost(), last);
                    });
                // interrupted anywhere, in a strict check too, and resumed
                for (unsigned int calls = 1; calls < 20000; calls += 1 + calls / 3)
                {
                    const double before = mfa->bestCost();
                    mfa->solve(test::afterCalls(calls));
                    EXPECT_LE(mfa->bestCost(), before);
                    if (problem->pdef->hasExactSolution())
                    {
                        EXPECT_EQ(problem->reportedCost(), last);
                        EXPECT_TRUE(problem->path().check());
                    }
                }
                EXPECT_TRUE(holdsAt(*problem, STRICTNESS)) << seed;
            }
        }

        TEST(Strictness, OnlyAPathThatHoldsMeetsTheThreshold)
        {
            double best = 0.0;
            {
                const auto problem = discProblem();
                const auto mfa = planner(*problem, STRICTNESS, 3);
                mfa->solve(test::afterCalls(40000));
                best = mfa->bestCost();
            }
            unsigned int lax = 0;
            for (std::uint32_t seed = 1; seed <= 10; ++seed)
            {
                for (const unsigned int strictness : {1U, STRICTNESS})
                {
                    const auto problem = discProblem();
                    const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(problem->si);
                    objective->setCostThreshold(ob::Cost(1.0005 * best));
                    problem->pdef->setOptimizationObjective(objective);
                    const auto mfa = planner(*problem, strictness, seed);
                    std::uint64_t calls = 0;
                    ASSERT_EQ(mfa->solve(ob::PlannerTerminationCondition([&] { return ++calls > 2000000; })),
                              ob::PlannerStatus::EXACT_SOLUTION);
                    EXPECT_LT(calls, 2000000U) << "it continued although the threshold can be met";
                    EXPECT_TRUE(problem->pdef->hasOptimizedSolution());
                    const bool holds = holdsAt(*problem, STRICTNESS);
                    EXPECT_TRUE(strictness == 1 || holds) << seed;
                    lax += strictness == 1 && holds ? 1 : 0;
                }
            }
            EXPECT_LT(lax, 10U) << "the problem does not need strictness";
        }

        TEST(Strictness, WhatExistsAtTheResolutionOnlyIsReturnedNevertheless)
        {
            for (std::uint32_t seed = 1; seed <= 5; ++seed)
            {
                const auto problem = thinWallProblem(blockedHeight());
                const auto mfa = planner(*problem, STRICTNESS, seed);
                ASSERT_EQ(mfa->solve(test::afterCalls(5000)), ob::PlannerStatus::EXACT_SOLUTION) << seed;
                EXPECT_TRUE(problem->path().check());
                EXPECT_FALSE(holdsAt(*problem, STRICTNESS));
            }
        }

        TEST(Strictness, AUserWhoWaitsForAnyPathGetsOneWithoutAStrictOne)
        {
            const auto problem = thinWallProblem(blockedHeight());
            const auto mfa = planner(*problem, STRICTNESS, 1);
            std::uint64_t calls = 0;
            EXPECT_EQ(mfa->solve(ob::PlannerTerminationCondition(
                          [&] { return ++calls > 500000 || problem->pdef->hasExactSolution(); })),
                      ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LT(calls, 500000U);
        }

        TEST(Strictness, AnOptimalMotionEndsTheSearchThoughNoPathIsStrict)
        {
            // some straight motions have no state within the wall
            unsigned int straight = 0;
            for (double y = 0.5; y < 9.5; y += 0.25)
            {
                const auto problem = thinWallProblem(y);
                if (!problem->si->checkMotion(problem->pdef->getStartState(0),
                                              problem->pdef->getGoal()->as<ob::GoalState>()->getState()))
                {
                    continue;
                }
                ++straight;
                const auto mfa = planner(*problem, STRICTNESS, 1);
                std::uint64_t calls = 0;
                EXPECT_EQ(mfa->solve(ob::PlannerTerminationCondition([&] { return ++calls > 100000; })),
                          ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_LT(calls, 100000U) << y;
            }
            EXPECT_GT(straight, 0U);
        }

        /* A wall that only the motion validator knows, by geometry. */
        class WallMotionValidator : public ob::MotionValidator
        {
        public:
            using ob::MotionValidator::MotionValidator;

            bool checkMotion(const ob::State *from, const ob::State *to) const override
            {
                const double x = test::coordinate(from, 0);
                const double dx = test::coordinate(to, 0) - x;
                const double y = test::coordinate(from, 1);
                if ((x - 5.0) * (x + dx - 5.0) >= 0.0)
                {
                    return si_->isValid(to);
                }
                return si_->isValid(to) && y + (test::coordinate(to, 1) - y) * (5.0 - x) / dx > 6.0;
            }

            bool checkMotion(const ob::State *from, const ob::State *to,
                             std::pair<ob::State *, double> &lastValid) const override
            {
                const bool valid = checkMotion(from, to);
                lastValid.second = valid ? 1.0 : 0.0;
                si_->copyState(lastValid.first, valid ? to : from);
                return valid;
            }
        };

        TEST(Strictness, AContinuousMotionValidatorIsTrusted)
        {
            std::vector<std::uint64_t> states;
            std::vector<double> costs;
            for (const unsigned int strictness : {1U, STRICTNESS})
            {
                const test::PlanningProblem problem(test::realVectorSpace(2, 0.0, 10.0),
                                                    [](const ob::State *) { return true; }, {1.0, 1.0}, {9.0, 1.0});
                problem.si->setMotionValidator(std::make_shared<WallMotionValidator>(problem.si));
                problem.si->setup();
                const auto mfa = planner(problem, strictness, 2);
                ASSERT_EQ(mfa->solve(test::afterCalls(5000)), ob::PlannerStatus::EXACT_SOLUTION);
                states.push_back(problem.counted.states);
                costs.push_back(mfa->bestCost());
            }
            EXPECT_EQ(states[0], states[1]);
            EXPECT_EQ(costs[0], costs[1]);
        }

        TEST(Strictness, ThePapersAlgorithmDoesNotKnowIt)
        {
            std::vector<std::uint64_t> states;
            std::vector<std::vector<double>> costs;
            for (const unsigned int strictness : {1U, STRICTNESS})
            {
                const auto problem = discProblem();
                const auto mfa = planner(*problem, strictness, 5, test::PlannerVariant::Paper);
                costs.emplace_back();
                problem->pdef->setIntermediateSolutionCallback(
                    [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
                    { costs.back().push_back(cost.value()); });
                ASSERT_EQ(mfa->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
                states.push_back(problem->counted.states);
            }
            EXPECT_EQ(states[0], states[1]);
            EXPECT_EQ(costs[0], costs[1]);
        }

        TEST(Strictness, ItChangesNothingWhereNoPathTouches)
        {
            const auto problem = test::freeProblem();
            const auto mfa = planner(*problem, STRICTNESS, 1);
            EXPECT_EQ(mfa->solve(test::afterCalls(100000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_DOUBLE_EQ(mfa->bestCost(), 8.0);
            EXPECT_TRUE(holdsAt(*problem, STRICTNESS));
        }

        TEST(Strictness, PathsOfCarsHold)
        {
            for (const bool symmetric : {false, true})
            {
                for (std::uint32_t seed = 1; seed <= 4; ++seed)
                {
                    const auto space = test::ready(
                        test::bounded(std::make_shared<ob::DubinsStateSpace>(0.5, symmetric), 2, 0.0, 20.0));
                    const test::PlanningProblem problem(
                        space,
                        [](const ob::State *state)
                        {
                            const auto *pose = state->as<ob::SE2StateSpace::StateType>();
                            return pose->getX() < 6.0 || pose->getX() > 14.0 || std::abs(pose->getY() - 10.0) < 0.6;
                        },
                        {1.0, 4.0, 0.0}, {19.0, 16.0, 0.0});
                    const auto mfa = planner(problem, STRICTNESS, seed);
                    ASSERT_EQ(mfa->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION) << seed;
                    EXPECT_TRUE(problem.path().check());
                    EXPECT_TRUE(holdsAt(problem, STRICTNESS)) << seed << (symmetric ? " symmetric" : "");
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
