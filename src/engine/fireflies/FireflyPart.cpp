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

#include "engine/fireflies/FireflyPart.h"

#include <algorithm>
#include <utility>

#include "path/PathDeformation.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* A firefly is tightened if it costs at most this factor times the best path. */
        constexpr double SLACK = 1.2;
    }  // namespace

    FireflyPart::FireflyPart(const SearchContext &context, std::shared_ptr<Swarms> swarms)
      : SearchPart(PartKind::Fireflies, context)
      , swarms_(std::move(swarms))
      , paths_(context, swarms_->options().fireflies)
    {
    }

    Share FireflyPart::firstShare() const
    {
        return {0.05, 0.05};
    }

    Share FireflyPart::improvementShare(double seconds) const
    {
        const double weight = 0.08 + 0.14 * std::max(0.0, 1.0 - roadmapFactor(*context().chart));
        return {weight, weight, Swarms::DELAY * seconds};
    }

    Readiness FireflyPart::readiness() const
    {
        if (swarms_->resting())
        {
            return paths_.ready() ? Readiness::Ready : Readiness::Idle;
        }
        if (!swarms_->any())
        {
            return Readiness::Idle;
        }
        return swarms_->waitForGuides() ? Readiness::Waiting : Readiness::Ready;
    }

    void FireflyPart::advance(std::uint64_t work, Findings &findings)
    {
        if (swarms_->resting())
        {
            return paths_.advance(work, findings);
        }
        Swarm *swarm = swarms_->active();
        if (swarm == nullptr)
        {
            return;
        }
        const SearchContext &search = context();
        // a path that tightening cannot make the best is useless
        if (swarms_->options().bounded)
        {
            swarm->setBound(
                search.evaluator().withSlack(search.incumbent.bound(), search.settings.tightening ? SLACK : 1.0));
        }
        if (swarms_->fly(work))
        {
            swarms_->chooseNext();
        }
        proposeFirefly(findings);
    }

    void FireflyPart::proposeFirefly(Findings &findings)
    {
        std::optional<Proposal> firefly = swarms_->takeFirefly();
        if (!firefly)
        {
            return;
        }
        const Incumbent &incumbent = context().incumbent;
        const bool better = incumbent.improvedBy(firefly->cost->value());
        if (!better && (!context().settings.tightening ||
                        !context().objective().isCostBetterThan(ob::Cost(incumbent.cost()), *firefly->cost) ||
                        path::seemDeformable(context().evaluator(), firefly->path, incumbent.path())))
        {
            return;
        }
        findings.paths.push_back(std::move(*firefly));
    }

    void FireflyPart::inherit(SearchPart &predecessor, const Heritage &heritage)
    {
        if (heritage.states)
        {
            swarms_->inherit(*static_cast<FireflyPart &>(predecessor).swarms_);
        }
    }

    void FireflyPart::explain(SearchGraph &graph) const
    {
        swarms_->explain(graph);
        for (std::size_t i = 0; i < context().pool.size(); ++i)
        {
            if (context().pool[i].valid)
            {
                graph.addPath(context().pool[i].path);
            }
        }
    }
}  // namespace ompl_mfa::engine::fireflies
