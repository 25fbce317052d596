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

#ifndef OMPL_MFA_ENGINE_GUIDES_INFORMED_SAMPLER_
#define OMPL_MFA_ENGINE_GUIDES_INFORMED_SAMPLER_

#include <cstdint>
#include <vector>

#include <ompl/base/StateSampler.h>
#include <ompl/util/RandomNumbers.h>

#include "engine/PairBounds.h"
#include "engine/guides/HyperspheroidCache.h"
#include "path/CostBounds.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::guides
{
    /** \brief Draws states through which a path better than a given cost can lead, by the lower bounds (the informed
        set).

        With several starts and goals each sample is drawn for a random pair among those that can still be on a
        better path; the informed set is the union of the pairs' informed sets.

        Where the objective is path length over the standard metrics, positions are drawn directly from the prolate
        hyperspheroid of the pair; otherwise uniform samples are rejected by the heuristic. It has its own random
        number generator, so that the same seed gives the same states.

        Where the user has set a StateSamplerAllocator on the space, or on a subspace of it, every other state is
        drawn by that sampler, brought within the bounds, and rejected by the heuristic like any other; whether it
        repeats for the same seed depends on that sampler. */
    class InformedSampler
    {
    public:
        /** \brief \e bounds must outlive the object. */
        InformedSampler(path::StateChartPtr chart, const path::CostBounds &bounds, std::uint_fast32_t seed);

        /** \brief Draws \e state such that the heuristic cost through it, from one of \e starts to one of \e goals, is
            better than \e bound (infinity: any state). False if no such state was found in a few tries. Between calls,
            states may only be appended to \e starts and \e goals. */
        bool sample(const path::Waypoints &starts, const path::Waypoints &goals, double bound,
                    ompl::base::State *state);

        /** \brief A lower bound of the cost of paths through the last state drawn; NaN if it was not computed. */
        double lowerBound() const
        {
            return lowerBound_;
        }

        /** \brief Lower bounds of the starts and goals that the last sample was drawn for. */
        PairBounds &pairs()
        {
            return pairs_;
        }

    private:
        void takeUpEnds(const path::Waypoints &starts, const path::Waypoints &goals, double bound);
        bool pickPair(double bound, std::uint32_t &start, std::uint32_t &goal);
        bool samplePositions(const path::Waypoints &starts, std::uint32_t start, const path::Waypoints &goals,
                             std::uint32_t goal, double bound, ompl::base::State *state);
        void sampleByUser(ompl::base::State *state);

        path::StateChartPtr chart_;
        const path::CostBounds &bounds_;
        ompl::RNG rng_;
        ompl::base::StateSamplerPtr users_;  ///< null unless the user has set one
        bool usersTurn_{false};
        bool direct_;
        double lowerBound_;
        PairBounds pairs_;
        double bound_;                       ///< bound by which the ends below were last selected
        std::vector<std::uint32_t> starts_;  ///< those that can be on a better path
        std::vector<std::uint32_t> goals_;
        std::size_t takenStarts_{0};
        std::size_t takenGoals_{0};
        Eigen::VectorXd focus1_;
        Eigen::VectorXd focus2_;
        Eigen::VectorXd values_;
        HyperspheroidCache hyperspheroids_;
    };
}  // namespace ompl_mfa::engine::guides

#endif
