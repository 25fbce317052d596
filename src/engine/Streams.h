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

#ifndef OMPL_MFA_ENGINE_STREAMS_
#define OMPL_MFA_ENGINE_STREAMS_

#include <cstdint>

#include "ompl_mfa/optimizer/RandomSource.h"

namespace ompl_mfa::engine
{
    /** \brief The random number streams of a run. Every consumer has its own, so that no two draw the same numbers,
        neither within a run nor in runs with different seeds. */
    enum class Stream : std::uint64_t
    {
        // of a run; the numbers are fixed, so that seeded runs of the paper's algorithm are the same in every version
        Trees = 0,              ///< TreePart
        Roadmap = 1,            ///< RoadmapPart
        Tightening = 2,         ///< PathTightening of the best path
        NewTightening = 3,      ///< PathTightening of new paths
        Swarm = 6,              ///< the swarm on the straight axis with this index
        Detours = 7,            ///< the detour with this index, for testing the objective's bounds
        GoalSearch = 8,         ///< the search for states that satisfy a goal
        DraftTightening = 11,   ///< PathTightening of drafts of new paths
        BestDraft = 12,         ///< PathTightening of a draft of the best path
        Repair = 13,            ///< PathRepair
        PathSwarm = 14,         ///< PathSwarm
        SwarmTightening = 15,   ///< PathTightening in PathSwarm
        LocalTrees = 16,        ///< LocalTrees of PathSwarm
        Strict = 17,            ///< PathRepair in StrictAnswer
        StrictTightening = 18,  ///< PathTightening in StrictAnswer
        Mending = 19,           ///< LocalTrees of PathMending
        Successor = 20,         ///< the search with this index that continues an earlier one

        // of a swarm, or of a search for goals
        Epoch = 9,          ///< the fireflies of the epoch with this index
        Recombination = 10  ///< fresh states for recombination
    };

    /** \brief The seed of \e stream, or of its \e index-th instance if there are several. \e seed is that of the run,
        or of the swarm or goal search that owns the stream. */
    inline std::uint64_t streamSeed(std::uint64_t seed, Stream stream, std::uint64_t index = 0)
    {
        return deriveSeed(seed, static_cast<std::uint64_t>(stream), index);
    }
}  // namespace ompl_mfa::engine

#endif
