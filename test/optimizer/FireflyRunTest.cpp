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

/* The optimiser over a whole run: evaluations, termination and reproducibility. */

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "optimizer/FireflyProblem.h"

namespace ompl_mfa
{
    namespace
    {
        using test::bumpyCost;
        using test::constant;
        using test::makeOptimizer;
        using test::never;
        using test::Recorder;
        using test::small;
        using test::Variant;

        void expectSame(const FireflyOptimizer &a, const FireflyOptimizer &b)
        {
            EXPECT_TRUE(a.population() == b.population());
            for (unsigned int i = 0; i < a.settings().populationSize; ++i)
            {
                EXPECT_EQ(a.brightness(i).cost, b.brightness(i).cost);
            }
            EXPECT_TRUE(a.best() == b.best());
            EXPECT_EQ(a.bestBrightness().cost, b.bestBrightness().cost);
            EXPECT_EQ(a.evaluations(), b.evaluations());
            EXPECT_EQ(a.generation(), b.generation());
        }

        using FireflyRunVariants = test::FireflyVariants;

        INSTANTIATE_TEST_SUITE_P(Both, FireflyRunVariants, ::testing::Values(Variant::FA, Variant::MFA),
                                 test::VariantName());

        TEST(FireflyRun, EpochEndKeepsTheBest)
        {
            auto optimizer = makeOptimizer(small(Variant::MFA, 10, 5));
            Recorder objective;
            for (int t = 0; t <= 5; ++t)
            {
                optimizer.step(objective, never);
            }
            const double before = optimizer.bestBrightness().cost;
            const double brightestCost = optimizer.brightness(optimizer.brightestIndex()).cost;
            optimizer.step(objective, never);
            EXPECT_LE(optimizer.bestBrightness().cost, before);
            EXPECT_LE(optimizer.brightness(optimizer.brightestIndex()).cost, brightestCost);
        }

        TEST_P(FireflyRunVariants, IsDeterministicInItsSeed)
        {
            auto a = makeOptimizer(small(GetParam()), 42);
            auto b = makeOptimizer(small(GetParam()), 42);
            auto c = makeOptimizer(small(GetParam()), 43);
            Recorder objective;
            for (int t = 0; t < 10; ++t)
            {
                a.step(objective, never);
                b.step(objective, never);
                c.step(objective, never);
            }
            expectSame(a, b);
            EXPECT_FALSE(a.population() == c.population());
        }

        TEST_P(FireflyRunVariants, ResumesAtTheVeryEvaluation)
        {
            auto whole = makeOptimizer(small(GetParam()), 9);
            auto interrupted = makeOptimizer(small(GetParam()), 9);
            Recorder objective;
            Recorder same;
            for (int t = 0; t < 6; ++t)
            {
                whole.step(objective, never);
            }
            for (int t = 0; t < 6; ++t)
            {
                // Interrupted after every evaluation.
                std::uint64_t limit = interrupted.evaluations();
                while (!interrupted.step(same, [&] { return interrupted.evaluations() >= limit; }))
                {
                    ASSERT_EQ(interrupted.evaluations(), limit);
                    ++limit;
                }
            }
            expectSame(whole, interrupted);
            ASSERT_EQ(objective.points.size(), same.points.size());
            for (std::size_t k = 0; k < same.points.size(); ++k)
            {
                EXPECT_TRUE(objective.points[k] == same.points[k]);
            }
        }

        TEST(FireflyRun, AsksStopBeforeEveryEvaluation)
        {
            auto optimizer = makeOptimizer(small(Variant::MFA));
            Recorder objective;
            std::uint64_t asked = 0;
            for (int t = 0; t < 5; ++t)
            {
                optimizer.step(objective, [&asked] { return ++asked, false; });
            }
            EXPECT_EQ(asked, optimizer.evaluations());
            EXPECT_EQ(asked, objective.points.size());
        }

