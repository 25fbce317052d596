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

#include "engine/Query.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Console.h>

#include "engine/GoalDistance.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* More goal states than these add little, and each costs a motion check from every start. */
        constexpr std::size_t MAX_GOALS = 1000;

        bool isListed(const ob::Goal &goal)
        {
            return dynamic_cast<const ob::GoalStates *>(&goal) != nullptr ||
                   dynamic_cast<const ob::GoalState *>(&goal) != nullptr;
        }

        std::size_t listedCount(const ob::Goal &goal)
        {
            if (const auto *states = dynamic_cast<const ob::GoalStates *>(&goal))
            {
                return states->getStateCount();
            }
            return goal.as<ob::GoalState>()->getState() != nullptr ? 1 : 0;
        }

        const ob::State *listedState(const ob::Goal &goal, std::size_t i)
        {
            if (const auto *states = dynamic_cast<const ob::GoalStates *>(&goal))
            {
                return states->getState(static_cast<unsigned int>(i));
            }
            return goal.as<ob::GoalState>()->getState();
        }

        /* OMPL accepts NaN as a coordinate within any bounds of R^n. */
        bool isFinite(const ob::StateSpace &space, const ob::State *state)
        {
            std::vector<double> coordinates;
            space.copyToReals(coordinates, state);
            return std::all_of(coordinates.begin(), coordinates.end(), [](double x) { return std::isfinite(x); });
        }

        /* Whether one of count states equals state. The search begins after the last match, so that two lists in the
           same order are compared in one pass. */
        template <typename StateAt>
        bool isAmong(std::size_t count, const StateAt &stateAt, const ob::StateSpace &space, const ob::State *state,
                     std::size_t &last)
        {
            for (std::size_t i = 0; i < count; ++i)
            {
                const std::size_t k = (last + 1 + i) % count;
                if (space.equalStates(stateAt(k), state))
                {
                    last = k;
                    return true;
                }
            }
            return false;
        }

        bool isAmong(const path::Waypoints &states, const ob::State *state, std::size_t &last)
        {
            return isAmong(
                states.size(), [&](std::size_t k) { return states[k]; }, *states.space(), state, last);
        }

        bool isAmong(const path::Waypoints &states, const ob::State *state)
        {
            std::size_t last = 0;
            return isAmong(states, state, last);
        }
    }  // namespace

    Query::Query(const ob::StateSpacePtr &space)
      : starts_(space)
      , goals_(space)
      , guard_(space)
    {
    }

    bool Query::differsFrom(const ob::ProblemDefinition &pdef) const
    {
        if (pdef.getGoal() != goal_ || pdef.getOptimizationObjective() != askedObjective_)
        {
            return true;
        }
        const auto startAt = [&](std::size_t k) { return pdef.getStartState(static_cast<unsigned int>(k)); };
        std::size_t last = 0;
        for (std::size_t i = 0; i < starts_.size(); ++i)
        {
            if (!isAmong(pdef.getStartStateCount(), startAt, *starts_.space(), starts_[i], last))
            {
                return true;
            }
        }
        return !goalsStillHold();
    }

    bool Query::goalsStillHold() const
    {
        if (goals_.empty())
        {
            return true;
        }
        if (isListed(*goal_))
        {
            const auto goalAt = [this](std::size_t k) { return listedState(*goal_, k); };
            const std::size_t count = listedCount(*goal_);
            std::size_t last = 0;
            for (std::size_t i = 0; i < goals_.size(); ++i)
            {
                if (!isAmong(count, goalAt, *goals_.space(), goals_[i], last))
                {
                    return false;
                }
            }
            return true;
        }
        // sampled states need not satisfy the goal; those that did must still do so
        for (std::size_t i = 0; i < goals_.size(); ++i)
        {
            if (satisfied_[i] && !isSatisfied(*goal_, guard_, goals_[i], nullptr))
            {
                return false;
            }
        }
        return true;
    }

    bool Query::isAnsweredBy(const path::Waypoints &path) const
    {
        return isAmong(starts_, path.front()) &&
               (isAmong(goals_, path.back()) || isSatisfied(*goal_, guard_, path.back(), nullptr));
    }

    void Query::ask(const ob::ProblemDefinition &pdef)
    {
        goal_ = pdef.getGoal();
        askedObjective_ = pdef.getOptimizationObjective();
    }

    ob::PlannerStatus::StatusType Query::begin(ob::PlannerInputStates &inputs,
                                               const ob::PlannerTerminationCondition &ptc,
                                               const ob::SpaceInformationPtr &si)
    {
        if (!goal_->hasType(ob::GOAL_REGION))
        {
            OMPL_ERROR("MFA: the goal neither can be sampled nor tells distances (it is not a GoalRegion)");
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        }
        si_ = si;
        // all inputs are read again, as states may have been replaced; known ones are skipped
        inputs.restart();
        listed_ = 0;
        while (const ob::State *start = inputs.nextStart())
        {
            takeStart(start);
        }
        if (starts_.empty())
        {
            OMPL_ERROR("MFA: there are no valid start states");
            return ob::PlannerStatus::INVALID_START;
        }
        if (needsGoalSearch())
        {
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (!goals_.empty())
        {
            if (isListed(*goal_))
            {
                skipKnownGoals();
            }
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (!goal_->as<ob::GoalSampleableRegion>()->couldSample())
        {
            OMPL_ERROR("MFA: the goal cannot be sampled");
            return ob::PlannerStatus::INVALID_GOAL;
        }
        return awaitGoal(inputs, ptc);
    }

    ob::PlannerStatus::StatusType Query::awaitGoal(ob::PlannerInputStates &inputs,
                                                   const ob::PlannerTerminationCondition &ptc)
    {
        const auto *lazy = dynamic_cast<const ob::GoalLazySamples *>(goal_.get());
        for (;;)
        {
            // asked before the goals are read, so that states which the sampling thread adds until it ends are not
            // missed
            const bool moreToCome = !isListed(*goal_) || (lazy != nullptr && lazy->isSampling());
            if (readGoal(inputs))
            {
                return ob::PlannerStatus::EXACT_SOLUTION;
            }
            if (!moreToCome && !haveMoreGoals(inputs))
            {
                OMPL_ERROR("MFA: there are no valid goal states");
                return ob::PlannerStatus::INVALID_GOAL;
            }
            if (ptc())
            {
                return ob::PlannerStatus::TIMEOUT;
            }
            if (!haveMoreGoals(inputs))
            {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        }
    }

    bool Query::goalsComplete() const
    {
        if (!isListed(*goal_))
        {
            return false;
        }
        const auto *lazy = dynamic_cast<const ob::GoalLazySamples *>(goal_.get());
        return (lazy == nullptr || !lazy->isSampling()) && listedCount(*goal_) <= listed_;
    }

    bool Query::haveMoreGoals(const ob::PlannerInputStates &inputs) const
    {
        return isListed(*goal_) ? listed_ < listedCount(*goal_) : inputs.haveMoreGoalStates();
    }

    bool Query::takeStart(const ob::State *state)
    {
        if (!isFinite(*starts_.space(), state) || isAmong(starts_, state))
        {
            return false;
        }
        starts_.append(state);
        return true;
    }

    bool Query::addGoal(const ob::State *state)
    {
        if (!isFinite(*goals_.space(), state) || isAmong(goals_, state))
        {
            return false;
        }
        goals_.append(state);
        satisfied_.push_back(isSatisfied(*goal_, guard_, state, nullptr));
        return true;
    }

    void Query::skipKnownGoals()
    {
        std::size_t last = goals_.size() - 1;
        while (listed_ < listedCount(*goal_) && isAmong(goals_, listedState(*goal_, listed_), last))
        {
            ++listed_;
        }
    }

    bool Query::readListedGoal()
    {
        if (listed_ >= listedCount(*goal_))
        {
            return false;
        }
        const ob::State *state = listedState(*goal_, listed_++);
        if (si_->satisfiesBounds(state) && si_->isValid(state))
        {
            return addGoal(state);
        }
        OMPL_WARN("MFA: Skipping invalid goal state %zu", listed_);
        return false;
    }

    bool Query::readGoal(ob::PlannerInputStates &inputs)
    {
        if (hasEnoughGoals())
        {
            return false;
        }
        if (isListed(*goal_))
        {
            return readListedGoal();
        }
        const ob::State *sample = inputs.nextGoal();
        if (sample == nullptr)
        {
            return false;
        }
        // a region never runs out of samples: sample it ever more rarely
        nextGoalPoll_ = polls_ + ++sampled_;
        return addGoal(sample);
    }

    bool Query::poll(ob::PlannerInputStates &inputs)
    {
        bool arrived = false;
        if (inputs.haveMoreStartStates())
        {
            if (const ob::State *start = inputs.nextStart())
            {
                arrived = takeStart(start);
            }
        }
        if (!haveMoreGoals(inputs))
        {
            return arrived;
        }
        if (polls_++ >= nextGoalPoll_ && readGoal(inputs))
        {
            arrived = true;
        }
        return arrived;
    }

    bool Query::needsGoalSearch() const
    {
        return !goal_->hasType(ob::GOAL_SAMPLEABLE_REGION);
    }

    bool Query::hasEnoughGoals() const
    {
        return goals_.size() >= MAX_GOALS;
    }
}  // namespace ompl_mfa::engine
