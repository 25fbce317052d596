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

#include "optimizer/TestFunction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::optimizer
{
    TEST(TestFunction, HasTheOptimumOfTheLiterature)
    {
        for (const auto &name : TestFunction::names())
        {
            for (const unsigned int dimension : {2U, 10U, 30U})
            {
                const TestFunction function(name, dimension);
                const double expected = name == "sinc" ? 1.0 : 0.0;
                EXPECT_NEAR(function.value(function.optimum()), expected, 1e-9) << name << " in " << dimension;
                EXPECT_TRUE(function.isNearOptimum(function.optimum()));
                EXPECT_FALSE(function.isNearOptimum(function.lower()));
                EXPECT_TRUE((function.lower().array() < function.upper().array()).all());
            }
        }
    }

    TEST(TestFunction, HasTheValuesOfTheLiterature)
    {
        // By hand, from the definitions.
        EXPECT_NEAR(TestFunction("sinc", 2).value(Eigen::Vector2d(1.0, 1.0)), std::sin(2.0) / 2.0, 1e-15);
        EXPECT_NEAR(TestFunction("ackley", 2).value(Eigen::Vector2d(1.0, 1.0)), 20.0 - 20.0 * std::exp(-0.2), 1e-12);
        EXPECT_NEAR(TestFunction("rastrigin", 2).value(Eigen::Vector2d(1.0, 0.5)), 1.0 + 0.25 + 20.0, 1e-12);
        EXPECT_NEAR(TestFunction("griewank", 2).value(Eigen::Vector2d(3.0, 4.0)),
                    1.0 + 25.0 / 4000.0 - std::cos(3.0) * std::cos(4.0 / std::sqrt(2.0)), 1e-12);
        EXPECT_NEAR(TestFunction("schwefel", 1).value(Eigen::VectorXd::Constant(1, 100.0)),
                    418.98288727243374 - 100.0 * std::sin(10.0), 1e-12);
        EXPECT_NEAR(TestFunction("rosenbrock", 2).value(Eigen::Vector2d(0.0, 2.0)), 401.0, 1e-12);
        EXPECT_NEAR(TestFunction("levy", 2).value(Eigen::Vector2d(5.0, 5.0)),
                    1.0 * (1.0 + 10.0 * std::pow(std::sin(2.0 * M_PI + 1.0), 2)) + 1.0, 1e-12);
    }

    TEST(TestFunction, CostsAreToBeMinimised)
    {
        TestFunction sinc("sinc", 2);
        const auto best = sinc.evaluate(Eigen::Vector2d::Zero(), nullptr);
        EXPECT_EQ(best.cost, -1.0);
        EXPECT_EQ(sinc.valueOf(best), 1.0);
        TestFunction ackley("ackley", 2);
        EXPECT_NEAR(ackley.evaluate(Eigen::Vector2d::Zero(), nullptr).cost, 0.0, 1e-12);
    }

    TEST(TestFunction, AShiftMovesTheOptimumAndNotTheCube)
    {
        const Eigen::Vector2d shift(0.7, -0.3);
        const TestFunction function("rastrigin", 2, shift);
        EXPECT_TRUE(function.optimum() == shift);
        EXPECT_NEAR(function.value(shift), 0.0, 1e-12);
        EXPECT_TRUE(function.lower() == TestFunction("rastrigin", 2).lower());
    }

    TEST(TestFunction, RefusesUnknownNamesAndTooFewDimensions)
    {
        EXPECT_THROW(TestFunction("sync", 2), InputError);
        EXPECT_THROW(TestFunction("rosenbrock", 1), InputError);
        EXPECT_THROW(TestFunction("sinc", 0), InputError);
    }
}  // namespace ompl_mfa::optimizer
