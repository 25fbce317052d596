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

/* Inputs of the optimiser: orders of brightness, injected points, settings and boxes. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "optimizer/FireflyProblem.h"

namespace ompl_mfa
{
    namespace
    {
        using test::constant;
        using test::makeOptimizer;
        using test::never;
        using test::Recorder;
        using test::small;
        using test::Variant;

        std::string refusal(const FireflyOptimizer::Settings &settings)
        {
            try
            {
                settings.validate();
            }
            catch (const std::invalid_argument &error)
            {
                return error.what();
            }
            return "";
        }

        TEST(FireflyInputs, RanksFeasibleBeforeLessViolated)
        {
            class Violated : public ObjectiveFunction
            {
            public:
                Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
                {
                    return {std::max(0.0, x[0] - 1.0), -x[0]};
                }
            } objective;
            FireflyOptimizer optimizer(small(Variant::MFA, 20, 30), constant(1, -10.0), constant(1, 10.0), 4);
            for (int t = 0; t <= 60; ++t)
            {
                optimizer.step(objective, never);
            }
            EXPECT_TRUE(optimizer.bestBrightness().isFeasible());
            EXPECT_NEAR(optimizer.best()[0], 1.0, 1e-2);
            EXPECT_LE(optimizer.best()[0], 1.0);
        }

        TEST(FireflyInputs, EveryPointIsPreparedBeforeItIsEvaluated)
        {
            class Prepared : public ObjectiveFunction
            {
            public:
                void prepare(const Eigen::Ref<const Eigen::MatrixXd> &points, const std::vector<bool> &wanted) override
                {
                    ASSERT_EQ(static_cast<std::size_t>(points.cols()), wanted.size());
                    points_.clear();
                    for (Eigen::Index i = 0; i < points.cols(); ++i)
                    {
                        if (wanted[static_cast<std::size_t>(i)])
                        {
                            points_.emplace_back(points.col(i));
                        }
                    }
                }

                Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
                {
                    unprepared += std::find(points_.begin(), points_.end(), x) == points_.end() ? 1 : 0;
                    return {0.0, x.squaredNorm()};
                }

                int unprepared{0};

            private:
                std::vector<Eigen::VectorXd> points_;
            };
            for (const Variant variant : {Variant::FA, Variant::MFA})
            {
                Prepared objective;
                FireflyOptimizer optimizer(small(variant, 8, 10), constant(3, -3.0), constant(3, 10.0), 4);
                for (int t = 0; t <= 10; ++t)
                {
                    optimizer.step(objective, never);
                }
                EXPECT_EQ(objective.unprepared, 0);
                EXPECT_GT(optimizer.evaluations(), 50U);
            }
        }

        TEST(FireflyInputs, OrdersAsTheObjectiveSays)
        {
            class Greatest : public ObjectiveFunction
            {
            public:
                Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
                {
                    return {0.0, -x.squaredNorm()};
                }
                bool isBrighter(const Brightness &a, const Brightness &b) const override
                {
                    return a.violation < b.violation || (a.violation == b.violation && a.cost > b.cost);
                }
            } objective;
            FireflyOptimizer optimizer(small(Variant::MFA, 20, 30), constant(2, -3.0), constant(2, 10.0), 4);
            for (int t = 0; t <= 30; ++t)
            {
                optimizer.step(objective, never);
            }
            EXPECT_LT(optimizer.best().norm(), 0.05);
        }

        TEST(FireflyInputs, TakesNanAsInfinitelyDim)
        {
            Recorder objective([](const std::vector<double> &x) { return x[0] > 0.0 ? std::nan("") : x[0] * x[0]; });
            auto optimizer = makeOptimizer(small(Variant::MFA, 20, 30));
            for (int t = 0; t <= 30; ++t)
            {
                optimizer.step(objective, never);
            }
            EXPECT_TRUE(optimizer.bestBrightness().isFeasible());
            EXPECT_LT(optimizer.bestBrightness().cost, 1e-2);
        }

        TEST(FireflyInputs, InjectedPointReplacesTheDimmest)
        {
            auto optimizer = makeOptimizer(small(Variant::MFA));
            Recorder objective;
            optimizer.step(objective, never);
            const unsigned int dimmest = optimizer.order().back();
            const Eigen::Vector3d dull(0.1, 1.1, 1.1);
            const double second = optimizer.brightness(optimizer.order()[10]).cost;
            optimizer.inject(dull, {0.0, second}, objective);
            EXPECT_TRUE(optimizer.population().col(dimmest) == dull);
            EXPECT_FALSE(optimizer.best() == dull);

            const Eigen::Vector3d bright(-99.0, 1.0, 2.0);
            optimizer.inject(bright, {0.0, -1e9}, objective);
            EXPECT_TRUE(optimizer.best() == Eigen::Vector3d(-4.0, 1.0, 2.0)) << "clamped to the box";
            EXPECT_EQ(optimizer.bestBrightness().cost, -1e9);
            EXPECT_EQ(optimizer.brightness(optimizer.brightestIndex()).cost, -1e9);
            optimizer.step(objective, never);
            EXPECT_EQ(optimizer.bestBrightness().cost, -1e9);
            EXPECT_TRUE(optimizer.population().col(optimizer.brightestIndex()) == optimizer.best());
        }

        /* Orders by the distance of the cost from a target, which may move. */
        class Aimed : public ObjectiveFunction
        {
        public:
            Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
            {
                return {0.0, x[0]};
            }

            bool isBrighter(const Brightness &a, const Brightness &b) const override
            {
                return std::abs(a.cost - aim) < std::abs(b.cost - aim);
            }

            double aim{-4.0};
        };

        TEST(FireflyInputs, AnOrderThatChangesIsThatOfTheWholePopulation)
        {
            for (const std::uint64_t evaluations : {0U, 5U, 12U, 15U, 30U})
            {
                auto optimizer = makeOptimizer(small(Variant::MFA), 4);
                Aimed objective;
                optimizer.step(objective, never);
                const std::uint64_t limit = optimizer.evaluations() + evaluations;
                optimizer.step(objective, [&] { return optimizer.evaluations() >= limit; });
                objective.aim = 6.0;
                optimizer.orderChanged(objective);
                const auto isBest = [&]
                {
                    for (unsigned int i = 0; i < 12; ++i)
                    {
                        EXPECT_FALSE(objective.isBrighter(optimizer.brightness(i), optimizer.bestBrightness()));
                    }
                };
                isBest();
                ASSERT_TRUE(optimizer.step(objective, never));
                isBest();
                for (unsigned int rank = 1; rank < 12; ++rank)
                {
                    EXPECT_FALSE(objective.isBrighter(optimizer.brightness(optimizer.order()[rank]),
                                                      optimizer.brightness(optimizer.order()[rank - 1])));
                }
                for (int t = 0; t < 20; ++t)
                {
                    optimizer.step(objective, never);
                }
                EXPECT_NEAR(optimizer.best()[0], 6.0, 0.1) << "the swarm follows the new order";
            }
        }

        TEST(FireflyInputs, FireflyMoveTowardTheBrighterOfTheNewOrder)
        {
            auto settings = small(Variant::FA, 2);
            settings.alpha = 0.0;
            settings.gamma = 0.0;
            auto optimizer = makeOptimizer(settings);
            optimizer.inject(Eigen::Vector3d(0.0, 1.0, 10.0));
            optimizer.inject(Eigen::Vector3d(5.0, 1.0, 10.0));
            Aimed objective;
            optimizer.step(objective, never);
            ASSERT_EQ(optimizer.brightestIndex(), 0U);
            objective.aim = 6.0;
            optimizer.orderChanged(objective);
            optimizer.step(objective, never);
            EXPECT_EQ(optimizer.population()(0, 1), 5.0);
            EXPECT_EQ(optimizer.population()(0, 0), 5.0) << "attracted all the way by the one that is brighter now";
        }

        TEST(FireflyInputs, InjectionInTheMiddleOfAGenerationSurvivesIt)
        {
            auto optimizer = makeOptimizer(small(Variant::FA));
            Recorder objective;
            optimizer.step(objective, never);
            const auto limit = optimizer.evaluations() + 3;
            EXPECT_FALSE(optimizer.step(objective, [&] { return optimizer.evaluations() >= limit; }));
            optimizer.inject(Eigen::Vector3d(1.0, 1.0, 1.0), {0.0, -1e9}, objective);
            EXPECT_TRUE(optimizer.step(objective, never));
            EXPECT_TRUE(optimizer.population().col(optimizer.brightestIndex()) == Eigen::Vector3d(1.0, 1.0, 1.0));
        }

        TEST(FireflyInputs, InjectionsAtTheWrongTimeAreLogicErrors)
        {
            auto optimizer = makeOptimizer(small(Variant::FA, 2));
            Recorder objective;
            const Eigen::Vector3d x(1.0, 1.0, 1.0);
            EXPECT_THROW(optimizer.inject(x, {0.0, 1.0}, objective), std::logic_error);
            optimizer.inject(x);
            optimizer.inject(x);
            EXPECT_THROW(optimizer.inject(x), std::logic_error);
            optimizer.step(objective, never);
            EXPECT_THROW(optimizer.inject(x), std::logic_error);
        }

        TEST(FireflyInputs, InjectedSeedsAreEvaluatedFirst)
        {
            auto optimizer = makeOptimizer(small(Variant::MFA));
            optimizer.inject(Eigen::Vector3d(1.0, 2.0, 3.0));
            Recorder objective;
            optimizer.step(objective, never);
            EXPECT_TRUE(objective.points.front() == Eigen::Vector3d(1.0, 2.0, 3.0));
        }

        TEST(FireflyInputs, RefusesBadSettingsByNameValueAndRange)
        {
            EXPECT_EQ(refusal({}), "");
            const double nan = std::nan("");
            const double inf = std::numeric_limits<double>::infinity();
            struct Case
            {
                const char *name;
                double FireflyOptimizer::Settings::*member;
                double bad;
            };
            for (const auto &bad : {Case{"gamma", &FireflyOptimizer::Settings::gamma, -0.1},
                                    Case{"gamma", &FireflyOptimizer::Settings::gamma, nan},
                                    Case{"gamma", &FireflyOptimizer::Settings::gamma, inf},
                                    Case{"alpha", &FireflyOptimizer::Settings::alpha, 1.5},
                                    Case{"alpha", &FireflyOptimizer::Settings::alpha, -0.5},
                                    Case{"alpha", &FireflyOptimizer::Settings::alpha, nan},
                                    Case{"eta", &FireflyOptimizer::Settings::eta, 2.5},
                                    Case{"eta", &FireflyOptimizer::Settings::eta, -1.0},
                                    Case{"betaMin", &FireflyOptimizer::Settings::betaMin, -1.0}})
            {
                FireflyOptimizer::Settings settings;
                settings.*bad.member = bad.bad;
                const std::string message = refusal(settings);
                EXPECT_NE(message.find(bad.name), std::string::npos) << message;
                EXPECT_NE(message.find("must be"), std::string::npos) << message;
            }
            EXPECT_EQ(refusal(small(Variant::MFA, 3)),
                      "FireflyOptimizer: populationSize = 3 is not accepted; it must be at least 4");
            EXPECT_EQ(refusal(small(Variant::FA, 1)), "");
            EXPECT_NE(refusal(small(Variant::FA, 0)), "");
            EXPECT_NE(refusal(small(Variant::FA, 10, 0)).find("generations = 0"), std::string::npos);
        }

        TEST(FireflyInputs, RefusesBadBoxes)
        {
            const auto make = [](const Eigen::VectorXd &lower, const Eigen::VectorXd &upper)
            { FireflyOptimizer(FireflyOptimizer::Settings(), lower, upper, 1); };
            EXPECT_THROW(make({}, {}), std::invalid_argument);
            EXPECT_THROW(make(constant(2, 0.0), constant(3, 1.0)), std::invalid_argument);
            EXPECT_THROW(make(constant(2, 1.0), constant(2, 0.0)), std::invalid_argument);
            EXPECT_THROW(make(constant(2, -INFINITY), constant(2, 0.0)), std::invalid_argument);
            EXPECT_THROW(make(constant(2, 0.0), constant(2, std::nan(""))), std::invalid_argument);
            EXPECT_THROW(make(constant(1, -1e308), constant(1, 1e308)), std::invalid_argument) << "the range overflows";
        }
    }  // namespace
}  // namespace ompl_mfa
