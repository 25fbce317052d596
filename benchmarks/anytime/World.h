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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_WORLD_
#define OMPL_MFA_BENCHMARKS_ANYTIME_WORLD_

#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>

#include "path/CountingValidityChecker.h"

namespace ompl_mfa::anytime
{
    /** \brief A problem with one start, one goal, a counting validity checker and path length as the objective. */
    struct Problem
    {
        ompl::base::SpaceInformationPtr si;
        ompl::base::ProblemDefinitionPtr pdef;
        std::shared_ptr<const path::CountingValidityChecker> checker;
    };

    /** \brief A problem that can be made identically in the process of each run. */
    struct World
    {
        std::string name;
        /** \brief Common name of worlds that differ only in their seed. */
        std::string family;
        /** \brief Makes random number generators of OMPL, so a seed has to be set before. */
        std::function<Problem()> make;
        /** \brief Length of the shortest path, computed from geometry; empty if not available. */
        std::function<double()> optimum;
    };

    using StateCheck = std::function<bool(const double *)>;

    /** \brief A problem in a box of R^n with path length as its objective.

        \e isFree is called with the n coordinates of a state within bounds. \e resolution is the largest distance
        between two checked states of a motion. */
    Problem makeProblem(const Eigen::VectorXd &lower, const Eigen::VectorXd &upper, const Eigen::VectorXd &start,
                        const Eigen::VectorXd &goal, double resolution, StateCheck isFree);

    /** \brief The problem of \e si and \e pdef, with its checker replaced by a counting one. */
    Problem countChecks(const ompl::base::SpaceInformationPtr &si, const ompl::base::ProblemDefinitionPtr &pdef);

    /** \brief Random numbers for the worlds. Standard distributions differ between libraries; this one is
        reproducible. */
    class WorldRandom
    {
    public:
        explicit WorldRandom(std::uint64_t seed)
          : engine_(seed)
        {
        }

        /** \brief Uniform in [low, high). */
        double uniform(double low, double high);

    private:
        std::mt19937_64 engine_;
    };
}  // namespace ompl_mfa::anytime

#endif
