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

#include "paper/PagmoContender.h"

#include <exception>
#include <utility>

#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/bee_colony.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/gwo.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <pagmo/types.hpp>

namespace ompl_mfa::paper
{
    namespace
    {
        constexpr unsigned int POPULATION = 100;
        constexpr unsigned int GENERATIONS = (BUDGET - POPULATION) / POPULATION;

        /** \brief Above every feasible cost in the study, so that its sum with the violation keeps the order of
            brightness. */
        constexpr double INFEASIBLE = 1e9;

        class BudgetSpent : public std::exception
        {
        };

        /** \brief The objective as a pagmo problem over the unit cube. */
        struct UnitCube
        {
            Recorder *recorder{nullptr};
            Eigen::VectorXd lower;
            Eigen::VectorXd range;

            pagmo::vector_double fitness(const pagmo::vector_double &x) const
            {
                if (recorder->isSpent())
                {
                    throw BudgetSpent();
                }
                const Eigen::Map<const Eigen::VectorXd> unit(x.data(), static_cast<Eigen::Index>(x.size()));
                const Eigen::VectorXd point = lower + range.cwiseProduct(unit);
                const auto brightness = recorder->evaluate(point, nullptr);
                return {brightness.isFeasible() ? brightness.cost : INFEASIBLE + brightness.violation};
            }

            std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const
            {
                const auto size = static_cast<std::size_t>(lower.size());
                return {pagmo::vector_double(size, 0.0), pagmo::vector_double(size, 1.0)};
            }
        };

        pagmo::algorithm makeAlgorithm(const std::string &name, unsigned int dimension, unsigned int seed)
        {
            constexpr double CONVERGED = 1e-12;
            if (name == "ga")
            {
                return pagmo::algorithm(pagmo::sga(GENERATIONS, 0.9, 10.0, 1.0 / dimension, 20.0, 2U, "sbx",
                                                   "polynomial", "tournament", seed));
            }
            if (name == "pso")
            {
                return pagmo::algorithm(pagmo::pso(GENERATIONS, 0.7298, 2.05, 2.05, 0.5, 5U, 2U, 4U, false, seed));
            }
            if (name == "de")
            {
                return pagmo::algorithm(pagmo::de(GENERATIONS, 0.8, 0.9, 2U, CONVERGED, CONVERGED, seed));
            }
            if (name == "sade")
            {
                return pagmo::algorithm(pagmo::sade(GENERATIONS, 2U, 1U, CONVERGED, CONVERGED, false, seed));
            }
            if (name == "cmaes")
            {
                return pagmo::algorithm(
                    pagmo::cmaes(GENERATIONS, -1, -1, -1, -1, 0.3, CONVERGED, CONVERGED, false, true, seed));
            }
            if (name == "abc")
            {
                return pagmo::algorithm(pagmo::bee_colony(GENERATIONS / 2, 20U, seed));
            }
            return pagmo::algorithm(pagmo::gwo(GENERATIONS, seed));
        }
    }  // namespace

    bool isPagmoContender(const std::string &algorithm)
    {
        for (const char *name : {"ga", "pso", "de", "sade", "cmaes", "abc", "gwo"})
        {
            if (algorithm == name)
            {
                return true;
            }
        }
        return false;
    }

    void runPagmo(const std::string &algorithm, Recorder &recorder, const Eigen::VectorXd &lower,
                  const Eigen::VectorXd &upper, unsigned int seed)
    {
        const pagmo::problem problem(UnitCube{&recorder, lower, upper - lower});
        const auto dimension = static_cast<unsigned int>(lower.size());
        try
        {
            for (unsigned int restart = 0; !recorder.isSpent(); ++restart)
            {
                const unsigned int restartSeed = seed + 1000003U * restart;
                makeAlgorithm(algorithm, dimension, restartSeed)
                    .evolve(pagmo::population(problem, POPULATION, restartSeed));
            }
        }
        catch (const BudgetSpent &)
        {
            // The recorder has the result.
        }
    }
}  // namespace ompl_mfa::paper
