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

#include "engine/fireflies/WindowSwarm.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        using Frame = WindowSwarm::Frame;

        struct FrameName
        {
            template <typename Info>
            std::string operator()(const Info &tested) const
            {
                return tested.param == Frame::Straight ? "Straight" : "Curved";
            }
        };

        class WindowSwarmTest : public ::testing::TestWithParam<Frame>
        {
        protected:
            WindowSwarmTest()
            {
                settings_.populationSize = 20;
                settings_.generations = 15;
            }

            path::Waypoints path(const std::vector<std::vector<double>> &states) const
            {
                path::Waypoints path(problem_->si->getStateSpace());
                for (const auto &state : states)
                {
                    path.append(problem_->state(state).get());
                }
                return path;
            }

            std::unique_ptr<WindowSwarm> open(const path::Waypoints &path, std::size_t first, std::size_t last,
                                              std::uint64_t seed)
            {
                return WindowSwarm::open({path, first, last, path.length()}, GetParam(), 6,
                                         std::make_shared<const path::StateChart>(problem_->si->getStateSpace()),
                                         evaluator_, settings_, seed);
            }

            static bool never()
            {
                return false;
            }

            void fly(WindowSwarm &window) const
            {
                while (!window.exhausted() && window.found().empty())
                {
                    window.swarm().step(never);
                }
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            path::PathEvaluator evaluator_{problem_->si,
                                           std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si)};
            FireflyOptimizer::Settings settings_;
            // a detour over the wall whose middle vertices leave room below
            path::Waypoints detour_ = path({{1.0, 1.0}, {2.0, 1.0}, {3.0, 8.5}, {7.0, 8.5}, {8.0, 1.0}, {9.0, 1.0}});
        };

        INSTANTIATE_TEST_SUITE_P(Planner, WindowSwarmTest, ::testing::Values(Frame::Straight, Frame::Curved),
                                 FrameName());

        TEST_P(WindowSwarmTest, FindsAValidWayBetweenTheVertices)
        {
            unsigned int found = 0;
            for (std::uint64_t seed = 0; seed < 10; ++seed)
            {
                const auto window = open(detour_, 1, 4, seed);
                ASSERT_NE(window, nullptr);
                fly(*window);
                if (window->found().empty())
                {
                    continue;
                }
                ++found;
                const path::Waypoints whole = window->pathWith(window->found());
                const auto &space = problem_->si->getStateSpace();
                EXPECT_TRUE(space->equalStates(whole[0], detour_[0]));
                EXPECT_TRUE(space->equalStates(whole[1], detour_[1]));
                EXPECT_TRUE(space->equalStates(whole[whole.size() - 2], detour_[4]));
                EXPECT_TRUE(space->equalStates(whole.back(), detour_.back()));
                EXPECT_TRUE(evaluator_.checkPath(whole));
                // longer than the present path by less than the slack
                EXPECT_LT(window->found().length(), window->cost().value() + 0.15 * detour_.length());
            }
            EXPECT_GE(found, 5U);
        }

        TEST_P(WindowSwarmTest, ThePathWithItsOwnPartIsThePath)
        {
            const auto window = open(detour_, 1, 4, 3);
            EXPECT_DOUBLE_EQ(window->cost().value(), window->segment().length());
            const path::Waypoints same = window->pathWith(window->segment());
            ASSERT_EQ(same.size(), detour_.size());
            for (std::size_t i = 0; i < same.size(); ++i)
            {
                EXPECT_TRUE(problem_->si->getStateSpace()->equalStates(same[i], detour_[i]));
            }
        }

        TEST_P(WindowSwarmTest, IsExhaustedAfterItsGenerations)
        {
            const auto window = open(detour_, 0, 5, 3);
            EXPECT_FALSE(window->exhausted());
            // the evaluation of the initial swarm is a separate step
            for (unsigned int k = 0; k < settings_.generations; ++k)
            {
                window->swarm().step(never);
            }
            EXPECT_FALSE(window->exhausted());
            window->swarm().step(never);
            EXPECT_TRUE(window->exhausted());
        }

        TEST_P(WindowSwarmTest, RecombinationFindsWaysToo)
        {
            unsigned int found = 0;
            for (std::uint64_t seed = 0; seed < 10; ++seed)
            {
                const auto window = open(detour_, 1, 4, seed);
                window->swarm().step(never);
                if (!window->recombine(200000))
                {
                    continue;
                }
                ++found;
                EXPECT_TRUE(evaluator_.checkPath(window->pathWith(window->found())));
            }
            EXPECT_GE(found, 5U);
        }

        TEST_P(WindowSwarmTest, WhatRecombinationFoundIsReplacedByWhatIsBetter)
        {
            unsigned int found = 0;
            unsigned int replaced = 0;
            for (std::uint64_t seed = 0; seed < 30; ++seed)
            {
                settings_.generations = 60;
                const auto window = open(detour_, 1, 4, seed);
                if (!window->recombine(200000))
                {
                    continue;
                }
                ++found;
                const double spliced = window->found().length();
                while (!window->exhausted())
                {
                    const double before = window->found().length();
                    window->swarm().step(never);
                    EXPECT_LE(window->found().length(), before);
                }
                replaced += window->found().length() < spliced ? 1 : 0;
                const double best = window->found().length();
                if (window->recombine(200000))
                {
                    EXPECT_LT(window->found().length(), best);
                }
                else
                {
                    EXPECT_EQ(window->found().length(), best);
                }
            }
            EXPECT_GE(found, 10U);
            EXPECT_GE(replaced, 1U);
        }

        /* Length, but infinite for motions that enter the band of the wall below y = 3.4. */
        class LethalBand : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                constexpr int PIECES = 100;
                ob::ScopedState<> state(si_->getStateSpace());
                for (int i = 0; i <= PIECES; ++i)
                {
                    si_->getStateSpace()->interpolate(from, to, static_cast<double>(i) / PIECES, state.get());
                    if (state[0] > 4.5 && state[0] < 5.5 && state[1] < 3.4)
                    {
                        return infiniteCost();
                    }
                }
                return PathLengthOptimizationObjective::motionCost(from, to);
            }
        };

        TEST_P(WindowSwarmTest, WhatReplacesASegmentOfInfiniteCostHasAFiniteOne)
        {
            problem_ = test::freeProblem();
            const auto objective = std::make_shared<LethalBand>(problem_->si);
            path::PathEvaluator evaluator(problem_->si, objective);
            const path::Waypoints through = path({{1.0, 1.0}, {3.0, 1.0}, {5.0, 2.0}, {7.0, 1.0}, {9.0, 1.0}});
            const double cost = evaluator.cost(through).value();
            ASSERT_EQ(cost, std::numeric_limits<double>::infinity());
            unsigned int found = 0;
            for (std::uint64_t seed = 0; seed < 10; ++seed)
            {
                const auto window =
                    WindowSwarm::open({through, 0, 4, cost}, GetParam(), 6,
                                      std::make_shared<const path::StateChart>(problem_->si->getStateSpace()),
                                      evaluator, settings_, seed);
                fly(*window);
                if (window->found().empty())
                {
                    continue;
                }
                ++found;
                EXPECT_TRUE(std::isfinite(evaluator.cost(window->found()).value())) << "seed " << seed;
            }
            EXPECT_GE(found, 1U);
        }

        TEST_P(WindowSwarmTest, ASegmentOfFiniteCostInAPathOfInfiniteCostHasASlackOfItsOwn)
        {
            problem_ = test::freeProblem();
            const auto objective = std::make_shared<LethalBand>(problem_->si);
            path::PathEvaluator evaluator(problem_->si, objective);
            const path::Waypoints through = path({{1.0, 1.0}, {2.0, 2.0}, {3.0, 1.0}, {5.0, 2.0}, {9.0, 1.0}});
            const auto chart = std::make_shared<const path::StateChart>(problem_->si->getStateSpace());
            const auto window = WindowSwarm::open({through, 0, 2, std::numeric_limits<double>::infinity()}, GetParam(),
                                                  6, chart, evaluator, settings_, 3);
            EXPECT_DOUBLE_EQ(window->bound(), 1.15 * 2.0 * std::sqrt(2.0));
            // the extreme numbers stand for infinite costs too
            for (const double extreme : {std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()})
            {
                const auto other =
                    WindowSwarm::open({through, 0, 4, extreme}, GetParam(), 6, chart, evaluator, settings_, 3);
                EXPECT_TRUE(std::isfinite(other->bound()));
            }
        }

        TEST_P(WindowSwarmTest, ThereIsNoneWhereSlicesHaveNoCoordinates)
        {
            auto line = std::make_shared<ob::RealVectorStateSpace>(1);
            line->setBounds(0.0, 1.0);
            auto si = std::make_shared<ob::SpaceInformation>(line);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            path::PathEvaluator evaluator(si, std::make_shared<ob::PathLengthOptimizationObjective>(si));
            path::Waypoints path(line);
            ob::ScopedState<ob::RealVectorStateSpace> state(line);
            for (const double x : {0.1, 0.5, 0.9})
            {
                state[0] = x;
                path.append(state.get());
            }
            EXPECT_EQ(WindowSwarm::open({path, 0, 2, 0.8}, GetParam(), 6,
                                        std::make_shared<const path::StateChart>(line), evaluator, settings_, 1),
                      nullptr);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
