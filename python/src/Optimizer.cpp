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

#include "Module.h"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "PythonCalls.h"
#include "ompl_mfa/optimizer/FireflyOptimizer.h"

namespace py = pybind11;

namespace ompl_mfa::python
{
    namespace
    {
        /* A Python function of x (d) to a number, or of x (d, k) to k numbers. */
        class PythonObjective : public ObjectiveFunction
        {
        public:
            PythonObjective(py::function function, bool vectorized, PythonCalls &calls)
              : function_(std::move(function))
              , vectorized_(vectorized)
              , calls_(calls)
            {
            }

            void prepare(const Eigen::Ref<const Eigen::MatrixXd> &points, const std::vector<bool> &wanted) override
            {
                if (!vectorized_)
                {
                    return;
                }
                points_.resize(points.rows(), points.cols());
                Eigen::Index count = 0;
                for (Eigen::Index i = 0; i < points.cols(); ++i)
                {
                    if (wanted[static_cast<std::size_t>(i)])
                    {
                        points_.col(count++) = points.col(i);
                    }
                }
                points_.conservativeResize(Eigen::NoChange, count);
                values_ = valuesOf(points_);
                next_ = 0;
            }

            Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/) override
            {
                return {0.0, orInfinite(vectorized_ ? prepared(x) : single(x))};
            }

        private:
            static constexpr double INFINITE = std::numeric_limits<double>::infinity();

            /* A value that is not a number is worse than any other. */
            static double orInfinite(double value)
            {
                return std::isnan(value) ? INFINITE : value;
            }

            Eigen::VectorXd valuesOf(const Eigen::MatrixXd &points)
            {
                return calls_.call(
                    [this, &points]
                    {
                        auto values = py::cast<Eigen::VectorXd>(function_(points));
                        if (values.size() != points.cols())
                        {
                            throw std::invalid_argument("the vectorized function returned " +
                                                        std::to_string(values.size()) + " values for " +
                                                        std::to_string(points.cols()) + " points");
                        }
                        return values;
                    },
                    Eigen::VectorXd(Eigen::VectorXd::Constant(points.cols(), INFINITE)));
            }

            double single(const Eigen::Ref<const Eigen::VectorXd> &x)
            {
                return calls_.call([this, &x] { return py::cast<double>(function_(Eigen::VectorXd(x))); }, INFINITE);
            }

            /* Points are evaluated in the order in which they were prepared; some are left out. After an interruption
               they were prepared in an earlier call. */
            double prepared(const Eigen::Ref<const Eigen::VectorXd> &x)
            {
                while (next_ < points_.cols() && points_.col(next_) != x)
                {
                    ++next_;
                }
                return next_ < points_.cols() ? values_[next_++] : valuesOf(x)[0];
            }

            py::function function_;
            bool vectorized_;
            PythonCalls &calls_;
            Eigen::MatrixXd points_;
            Eigen::VectorXd values_;
            Eigen::Index next_{0};
        };

        /* One generation. Returns false if stopped by \e maxEvaluations. */
        bool step(FireflyOptimizer &optimizer, const py::function &function, bool vectorized,
                  std::uint64_t maxEvaluations)
        {
            PythonCalls calls;
            PythonObjective objective(function, vectorized, calls);
            bool finished = false;
            {
                const py::gil_scoped_release unlocked;
                finished = optimizer.step(
                    objective, [&] { return optimizer.evaluations() >= maxEvaluations || calls.mustStop(); });
            }
            calls.rethrow();
            return finished;
        }

