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

#include "engine/OptimalityProof.h"

#include <ompl/util/RandomNumbers.h>

namespace ompl_mfa::engine
{
    namespace
    {
        /* Random detours that are compared with the objective's lower bounds before a path that meets them ends the
           search. */
        constexpr unsigned int PROBES = 64;
    }  // namespace

    OptimalityProof::OptimalityProof(const SearchContext &context)
      : context_(context)
      , pairs_(context.evaluator().bounds())
    {
    }

    bool OptimalityProof::holds()
    {
        return meetsBounds() && boundsHold();
    }

    bool OptimalityProof::meetsBounds()
    {
        const Query &query = context_.query;
        if (!query.goalsComplete() || !context_.evaluator().bounds().admissible())
        {
            return false;
        }
        pairs_.update(query.starts(), query.goals());
        return pairs_.isBest(context_.incumbent.cost(), query.starts(), query.goals());
    }

    /* The proof relies on the objective's heuristic. Unless that is certain to be a lower bound, it is tested on random
       detours: an objective may charge more for the straight motion than for a detour. */
    bool OptimalityProof::boundsHold()
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const path::CostBounds &bounds = evaluator.bounds();
        if (bounds.certain())
        {
            return true;
        }
        const Query &query = context_.query;
        const auto &space = context_.chart->space();
        ompl::RNG rng(static_cast<std::uint_fast32_t>(streamSeed(context_.seed, Stream::Detours, probes_)));
        path::Waypoints detour(space);
        detour.resize(3);
        for (; probes_ < PROBES && bounds.admissible(); ++probes_)
        {
            space->copyState(detour[0], query.starts()[probes_ % query.starts().size()]);
            context_.chart->sampleUniform(rng, detour[1]);
            space->copyState(detour[2], query.goals()[probes_ % query.goals().size()]);
            evaluator.cost(detour);
            if (evaluator.interrupted())
            {
                return false;
            }
        }
        return bounds.admissible();
    }
}  // namespace ompl_mfa::engine
