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

#ifndef OMPL_MFA_PAGMO_PAGMO_FIREFLY_
#define OMPL_MFA_PAGMO_PAGMO_FIREFLY_

#include <string>

#include <pagmo/algorithm.hpp>
#include <pagmo/population.hpp>
#include <pagmo/rng.hpp>

#include "ompl_mfa/Export.h"

namespace ompl_mfa
{
    /** \brief The Modified Firefly Algorithm as a user-defined algorithm of pagmo:
        `pagmo::algorithm{ompl_mfa::PagmoFirefly{50}}`.

        It takes single-objective, unconstrained, deterministic problems with finite bounds; populations of at least 4
        for MFA, 1 for FA. An epoch of the schedules, eqs. (13) and (14), is one call of evolve. */
    class OMPL_MFA_EXPORT PagmoFirefly
    {
    public:
        /** \brief \e variant is "mfa" or "fa"; \e generations is the number of generations of one evolve. Throws
            std::invalid_argument for values that FireflyOptimizer::Settings does not accept. */
        explicit PagmoFirefly(unsigned int generations = 50, double gamma = 0.5, double alpha = 0.2, double eta = 1.0,
                              const std::string &variant = "mfa", unsigned int seed = pagmo::random_device::next());

        /** \brief Evolves a copy of \e population, whose members are the first fireflies; nothing is evaluated twice.
            The best point found is in the population returned. Throws std::invalid_argument for problems and
            populations that are not suitable. */
        pagmo::population evolve(pagmo::population population) const;

        void set_seed(unsigned int seed);        // NOLINT(readability-identifier-naming): pagmo's name
        void set_verbosity(unsigned int level);  // NOLINT(readability-identifier-naming): pagmo's name

        unsigned int get_seed() const  // NOLINT(readability-identifier-naming): pagmo's name
        {
            return seed_;
        }

        unsigned int get_gen() const  // NOLINT(readability-identifier-naming): pagmo's name
        {
            return generations_;
        }

        std::string get_name() const;        // NOLINT(readability-identifier-naming): pagmo's name
        std::string get_extra_info() const;  // NOLINT(readability-identifier-naming): pagmo's name

        template <typename Archive>
        void serialize(Archive &archive, unsigned int /*version*/)
        {
            archive &generations_ &gamma_ &alpha_ &eta_ &isMfa_ &seed_ &verbosity_ &calls_;
        }

    private:
        unsigned int generations_;
        double gamma_;
        double alpha_;
        double eta_;
        bool isMfa_;
        unsigned int seed_;
        unsigned int verbosity_{0};

        /** \brief Calls of evolve since the seed was set: each goes on with other random numbers. */
        mutable unsigned int calls_{0};
    };
}  // namespace ompl_mfa

PAGMO_S11N_ALGORITHM_EXPORT_KEY(ompl_mfa::PagmoFirefly)

#endif
