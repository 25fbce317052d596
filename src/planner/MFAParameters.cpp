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

#include "planner/MFAParameters.h"

#include <cstdint>
#include <limits>
#include <type_traits>

namespace ompl_mfa::planner
{
    static_assert(std::is_same_v<decltype(engine::SearchSettings::seed), std::uint32_t>, "a seed has 32 bits");

    const std::vector<AnyMFAParameter> &mfaParameters()
    {
        using Word = MFAParameter<std::string>;
        using Whole = MFAParameter<unsigned int>;
        using Real = MFAParameter<double>;
        using Switch = MFAParameter<bool>;
        using Words = AcceptedValues<std::string>;
        using Numbers = AcceptedValues<unsigned int>;
        using Reals = AcceptedValues<double>;
        static const std::vector<AnyMFAParameter> TABLE{
            Word{"variant", &engine::SearchSettings::variant, Words({"mfa", "fa"}),
                 "the paper's modified firefly algorithm or the original one"},
            Switch{"fireflies",
                   &engine::SearchSettings::fireflies,
                   {},
                   "whether the firefly algorithm is used; without it and without recombination only the guides and "
                   "tightening search"},
            Word{"firefly_moves", &engine::SearchSettings::fireflyMoves, Words({"both", "equations", "detours"}),
                 "how fireflies move once there is a path: by the equations, by random detours, or both in turn"},
            // one range for both variants; trial vectors need four fireflies
            Whole{"population_size", &engine::SearchSettings::populationSize, Numbers(4, 1, 10000, 0),
                  "size of the swarm; 0: 100 in paper mode, else 20 before there is a path and 8 from then on"},
            Whole{"slices", &engine::SearchSettings::slices, Numbers(1, 1, 1000),
                  "slices across the axis from start to goal, m - 1 in the paper; used until there is a path"},
            Whole{"generations", &engine::SearchSettings::generations, Numbers(1, 1, 100000),
                  "length of an epoch, over which the random step and the attraction shrink"},
            Real{"gamma", &engine::SearchSettings::gamma, Reals(0.0, 0.01, 100.0),
                 "light absorption: how fast the attraction decreases with the distance of two fireflies, measured in "
                 "ranges of their coordinates"},
            Real{"alpha", &engine::SearchSettings::alpha, Reals(0.0, 0.01, 1.0),
                 "random step at the beginning of an epoch"},
            Real{"eta", &engine::SearchSettings::eta, Reals(0.0, 0.01, 2.0),
                 "attraction at distance 0 at the beginning of an epoch; 1 moves a firefly to the position of the "
                 "brighter one"},
            Word{"guide", &engine::SearchSettings::guide, Words({"none", "trees", "roadmap", "both"}),
                 "planners besides the swarm, for paths that straight slices cannot represent: RRT-Connect with "
                 "restarts, a growing roadmap"},
            Switch{"recombination",
                   &engine::SearchSettings::recombination,
                   {},
                   "combines sections of the swarm's paths into better paths"},
            Switch{"tightening",
                   &engine::SearchSettings::tightening,
                   {},
                   "refines new paths: fewer vertices, shortcuts, pulls toward the chord, cut corners"},
            Whole{"seed", &engine::SearchSettings::seed, Numbers(0, 1, std::numeric_limits<std::uint32_t>::max()),
                  "makes runs repeatable: fixes the random numbers, and no decision depends on a clock; 0: every run "
                  "is different"},
            Real{"state_check_time", &engine::SearchSettings::stateCheckTime, Reals(0.001, 0.001, 100000.0),
                 "duration of a state check, by which a seeded run, which reads no clock, allocates its time"},
            Whole{"threads", &engine::SearchSettings::threads, Numbers(1, 1, 64),
                  "number of threads that check states and motions, see above"},
            Whole{"strictness", &engine::SearchSettings::strictness, Numbers(1, 1, 64),
                  "a published path is checked at this many times the resolution, see above; 1: at the resolution "
                  "only; without effect in the paper's algorithm"}};
        return TABLE;
    }
}  // namespace ompl_mfa::planner
