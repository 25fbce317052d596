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

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/refinement/TightenRounds.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* A draft is repaired if it costs at most this factor times the path that it should beat: the repaired path is
           tightened further. */
        constexpr double DRAFT_SLACK = 1.01;
        /* Relative gain that a draft of the best path must promise to be repaired. */
        constexpr double LEAST_PROMISE = 0.004;
        /* Another best path that is better by this fraction replaces the draft of the last one. */
        constexpr double RESTART_GAIN = 0.003;
    }  // namespace

    TighteningPart::TighteningPart(const SearchContext &context)
      : SearchPart(PartKind::Tightening, context)
      , best_(std::make_unique<PathTightening>(context.chart, context.evaluator(),
                                               streamSeed(context.seed, Stream::Tightening)))
      , new_(std::make_unique<PathTightening>(context.chart, context.evaluator(),
                                              streamSeed(context.seed, Stream::NewTightening)))
      , draft_(context.chart, context.evaluator(), streamSeed(context.seed, Stream::DraftTightening))
      , bestDraft_(context.chart, context.evaluator(), streamSeed(context.seed, Stream::BestDraft))
      , repair_(context.chart, context.evaluator(), streamSeed(context.seed, Stream::Repair))
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

    /* Relative to the cost before; negative if that was better. */
    double TighteningPart::gain(double before, double after) const
    {
        const double size = std::abs(before - after) / std::max(std::abs(before), 1e-12);
        return context().evaluator().isBetter(after, before) ? size : -size;
    }

    void TighteningPart::advance(std::uint64_t work, Findings &findings)
    {
        refined_ = false;
        if (turn_++ % 2 == 0 && advanceDraft(work, findings))
        {
            return;
        }
        const Incumbent &incumbent = context().incumbent;
        if (std::exchange(stale_, false))
        {
            best_->begin(incumbent.path());
        }
        if (best_->advance(work))
        {
            findings.paths.push_back({best_->path(), best_->cost(), Proposal::Stage::Tight, incumbent.origin(), false});
        }
    }

    /* Tightens the draft of the best path; false if there is nothing to gain by it. */
    bool TighteningPart::advanceDraft(std::uint64_t work, Findings &findings)
    {
        const Incumbent &incumbent = context().incumbent;
        const unsigned int stride = context().draftStride();
        if (stride < 2)
        {
            return false;
        }
        if (drafted_.promised > 0.0)
        {
            // a draft that did not become the best path must promise more the next time, or it is proposed for ever
            drafted_.promise = 2.0 * std::max(drafted_.promise, drafted_.promised);
            drafted_.promised = 0.0;
        }
        if (!drafted_.begun || gain(drafted_.cost, incumbent.cost()) > RESTART_GAIN)
        {
            bestDraft_.begin(incumbent.path());
            drafted_ = {incumbent.cost(), true, false, LEAST_PROMISE, 0.0};
        }
        if (drafted_.done)
        {
            return false;
        }
        const path::StrideScope draft(context().evaluator(), stride);
        bestDraft_.advance(work);
        drafted_.done = bestDraft_.converged();
        const ob::Cost cost = bestDraft_.cost();
        const double promised = gain(incumbent.cost(), cost.value());
        if (promised > drafted_.promise * (drafted_.done ? 0.5 : 1.0) && !context().evaluator().interrupted())
        {
            drafted_.promised = promised;
            findings.paths.push_back({bestDraft_.path(), cost, Proposal::Stage::Tight, incumbent.origin(), true});
        }
        return true;
    }

    void TighteningPart::improved(const Proposal &proposal)
    {
        stale_ = proposal.stage != Proposal::Stage::Tight;
        if (!stale_ && refined_)
        {
            std::swap(best_, new_);
        }
        if (drafted_.promised > 0.0)
        {
            drafted_.promised = 0.0;
            drafted_.cost = context().incumbent.cost();
        }
    }

    Proposal TighteningPart::refine(Proposal proposal, ob::Cost rival)
    {
        const path::Waypoints raw = proposal.path;
        const ob::Cost rawCost = *proposal.cost;
        const bool rawDraft = proposal.draft;
        const bool tighten = proposal.stage == Proposal::Stage::Raw;
        refined_ = false;
        proposal.stage = Proposal::Stage::Tight;
        if (tighten && context().draftStride() > 1 && !tightenDraft(proposal, rival))
        {
            return proposal;
        }
        if (proposal.draft && !repair(proposal))
        {
            if (rawDraft || context().evaluator().interrupted())
            {
                return proposal;
            }
            proposal.path = raw;
            proposal.cost = rawCost;
            proposal.draft = false;
        }
        tightenFully(proposal, rival);
        return proposal;
    }

    /* Whether the draft promises to be better than the rival. */
    bool TighteningPart::tightenDraft(Proposal &proposal, ob::Cost rival)
    {
        path::PathEvaluator &evaluator = context().evaluator();
        const path::StrideScope draft(evaluator, context().draftStride());
        const ob::Cost promising(evaluator.withSlack(rival.value(), DRAFT_SLACK));
        const bool best = !evaluator.isBetter(context().incumbent.cost(), proposal.cost->value());
        draft_.begin(proposal.path);
        proposal.cost = tightenRounds(draft_, evaluator, *proposal.cost, promising, !best);
        proposal.path = draft_.path();
        proposal.draft = true;
        return !evaluator.interrupted() && evaluator.isBetter(proposal.cost->value(), promising.value());
    }

    bool TighteningPart::repair(Proposal &proposal)
    {
        path::Waypoints repaired = proposal.path;
        if (!repair_.repair(repaired))
        {
            return false;
        }
        const ob::Cost cost = context().evaluator().cost(repaired);
        if (context().evaluator().interrupted())
        {
            return false;
        }
        proposal.path = std::move(repaired);
        proposal.cost = cost;
        proposal.draft = false;
        return true;
    }

    void TighteningPart::tightenFully(Proposal &proposal, ob::Cost rival)
    {
        refined_ = true;
        new_->begin(proposal.path);
        proposal.cost = tightenRounds(*new_, context().evaluator(), *proposal.cost, rival, true);
        proposal.path = new_->path();
    }
}  // namespace ompl_mfa::engine::refinement
