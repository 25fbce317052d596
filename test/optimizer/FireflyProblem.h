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

#ifndef OMPL_MFA_TEST_OPTIMIZER_FIREFLY_PROBLEM_
#define OMPL_MFA_TEST_OPTIMIZER_FIREFLY_PROBLEM_

/* Objectives for the tests of the firefly optimiser, and optimisers small enough for many runs. */

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"

namespace ompl_mfa::test
{
    using Variant = FireflyOptimizer::Variant;

    inline bool never()
    {
        return false;
    }

    inline double bumpyCost(const std::vector<double> &x)
    {
        double cost = 0.0;
        for (std::size_t k = 0; k < x.size(); ++k)
        {
            cost += std::pow(x[k] - 1.3 * static_cast<double>(k + 1), 2) + 2.0 * std::cos(5.0 * x[k]);
        }
        return cost;
    }

    /** \brief Records the points evaluated, in order. */
    class Recorder : public ObjectiveFunction
    {
    public:
        using Cost = std::function<double(const std::vector<double> &)>;

        explicit Recorder(Cost cost = bumpyCost)
          : cost_(std::move(cost))
        {
        }

        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override
        {
            points.emplace_back(x);
            hadRival.push_back(rival != nullptr);
            const Brightness brightness{0.0, cost_({x.data(), x.data() + x.size()})};
            if (rival != nullptr && !isBrighter(brightness, *rival))
            {
                return {};
            }
            return brightness;
        }

        std::vector<Eigen::VectorXd> points;
        std::vector<bool> hadRival;

    private:
        Cost cost_;
    };

    inline FireflyOptimizer::Settings small(Variant variant, unsigned int size = 12, unsigned int generations = 8)
    {
        FireflyOptimizer::Settings settings;
        settings.variant = variant;
        settings.populationSize = size;
        settings.generations = generations;
        return settings;
    }

    inline Eigen::VectorXd constant(Eigen::Index d, double value)
    {
        return Eigen::VectorXd::Constant(d, value);
    }

    /** \brief An optimiser in R^3 on a box of unequal edges, away from the origin. */
    inline FireflyOptimizer makeOptimizer(const FireflyOptimizer::Settings &settings, std::uint64_t seed = 3)
    {
        return {settings, Eigen::Vector3d(-4.0, 0.5, -1.0), Eigen::Vector3d(6.0, 2.5, 30.0), seed};
    }

    /** \brief For tests of both the firefly algorithm and the modified one. */
    class FireflyVariants : public ::testing::TestWithParam<Variant>
    {
    };

    struct VariantName
    {
        template <typename Info>
        std::string operator()(const Info &info) const
        {
            return info.param == Variant::FA ? "FA" : "MFA";
        }
    };
}  // namespace ompl_mfa::test

#endif
