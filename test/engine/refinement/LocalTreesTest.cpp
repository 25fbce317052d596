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

#include "engine/refinement/LocalTrees.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        constexpr std::uint64_t PLENTY = 1000000;

        /* Trees in the space of a problem, between its ends. */
        struct Trees
        {
            explicit Trees(std::unique_ptr<test::PlanningProblem> theProblem, std::uint_fast32_t seed = 3)
              : problem(std::move(theProblem))
              , evaluator(problem->si, std::make_shared<ob::PathLengthOptimizationObjective>(problem->si))
              , trees(std::make_shared<const path::StateChart>(problem->si->getStateSpace()), evaluator, seed)
              , from(problem->state({1.0, 1.0}))
              , to(problem->state({9.0, 1.0}))
              , found(problem->si->getStateSpace())
            {
            }

            bool connect(double longest, std::uint64_t work = PLENTY)
            {
                return trees.connect(from.get(), to.get(), longest, work, found);
            }

            const ob::StateSpacePtr &space() const
            {
                return problem->si->getStateSpace();
            }

            std::unique_ptr<test::PlanningProblem> problem;
            path::PathEvaluator evaluator;
            LocalTrees trees;
            ob::ScopedState<> from;
            ob::ScopedState<> to;
            path::Waypoints found;
        };

        void expectConnection(const path::Waypoints &found, const ob::State *from, const ob::State *to,
                              const ob::SpaceInformationPtr &si)
        {
            ASSERT_GE(found.size(), 3U) << "the straight motion";
            EXPECT_TRUE(si->equalStates(found.front(), from));
            EXPECT_TRUE(si->equalStates(found.back(), to));
            for (std::size_t i = 1; i < found.size(); ++i)
            {
                EXPECT_TRUE(si->satisfiesBounds(found[i]));
                EXPECT_TRUE(si->checkMotion(found[i - 1], found[i])) << "motion " << i;
            }
        }

        TEST(LocalTrees, FindAWayAroundWithinTheEllipsoid)
        {
            const double longest = 1.2 * test::wallOptimum();
            std::size_t states = 0;
            for (std::uint_fast32_t seed = 1; seed <= 30; ++seed)
            {
                Trees trees(test::wallProblem(), seed);
                ASSERT_TRUE(trees.connect(longest)) << "seed " << seed;
                expectConnection(trees.found, trees.from.get(), trees.to.get(), trees.problem->si);
                for (std::size_t i = 0; i < trees.found.size(); ++i)
                {
                    EXPECT_LE(trees.space()->distance(trees.from.get(), trees.found[i]) +
                                  trees.space()->distance(trees.found[i], trees.to.get()),
                              longest + 1e-9);
                    // a fifth of the extent
                    EXPECT_LE(trees.space()->distance(trees.found[i > 0 ? i - 1 : 0], trees.found[i]),
                              2.0 * std::sqrt(2.0) + 1e-9);
                    states += test::coordinate(trees.found[i], 1) > 6.0 ? 1 : 0;
                }
            }
            EXPECT_GE(states, 30U) << "over the wall";
        }

        TEST(LocalTrees, TheEllipsoidIsExploredUpToItsEdges)
        {
            // ellipses that are smaller than the motions of the trees may be, with half axes of 0.5 and 0.4
            for (const double angle : {0.0, 0.7, 1.5, 3.1, -2.0})
            {
                const double cosine = std::cos(angle);
                const double sine = std::sin(angle);
                Trees trees(test::freeProblem());
                trees.from = std::vector<double>{5.0 - 0.3 * cosine, 5.0 - 0.3 * sine};
                trees.to = std::vector<double>{5.0 + 0.3 * cosine, 5.0 + 0.3 * sine};
                double back = 0.0;
                double ahead = 0.0;
                double right = 0.0;
                double left = 0.0;
                for (int i = 0; i < 500; ++i)
                {
                    ASSERT_TRUE(trees.connect(1.0));
                    for (std::size_t k = 0; k < trees.found.size(); ++k)
                    {
                        const double x = test::coordinate(trees.found[k], 0) - 5.0;
                        const double y = test::coordinate(trees.found[k], 1) - 5.0;
                        back = std::min(back, cosine * x + sine * y);
                        ahead = std::max(ahead, cosine * x + sine * y);
                        right = std::min(right, cosine * y - sine * x);
                        left = std::max(left, cosine * y - sine * x);
                    }
                }
                EXPECT_NEAR(back, -0.48, 0.02) << angle;
                EXPECT_NEAR(ahead, 0.48, 0.02) << angle;
                EXPECT_NEAR(right, -0.38, 0.02) << angle;
                EXPECT_NEAR(left, 0.38, 0.02) << angle;
            }
        }

        TEST(LocalTrees, FindNothingIfTheEllipsoidIsBlocked)
        {
            Trees trees(test::wallProblem());
            EXPECT_FALSE(trees.connect(0.99 * test::wallOptimum(), 20000));
        }

        TEST(LocalTrees, KeepToTheirBudget)
        {
            for (const std::uint64_t budget : {100U, 1000U, 20000U})
            {
                Trees trees(test::closedProblem());
                // of another call, which does not count
                EXPECT_FALSE(trees.connect(30.0, 500));
                const auto before = trees.evaluator.work();
                EXPECT_FALSE(trees.connect(30.0, budget));
                const auto spent = trees.evaluator.work() - before;
                EXPECT_GE(spent, budget);
                // a few motions of at most 20 states
                EXPECT_LT(spent, budget + 300);
            }
            Trees trees(test::freeProblem());
            EXPECT_FALSE(trees.connect(10.0, 0));
        }

        TEST(LocalTrees, StopWithTheCondition)
        {
            Trees trees(test::closedProblem());
            int asked = 0;
            trees.evaluator.setStopCondition([&asked] { return ++asked > 40; });
            EXPECT_FALSE(trees.connect(30.0));
            EXPECT_TRUE(trees.evaluator.interrupted());
            trees.problem->counted.forget();
            EXPECT_FALSE(trees.connect(30.0));
            EXPECT_EQ(trees.problem->counted.states, 0U);
        }

        TEST(LocalTrees, FindTheSameForASeed)
        {
            Trees a(test::wallProblem(), 5);
            Trees b(test::wallProblem(), 5);
            Trees other(test::wallProblem(), 6);
            for (int i = 0; i < 3; ++i)
            {
                ASSERT_TRUE(a.connect(20.0));
                ASSERT_TRUE(b.connect(20.0));
                ASSERT_TRUE(other.connect(20.0));
                ASSERT_EQ(a.found.size(), b.found.size());
                for (std::size_t k = 0; k < a.found.size(); ++k)
                {
                    EXPECT_TRUE(a.space()->equalStates(a.found[k], b.found[k]));
                }
                EXPECT_NE(a.found.length(), other.found.length());
            }
        }

        /* A wall across the square that a draft of most motions does not notice. */
        TEST(LocalTrees, AreCheckedAsDraftsIfTheEvaluatorMakesDrafts)
        {
            Trees trees(std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, 0.0, 10.0),
                [](const ob::State *state) { return std::abs(test::coordinate(state, 0) - 5.1) > 0.02; },
                std::vector<double>{1.0, 1.0}, std::vector<double>{9.0, 1.0}));
            trees.problem->si->setStateValidityCheckingResolution(0.001);
            trees.problem->si->setup();
            EXPECT_FALSE(trees.connect(9.0, 50000));
            const path::StrideScope draft(trees.evaluator, 30);
            ASSERT_TRUE(trees.connect(9.0, 50000));
            EXPECT_TRUE(trees.evaluator.checkPath(trees.found));
            EXPECT_FALSE(trees.problem->si->checkMotion(trees.from.get(), trees.to.get()));
        }

        class LocalTreesInSpaces : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Spaces, LocalTreesInSpaces, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(LocalTreesInSpaces, ConnectRandomStates)
        {
            const auto space = GetParam().make();
            const test::CountingProblem problem(space, [](const ob::State *) { return true; });
            path::PathEvaluator evaluator(problem.si,
                                          std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
            const auto chart = std::make_shared<const path::StateChart>(space);
            LocalTrees trees(chart, evaluator, 7);
            ompl::RNG rng(11);
            ob::ScopedState<> from(space);
            ob::ScopedState<> to(space);
            path::Waypoints found(space);
            for (int i = 0; i < 100; ++i)
            {
                chart->sampleUniform(rng, from.get());
                chart->sampleUniform(rng, to.get());
                // curves of cars near the bounds lead out of them, and make no progress if cut off there
                ASSERT_TRUE(
                    trees.connect(from.get(), to.get(), 1.2 * chart->distance(from.get(), to.get()), 100000, found));
                expectConnection(found, from.get(), to.get(), problem.si);
            }
            // with only a few motions
            for (int i = 0; i < 100; ++i)
            {
                chart->sampleUniform(rng, from.get());
                chart->sampleUniform(rng, to.get());
                const auto before = evaluator.work();
                trees.connect(from.get(), to.get(), 1.2 * chart->distance(from.get(), to.get()), 50, found);
                EXPECT_LT(evaluator.work() - before, 50U + 500U);
            }
            // from a state to itself
            ASSERT_TRUE(trees.connect(from.get(), from.get(), 1.0, 100000, found));
            expectConnection(found, from.get(), from.get(), problem.si);
        }

        /* Cars between two rows of posts, of which a curve and the one back pass different ones. */
        TEST(LocalTrees, MotionsOfACarAreValidInTheirDirection)
        {
            const auto space = test::dubinsSpace(false, 0.7);
            const auto isValid = [](const ob::State *state)
            {
                const auto *pose = state->as<ob::SE2StateSpace::StateType>();
                return std::hypot(std::remainder(pose->getX(), 4.0), std::remainder(pose->getY(), 4.0)) > 1.0;
            };
            const test::CountingProblem problem(space, isValid);
            path::PathEvaluator evaluator(problem.si,
                                          std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
            const auto chart = std::make_shared<const path::StateChart>(space);
            ob::ScopedState<ob::DubinsStateSpace> from(space);
            ob::ScopedState<ob::DubinsStateSpace> to(space);
            path::Waypoints found(space);
            unsigned int connected = 0;
            unsigned int oneWay = 0;
            for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
            {
                LocalTrees trees(chart, evaluator, seed);
                from->setXY(-6.0, -6.0);
                from->setYaw(0.1 * static_cast<double>(seed));
                to->setXY(6.0, 2.0);
                to->setYaw(3.0 - 0.3 * static_cast<double>(seed));
                if (!trees.connect(from.get(), to.get(), 30.0, PLENTY, found))
                {
                    continue;
                }
                ++connected;
                expectConnection(found, from.get(), to.get(), problem.si);
                found.reverse();
                oneWay += evaluator.checkPath(found) ? 0 : 1;
            }
            EXPECT_GT(connected, 15U);
            EXPECT_GT(oneWay, 5U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
