#ifndef OMPL_MFA_TEST_PLANNER_DISTANCE_GOAL_
#define OMPL_MFA_TEST_PLANNER_DISTANCE_GOAL_

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalRegion.h>

namespace ompl_mfa::test
{
    /** \brief All states within a distance of a target; it tells distances and cannot be sampled. */
    class DistanceGoal : public ompl::base::GoalRegion
    {
    public:
        DistanceGoal(const ompl::base::SpaceInformationPtr &si, const ompl::base::State *target, double threshold)
          : GoalRegion(si)
          , target_(si->cloneState(target))
        {
            setThreshold(threshold);
        }

        ~DistanceGoal() override
        {
            si_->freeState(target_);
        }

        DistanceGoal(const DistanceGoal &) = delete;
        DistanceGoal &operator=(const DistanceGoal &) = delete;

        double distanceGoal(const ompl::base::State *state) const override
        {
            return si_->distance(state, target_);
        }

    private:
        ompl::base::State *target_;
    };
}  // namespace ompl_mfa::test

#endif
