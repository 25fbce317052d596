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

#include "engine/refinement/TightenRounds.h"

#include <cmath>
#include <cstdint>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* Maximum rounds, and the work of each as a factor of the work of checking the path once. */
        constexpr unsigned int ROUNDS = 8;
        constexpr std::uint64_t ROUND_FACTOR = 3;
        /* A path is given up if this many more rounds like the last would not make it better than its rival. */
        constexpr double PATIENCE = 4.0;
        /* A round that gains less than this fraction of the cost is the last, from the fourth on. */
        constexpr double LEAST_GAIN = 1e-3;
        constexpr unsigned int LEAST_ROUNDS = 3;
    }  // namespace

    ob::Cost tightenRounds(PathTightening &tightening, path::PathEvaluator &evaluator, ob::Cost cost, ob::Cost rival,
                           bool untilBetter)
    {
        const ob::OptimizationObjective &objective = *evaluator.objective();
        const std::uint64_t work = ROUND_FACTOR * evaluator.checkWork(tightening.path());
        for (unsigned int k = 0; k < ROUNDS && !tightening.converged() && !evaluator.stopped(); ++k)
        {
            tightening.advance(work);
            const double before = cost.value();
            cost = tightening.cost();
            if (untilBetter && objective.isCostBetterThan(cost, rival))
            {
                break;
            }
            // no extrapolation from an infinite cost
            const ob::Cost promised(cost.value() - PATIENCE * (before - cost.value()));
            if (k > 0 && std::isfinite(cost.value()) && !objective.isCostBetterThan(cost, rival) &&
                !objective.isCostBetterThan(promised, rival))
            {
                break;
            }
            if (k >= LEAST_ROUNDS && std::abs(before - cost.value()) < LEAST_GAIN * std::abs(cost.value()))
            {
                break;
            }
        }
        return cost;
    }
}  // namespace ompl_mfa::engine::refinement
