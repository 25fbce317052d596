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

#include <array>
#include <cmath>

#include "ompl_mfa/InputError.h"
#include "text/NearestName.h"

namespace ompl_mfa::optimizer
{
    namespace
    {
        constexpr double PI = 3.14159265358979323846;

        // Eq. (19); at the origin its limit.
        double sinc(const Eigen::VectorXd &x)
        {
            const double squared = x.squaredNorm();
            return squared == 0.0 ? 1.0 : std::sin(squared) / squared;
        }

        double ackley(const Eigen::VectorXd &x)
        {
            const auto d = static_cast<double>(x.size());
            const double distance = std::sqrt(x.squaredNorm() / d);
            const double waves = (2 * PI * x.array()).cos().sum() / d;
            return 20.0 + std::exp(1.0) - 20.0 * std::exp(-0.2 * distance) - std::exp(waves);
        }

        double rastrigin(const Eigen::VectorXd &x)
        {
            return (x.array().square() - 10.0 * (2 * PI * x.array()).cos() + 10.0).sum();
        }

        double griewank(const Eigen::VectorXd &x)
        {
            double product = 1.0;
            for (Eigen::Index i = 0; i < x.size(); ++i)
            {
                product *= std::cos(x[i] / std::sqrt(static_cast<double>(i + 1)));
            }
            return 1.0 + x.squaredNorm() / 4000.0 - product;
        }

        double schwefel(const Eigen::VectorXd &x)
        {
            return (418.98288727243374 - x.array() * x.array().abs().sqrt().sin()).sum();
        }

        double rosenbrock(const Eigen::VectorXd &x)
        {
            double sum = 0.0;
            for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
            {
                sum += 100.0 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1.0 - x[i], 2);
            }
            return sum;
        }

        double levy(const Eigen::VectorXd &x)
        {
            const Eigen::ArrayXd w = 1.0 + (x.array() - 1.0) / 4.0;
            const double last = w[w.size() - 1];
            double sum = std::pow(std::sin(PI * w[0]), 2) +
                         std::pow(last - 1.0, 2) * (1.0 + std::pow(std::sin(2 * PI * last), 2));
            for (Eigen::Index i = 0; i + 1 < w.size(); ++i)
            {
                sum += std::pow(w[i] - 1.0, 2) * (1.0 + 10.0 * std::pow(std::sin(PI * w[i] + 1.0), 2));
            }
            return sum;
        }

        struct Definition
        {
            const char *name;
            double lower;
            double upper;
            double optimum;
            double (*function)(const Eigen::VectorXd &x);
            bool maximised;
        };

        constexpr std::array<Definition, 7> DEFINITIONS{{
            {"sinc", -5.0, 5.0, 0.0, sinc, true},
            {"ackley", -32.768, 32.768, 0.0, ackley, false},
            {"rastrigin", -5.12, 5.12, 0.0, rastrigin, false},
            {"griewank", -600.0, 600.0, 0.0, griewank, false},
            {"schwefel", -500.0, 500.0, 420.968746359982, schwefel, false},
            {"rosenbrock", -5.0, 10.0, 1.0, rosenbrock, false},
            {"levy", -10.0, 10.0, 1.0, levy, false},
        }};
    }  // namespace

    TestFunction::TestFunction(const std::string &name, unsigned int dimension, const Eigen::VectorXd &shift)
      : name_(name)
      , dimension_(dimension)
      , shift_(shift)
    {
        text::requireKnown("function", name, names());
        const unsigned int smallest = name == "rosenbrock" ? 2 : 1;
        if (dimension < smallest)
        {
            throw InputError("dimension " + std::to_string(dimension) + " of function '" + name +
                             "' is not accepted; it must be at least " + std::to_string(smallest));
        }
        if (shift_.size() == 0)
        {
            shift_ = Eigen::VectorXd::Zero(dimension_);
        }
        for (const auto &definition : DEFINITIONS)
        {
            if (name != definition.name)
            {
                continue;
            }
            lower_ = definition.lower;
            upper_ = definition.upper;
            optimum_ = definition.optimum;
            function_ = definition.function;
            maximised_ = definition.maximised;
        }
    }

    const std::vector<std::string> &TestFunction::names()
    {
        static const std::vector<std::string> ALL_NAMES = []
        {
            std::vector<std::string> list;
            list.reserve(DEFINITIONS.size());
            for (const auto &definition : DEFINITIONS)
            {
                list.emplace_back(definition.name);
            }
            return list;
        }();
        return ALL_NAMES;
    }

    Brightness TestFunction::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/)
    {
        const double result = value(x);
        return {0.0, maximised_ ? -result : result};
    }

    double TestFunction::value(const Eigen::Ref<const Eigen::VectorXd> &x) const
    {
        return function_(x - shift_);
    }

    double TestFunction::valueOf(const Brightness &brightness) const
    {
        return maximised_ ? -brightness.cost : brightness.cost;
    }

    Eigen::VectorXd TestFunction::lower() const
    {
        return Eigen::VectorXd::Constant(dimension_, lower_);
    }

    Eigen::VectorXd TestFunction::upper() const
    {
        return Eigen::VectorXd::Constant(dimension_, upper_);
    }

    Eigen::VectorXd TestFunction::optimum() const
    {
        return Eigen::VectorXd::Constant(dimension_, optimum_) + shift_;
    }

    bool TestFunction::isNearOptimum(const Eigen::Ref<const Eigen::VectorXd> &x) const
    {
        return (x - optimum()).norm() <= 0.05 * (upper_ - lower_);
    }
}  // namespace ompl_mfa::optimizer