        FireflyOptimizer::Variant variantNamed(const std::string &name)
        {
            if (name == "mfa")
            {
                return FireflyOptimizer::Variant::MFA;
            }
            if (name == "fa")
            {
                return FireflyOptimizer::Variant::FA;
            }
            throw std::invalid_argument("algorithm = '" + name + "': accepted are 'mfa' and 'fa'");
        }
    }  // namespace

    void bindOptimizer(py::module_ &module)
    {
        py::class_<FireflyOptimizer>(module, "FireflyOptimizer", R"(The firefly algorithm over a box, step by step.

A population of points of the box [lower, upper] is improved generation by generation; the class documents in C++ and
docs/algorithm.md the equations. minimize() is the simpler way to use it.)")
            .def(py::init(
                     [](const Eigen::VectorXd &lower, const Eigen::VectorXd &upper, const std::string &algorithm,
                        unsigned int population, unsigned int generations, double gamma, double alpha, double eta,
                        std::uint64_t seed)
                     {
                         FireflyOptimizer::Settings settings;
                         settings.variant = variantNamed(algorithm);
                         settings.populationSize = population;
                         settings.generations = generations;
                         settings.gamma = gamma;
                         settings.alpha = alpha;
                         settings.eta = eta;
                         return std::make_unique<FireflyOptimizer>(settings, lower, upper, seed);
                     }),
                 py::arg("lower"), py::arg("upper"), py::arg("algorithm") = "mfa", py::arg("population") = 100,
                 py::arg("generations") = 50, py::arg("gamma") = 0.5, py::arg("alpha") = 0.2, py::arg("eta") = 1.0,
                 py::arg("seed") = 1, R"(Parameters
----------
lower, upper : array of shape (d,)
    The box, lower <= upper.
algorithm : 'mfa' or 'fa'
population : int
    Number of fireflies, at least 1, for 'mfa' at least 4.
generations : int
    Length of an epoch, over which the steps of 'mfa' shrink; another epoch follows.
gamma, alpha, eta : float
    Light absorption (at least 0), random step (0 to 1), attraction (0 to 2) of eqs. 4, 5, 13, 14.
seed : int
    The same seed gives the same run, bit for bit.

Raises ValueError for a value that is not accepted.)")
            .def("step", &step, py::arg("function"), py::arg("vectorized") = false,
                 py::arg("max_evaluations") = std::numeric_limits<std::uint64_t>::max(),
                 R"(Run to the end of a generation; the first call evaluates the initial population.

function takes x of shape (d,) and returns a number, or if vectorized, x of shape (d, k) and returns k numbers.
Returns False if max_evaluations were reached before the end of the generation. An exception of the function, and
Ctrl-C, end the call, and the next one continues; the point whose evaluation failed counts as infinitely bad.)")
            .def(
                "inject",
                [](FireflyOptimizer &optimizer, const Eigen::VectorXd &x)
                {
                    if (x.size() != optimizer.lower().size())
                    {
                        throw std::invalid_argument("inject: x has " + std::to_string(x.size()) + " coordinates, not " +
                                                    std::to_string(optimizer.lower().size()));
                    }
                    optimizer.inject(x);
                },
                py::arg("x"), "Put a point into the initial population. RuntimeError after the first step.")
            .def("restart_epoch", &FireflyOptimizer::restartEpoch, "Begin the schedules of step and attraction again.")
            .def_property_readonly(
                "population",
                [](const FireflyOptimizer &optimizer) { return Eigen::MatrixXd(optimizer.population().transpose()); },
                "A copy of the fireflies, shape (population, d).")
            .def_property_readonly(
                "values",
                [](const FireflyOptimizer &optimizer)
                {
                    Eigen::VectorXd values(optimizer.population().cols());
                    for (Eigen::Index i = 0; i < values.size(); ++i)
                    {
                        values[i] = optimizer.brightness(static_cast<unsigned int>(i)).cost;
                    }
                    return values;
                },
                "The function's values of population, shape (population,).")
            .def_property_readonly(
                "best", [](const FireflyOptimizer &optimizer) { return Eigen::VectorXd(optimizer.best()); },
                "The best point ever evaluated, shape (d,).")
            .def_property_readonly(
                "best_value", [](const FireflyOptimizer &optimizer) { return optimizer.bestBrightness().cost; },
                "The function's value of best; infinite before the first step.")
            .def_property_readonly("generation", &FireflyOptimizer::generation, "Completed generations.")
            .def_property_readonly("evaluations", &FireflyOptimizer::evaluations, "Evaluated points.")
            .def_property_readonly("alpha", &FireflyOptimizer::alpha, "Random step of the next generation, eq. 13.")
            .def_property_readonly("beta0", &FireflyOptimizer::beta0, "Attraction of the next generation, eq. 14.");
    }
}  // namespace ompl_mfa::python
