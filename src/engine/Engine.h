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

#ifndef OMPL_MFA_ENGINE_ENGINE_
#define OMPL_MFA_ENGINE_ENGINE_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <ompl/base/Planner.h>

#include "engine/OptimalityProof.h"
#include "engine/PartRegistry.h"
#include "engine/SearchContext.h"
#include "engine/SearchPart.h"
#include "engine/StraightMotions.h"
#include "engine/TurnSharing.h"

namespace ompl_mfa::engine
{
    /** \brief The search for one query: decides whose turn it is, what becomes of the paths that the parts propose, and
        when the search is over. */
    class Engine
    {
    public:
        /** \brief As SearchContext; \e guest makes a planner that takes turns with the other parts, or is null. Throws
            ompl::Exception where nothing searches, or if \e guest returns no planner. */
        Engine(const ompl::base::Planner &owner, const path::StateChartPtr &chart, const SearchSettings &settings,
               std::uint64_t seed, const ompl::base::PlannerAllocator &guest, SearchProgress &progress);
        ~Engine();
        Engine(const Engine &) = delete;
        Engine &operator=(const Engine &) = delete;

        /** \brief Whether the search for this query can go on for \e pdef: it asks the same, the bounds of the space
           are what they were, and what was found still holds. Goals change in place, and so do the validity checker's
            answers; where the stop condition leaves no time to check, the path is taken as it was. */
        bool canContinue(const ompl::base::ProblemDefinition &pdef, const ompl::base::PlannerTerminationCondition &ptc);

        /** \brief Searches until \e ptc is true or nothing better can be found. Returns EXACT_SOLUTION if it has
            searched, whatever it found, else the status that says why not. Calls \e mayPublish when it begins, when the
            best path became better, and after every turn. */
        ompl::base::PlannerStatus::StatusType search(ompl::base::PlannerInputStates &inputs,
                                                     const ompl::base::PlannerTerminationCondition &ptc,
                                                     const std::function<void()> &mayPublish);

        const SearchContext &context() const
        {
            return context_;
        }

        /** \brief What all parts know, and the best path. */
        void explain(SearchGraph &graph) const;

        /** \brief The swarms of the search; null where no fireflies fly. */
        const fireflies::Swarms *swarms() const
        {
            return parts_.swarms.get();
        }

    private:
        bool finished(const ompl::base::PlannerTerminationCondition &ptc);
        void iterate(ompl::base::PlannerInputStates &inputs, const ompl::base::PlannerTerminationCondition &ptc);
        void tryStraightMotions();
        void considerPending();
        void takeTurn(std::size_t number);
        void consider(Findings &findings);
        void consider(Proposal proposal);
        void consider(const Detour &detour);
        bool offer(const Proposal &proposal);
        void credit(std::optional<PartKind> origin, double gain);
        void updatePhase();
        bool pathHolds(const ompl::base::PlannerTerminationCondition &ptc);
        void offerPartial(const path::Waypoints &path, std::size_t motion, const ompl::base::State *lastValid);

        SearchContext context_;
        std::vector<double> bounds_;  ///< of the space when the search began
        PartList parts_;
        TurnSharing sharing_;
        StraightMotions straightMotions_;
        OptimalityProof proof_;
        std::vector<Proposal> pending_;  ///< whose costs the stop condition left unknown
        std::vector<double> gains_;      ///< of the parts in this turn
        std::size_t turn_{0};            ///< number of the part whose turn it is
        bool improving_{false};          ///< whether the parts share the time as they do once there is a path
        std::function<void()> mayPublish_;
    };
}  // namespace ompl_mfa::engine

#endif
