#include "engine/GoalDistance.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>

#include "path/ExactType.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* The states to which one of OMPL's own goals measures the distance; none for goals of other kinds. */
        std::vector<const ob::State *> measuredStates(const ob::Goal &goal)
        {
            std::vector<const ob::State *> states;
            if (isExactly<ob::GoalState>(goal))
                states.push_back(goal.as<ob::GoalState>()->getState());
            else if (isExactly<ob::GoalStates, ob::GoalLazySamples>(goal))
            {
                const auto &listed = *goal.as<ob::GoalStates>();
                for (unsigned int i = 0; i < listed.getStateCount(); ++i)
                    states.push_back(listed.getState(i));
            }
            return states;
        }
    }  // namespace

    bool isSatisfied(const ob::Goal &goal, const DubinsGuard &guard, const ob::State *state, double *distance)
    {
        const auto ask = [&]
        { return distance != nullptr ? goal.isSatisfied(state, distance) : goal.isSatisfied(state); };
        if (!guard.refusesAny())
            return ask();
        const std::vector<const ob::State *> goals = measuredStates(goal);
        if (std::all_of(goals.begin(), goals.end(), [&](const ob::State *end) { return guard.computes(state, end); }))
            return ask();
        double nearest = std::numeric_limits<double>::infinity();
        for (const ob::State *end : goals)
            nearest = std::min(nearest, guard.distance(state, end));
        if (distance != nullptr)
            *distance = nearest;
        return nearest <= goal.as<ob::GoalRegion>()->getThreshold();
    }
}  // namespace ompl_mfa
