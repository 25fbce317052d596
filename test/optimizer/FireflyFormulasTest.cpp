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

/* The optimiser against the equations: compared with an oracle, and equation by equation. */

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "optimizer/FireflyOracle.h"
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

        using FireflyFormulasVariants = test::FireflyVariants;

        INSTANTIATE_TEST_SUITE_P(Both, FireflyFormulasVariants, ::testing::Values(Variant::FA, Variant::MFA),
                                 test::VariantName());

        TEST_P(FireflyFormulasVariants, FollowsTheFormulasOverAnEpoch)
        {
            const FireflyOracle::Point lower{-4.0, 0.5, -1.0};
            const FireflyOracle::Point upper{6.0, 2.5, 30.0};
            auto settings = small(GetParam());
            settings.gamma = 0.03;
            settings.eta = 1.1;
            for (std::uint64_t seed = 1; seed <= 5; ++seed)
            {
                FireflyOracle oracle({GetParam() == Variant::MFA, 12, 8, 0.03, 0.2, 1.1}, lower, upper, bumpyCost,
                                     seed);
                auto optimizer = makeOptimizer(settings, seed);
                Recorder objective;
                ASSERT_TRUE(optimizer.step(objective, never));
                for (unsigned int t = 0; t < 8; ++t)
                {
                    oracle.generation(t);
                    ASSERT_TRUE(optimizer.step(objective, never));
                    for (unsigned int i = 0; i < 12; ++i)
                    {
                        for (unsigned int k = 0; k < 3; ++k)
                        {
                            ASSERT_NEAR(optimizer.population()(k, i), oracle.points[i][k], 1e-9) << "generation " << t;
                        }
                        ASSERT_NEAR(optimizer.brightness(i).cost, oracle.costs[i], 1e-7);
                    }
                    ASSERT_NEAR(optimizer.bestBrightness().cost, oracle.bestCost, 1e-7);
                }
            }
        }

        TEST(FireflyFormulas, MovesTowardTheBrighterByEquation4And5)
        {
            // Two fireflies without random step: the dimmer ends at x + beta0 exp(-gamma r^2) (y - x), r in tenths of
            // ranges.
            auto settings = small(Variant::FA, 2);
            settings.alpha = 0.0;
            settings.eta = 0.8;
            settings.gamma = 0.02;
            auto optimizer = makeOptimizer(settings);
            optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
            optimizer.inject(Eigen::Vector3d(5.0, 1.5, 25.5));
            Recorder objective([](const std::vector<double> &x) { return x[0]; });
            optimizer.step(objective, never);
            optimizer.step(objective, never);
            // r^2 = (5/1)^2 + (0.5/0.2)^2 + (15.5/3.1)^2 = 56.25; beta = 0.8 exp(-1.125) = 0.259722...
            const double beta = 0.8 * 0.32465246735834974;
            EXPECT_NEAR(optimizer.population()(0, 1), 5.0 - 5.0 * beta, 1e-12);
            EXPECT_NEAR(optimizer.population()(1, 1), 1.5 - 0.5 * beta, 1e-12);
            EXPECT_NEAR(optimizer.population()(2, 1), 25.5 - 15.5 * beta, 1e-12);
            EXPECT_TRUE(optimizer.population().col(0) == Eigen::Vector3d(0.0, 1.0, 10.0));
            EXPECT_EQ(optimizer.evaluations(), 3U);
        }

        TEST(FireflyFormulas, KeepsAPartOfTheAttractionAtAnyDistance)
        {
            auto settings = small(Variant::FA, 2);
            settings.alpha = 0.0;
            settings.gamma = 1e6;
            settings.betaMin = 0.2;
            auto optimizer = makeOptimizer(settings);
            optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
            optimizer.inject(Eigen::Vector3d(5.0, 1.5, 25.0));
            Recorder objective([](const std::vector<double> &x) { return x[0]; });
            optimizer.step(objective, never);
            optimizer.step(objective, never);
            EXPECT_NEAR(optimizer.population()(0, 1), 4.0, 1e-12);
            EXPECT_NEAR(optimizer.population()(2, 1), 22.0, 1e-12);
        }

        TEST(FireflyFormulas, RandomStepIsUniformAndScaledByEachRange)
        {
            // Without attraction a firefly with one brighter neighbour moves by alpha eps, eps in [-1/2, 1/2] of each
            // range.
            auto settings = small(Variant::FA, 2);
            settings.eta = 0.0;
            settings.alpha = 0.1;
            double squares[3] = {0.0, 0.0, 0.0};
            const Eigen::Vector3d start(1.0, 1.5, 15.0);
            const Eigen::Vector3d range(10.0, 2.0, 31.0);
            constexpr int RUNS = 4000;
            for (int run = 0; run < RUNS; ++run)
            {
                auto optimizer = makeOptimizer(settings, 100 + run);
                optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
                optimizer.inject(start);
                Recorder objective([](const std::vector<double> &x) { return x[2]; });
                optimizer.step(objective, never);
                optimizer.step(objective, never);
                for (int k = 0; k < 3; ++k)
                {
                    const double part = (optimizer.population()(k, 1) - start[k]) / range[k] / 0.1;
                    ASSERT_LE(std::abs(part), 0.5 + 1e-12);
                    squares[k] += part * part / RUNS;
                }
            }
            for (const double square : squares)
            {
                EXPECT_NEAR(square, 1.0 / 12.0, 0.004);
            }
        }

        TEST(FireflyFormulas, EquallyBrightFirefliesMoveAtRandomExceptTheFirst)
        {
            auto optimizer = makeOptimizer(small(Variant::FA));
            Recorder flat([](const std::vector<double> &) { return 1.0; });
            optimizer.step(flat, never);
            const Eigen::MatrixXd before = optimizer.population();
            optimizer.step(flat, never);
            EXPECT_TRUE(optimizer.population().col(0) == before.col(0));
            for (int i = 1; i < 12; ++i)
            {
                const Eigen::Vector3d step =
                    (optimizer.population().col(i) - before.col(i)).cwiseQuotient(Eigen::Vector3d(10.0, 2.0, 31.0));
                EXPECT_GT(step.cwiseAbs().maxCoeff(), 0.0);
                EXPECT_LE(step.cwiseAbs().maxCoeff(), 0.1 + 1e-12);
            }
        }

        TEST(FireflyFormulas, TrialVectorsObeyEquations6To12)
        {
            // The population is recovered from the evaluations; no firefly moves, since all are equally bright.
            auto settings = small(Variant::MFA, 8);
            settings.alpha = 0.0;
            const Eigen::VectorXd lower = constant(4, -1e3);
            const Eigen::VectorXd upper = constant(4, 1e3);
            FireflyOptimizer optimizer(settings, lower, upper, 12);
            // Narrow around a far point, so that no trial is clamped.
            for (int i = 0; i < 8; ++i)
            {
                optimizer.inject(Eigen::Vector4d(10.0 + i, 20.0 + i * i, 30.0 - i * i * i / 64.0, 7.0 * std::sin(i)));
            }
            Recorder flat([](const std::vector<double> &) { return 1.0; });
            optimizer.step(flat, never);
            const Eigen::MatrixXd x = optimizer.population();
            const Eigen::VectorXd best = optimizer.best();
            const Eigen::VectorXd worst = x.col(7);
            flat.points.clear();
            flat.hadRival.clear();
            optimizer.step(flat, never);
            ASSERT_EQ(flat.points.size(), 7U + 8U * 5U)
                << "a trial equal to its firefly would be left out; choose another seed";
            unsigned int both = 0;
            for (int i = 0; i < 8; ++i)
            {
                const auto *trial = &flat.points[7 + 5 * static_cast<std::size_t>(i)];
                // (7): F_new2 - F_new1 = l (F_best - F_worst) with one l for all components; F_new1 shows in (8) and
                // (9).
                std::set<long> lambdas;
                for (int j = 0; j < 4; ++j)
                {
                    const bool newIn8 = trial[0][j] != best[j];
                    const bool newIn9 = trial[1][j] != x(j, i);
                    if (newIn8 && newIn9)
                    {
                        EXPECT_EQ(trial[0][j], trial[1][j]);
                        ++both;
                    }
                    EXPECT_TRUE(trial[2][j] == x(j, i) || trial[2][j] == trial[3][j]);
                    if (newIn8 || newIn9)
                    {
                        const double new1 = newIn8 ? trial[0][j] : trial[1][j];
                        lambdas.insert(std::lround(1e9 * (trial[3][j] - new1) / (best[j] - worst[j])));
                    }
                }
                EXPECT_EQ(lambdas.size(), 1U) << "one of four components at least shows F_new1";
                for (const long lambda : lambdas)
                {
                    EXPECT_GE(lambda, 0);
                    EXPECT_LT(lambda, 1000000000);
                }
                // (12): delta F_worst + psi (F_best - F_worst), both in [0, 1).
                Eigen::MatrixXd basis(4, 2);
                basis << worst, best - worst;
                const Eigen::Vector2d weights = basis.colPivHouseholderQr().solve(trial[4]);
                EXPECT_NEAR((basis * weights - trial[4]).norm(), 0.0, 1e-9);
                EXPECT_GE(weights.minCoeff(), -1e-9);
                EXPECT_LT(weights.maxCoeff(), 1.0 + 1e-9);
            }
            EXPECT_GT(both, 4U);
            for (std::size_t k = 0; k < flat.hadRival.size(); ++k)
            {
                EXPECT_EQ(flat.hadRival[k], k >= 7) << "only trial vectors have a rival";
            }
        }

        TEST(FireflyFormulas, DrawsFourDistinctFireflies)
        {
            // The fireflies are the unit vectors, so that the components of a trial are the weights of the fireflies.
            // With N of them the best is e_0 and the worst e_(N-1), and eq. (11) makes of F_n1 + l1 (F_n2 - F_n3) +
            // l2 (F_n3 - F_n4) + l (e_0 - e_(N-1)) the weights 1, l1, l2 - l1, -l2 at four fireflies, and l, -l at two.
            constexpr unsigned int SIZE = 12;
            constexpr unsigned int GENERATIONS = 200;
            auto settings = small(Variant::MFA, SIZE, 2000);
            settings.alpha = 0.0;
            settings.trialVectors = {{false, false, false, true, false}};
            FireflyOptimizer optimizer(settings, constant(SIZE, -10.0), constant(SIZE, 10.0), 5);
            for (unsigned int i = 0; i < SIZE; ++i)
            {
                optimizer.inject(Eigen::VectorXd::Unit(SIZE, i));
            }
            Recorder flat([](const std::vector<double> &) { return 1.0; });
            optimizer.step(flat, never);
            unsigned int readable = 0;
            std::vector<unsigned int> timesFirst(SIZE, 0);
            for (unsigned int generation = 0; generation < GENERATIONS; ++generation)
            {
                flat.points.clear();
                optimizer.step(flat, never);
                ASSERT_EQ(flat.points.size(), SIZE - 1U + SIZE) << "all but the brightest move, then come the trials";
                for (std::size_t k = SIZE - 1; k < flat.points.size(); ++k)
                {
                    const Eigen::VectorXd &trial = flat.points[k];
                    // where best and worst are among the four drawn, their weights cannot be told apart
                    if (trial[0] != -trial[SIZE - 1])
                    {
                        continue;
                    }
                    ++readable;
                    const auto inner = trial.segment(1, SIZE - 2).array();
                    EXPECT_EQ((inner != 0.0).count(), 4);
                    EXPECT_EQ((inner == 1.0).count(), 1) << "F_n1 keeps its whole weight";
                    for (unsigned int i = 1; i + 1 < SIZE; ++i)
                    {
                        timesFirst[i] += trial[i] == 1.0 ? 1 : 0;
                    }
                }
            }
            // neither is drawn in 10 * 9 * 8 * 7 of 12 * 11 * 10 * 9 cases, and then each of ten is as often n1
            const double expected = SIZE * GENERATIONS * 14.0 / 33.0;
            EXPECT_NEAR(readable, expected, 0.1 * expected);
            for (unsigned int i = 1; i + 1 < SIZE; ++i)
            {
                EXPECT_NEAR(timesFirst[i], 0.1 * expected, 0.05 * expected) << "F_" << i;
            }
        }

        TEST(FireflyFormulas, SchedulesEndWhereEquations13And14Say)
        {
            auto optimizer = makeOptimizer(small(Variant::MFA, 5, 10));
            Recorder objective;
            optimizer.step(objective, never);
            EXPECT_DOUBLE_EQ(optimizer.alpha(), 0.2);
            EXPECT_DOUBLE_EQ(optimizer.beta0(), 1.0);
            optimizer.step(objective, never);
            EXPECT_NEAR(optimizer.alpha(), 0.2 * std::pow(1.0 / 20.0, 0.1), 1e-15);
            EXPECT_NEAR(optimizer.beta0(), 0.9, 1e-15);
            for (int t = 1; t < 10; ++t)
            {
                optimizer.step(objective, never);
            }
            EXPECT_NEAR(optimizer.alpha(), 0.2 / 20.0, 1e-15);
            EXPECT_NEAR(optimizer.beta0(), 0.0, 1e-15);

            optimizer.step(objective, never);
            EXPECT_EQ(optimizer.generation(), 11U);
            EXPECT_NEAR(optimizer.alpha(), 0.2 * std::pow(1.0 / 20.0, 0.1), 1e-15)
                << "the second epoch restarts the schedule";
            optimizer.restartEpoch();
            EXPECT_DOUBLE_EQ(optimizer.alpha(), 0.2);
            EXPECT_DOUBLE_EQ(optimizer.beta0(), 1.0);
        }

        TEST(FireflyFormulas, OtherSchedulesEndWhereTheySay)
        {
            using Alpha = FireflyOptimizer::AlphaSchedule;
            const std::pair<Alpha, double> ends[] = {
                {Alpha::Constant, 0.2}, {Alpha::Geometric, 0.01}, {Alpha::Yang, 0.2e-4 / 0.9}, {Alpha::Linear, 0.0}};
            for (const auto &end : ends)
            {
                auto settings = small(Variant::FA, 5, 10);
                settings.alphaSchedule = end.first;
                auto optimizer = makeOptimizer(settings);
                Recorder objective;
                EXPECT_DOUBLE_EQ(optimizer.alpha(), 0.2);
                for (int t = 0; t <= 10; ++t)
                {
                    optimizer.step(objective, never);
                }
                EXPECT_NEAR(optimizer.alpha(), end.second, 1e-15);
                EXPECT_EQ(optimizer.beta0(), 1.0);
            }
            auto settings = small(Variant::MFA, 5, 10);
            settings.alphaSchedule = Alpha::Constant;
            settings.betaSchedule = FireflyOptimizer::BetaSchedule::Constant;
            auto optimizer = makeOptimizer(settings);
            Recorder objective;
            for (int t = 0; t <= 10; ++t)
            {
                optimizer.step(objective, never);
            }
            EXPECT_EQ(optimizer.alpha(), 0.2);
            EXPECT_EQ(optimizer.beta0(), 1.0);
        }

        TEST(FireflyFormulas, AttractionNeverBecomesRepulsion)
        {
            auto settings = small(Variant::MFA, 5, 10);
            settings.eta = 0.35;
            auto optimizer = makeOptimizer(settings);
            Recorder objective;
            for (int t = 0; t <= 10; ++t)
            {
                EXPECT_GE(optimizer.beta0(), 0.0);
                optimizer.step(objective, never);
            }
        }
    }  // namespace
}  // namespace ompl_mfa
