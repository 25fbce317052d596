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

#ifndef OMPL_MFA_ENGINE_QUERY_
#define OMPL_MFA_ENGINE_QUERY_

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/Goal.h>
#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>

#include "path/DubinsGuard.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief The start and goal states of a problem definition that are known so far, without duplicates. Goals may
        arrive late. Each solve() may bring another problem definition, or changed states and goal in the same one: what
        is known is kept as long as the query still includes all of it. */
    class Query
    {
    public:
        explicit Query(const ompl::base::StateSpacePtr &space);

        /** \brief Whether \e pdef is a different query: it has another goal or objective, or lacks one of starts() or
            goals(). Additional states and the order of states make no difference. */
        bool differsFrom(const ompl::base::ProblemDefinition &pdef) const;

        /** \brief Whether \e other was asked with the same objective. */
        bool hasObjectiveOf(const Query &other) const
        {
            return askedObjective_ == other.askedObjective_;
        }

        /** \brief Whether \e path begins at one of starts() and ends at one of goals() or at another state that
            satisfies the goal. */
        bool isAnsweredBy(const path::Waypoints &path) const;

        /** \brief Stores the goal and objective of \e pdef. To be called once, before begin(). */
        void ask(const ompl::base::ProblemDefinition &pdef);

        /** \brief To be called at the beginning of each solve(): reads all start states and, if the goal can be sampled
            and no goal state is known, waits for the first. Returns EXACT_SOLUTION if planning can begin, else the
            status that explains why not. For a goal that cannot be sampled but measures distances, goal states have to
            be searched for and added by addGoal(). */
        ompl::base::PlannerStatus::StatusType begin(ompl::base::PlannerInputStates &inputs,
                                                    const ompl::base::PlannerTerminationCondition &ptc,
                                                    const ompl::base::SpaceInformationPtr &si);

        /** \brief Adds start and goal states that arrived since the last call; true if there were any. */
        bool poll(ompl::base::PlannerInputStates &inputs);

        /** \brief Adds \e state, which must be valid and satisfy the goal; true if it is new. */
        bool addGoal(const ompl::base::State *state);

        /** \brief Whether goal states have to be searched for: the goal cannot be sampled but measures distances. */
        bool needsGoalSearch() const;

        /** \brief Whether the maximum number of goal states is reached. */
        bool hasEnoughGoals() const;

        const path::Waypoints &starts() const
        {
            return starts_;
        }

        const path::Waypoints &goals() const
        {
            return goals_;
        }

        /** \brief Whether goals() is final: no further goal state can arrive. */
        bool goalsComplete() const;

        const ompl::base::GoalPtr &goal() const
        {
            return goal_;
        }

    private:
        /** \brief Waits for a first valid goal state as long as one can arrive. */
        ompl::base::PlannerStatus::StatusType awaitGoal(ompl::base::PlannerInputStates &inputs,
                                                        const ompl::base::PlannerTerminationCondition &ptc);

        /** \brief Whether a goal state can be read without waiting, valid or not. */
        bool haveMoreGoals(const ompl::base::PlannerInputStates &inputs) const;

        /** \brief Reads a goal state, if there is one; true if it is valid and new. */
        bool readGoal(ompl::base::PlannerInputStates &inputs);
        bool readListedGoal();
        void skipKnownGoals();
        bool takeStart(const ompl::base::State *state);
        bool goalsStillHold() const;

        path::Waypoints starts_;
        path::Waypoints goals_;
        path::DubinsGuard guard_;
        std::vector<bool> satisfied_;  ///< for each of goals_: whether it satisfied the goal when it was added
        ompl::base::SpaceInformationPtr si_;
        ompl::base::GoalPtr goal_;
        ompl::base::OptimizationObjectivePtr askedObjective_;
        std::size_t listed_{0};  ///< number of states read in this solve() from a goal that lists its states
        std::uint64_t polls_{0};
        std::uint64_t nextGoalPoll_{0};
        std::uint64_t sampled_{0};  ///< valid goal states sampled so far, including known ones
    };
}  // namespace ompl_mfa::engine

#endif
