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

#include "engine/fireflies/RecombinationPart.h"

#include <utility>

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* A splice is tightened if it costs at most this factor times the best path. */
        constexpr double SLACK = 1.1;
    }  // namespace

    RecombinationPart::RecombinationPart(const SearchContext &context, std::shared_ptr<Swarms> swarms)
      : SearchPart(PartKind::Recombination, context)
      , swarms_(std::move(swarms))
    {
    }

    Share RecombinationPart::firstShare() const
    {
        return {0.03, 0.03};
    }

    Share RecombinationPart::improvementShare(double seconds) const
    {
        return {0.04, 0.04, Swarms::DELAY * seconds};
    }

    Readiness RecombinationPart::readiness() const
    {
        const Swarm *swarm = swarms_->current();
        if (swarm == nullptr || swarms_->resting() || swarm->frame().slices() == 0 ||
            swarm->fireflies().evaluations() == 0)
        {
            return Readiness::Idle;
        }
        return swarms_->waitForGuides() ? Readiness::Waiting : Readiness::Ready;
    }

    void RecombinationPart::advance(std::uint64_t work, Findings &findings)
    {
        Swarm *swarm = swarms_->active();
        if (swarm == nullptr)
        {
            return;
        }
        const Incumbent &incumbent = context().incumbent;
        path::Waypoints onSlices(context().chart->space());
        path::Waypoints spliced(context().chart->space());
        if (!incumbent.hasPath() || !swarm->frame().crossings(incumbent.path(), onSlices))
        {
            onSlices.clear();
        }
        const double bound =
            context().evaluator().withSlack(incumbent.bound(), context().settings.tightening ? SLACK : 1.0);
        if (swarm->recombine(onSlices, bound, work, spliced))
        {
            propose(std::move(spliced), findings);
        }
    }
}  // namespace ompl_mfa::engine::fireflies