        /* Stops at every evaluation of the condition but the one after each stop, so that a run is interrupted wherever
           it can be. */
        class EverySecond
        {
        public:
            bool operator()()
            {
                stops_ = !stops_;
                return stops_;
            }

        private:
            bool stops_{false};
        };

        TEST_P(FireflyRunVariants, InterruptedAtEveryQuestionARunIsTheSame)
        {
            // large enough to be interrupted while it places, moves and sorts as well
            const auto make = []
            { return FireflyOptimizer(small(GetParam(), 150, 4), constant(40, -3.0), constant(40, 5.0), 9); };
            auto whole = make();
            auto interrupted = make();
            Recorder objective;
            Recorder same;
            EverySecond stop;
            std::uint64_t interruptions = 0;
            for (int t = 0; t < 6; ++t)
            {
                whole.step(objective, never);
                while (!interrupted.step(same, std::ref(stop)))
                {
                    ++interruptions;
                }
                expectSame(whole, interrupted);
                EXPECT_EQ(whole.order(), interrupted.order());
            }
            EXPECT_GT(interruptions, interrupted.evaluations() + 5 * 150 * 149 / 2 * 40 / 5000);
            ASSERT_EQ(objective.points.size(), same.points.size());
            for (std::size_t k = 0; k < same.points.size(); ++k)
            {
                ASSERT_TRUE(objective.points[k] == same.points[k]);
            }
        }

        /* How often the stop condition is evaluated before the first evaluation, between each two and after the last of
           a step. */
        struct Questions
        {
            std::uint64_t beforeTheFirst;
            std::uint64_t between;  ///< the most
            std::uint64_t afterTheLast;
        };

        Questions questionsOfAStep(FireflyOptimizer &optimizer)
        {
            std::uint64_t asked = 0;
            std::uint64_t last = 0;
            bool any = false;
            Questions questions{0, 0, 0};
            Recorder objective(
                [&](const std::vector<double> &x)
                {
                    if (any)
                    {
                        questions.between = std::max(questions.between, asked - last);
                    }
                    else
                    {
                        questions.beforeTheFirst = asked;
                    }
                    any = true;
                    last = asked;
                    return bumpyCost(x);
                });
            EXPECT_TRUE(optimizer.step(objective, [&asked] { return ++asked, false; }));
            EXPECT_TRUE(any);
            questions.afterTheLast = asked - last;
            return questions;
        }

        TEST(FireflyRun, AsksStopWhileItPlacesMovesAndSortsALargePopulation)
        {
            constexpr unsigned int SIZE = 4000;
            constexpr unsigned int DIMENSION = 20;
            // at most so many operations between two evaluations of the condition: a tenth of a millisecond of work
            constexpr std::uint64_t BETWEEN = 8192;
            FireflyOptimizer optimizer(small(Variant::FA, SIZE), constant(DIMENSION, -3.0), constant(DIMENSION, 5.0),
                                       2);
            const Questions initial = questionsOfAStep(optimizer);
            EXPECT_GE(initial.beforeTheFirst, SIZE * DIMENSION / BETWEEN);
            // sorting so many compares each with others about 11 times
            EXPECT_GE(initial.afterTheLast, SIZE * 11 / BETWEEN);
            const Questions moves = questionsOfAStep(optimizer);
            EXPECT_GE(moves.beforeTheFirst, std::uint64_t(SIZE) * (SIZE - 1) / 2 * DIMENSION / BETWEEN);
            EXPECT_GE(moves.afterTheLast, SIZE * 11 / BETWEEN);
        }

        TEST(FireflyRun, AsksStopInTheMovesOfOneFirefly)
        {
            // the dimmest two fireflies make 149 and 148 moves, of 3000 coordinates each
            FireflyOptimizer optimizer(small(Variant::FA, 150), constant(3000, -3.0), constant(3000, 5.0), 2);
            questionsOfAStep(optimizer);
            EXPECT_GE(questionsOfAStep(optimizer).beforeTheFirst, 150U * 149U / 2U * 3000U / 8192U);
        }

