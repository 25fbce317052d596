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

#include "ompl_mfa/pagmo/PagmoFirefly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

#include <pagmo/exceptions.hpp>
#include <pagmo/io.hpp>
#include <pagmo/s11n.hpp>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/optimizer/RandomSource.h"

PAGMO_S11N_ALGORITHM_IMPLEMENT(ompl_mfa::PagmoFirefly)

namespace
{
    /** \brief The problem of a population, whose members' fitness is known already. */
    class ProblemObjective : public ompl_mfa::ObjectiveFunction
    {
    public:
        explicit ProblemObjective(const pagmo::population &population)
          : problem_(population.get_problem())
          , known_(population.get_f())
          , x_(problem_.get_nx())
        {
        }

        ompl_mfa::Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x,
                                      const ompl_mfa::Brightness * /*rival*/) override
        {
            // The optimiser begins with the members in their order.
            if (next_ < known_.size())
            {
                return {0.0, known_[next_++][0]};
            }
            std::copy(x.data(), x.data() + x.size(), x_.begin());
            return {0.0, problem_.fitness(x_)[0]};
        }

    private:
        const pagmo::problem &problem_;
        const std::vector<pagmo::vector_double> known_;
        pagmo::vector_double x_;
        std::size_t next_{0};
    };

    Eigen::VectorXd toEigen(const pagmo::vector_double &x)
    {
        return Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    }

    pagmo::vector_double fromEigen(const Eigen::Ref<const Eigen::VectorXd> &x)
    {
        return {x.data(), x.data() + x.size()};
    }

    void requireSuitable(const pagmo::problem &problem, const std::string &name)
    {
        const auto refuse = [&](const std::string &what)
        {
            pagmo_throw(std::invalid_argument, name + " cannot deal with " + what + " (problem '" + problem.get_name() +
                                                   "'); it needs one objective, no constraints, no randomness and "
                                                   "continuous, finite bounds");
        };
        if (problem.get_nobj() != 1U)
        {
            refuse("several objectives");
        }
        if (problem.get_nc() != 0U)
        {
            refuse("constraints");
        }
        if (problem.is_stochastic())
        {
            refuse("a stochastic problem");
        }
        if (problem.get_nix() != 0U)
        {
            refuse("integers");
        }
        const auto isFinite = [](double value) { return std::isfinite(value); };
        const auto bounds = problem.get_bounds();
        if (!std::all_of(bounds.first.begin(), bounds.first.end(), isFinite) ||
            !std::all_of(bounds.second.begin(), bounds.second.end(), isFinite))
        {
            refuse("infinite bounds");
        }
    }
}  // namespace

ompl_mfa::PagmoFirefly::PagmoFirefly(unsigned int generations, double gamma, double alpha, double eta,
                                     const std::string &variant, unsigned int seed)
  : generations_(generations)
  , gamma_(gamma)
  , alpha_(alpha)
  , eta_(eta)
  , isMfa_(variant == "mfa")
  , seed_(seed)
{
    if (variant != "mfa" && variant != "fa")
    {
        pagmo_throw(std::invalid_argument,
                    "PagmoFirefly: variant '" + variant + "' is not accepted; use 'mfa' or 'fa'");
    }
    FireflyOptimizer::Settings settings;
    settings.gamma = gamma_;
    settings.alpha = alpha_;
    settings.eta = eta_;
    settings.validate();
}

pagmo::population ompl_mfa::PagmoFirefly::evolve(pagmo::population population) const
{
    requireSuitable(population.get_problem(), get_name());
    if (generations_ == 0U)
    {
        return population;
    }
    FireflyOptimizer::Settings settings;
    settings.variant = isMfa_ ? FireflyOptimizer::Variant::MFA : FireflyOptimizer::Variant::FA;
    settings.populationSize = static_cast<unsigned int>(population.size());
    settings.generations = generations_;
    settings.gamma = gamma_;
    settings.alpha = alpha_;
    settings.eta = eta_;
    const auto bounds = population.get_problem().get_bounds();
    FireflyOptimizer optimizer(settings, toEigen(bounds.first), toEigen(bounds.second), deriveSeed(seed_, 0, calls_++));
    for (const auto &x : population.get_x())
    {
        optimizer.inject(toEigen(x));
    }

    ProblemObjective objective(population);
    const auto never = [] { return false; };
    for (unsigned int generation = 0; generation <= generations_; ++generation)
    {
        optimizer.step(objective, never);
        if (verbosity_ > 0U && generation % verbosity_ == 0U)
        {
            pagmo::print("generation ", generation, ", best ", optimizer.bestBrightness().cost, "\n");
        }
    }
    for (unsigned int i = 0; i < settings.populationSize; ++i)
    {
        population.set_xf(i, fromEigen(optimizer.population().col(i)), {optimizer.brightness(i).cost});
    }
    if (optimizer.bestBrightness().cost < optimizer.brightness(optimizer.brightestIndex()).cost)
    {
        population.set_xf(optimizer.order().back(), fromEigen(optimizer.best()), {optimizer.bestBrightness().cost});
    }
    return population;
}

void ompl_mfa::PagmoFirefly::set_seed(unsigned int seed)
{
    seed_ = seed;
    calls_ = 0;
}

void ompl_mfa::PagmoFirefly::set_verbosity(unsigned int level)
{
    verbosity_ = level;
}

std::string ompl_mfa::PagmoFirefly::get_name() const
{
    return isMfa_ ? "MFA: Modified Firefly Algorithm" : "FA: Firefly Algorithm";
}

std::string ompl_mfa::PagmoFirefly::get_extra_info() const
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << "\tGenerations: " << generations_ << "\n\tgamma: " << gamma_ << "\n\talpha: " << alpha_
        << "\n\teta: " << eta_ << "\n\tSeed: " << seed_ << "\n\tVerbosity: " << verbosity_;
    return out.str();
}
