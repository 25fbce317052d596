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

#include "engine/fireflies/Swarm.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        class SwarmTest : public ::testing::Test
        {
        protected:
            SwarmTest()
            {
                settings_.populationSize = 10;
                settings_.generations = 5;
            }

            SliceFrame frame() const
            {
                return SliceFrame::straight(std::make_shared<const path::StateChart>(problem_->si->getStateSpace()),
                                            problem_->state({1.0, 1.0}).get(), problem_->state({9.0, 1.0}).get(), 4);
            }

            Swarm makeSwarm(std::uint64_t seed, Swarm::Coordinates coordinates = Swarm::Coordinates::Offsets)
            {
                return {frame(),
                        coordinates,
                        evaluator_,
                        settings_,
                        seed,
                        [this](const path::Waypoints &, const Brightness &brightness) { costs_.push_back(brightness.cost); }};
            }

            static bool never()
            {
                return false;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            path::PathEvaluator evaluator_{problem_->si,
                                           std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si)};
            FireflyOptimizer::Settings settings_;
            std::vector<double> costs_;
        };

        TEST_F(SwarmTest, CountsEpochsAndEvaluationsAcrossThem)
        {
            Swarm swarm = makeSwarm(3);
            std::uint64_t before = 0;
            for (int i = 0; i < 25; ++i)
            {
                EXPECT_TRUE(swarm.step(never));
                EXPECT_GT(swarm.evaluations(), before);
                before = swarm.evaluations();
            }
            // the evaluation of the initial swarm is a separate step before 5 generations
            EXPECT_EQ(swarm.epoch(), 25U / 6U);
        }

        TEST_F(SwarmTest, TheBestSurvivesTheEndOfAnEpoch)
        {
            Swarm swarm = makeSwarm(3);
            while (!swarm.fireflies().bestBrightness().isFeasible() || swarm.fireflies().generation() < 5)
            {
                swarm.step(never);
            }
            const unsigned int epoch = swarm.epoch();
            const double best = swarm.fireflies().bestBrightness().cost;
            swarm.step(never);
            EXPECT_EQ(swarm.epoch(), epoch + 1);
            EXPECT_LE(swarm.fireflies().bestBrightness().cost, best);
        }

        TEST_F(SwarmTest, AnInjectedPathIsEvaluated)
        {
            // over the corners of the wall, as short as slices at x = 3, 5, 7 allow
            path::Waypoints path(problem_->si->getStateSpace());
            for (const auto &[x, y] :
                 std::vector<std::pair<double, double>>{{1, 1}, {3, 4.3}, {5, 7.6}, {7, 4.3}, {9, 1}})
            {
                path.append(problem_->state({x, y}).get());
            }
            Swarm swarm = makeSwarm(3);
            swarm.inject(path);
            swarm.step(never);
            EXPECT_LE(swarm.fireflies().bestBrightness().cost, evaluator_.cost(path).value() + 1e-9);
            EXPECT_FALSE(costs_.empty());
        }

        TEST_F(SwarmTest, TheSeedDecidesTheRun)
        {
            const auto population = [this](std::uint64_t seed)
            {
                Swarm swarm = makeSwarm(seed);
                for (int i = 0; i < 9; ++i)
                {
                    swarm.step(never);
                }
                return Eigen::MatrixXd(swarm.fireflies().population());
            };
            EXPECT_EQ(population(3), population(3));
            EXPECT_NE(population(3), population(4));
        }

        TEST_F(SwarmTest, FirefliesInModesAreSmoothPathsOverTheSameSlices)
        {
            const auto meanLength = [this](Swarm::Coordinates coordinates)
            {
                Swarm swarm = makeSwarm(3, coordinates);
                swarm.step(never);
                path::Waypoints path(problem_->si->getStateSpace());
                double sum = 0.0;
                for (Eigen::Index i = 0; i < swarm.fireflies().population().cols(); ++i)
                {
                    swarm.pathOf(i, path);
                    EXPECT_EQ(path.size(), swarm.frame().slices() + 2);
                    sum += path.length();
                }
                return sum / static_cast<double>(swarm.fireflies().population().cols());
            };
            EXPECT_LT(meanLength(Swarm::Coordinates::Modes), 0.9 * meanLength(Swarm::Coordinates::Offsets));
        }

        /* A bound that no valid path meets: fireflies that were valid before must no longer lead the swarm. */
        TEST_F(SwarmTest, ABoundThatMovesMeasuresTheWholeSwarm)
        {
            for (std::uint64_t seed = 1; seed <= 5; ++seed)
            {
                settings_.generations = 100;
                Swarm swarm = makeSwarm(seed);
                while (!swarm.fireflies().bestBrightness().isFeasible())
                {
                    ASSERT_TRUE(swarm.step(never));
                }
                ASSERT_GE(swarm.fireflies().bestBrightness().cost, test::wallOptimum());
                swarm.setBound(0.9 * test::wallOptimum());
                for (int i = 0; i < 20; ++i)
                {
                    swarm.step(never);
                }
                const FireflyOptimizer &fireflies = swarm.fireflies();
                EXPECT_LT(fireflies.bestBrightness().cost, 0.9 * test::wallOptimum()) << "seed " << seed;
                EXPECT_LT(fireflies.brightness(fireflies.brightestIndex()).cost, 0.9 * test::wallOptimum());
            }
        }

        /* The numbers in [0, 1] drawn for the first offsets of an epoch's fireflies, or for the fresh ones of
           recombination, in a frame with one slice. */
        class SwarmStreams : public ::testing::Test
        {
        protected:
            class Recording : public ob::PathLengthOptimizationObjective
            {
            public:
                using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

                ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
                {
                    // the cost of the straight motion from start to goal is computed for its bound
                    if (test::coordinate(from, 0) == 1.0 && test::coordinate(to, 0) < 9.0)
                    {
                        ends.insert(std::llround(1e9 * test::coordinate(to, 1) / 10.0));
                    }
                    return PathLengthOptimizationObjective::motionCost(from, to);
                }

                mutable std::set<long long> ends;
            };

            std::unique_ptr<Swarm> makeSwarm(std::uint64_t seed)
            {
                FireflyOptimizer::Settings settings;
                settings.populationSize = 30;
                settings.generations = 1;
                return std::make_unique<Swarm>(
                    SliceFrame::straight(std::make_shared<const path::StateChart>(problem_->si->getStateSpace()),
                                         problem_->state({1.0, 5.0}).get(), problem_->state({9.0, 5.0}).get(), 2),
                    Swarm::Coordinates::Offsets, evaluator_, settings, seed,
                    [](const path::Waypoints &, const Brightness &) {});
            }

            std::set<long long> evaluated(Swarm &swarm)
            {
                objective_->ends.clear();
                EXPECT_TRUE(swarm.step([] { return false; }));
                return std::exchange(objective_->ends, {});
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::freeProblem();
            std::shared_ptr<Recording> objective_ = std::make_shared<Recording>(problem_->si);
            path::PathEvaluator evaluator_{problem_->si, objective_};
        };

        TEST_F(SwarmStreams, EpochsAndRecombinationDrawDifferentNumbers)
        {
            std::set<long long> all;
            std::size_t drawn = 0;
            const auto add = [&](const std::set<long long> &numbers)
            {
                drawn += numbers.size();
                all.insert(numbers.begin(), numbers.end());
            };
            for (const std::uint64_t seed : {1U, 2U, 8U})
            {
                const auto swarm = makeSwarm(seed);
                const std::set<long long> first = evaluated(*swarm);
                EXPECT_EQ(first.size(), 30U);
                add(first);
                // the candidates are the brightest 20, already evaluated, and 16 fresh ones
                objective_->ends.clear();
                path::Waypoints found(problem_->si->getStateSpace());
                swarm->recombine(found, std::numeric_limits<double>::infinity(), 1, found);
                std::set<long long> fresh;
                std::set_difference(objective_->ends.begin(), objective_->ends.end(), first.begin(), first.end(),
                                    std::inserter(fresh, fresh.end()));
                EXPECT_EQ(fresh.size(), 16U);
                add(fresh);
                evaluated(*swarm);
                // six of the next epoch's fireflies come from the previous swarm
                std::set<long long> second = evaluated(*swarm);
                ASSERT_EQ(swarm->epoch(), 1U);
                for (int i = 0; i < 6; ++i)
                {
                    path::Waypoints path(problem_->si->getStateSpace());
                    swarm->pathOf(i, path);
                    second.erase(std::llround(1e9 * test::coordinate(path[1], 1) / 10.0));
                }
                EXPECT_EQ(second.size(), 24U);
                add(second);
            }
            EXPECT_EQ(all.size(), drawn);
        }

        TEST_F(SwarmTest, CountsTheMovesOfALargeSwarmAsWork)
        {
            settings_.populationSize = 400;
            Swarm swarm = makeSwarm(3);
            ASSERT_TRUE(swarm.step(never));
            const std::uint64_t before = evaluator_.work();
            std::uint64_t moved = 0;
            // until the first evaluation of the generation
            swarm.step(
                [&]
                {
                    moved = evaluator_.work() - before;
                    return swarm.evaluations() > 400;
                });
            // 400 * 399 / 2 moves of 3 coordinates
            EXPECT_GT(moved, 400U * 399U / 2U * 3U / 100U);
        }

        TEST_F(SwarmTest, StopsBeforeAnyEvaluation)
        {
            Swarm swarm = makeSwarm(3);
            EXPECT_FALSE(swarm.step([] { return true; }));
            EXPECT_EQ(swarm.evaluations(), 0U);
            int left = 4;
            EXPECT_FALSE(swarm.step([&left] { return left-- == 0; }));
            EXPECT_EQ(swarm.evaluations(), 4U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