        TEST(FireflyRun, AsksStopWhileItMakesTrialVectorsThatAreNotEvaluated)
        {
            auto settings = small(Variant::MFA, 2000);
            settings.trialVectors = {{false, false, false, false, false}};
            settings.alpha = 0.0;
            FireflyOptimizer optimizer(settings, constant(30, -3.0), constant(30, 5.0), 2);
            questionsOfAStep(optimizer);
            EXPECT_GE(questionsOfAStep(optimizer).afterTheLast, 2000U * 5U * 30U / 8192U);
        }

        TEST(FireflyRun, StoppedBeforeTheFirstEvaluationItHasNothing)
        {
            auto optimizer = makeOptimizer(small(Variant::MFA));
            Recorder objective;
            EXPECT_FALSE(optimizer.step(objective, [] { return true; }));
            EXPECT_EQ(optimizer.evaluations(), 0U);
            EXPECT_FALSE(optimizer.bestBrightness().isFeasible());
            EXPECT_EQ(optimizer.best().size(), 3);
        }

        TEST_P(FireflyRunVariants, ZeroGenerationsAreTheInitialPopulation)
        {
            auto optimizer = makeOptimizer(small(GetParam()));
            Recorder objective;
            EXPECT_TRUE(optimizer.step(objective, never));
            EXPECT_EQ(optimizer.generation(), 0U);
            EXPECT_EQ(optimizer.evaluations(), 12U);
            const Eigen::MatrixXd initial = optimizer.population();
            ASSERT_EQ(objective.points.size(), 12U);
            for (unsigned int i = 0; i < 12; ++i)
            {
                EXPECT_TRUE(objective.points[i] == initial.col(i));
            }
            double lowest = INFINITY;
            for (unsigned int i = 0; i < 12; ++i)
            {
                EXPECT_EQ(optimizer.brightness(i).cost, bumpyCost({&initial(0, i), &initial(0, i) + 3}));
                lowest = std::min(lowest, optimizer.brightness(i).cost);
            }
            EXPECT_EQ(optimizer.bestBrightness().cost, lowest);
            EXPECT_EQ(optimizer.brightness(optimizer.brightestIndex()).cost, lowest);
        }

        TEST(FireflyRun, InitialPopulationFillsTheBoxUniformly)
        {
            FireflyOptimizer optimizer(small(Variant::FA, 20000), Eigen::Vector2d(-3.0, 100.0),
                                       Eigen::Vector2d(1.0, 100.5), 1);
            Recorder objective;
            ASSERT_TRUE(optimizer.step(objective, never));
            const Eigen::MatrixXd unit = ((optimizer.population().colwise() - optimizer.lower()).array().colwise() /
                                          (optimizer.upper() - optimizer.lower()).array())
                                             .matrix();
            EXPECT_GE(unit.minCoeff(), 0.0);
            EXPECT_LE(unit.maxCoeff(), 1.0);
            for (int k = 0; k < 2; ++k)
            {
                EXPECT_NEAR(unit.row(k).mean(), 0.5, 0.01);
                EXPECT_NEAR(unit.row(k).squaredNorm() / 20000, 1.0 / 3.0, 0.01);
            }
        }

        TEST_P(FireflyRunVariants, NeverLeavesTheBox)
        {
            // The optimum lies outside: every move and trial pushes against the bounds.
            auto settings = small(GetParam());
            settings.alpha = 1.0;
            settings.eta = 2.0;
            auto optimizer = makeOptimizer(settings);
            Recorder objective([](const std::vector<double> &x) { return x[0] + x[1] - x[2]; });
            for (int t = 0; t < 20; ++t)
            {
                optimizer.step(objective, never);
            }
            for (const auto &x : objective.points)
            {
                ASSERT_TRUE((x.array() >= optimizer.lower().array()).all());
                ASSERT_TRUE((x.array() <= optimizer.upper().array()).all());
            }
            EXPECT_TRUE(optimizer.best() == Eigen::Vector3d(-4.0, 0.5, 30.0)) << "the corner is reached exactly";
        }

