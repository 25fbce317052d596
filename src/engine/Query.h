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
    /** \brief The start and goal states of a problem definition that are known so far, each of them once. Goals may
        arrive late. The problem definition may be another one in each solve(), and its states and its goal may change
       in place in between: what is known is kept for as long as all of it still is asked for. */
    class Query
    {
    public:
        explicit Query(const ompl::base::StateSpacePtr &space);

        /** \brief Whether \e pdef asks something else than what is known answers: another goal or objective, or one of
            starts() or goals() is no start or no goal state any more. States that were only added, and the order of
            states, make no difference. */
        bool differsFrom(const ompl::base::ProblemDefinition &pdef) const;

        /** \brief Whether \e path begins at one of starts() and ends at one of goals() or where the goal is satisfied
            otherwise. */
        bool isAnsweredBy(const path::Waypoints &path) const;

        /** \brief Remembers what \e pdef asks. To be called once, before begin(). */
        void ask(const ompl::base::ProblemDefinition &pdef);

        /** \brief To be called at the beginning of each solve(): reads all start states and waits for a first goal
            state where the goal can be sampled and none is known. Returns EXACT_SOLUTION if planning can begin, else
            the status that says why not. States that satisfy a goal which cannot be sampled but tells distances have
            to be found by others, who hand them over with addGoal(). */
        ompl::base::PlannerStatus::StatusType begin(ompl::base::PlannerInputStates &inputs,
                                                    const ompl::base::PlannerTerminationCondition &ptc,
                                                    const ompl::base::SpaceInformationPtr &si);

        /** \brief Takes start and goal states that have arrived since; true if there were any. */
        bool poll(ompl::base::PlannerInputStates &inputs);

        /** \brief Takes \e state, which is valid and satisfies the goal; true if it is new. */
        bool addGoal(const ompl::base::State *state);

        /** \brief Whether goal states have to be searched for: the goal cannot be sampled but tells distances. */
        bool needsGoalSearch() const;

        /** \brief Whether there are so many goal states that no more are taken. */
        bool hasEnoughGoals() const;

        const path::Waypoints &starts() const
        {
            return starts_;
        }

        const path::Waypoints &goals() const
        {
            return goals_;
        }

        /** \brief Whether no goal state can come any more that is not in goals(). */
        bool goalsComplete() const;

        const ompl::base::GoalPtr &goal() const
        {
            return goal_;
        }

    private:
        /** \brief Waits for a first valid goal state, but not for one that cannot come. */
        ompl::base::PlannerStatus::StatusType awaitGoal(ompl::base::PlannerInputStates &inputs,
                                                        const ompl::base::PlannerTerminationCondition &ptc);

        /** \brief Whether a goal state can be read at once, valid or not. */
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
        std::vector<bool> satisfied_;  ///< whether each of goals_ satisfied the goal when it was taken
        ompl::base::SpaceInformationPtr si_;
        ompl::base::GoalPtr goal_;
        ompl::base::OptimizationObjectivePtr askedObjective_;
        std::size_t listed_{0};  ///< states of a goal that lists them which were read in this solve()
        std::uint64_t polls_{0};
        std::uint64_t nextGoalPoll_{0};
        std::uint64_t sampled_{0};  ///< valid goal states that were sampled, known ones included
    };
}  // namespace ompl_mfa::engine

#endif
