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

#include "engine/SearchPart.h"

#include <algorithm>
#include <utility>

namespace ompl_mfa::engine
{
    namespace
    {
        /* The dimension in which the roadmap has its nominal share. In more dimensions it has less and in fewer more,
           up to a maximum factor. */
        constexpr double ROADMAP_DIMENSIONS = 3.0;
        constexpr double MOST_ROADMAP = 1.5;
    }  // namespace

    SearchPart::SearchPart(PartKind kind, const SearchContext &context)
      : kind_(kind)
      , context_(context)
    {
    }

    void SearchPart::improved(const Proposal & /*proposal*/)
    {
    }

    void SearchPart::inherit(SearchPart & /*predecessor*/, const Heritage & /*heritage*/)
    {
    }

    void SearchPart::explain(SearchGraph & /*graph*/) const
    {
    }

    void SearchPart::propose(path::Waypoints path, Findings &findings) const
    {
        findings.paths.push_back({std::move(path), std::nullopt, Proposal::Stage::Raw, kind_, false});
    }

    double roadmapFactor(const path::StateChart &chart)
    {
        return std::min(MOST_ROADMAP, ROADMAP_DIMENSIONS / static_cast<double>(chart.dimension()));
    }
}  // namespace ompl_mfa::engine
