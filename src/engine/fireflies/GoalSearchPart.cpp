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

#include "engine/fireflies/GoalSearchPart.h"

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Work between two turns, for each goal state found so far. */
        constexpr std::uint64_t PAUSE = 400;
    }  // namespace

    GoalSearchPart::GoalSearchPart(const SearchContext &context)
      : SearchPart(PartKind::GoalSearch, context)
    {
    }

    Share GoalSearchPart::firstShare() const
    {
        return {0.2, 0.2};
    }

    Share GoalSearchPart::improvementShare(double /*seconds*/) const
    {
        return {0.05, 0.05};
    }

    Readiness GoalSearchPart::readiness() const
    {
        const Query &query = context().query;
        if (query.starts().empty() || query.hasEnoughGoals())
        {
            return Readiness::Idle;
        }
        // the more goal states there are, the less another is worth
        return query.goals().empty() || context().evaluator().work() >= due_ ? Readiness::Ready : Readiness::Idle;
    }

    /* One generation, whatever the budget. */
    void GoalSearchPart::advance(std::uint64_t /*work*/, Findings &findings)
    {
        path::PathEvaluator &evaluator = context().evaluator();
        if (!search_)
        {
            search_ = std::make_unique<GoalSearch>(context().chart, context().spaceInformation(),
                                                   context().query.goal(), context().query.starts().front(),
                                                   streamSeed(context().seed, Stream::GoalSearch));
        }
        const std::uint64_t before = search_->evaluations();
        if (search_->advance([&] { return evaluator.stopped(); }, findings.goals))
        {
            due_ = evaluator.work() + PAUSE * ++found_;
        }
        evaluator.addChecks(search_->evaluations() - before);
    }
}  // namespace ompl_mfa::engine::fireflies
