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

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "PythonCalls.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;
namespace py = pybind11;

namespace ompl_mfa::python
{
    namespace
    {
        using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        using Parameters = std::vector<std::pair<std::string, std::string>>;

        constexpr double INFINITE = std::numeric_limits<double>::infinity();

        /* How a run is limited. */
        struct Limits
        {
            double time{1.0};
            std::uint64_t iterations{0};
        };

        struct Result
        {
            std::string status;
            bool exact{false};
            double cost{INFINITE};
            double time{0.0};
            /* Rows of time and best cost. */
            Matrix costs;
            /* A row per state. */
            Matrix path;
        };

        double secondsSince(std::chrono::steady_clock::time_point start)
        {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        }

        Matrix toMatrix(const std::vector<std::vector<double>> &rows, std::size_t columns)
        {
            Matrix matrix(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
            for (std::size_t i = 0; i < rows.size(); ++i)
            {
                for (std::size_t j = 0; j < columns; ++j)
                {
                    matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows[i][j];
                }
            }
            return matrix;
        }

        benchmark::PlannerSpec specOf(const std::string &planner, const Parameters &parameters)
        {
            const std::string type = lowerCase(planner);
            const std::string origin = "planner = '" + planner + "'";
            benchmark::requireKnownPlanner(type, origin);
            benchmark::PlannerSpec spec{type, benchmark::plannerTitle(type), origin, {}, {}};
            for (const auto &parameter : parameters)
            {
                spec.parameters.push_back({parameter.first, parameter.second, "params"});
            }
            return spec;
        }

        void requireLimits(const Limits &limits)
        {
            if (!(limits.time > 0.0 && limits.time <= benchmark::LONGEST_TIME_LIMIT))
            {
                throw InputError("time = " + std::to_string(limits.time) +
                                 ": accepted is a number above 0 and at most 1e9 (seconds)");
            }
        }

        /* Seeds OMPL, which writes an error if this is not the first run of the process. */
        void seedOmpl(std::uint32_t seed)
        {
            const auto level = ompl::msg::getLogLevel();
            ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
            try
            {
                benchmark::setRandomSeed(seed);
            }
            catch (...)
            {
                ompl::msg::setLogLevel(level);
                throw;
            }
            ompl::msg::setLogLevel(level);
        }

        /* Runs the planner of \e setup without the interpreter's lock. */
        Result run(og::SimpleSetup &setup, const Limits &limits, PythonCalls &calls)
        {
            const auto objective =
                setup.getOptimizationObjective()
                    ? setup.getOptimizationObjective()
                    : std::make_shared<ob::PathLengthOptimizationObjective>(setup.getSpaceInformation());
            std::mutex mutex;
            std::vector<std::vector<double>> costs;
            const auto start = std::chrono::steady_clock::now();
            const auto improved = [&](double cost)
            {
                const std::lock_guard<std::mutex> lock(mutex);
                if (costs.empty() || objective->isCostBetterThan(ob::Cost(cost), ob::Cost(costs.back()[1])))
                {
                    costs.push_back({secondsSince(start), cost});
                }
            };
            setup.getProblemDefinition()->setIntermediateSolutionCallback(
                [&](const ob::Planner *, const std::vector<const ob::State *> &, ob::Cost cost)
                { improved(cost.value()); });
            std::uint64_t evaluations = 0;
            const ob::PlannerTerminationCondition stop(
                [&]
                {
                    return (limits.iterations > 0 && ++evaluations > limits.iterations) ||
                           secondsSince(start) >= limits.time || calls.mustStop();
                });
            Result result;
            {
                const py::gil_scoped_release unlocked;
                const ob::PlannerStatus status = setup.solve(stop);
                result.time = secondsSince(start);
                result.status = status.asString();
                result.exact = status == ob::PlannerStatus::EXACT_SOLUTION;
            }
            setup.getProblemDefinition()->setIntermediateSolutionCallback({});
            calls.rethrow();
            std::vector<std::vector<double>> states;
            std::size_t columns = 0;
            if (setup.haveSolutionPath())
            {
                og::PathGeometric &path = setup.getSolutionPath();
                for (ob::State *state : path.getStates())
                {
                    states.emplace_back();
                    setup.getStateSpace()->copyToReals(states.back(), state);
                    columns = states.back().size();
                }
                result.cost = path.cost(objective).value();
                if (result.exact)
                {
                    improved(result.cost);
                }
            }
            result.path = toMatrix(states, columns);
            result.costs = toMatrix(costs, 2);
            calls.rethrow();
            return result;
        }

        void setPlanner(og::SimpleSetup &setup, const benchmark::PlannerSpec &spec, std::uint32_t seed)
        {
            const ob::PlannerPtr planner = benchmark::createPlanner(setup.getSpaceInformation(), spec);
            benchmark::seedPlanner(*planner, seed);
            setup.setPlanner(planner);
        }

        Result planConfig(const std::string &text, const std::string &file, const std::string &planner,
                          const Parameters &parameters, const Limits &limits, std::uint32_t seed)
        {
            requireLimits(limits);
            seedOmpl(seed);
            std::istringstream in(text);
            const benchmark::ProblemFactory factory(text.empty() ? benchmark::readBenchmarkConfig(file)
                                                                 : benchmark::parseBenchmarkConfig(in, file));
            const benchmark::PlannerSpec spec = specOf(planner, parameters);
            const og::SimpleSetupPtr setup = factory.create(spec);
            setPlanner(*setup, spec, seed);
            PythonCalls calls;
            return run(*setup, limits, calls);
        }

        /* A Python function of states as validity checker. */
        class PythonValidity
        {
        public:
            PythonValidity(py::function function, bool vectorized, PythonCalls &calls)
              : function_(std::move(function))
              , vectorized_(vectorized)
              , calls_(calls)
            {
            }

            bool vectorized() const
            {
                return vectorized_;
            }

            /* Whether all states, the rows of \e states, are valid. */
            bool areValid(const Matrix &states) const
            {
                return calls_.call(
                    [&]
                    {
                        if (!vectorized_)
                        {
                            return py::cast<bool>(py::bool_(function_(Eigen::VectorXd(states.row(0)))));
                        }
                        const auto valid = py::cast<py::array_t<bool, py::array::forcecast>>(function_(states));
                        if (valid.size() != states.rows())
                        {
                            throw InputError("is_valid returned " + std::to_string(valid.size()) + " values for " +
                                             std::to_string(states.rows()) + " states");
                        }
                        return std::all_of(valid.data(), valid.data() + valid.size(), [](bool each) { return each; });
                    },
                    false);
            }

        private:
            py::function function_;
            bool vectorized_;
            PythonCalls &calls_;
        };

        void copyToRow(const ob::StateSpace &space, const ob::State *state, Matrix &rows, Eigen::Index row)
        {
            std::vector<double> values;
            space.copyToReals(values, state);
            rows.conservativeResize(rows.rows(), static_cast<Eigen::Index>(values.size()));
            for (std::size_t j = 0; j < values.size(); ++j)
            {
                rows(row, static_cast<Eigen::Index>(j)) = values[j];
            }
        }

        class StateCheck : public ob::StateValidityChecker
        {
        public:
            StateCheck(const ob::SpaceInformationPtr &si, const PythonValidity &validity)
              : ob::StateValidityChecker(si)
              , validity_(validity)
            {
            }

            bool isValid(const ob::State *state) const override
            {
                if (!si_->satisfiesBounds(state))
                {
                    return false;
                }
                Matrix rows(1, 0);
                copyToRow(*si_->getStateSpace(), state, rows, 0);
                return validity_.areValid(rows);
            }

        private:
            const PythonValidity &validity_;
        };

        /* All states of a motion, at OMPL's resolution, in one call of a vectorized function. */
        class MotionCheck : public ob::DiscreteMotionValidator
        {
        public:
            MotionCheck(const ob::SpaceInformationPtr &si, const PythonValidity &validity)
              : ob::DiscreteMotionValidator(si)
              , validity_(validity)
            {
            }

            using ob::DiscreteMotionValidator::checkMotion;

            bool checkMotion(const ob::State *from, const ob::State *to) const override
            {
                const auto &space = *si_->getStateSpace();
                const unsigned int segments = space.validSegmentCount(from, to);
                Matrix rows(segments, 0);
                ob::State *state = si_->allocState();
                bool valid = si_->satisfiesBounds(to);
                for (unsigned int i = 1; valid && i <= segments; ++i)
                {
                    space.interpolate(from, to, static_cast<double>(i) / segments, state);
                    copyToRow(space, i < segments ? state : to, rows, i - 1);
                }
                si_->freeState(state);
                valid = valid && validity_.areValid(rows);
                ++(valid ? valid_ : invalid_);
                return valid;
            }

        private:
            const PythonValidity &validity_;
        };

        ob::StateSpacePtr makeSpace(const std::string &kind, const Matrix &bounds, double turningRadius)
        {
            const auto requireRows = [&](Eigen::Index count)
            {
                if (bounds.rows() != count)
                {
                    throw InputError("bounds: space '" + kind + "' has " + std::to_string(count) +
                                     " coordinates with bounds, x and y" + (count == 3 ? " and z" : "") + "; " +
                                     std::to_string(bounds.rows()) + " were given");
                }
            };
            ob::RealVectorBounds box(static_cast<unsigned int>(bounds.rows()));
            for (unsigned int i = 0; i < bounds.rows(); ++i)
            {
                box.low[i] = bounds(i, 0);
                box.high[i] = bounds(i, 1);
                if (!(std::isfinite(box.low[i]) && std::isfinite(box.high[i]) && box.low[i] < box.high[i]))
                {
                    throw InputError("bounds: coordinate " + std::to_string(i) + " has [" + std::to_string(box.low[i]) +
                                     ", " + std::to_string(box.high[i]) + "]; accepted are finite low < high");
                }
            }
            if (kind == "real")
            {
                const auto space = std::make_shared<ob::RealVectorStateSpace>(static_cast<unsigned int>(bounds.rows()));
                space->setBounds(box);
                return space;
            }
            if (kind == "se3")
            {
                requireRows(3);
                const auto space = std::make_shared<ob::SE3StateSpace>();
                space->setBounds(box);
                return space;
            }
            std::shared_ptr<ob::SE2StateSpace> space;
            if (kind == "se2")
            {
                space = std::make_shared<ob::SE2StateSpace>();
            }
            else if (kind == "dubins")
            {
                space = std::make_shared<ob::DubinsStateSpace>(turningRadius);
            }
            else if (kind == "reedsshepp")
            {
                space = std::make_shared<ob::ReedsSheppStateSpace>(turningRadius);
            }
            else
            {
                throw InputError("space = '" + kind + "': accepted are real, se2, se3, dubins, reedsshepp");
            }
            requireRows(2);
            space->setBounds(box);
            return space;
        }

        void setState(const ob::StateSpacePtr &space, const std::string &name, const std::vector<double> &values,
                      ob::ScopedState<> &state)
        {
            std::vector<double> accepted;
            space->copyToReals(accepted, state.get());
            if (values.size() != accepted.size())
            {
                throw InputError(name + " has " + std::to_string(values.size()) + " values; the space has " +
                                 std::to_string(accepted.size()));
            }
            if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
            {
                throw InputError(name + " has a value that is not finite");
            }
            space->copyFromReals(state.get(), values);
            if (const auto *se3 = dynamic_cast<const ob::SE3StateSpace *>(space.get()))
            {
                auto *rotation = state->as<ob::SE3StateSpace::StateType>()->as<ob::SO3StateSpace::StateType>(1);
                const auto *rotations = se3->getSubspace(1)->as<ob::SO3StateSpace>();
                if (std::abs(rotations->norm(rotation) - 1.0) > 1e-6)
                {
                    throw InputError(name +
                                     ": the quaternion, the last four values in the order x, y, z, w, "
                                     "is not a unit quaternion");
                }
            }
            if (!space->satisfiesBounds(state.get()))
            {
                throw InputError(name + " is out of bounds");
            }
        }

        Result solve(const py::function &isValid, const std::string &kind, const Matrix &bounds,
                     const std::vector<double> &startValues, const std::vector<double> &goalValues, bool vectorized,
                     double resolution, double turningRadius, const std::string &planner, const Parameters &parameters,
                     const Limits &limits, std::uint32_t seed)
        {
            requireLimits(limits);
            if (!(resolution > 0.0 && resolution <= 1.0))
            {
                throw InputError("resolution = " + std::to_string(resolution) + ": accepted is a number in (0, 1]");
            }
            if (!(turningRadius > 0.0 && std::isfinite(turningRadius)))
            {
                throw InputError("turning_radius = " + std::to_string(turningRadius) +
                                 ": accepted is a number above 0");
            }
            seedOmpl(seed);
            const ob::StateSpacePtr space = makeSpace(kind, bounds, turningRadius);
            space->setLongestValidSegmentFraction(resolution);
            PythonCalls calls;
            const PythonValidity validity(isValid, vectorized, calls);
            og::SimpleSetup setup(space);
            const auto &si = setup.getSpaceInformation();
            si->setStateValidityChecker(std::make_shared<StateCheck>(si, validity));
            if (vectorized)
            {
                si->setMotionValidator(std::make_shared<MotionCheck>(si, validity));
            }
            si->setup();
            ob::ScopedState<> start(space);
            ob::ScopedState<> goal(space);
            setState(space, "start", startValues, start);
            setState(space, "goal", goalValues, goal);
            setup.setStartAndGoalStates(start, goal);
            setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
            setPlanner(setup, specOf(planner, parameters), seed);
            return run(setup, limits, calls);
        }
    }  // namespace

    void bindPlanning(py::module_ &module)
    {
        py::class_<Limits>(module, "Limits")
            .def(py::init(
                     [](double time, std::uint64_t iterations) {
                         return Limits{time, iterations};
                     }),
                 py::arg("time"), py::arg("iterations"));
        py::class_<Result>(module, "Result")
            .def_readonly("status", &Result::status)
            .def_readonly("exact", &Result::exact)
            .def_readonly("cost", &Result::cost)
            .def_readonly("time", &Result::time)
            .def_property_readonly("costs", [](const Result &result) { return Matrix(result.costs); })
            .def_property_readonly("path", [](const Result &result) { return Matrix(result.path); });
        module.def("plan_config", &planConfig, py::arg("text"), py::arg("file"), py::arg("planner"),
                   py::arg("parameters"), py::arg("limits"), py::arg("seed"));
        module.def("solve", &solve, py::arg("is_valid"), py::arg("space"), py::arg("bounds"), py::arg("start"),
                   py::arg("goal"), py::arg("vectorized"), py::arg("resolution"), py::arg("turning_radius"),
                   py::arg("planner"), py::arg("parameters"), py::arg("limits"), py::arg("seed"));
    }
}  // namespace ompl_mfa::python
