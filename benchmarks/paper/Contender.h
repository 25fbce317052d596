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

#ifndef OMPL_MFA_BENCHMARKS_PAPER_CONTENDER_
#define OMPL_MFA_BENCHMARKS_PAPER_CONTENDER_

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/optimizer/ObjectiveFunction.h"

namespace ompl_mfa::paper
{
    /** \brief Maximum number of evaluations of every algorithm: that of MFA with 100 fireflies and 50 generations. */
    constexpr std::uint64_t BUDGET = 100 + 50 * 599;

    /** \brief Result of one run. */
    struct Run
    {
        Brightness best;
        Eigen::VectorXd x;
        std::uint64_t evaluations{0};
        double seconds{0.0};

        /** \brief Evaluations (0 for never) and seconds until the cost first reached the target. */
        std::uint64_t evaluationsToTarget{0};
        double secondsToTarget{0.0};

        /** \brief Best cost so far after each hundredth of the budget; infinite before the first feasible one. */
        std::vector<double> trace;

        /** \brief The final population of a firefly algorithm, d x N. */
        Eigen::MatrixXd population;
    };

    /** \brief The algorithms for any objective: fa, mfa, the firefly variants and pagmo's. */
    const std::vector<std::string> &contenders();

    /** \brief MFA with one of its components left out: no_eq8, ..., no_eq12, no_trials, no_eq13, no_eq14. */
    const std::vector<std::string> &ablations();

    /** \brief Runs one of contenders() or ablations() over the box until BUDGET evaluations are spent. \e target is a
        cost. Throws std::invalid_argument for an unknown name. */
    Run runContender(const std::string &algorithm, ObjectiveFunction &objective, const Eigen::VectorXd &lower,
                     const Eigen::VectorXd &upper, double target, std::uint64_t seed);
}  // namespace ompl_mfa::paper

#endif