        TEST_P(FireflyRunVariants, BestSoFarIsMonotoneAndTheBestOfAll)
        {
            auto settings = small(GetParam());
            settings.alpha = 1.0;
            auto optimizer = makeOptimizer(settings);
            double lowest = INFINITY;
            Recorder objective(
                [&lowest](const std::vector<double> &x)
                {
                    lowest = std::min(lowest, bumpyCost(x));
                    return bumpyCost(x);
                });
            double previous = INFINITY;
            for (int t = 0; t < 30; ++t)
            {
                optimizer.step(objective, never);
                EXPECT_LE(optimizer.bestBrightness().cost, previous);
                previous = optimizer.bestBrightness().cost;
                EXPECT_EQ(previous, lowest);
                const auto &best = optimizer.best();
                EXPECT_EQ(bumpyCost({best.data(), best.data() + best.size()}), lowest);
            }
        }

        TEST(FireflyRun, SpendsAtMostOneAndSixEvaluationsAFirefly)
        {
            for (const auto variant : {Variant::FA, Variant::MFA})
            {
                auto optimizer = makeOptimizer(small(variant));
                Recorder objective;
                optimizer.step(objective, never);
                for (int t = 0; t < 20; ++t)
                {
                    const auto before = optimizer.evaluations();
                    optimizer.step(objective, never);
                    const auto spent = optimizer.evaluations() - before;
                    if (variant == Variant::FA)
                    {
                        EXPECT_EQ(spent, 11U);
                    }
                    else
                    {
                        EXPECT_LE(spent, 11U + 60U);
                    }
                }
            }
        }

        TEST(FireflyRun, LeavesOutTheTrialVectorsThatAreSwitchedOff)
        {
            auto settings = small(Variant::MFA);
            settings.trialVectors = {{false, false, false, false, false}};
            settings.alphaSchedule = FireflyOptimizer::AlphaSchedule::Constant;
            settings.betaSchedule = FireflyOptimizer::BetaSchedule::Constant;
            auto optimizer = makeOptimizer(settings);
            Recorder objective;
            for (int t = 0; t <= 4; ++t)
            {
                optimizer.step(objective, never);
            }
            EXPECT_EQ(optimizer.evaluations(), 12U + 4U * 11U);
        }

        TEST(FireflyRun, ACoordinateWithoutRangeStaysPut)
        {
            for (const auto variant : {Variant::FA, Variant::MFA})
            {
                FireflyOptimizer optimizer(small(variant), Eigen::Vector2d(-1.0, 7.0), Eigen::Vector2d(1.0, 7.0), 2);
                Recorder objective;
                for (int t = 0; t <= 10; ++t)
                {
                    optimizer.step(objective, never);
                }
                EXPECT_TRUE((optimizer.population().row(1).array() == 7.0).all());
                EXPECT_TRUE(optimizer.population().allFinite());
            }
        }

        TEST(FireflyRun, FindsTheOptimumOfEquation19)
        {
            // -f, eq. (19), over [-5, 5]^2 with the paper's settings.
            Recorder objective(
                [](const std::vector<double> &x)
                {
                    const double squared = x[0] * x[0] + x[1] * x[1];
                    return squared == 0.0 ? -1.0 : -std::sin(squared) / squared;
                });
            std::vector<int> near;
            for (std::uint64_t seed = 1; seed <= 30; ++seed)
            {
                FireflyOptimizer optimizer({}, constant(2, -5.0), constant(2, 5.0), seed);
                for (int t = 0; t <= 50; ++t)
                {
                    optimizer.step(objective, never);
                }
                near.push_back(static_cast<int>((optimizer.population().colwise().norm().array() <= 0.5).count()));
            }
            std::sort(near.begin(), near.end());
            EXPECT_GE(near[14], 95);
        }
    }  // namespace
}  // namespace ompl_mfa
