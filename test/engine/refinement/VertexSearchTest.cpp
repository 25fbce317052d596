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

#include "engine/refinement/VertexSearch.h"

#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <rapidcheck/gtest.h>

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* The matrix A of a search, column by column: a step is sigma A z, z being the next draws of the generator. */
        Eigen::MatrixXd factorOf(const VertexSearch &search, Eigen::Index d)
        {
            // d independent steps and their normal vectors, from two generators of one seed
            VertexSearch copy(search);
            ompl::RNG steps(17);
            ompl::RNG normals(17);
            Eigen::MatrixXd z(d, d);
            Eigen::MatrixXd drawn(d, d);
            for (Eigen::Index k = 0; k < d; ++k)
            {
                Eigen::VectorXd step(d);
                copy.draw(steps, step);
                drawn.col(k) = step / search.sigma();
                for (Eigen::Index i = 0; i < d; ++i)
                {
                    z(i, k) = normals.gaussian01();
                }
            }
            return drawn * z.inverse();
        }

        Eigen::MatrixXd covarianceOf(const VertexSearch &search, Eigen::Index d)
        {
            const Eigen::MatrixXd factor = factorOf(search, d);
            return factor * factor.transpose();
        }

        TEST(VertexSearch, BeginsWithIndependentStepsOfItsDeviation)
        {
            VertexSearch search(3, 0.5);
            EXPECT_EQ(search.sigma(), 0.5);
            EXPECT_TRUE(covarianceOf(search, 3).isApprox(Eigen::MatrixXd::Identity(3, 3), 1e-9));
            ompl::RNG rng(1);
            Eigen::VectorXd step(3);
            double sum = 0.0;
            for (int i = 0; i < 2000; ++i)
            {
                search.draw(rng, step);
                sum += step.squaredNorm();
            }
            EXPECT_NEAR(sum / 2000, 3 * 0.25, 0.08);
        }

        /* The constants of Arnold and Hansen: a success rate of 2/11 keeps the deviation, damping 1 + d/2, memory
           1/12. */
        TEST(VertexSearch, TheDeviationFollowsTheRateOfSuccess)
        {
            for (const Eigen::Index d : {1, 2, 7})
            {
                VertexSearch search(d, 1.0);
                ompl::RNG rng(2);
                Eigen::VectorXd step(d);
                double rate = 2.0 / 11.0;
                double sigma = 1.0;
                for (int i = 0; i < 100; ++i)
                {
                    const bool success = i % 7 == 0;
                    search.draw(rng, step);
                    success ? search.succeeded() : search.failed();
                    rate = 11.0 / 12.0 * rate + (success ? 1.0 / 12.0 : 0.0);
                    sigma *= std::exp((rate - 2.0 / 11.0) / (9.0 / 11.0) / (1.0 + 0.5 * static_cast<double>(d)));
                    ASSERT_NEAR(search.sigma(), sigma, 1e-12 * sigma) << i;
                }
            }
        }

        TEST(VertexSearch, AStepThatIsBlockedLeavesTheDeviation)
        {
            VertexSearch search(2, 0.3);
            ompl::RNG rng(2);
            Eigen::VectorXd step(2);
            search.draw(rng, step);
            search.violated();
            EXPECT_EQ(search.sigma(), 0.3);
        }

        /* A A^T becomes (1 - c) A A^T + c s s^T, with the path s of successful steps. */
        RC_GTEST_PROP(VertexSearchProperty, SuccessTurnsTheCovarianceTowardTheStepsTaken, ())
        {
            const Eigen::Index d = *rc::gen::inRange(1, 8);
            const auto n = static_cast<double>(d);
            const double pathWeight = 2.0 / (n + 2.0);
            const double covarianceWeight = 2.0 / (n * n + 6.0);
            VertexSearch search(d, 0.7);
            ompl::RNG rng(static_cast<std::uint_fast32_t>(*rc::gen::inRange(1, 1 << 30)));
            Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(d, d);
            Eigen::VectorXd path = Eigen::VectorXd::Zero(d);
            Eigen::VectorXd step(d);
            for (int i = 0; i < 12; ++i)
            {
                const double sigma = search.sigma();
                search.draw(rng, step);
                if (*rc::gen::inRange(0, 3) == 0)
                {
                    search.failed();
                    continue;
                }
                search.succeeded();
                path = (1.0 - pathWeight) * path + std::sqrt(pathWeight * (2.0 - pathWeight)) * step / sigma;
                covariance = (1.0 - covarianceWeight) * covariance + covarianceWeight * path * path.transpose();
                RC_ASSERT(covarianceOf(search, d).isApprox(covariance, 1e-6));
            }
        }

        /* A is reduced by beta / |w|^2 v w^T with w = A^-1 v, v the fading record of blocked steps. */
        RC_GTEST_PROP(VertexSearchProperty, AConstraintNarrowsTheDistributionAcrossIt, ())
        {
            const Eigen::Index d = *rc::gen::inRange(1, 8);
            const auto n = static_cast<double>(d);
            VertexSearch search(d, 0.7);
            ompl::RNG rng(static_cast<std::uint_fast32_t>(*rc::gen::inRange(1, 1 << 30)));
            Eigen::MatrixXd factor = Eigen::MatrixXd::Identity(d, d);
            Eigen::VectorXd record = Eigen::VectorXd::Zero(d);
            Eigen::VectorXd step(d);
            for (int i = 0; i < 10; ++i)
            {
                search.draw(rng, step);
                search.violated();
                record = (1.0 - 1.0 / (n + 2.0)) * record + 1.0 / (n + 2.0) * step / search.sigma();
                const Eigen::VectorXd w = factor.inverse() * record;
                factor -= 0.1 / (n + 2.0) / w.squaredNorm() * record * w.transpose();
                RC_ASSERT(factorOf(search, d).isApprox(factor, 1e-6));
            }
        }

        /* If all steps with a positive first coordinate are blocked, the others become the likely ones. */
        TEST(VertexSearch, VarianceShrinksAlongABlockedDirectionAlone)
        {
            VertexSearch search(3, 1.0);
            ompl::RNG rng(5);
            Eigen::VectorXd step(3);
            for (int i = 0; i < 200; ++i)
            {
                search.draw(rng, step);
                if (step[0] > 0.0)
                {
                    search.violated();
                }
            }
            const Eigen::MatrixXd covariance = covarianceOf(search, 3);
            EXPECT_LT(covariance(0, 0), 0.2 * covariance(1, 1));
            EXPECT_LT(covariance(0, 0), 0.2 * covariance(2, 2));
            EXPECT_GT(covariance(1, 1), 0.1);
        }

        /* The minimum of a narrow valley on a constraint, in one dimension and in several. */
        TEST(VertexSearch, FindsTheMinimumOfAValleyOnAConstraint)
        {
            for (const Eigen::Index d : {1, 2, 5})
            {
                const auto cost = [](const Eigen::VectorXd &x)
                {
                    double sum = 0.0;
                    for (Eigen::Index i = 0; i < x.size(); ++i)
                    {
                        sum += std::pow(10.0, static_cast<double>(i)) * x[i] * x[i];
                    }
                    return sum;
                };
                VertexSearch search(d, 0.5);
                ompl::RNG rng(9);
                Eigen::VectorXd x = Eigen::VectorXd::Constant(d, 3.0);
                Eigen::VectorXd step(d);
                // x_0 >= 1: the best is 1
                for (int i = 0; i < 600 * d; ++i)
                {
                    search.draw(rng, step);
                    if (cost(x + step) >= cost(x))
                    {
                        search.failed();
                    }
                    else if (x[0] + step[0] < 1.0)
                    {
                        search.violated();
                    }
                    else
                    {
                        search.succeeded();
                        x += step;
                    }
                }
                EXPECT_NEAR(cost(x), 1.0, 1e-3) << d << " dimensions";
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
