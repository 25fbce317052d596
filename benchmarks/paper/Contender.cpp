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

#include "paper/Contender.h"

#include <algorithm>
#include <stdexcept>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "paper/PagmoContender.h"
#include "paper/Recorder.h"

namespace ompl_mfa::paper
{
    namespace
    {
        using Variant = FireflyOptimizer::Variant;
        using Alpha = FireflyOptimizer::AlphaSchedule;
        using Beta = FireflyOptimizer::BetaSchedule;

        /** \brief Number of generations within BUDGET if each costs N - 1 evaluations. */
        unsigned int affordableGenerations(unsigned int populationSize)
        {
            return static_cast<unsigned int>((BUDGET - populationSize) / (populationSize - 1));
        }

        FireflyOptimizer::Settings ablated(const std::string &algorithm)
        {
            FireflyOptimizer::Settings settings;
            if (algorithm == "no_eq13")
            {
                settings.alphaSchedule = Alpha::Constant;
            }
            else if (algorithm == "no_eq14")
            {
                settings.betaSchedule = Beta::Constant;
            }
            else if (algorithm == "no_trials")
            {
                settings.trialVectors.fill(false);
            }
            else
            {
                settings.trialVectors.at(static_cast<std::size_t>(std::stoi(algorithm.substr(5)) - 8)) = false;
                // The evaluations saved without the trial vector are used for further generations.
                settings.generations = 60;
            }
            return settings;
        }

        /** \brief Settings of a firefly algorithm, with its epoch extended to the whole budget. */
        FireflyOptimizer::Settings fireflySettings(const std::string &algorithm)
        {
            FireflyOptimizer::Settings settings;
            const bool isAblation = algorithm.rfind("no_", 0) == 0;
            if (isAblation)
            {
                settings = ablated(algorithm);
            }
            if (algorithm == "mfa" || (isAblation && algorithm != "no_trials"))
            {
                return settings;
            }
            if (!isAblation)
            {
                settings.variant = Variant::FA;
            }
            if (algorithm == "fa_yang")
            {
                // n = 20, alpha 0.5, beta_min 0.2, gamma 1, as in Yang's reference program.
                settings.populationSize = 20;
                settings.alpha = 0.5;
                settings.betaMin = 0.2;
                settings.gamma = 1.0;
                settings.alphaSchedule = Alpha::Yang;
            }
            else if (algorithm == "fa_linear")
            {
                settings.alphaSchedule = Alpha::Linear;
            }
            else if (algorithm == "fa_long")
            {
                // FA performs better if all fireflies attract each other; a larger gamma would favour MFA.
                settings.gamma = 0.005;
            }
            settings.generations = affordableGenerations(settings.populationSize);
            return settings;
        }

        Run runFireflies(const FireflyOptimizer::Settings &settings, Recorder &recorder, const Eigen::VectorXd &lower,
                         const Eigen::VectorXd &upper, std::uint64_t seed)
        {
            FireflyOptimizer optimizer(settings, lower, upper, seed);
            const auto isSpent = [&recorder] { return recorder.isSpent(); };
            while (optimizer.step(recorder, isSpent))
            {
            }
            auto run = recorder.finish();
            run.population = optimizer.population();
            return run;
        }
    }  // namespace

    const std::vector<std::string> &contenders()
    {
        static const std::vector<std::string> NAMES{"ga",  "fa", "mfa",  "fa_yang", "fa_linear", "fa_long",
                                                    "pso", "de", "sade", "cmaes",   "abc",       "gwo"};
        return NAMES;
    }

    const std::vector<std::string> &ablations()
    {
        static const std::vector<std::string> NAMES{"no_eq8",  "no_eq9",    "no_eq10", "no_eq11",
                                                    "no_eq12", "no_trials", "no_eq13", "no_eq14"};
        return NAMES;
    }

    Run runContender(const std::string &algorithm, ObjectiveFunction &objective, const Eigen::VectorXd &lower,
                     const Eigen::VectorXd &upper, double target, std::uint64_t seed)
    {
        const auto isOneOf = [&algorithm](const std::vector<std::string> &names)
        { return std::find(names.begin(), names.end(), algorithm) != names.end(); };
        Recorder recorder(objective, target);
        if (isPagmoContender(algorithm))
        {
            runPagmo(algorithm, recorder, lower, upper, static_cast<unsigned int>(seed));
            return recorder.finish();
        }
        if (!isOneOf(contenders()) && !isOneOf(ablations()))
        {
            throw std::invalid_argument("runContender: unknown algorithm '" + algorithm + "'");
        }
        return runFireflies(fireflySettings(algorithm), recorder, lower, upper, seed);
    }
}  // namespace ompl_mfa::paper
