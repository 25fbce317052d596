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

#include "engine/refinement/TighteningPart.h"

#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* Maximum rounds of tightening for a new path, and the work of each as a factor of the work of checking the
           path once. */
        constexpr unsigned int ROUNDS = 8;
        constexpr std::uint64_t ROUND_FACTOR = 3;
        /* A new path is given up if this many more rounds like the last would not make it the best. */
        constexpr double PATIENCE = 4.0;
    }  // namespace

    TighteningPart::TighteningPart(const SearchContext &context)
      : SearchPart(PartKind::Tightening, context)
      , best_(std::make_unique<PathTightening>(context.chart, context.evaluator(),
                                               streamSeed(context.seed, Stream::Tightening)))
      , new_(std::make_unique<PathTightening>(context.chart, context.evaluator(),
                                              streamSeed(context.seed, Stream::NewTightening)))
    {
    }

    Share TighteningPart::firstShare() const
    {
        return {0.01, 0.01};
    }

    Share TighteningPart::improvementShare(double /*seconds*/) const
    {
        return {0.30, 0.12};
    }

    /* A single motion of finite cost cannot be improved. */
    Readiness TighteningPart::readiness() const
    {
        const Incumbent &incumbent = context().incumbent;
        return incumbent.hasPath() && (incumbent.path().size() > 2 || !incumbent.hasFinitePath()) ? Readiness::Ready
                                                                                                  : Readiness::Idle;
    }

    void TighteningPart::advance(std::uint64_t work, Findings &findings)
    {
        const Incumbent &incumbent = context().incumbent;
        if (std::exchange(stale_, false))
        {
            best_->begin(incumbent.path());
        }
        refined_ = false;
        if (best_->advance(work))
        {
            findings.paths.push_back({best_->path(), best_->cost(), Proposal::Stage::Tight, incumbent.origin()});
        }
    }

    void TighteningPart::improved(const Proposal &proposal)
    {
        stale_ = proposal.stage != Proposal::Stage::Tight;
        if (!stale_ && refined_)
        {
            std::swap(best_, new_);
        }
    }

    const path::Waypoints &TighteningPart::refine(const path::Waypoints &path, ob::Cost &cost, ob::Cost rival)
    {
        path::PathEvaluator &evaluator = context().evaluator();
        const ob::OptimizationObjective &objective = context().objective();
        std::uint64_t check = path.size();
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            check += path.space()->validSegmentCount(path[i - 1], path[i]);
        }
        refined_ = true;
        new_->begin(path);
        for (unsigned int k = 0; k < ROUNDS && !new_->converged() && !evaluator.stopped(); ++k)
        {
            new_->advance(ROUND_FACTOR * check);
            const double before = cost.value();
            cost = new_->cost();
            if (objective.isCostBetterThan(cost, rival))
            {
                break;
            }
            // no extrapolation from an infinite cost
            const ob::Cost promised(cost.value() - PATIENCE * (before - cost.value()));
            if (k > 0 && std::isfinite(cost.value()) && !objective.isCostBetterThan(promised, rival))
            {
                break;
            }
        }
        return new_->path();
    }
}  // namespace ompl_mfa::engine::refinement
