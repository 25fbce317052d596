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

#include "engine/AnswerMaker.h"
#include "engine/OptimalityProof.h"
#include "engine/PartRegistry.h"
#include "engine/PathHints.h"
#include "engine/SearchContext.h"
#include "engine/SearchPart.h"
#include "engine/StraightMotions.h"
#include "engine/TurnSharing.h"

namespace ompl_mfa::engine
{
    /** \brief The search for one query: chooses which part gets the next turn, tightens and compares the paths that the
        parts propose, and decides when to stop. */
    class Engine
    {
    public:
        /** \brief Arguments as for SearchContext; \e guest allocates the guide planner, or is null. Throws
            ompl::Exception if no part can find a first path, or if \e guest returns no planner. */
        Engine(const ompl::base::Planner &owner, const path::StateChartPtr &chart, const SearchSettings &settings,
               std::uint64_t seed, const ompl::base::PlannerAllocator &guest, SearchProgress &progress);
        ~Engine();
        Engine(const Engine &) = delete;
        Engine &operator=(const Engine &) = delete;

        /** \brief Takes what is of use in this search from \e predecessor, an earlier search for any query: roadmap,
           good paths as hints, and fireflies. \e sameValidity is whether states and motions that it found valid or
           invalid still are. To be called before search(); the predecessor is not used again. */
        void inherit(Engine &predecessor, bool sameValidity);

        /** \brief Adds a path of any states, at least one, which may help: it is joined to start and goal and made
           valid if necessary. In the paper's algorithm it becomes a firefly of the next swarm that is made. */
        void addHint(path::Waypoints path);

        /** \brief Whether this search can be continued for \e pdef: the query and the bounds of the space are the same,
           and the results so far are still valid. Goals and the validity checker's answers may have changed, so the
           best path is checked again, unless the stop condition leaves no time for it. */
        bool canContinue(const ompl::base::ProblemDefinition &pdef, const ompl::base::PlannerTerminationCondition &ptc);

        /** \brief Searches until \e ptc is true or no better path can be found. The result is the context's answer.
            Returns EXACT_SOLUTION if a search took
            place, whether or not it found a path, else the status that explains why it did not. Calls \e mayPublish at
            the beginning, after each improvement of the answer, and after each turn. */
        ompl::base::PlannerStatus::StatusType search(ompl::base::PlannerInputStates &inputs,
                                                     const ompl::base::PlannerTerminationCondition &ptc,
                                                     const std::function<void()> &mayPublish);

        const SearchContext &context() const
        {
            return context_;
        }

        /** \brief Appends what all parts know, and the best path, to \e graph. */
        void explain(SearchGraph &graph) const;

        /** \brief The swarms of the search; null without fireflies. */
        const fireflies::Swarms *swarms() const
        {
            return parts_.swarms.get();
        }

    private:
        bool finished(const ompl::base::PlannerTerminationCondition &ptc);
        void iterate(ompl::base::PlannerInputStates &inputs, const ompl::base::PlannerTerminationCondition &ptc);
        void tryStraightMotions();
        void tryHints();
        void considerPending();
        void takeTurn(std::size_t number);
        void consider(Findings &findings);
        void consider(Proposal proposal);
        bool offer(const Proposal &proposal);
        bool meetsThreshold(const Incumbent &path) const;
        void updateAnswer();
        void credit(std::optional<PartKind> origin, double gain);
        void updatePhase();
        bool pathHolds(const ompl::base::PlannerTerminationCondition &ptc);
        bool holds(const path::Waypoints &path);
        void offerPartial(const path::Waypoints &path, std::size_t motion, const ompl::base::State *lastValid);

        SearchContext context_;
        std::vector<double> bounds_;  ///< bounds of the space when the search began
        PartList parts_;
        TurnSharing sharing_;
        StraightMotions straightMotions_;
        PathHints hints_;
        OptimalityProof proof_;
        std::unique_ptr<AnswerMaker> answer_;
        std::vector<Proposal> pending_;  ///< proposals whose cost is not computed yet
        std::vector<double> gains_;      ///< gain of each part in this turn
        std::size_t turn_{0};            ///< index of the part whose turn it is
        bool improving_{false};          ///< whether the parts use their improvement shares
        std::function<void()> mayPublish_;
    };
}  // namespace ompl_mfa::engine

#endif
