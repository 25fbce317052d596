#include "ompl_mfa/planner/Query.h"

#include <chrono>
#include <thread>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Console.h>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* Goal states beyond these add little, and each costs a motion check from every start. */
        constexpr std::size_t MAX_GOALS = 1000;

        const ob::State *goalStateOf(const ob::GoalPtr &goal)
        {
            const auto *goalState = dynamic_cast<const ob::GoalState *>(goal.get());
            return goalState != nullptr ? goalState->getState() : nullptr;
        }
    }  // namespace

    Query::Query(const ob::StateSpacePtr &space)
      : starts_(space)
      , goals_(space)
      , askedStarts_(space)
      , askedGoal_(space)
    {
    }

    Query::~Query() = default;

    bool Query::differsFrom(const ob::ProblemDefinition &pdef) const
    {
        if (pdef.getGoal() != goal_ || pdef.getOptimizationObjective() != askedObjective_ ||
            pdef.getStartStateCount() < askedStarts_.size())
            return true;
        const auto &space = starts_.space();
        // start states that were only added are read as they come
        for (unsigned int i = 0; i < askedStarts_.size(); ++i)
        {
            if (!space->equalStates(pdef.getStartState(i), askedStarts_[i]))
                return true;
        }
        const ob::State *goalState = goalStateOf(goal_);
        return goalState != nullptr && (askedGoal_.empty() || !space->equalStates(goalState, askedGoal_.front()));
    }

    void Query::reset()
    {
        starts_.clear();
        goals_.clear();
        askedStarts_.clear();
        askedGoal_.clear();
        goal_.reset();
        askedObjective_.reset();
        goalSearch_.reset();
        polls_ = nextGoalPoll_ = 0;
    }

    void Query::reset(const ob::ProblemDefinition &pdef)
    {
        reset();
        goal_ = pdef.getGoal();
        askedObjective_ = pdef.getOptimizationObjective();
        for (unsigned int i = 0; i < pdef.getStartStateCount(); ++i)
            askedStarts_.append(pdef.getStartState(i));
        if (const ob::State *goalState = goalStateOf(goal_))
            askedGoal_.append(goalState);
    }

    ob::PlannerStatus::StatusType Query::begin(ob::PlannerInputStates &inputs,
                                               const ob::PlannerTerminationCondition &ptc, const StateChartPtr &chart,
                                               const ob::SpaceInformationPtr &si, std::uint64_t seed)
    {
        if (!goal_->hasType(ob::GOAL_REGION))
        {
            OMPL_ERROR("MFA: the goal neither can be sampled nor tells distances (it is not a GoalRegion)");
            return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
        }
        while (const ob::State *start = inputs.nextStart())
            starts_.append(start);
        if (starts_.empty())
        {
            OMPL_ERROR("MFA: there are no valid start states");
            return ob::PlannerStatus::INVALID_START;
        }
        if (!goal_->hasType(ob::GOAL_SAMPLEABLE_REGION))
        {
            if (!goalSearch_)
                goalSearch_ = std::make_unique<GoalSearch>(chart, si, goal_, starts_.front(), seed);
            return ob::PlannerStatus::EXACT_SOLUTION;
        }
        if (goals_.empty())
        {
            if (!goal_->as<ob::GoalSampleableRegion>()->couldSample())
            {
                OMPL_ERROR("MFA: the goal cannot be sampled");
                return ob::PlannerStatus::INVALID_GOAL;
            }
            return awaitGoal(inputs, ptc);
        }
        return ob::PlannerStatus::EXACT_SOLUTION;
    }

    ob::PlannerStatus::StatusType Query::awaitGoal(ob::PlannerInputStates &inputs,
                                                   const ob::PlannerTerminationCondition &ptc)
    {
        const bool listed = dynamic_cast<const ob::GoalState *>(goal_.get()) != nullptr ||
                            dynamic_cast<const ob::GoalStates *>(goal_.get()) != nullptr;
        const auto *lazy = dynamic_cast<const ob::GoalLazySamples *>(goal_.get());
        for (;;)
        {
            // asked before the goals are read: what its thread adds until it ends is not missed
            const bool moreToCome = !listed || (lazy != nullptr && lazy->isSampling());
            if (const ob::State *goal = inputs.nextGoal())
            {
                goals_.append(goal);
                return ob::PlannerStatus::EXACT_SOLUTION;
            }
            if (!moreToCome && !inputs.haveMoreGoalStates())
            {
                OMPL_ERROR("MFA: there are no valid goal states");
                return ob::PlannerStatus::INVALID_GOAL;
            }
            if (ptc())
                return ob::PlannerStatus::TIMEOUT;
            if (!inputs.haveMoreGoalStates())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    bool Query::goalsComplete() const
    {
        if (const auto *lazy = dynamic_cast<const ob::GoalLazySamples *>(goal_.get()))
            return !lazy->isSampling() && lazy->getStateCount() <= goals_.size();
        if (const auto *listed = dynamic_cast<const ob::GoalStates *>(goal_.get()))
            return listed->getStateCount() <= goals_.size();
        return dynamic_cast<const ob::GoalState *>(goal_.get()) != nullptr;
    }

    bool Query::pollGoal(ob::PlannerInputStates &inputs, const ob::PlannerTerminationCondition &ptc)
    {
        if (goals_.size() >= MAX_GOALS)
            return false;
        if (goalSearch_)
            return goalSearch_->advance(ptc, goals_);
        const ob::State *goal = inputs.nextGoal();
        if (goal == nullptr)
            return false;
        goals_.append(goal);
        return true;
    }

    bool Query::poll(ob::PlannerInputStates &inputs, const ob::PlannerTerminationCondition &ptc)
    {
        bool arrived = false;
        if (inputs.haveMoreStartStates())
        {
            if (const ob::State *start = inputs.nextStart())
            {
                starts_.append(start);
                arrived = true;
            }
        }
        // a region without end is sampled ever more rarely, listed goals are taken as soon as they are there
        if (!goalSearch_ && !inputs.haveMoreGoalStates())
            return arrived;
        if (polls_++ >= nextGoalPoll_)
        {
            const bool found = pollGoal(inputs, ptc);
            const bool listed = dynamic_cast<const ob::GoalStates *>(goal_.get()) != nullptr;
            nextGoalPoll_ = !found || listed ? polls_ : polls_ + goals_.size();
            arrived = arrived || found;
        }
        return arrived;
    }
}  // namespace ompl_mfa
