#ifndef OMPL_MFA_PLANNER_GOAL_SEARCH_
#define OMPL_MFA_PLANNER_GOAL_SEARCH_

#include <cstdint>

#include <ompl/base/Goal.h>
#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/path/StateChart.h"
#include "ompl_mfa/path/Waypoints.h"

namespace ompl_mfa
{
    /** \brief Finds states that satisfy a goal which only knows distances: fireflies over the whole state space, the
        nearer to the goal the brighter. Every valid state that satisfies the goal is collected. After an epoch the
       swarm begins anew. */
    class GoalSearch : private ObjectiveFunction
    {
    public:
        /** \brief Fireflies start around \e origin, any state of the space. */
        GoalSearch(const StateChartPtr &chart, const ompl::base::SpaceInformationPtr &si, ompl::base::GoalPtr goal,
                   const ompl::base::State *origin, std::uint64_t seed);
        ~GoalSearch() override;
        GoalSearch(const GoalSearch &) = delete;
        GoalSearch &operator=(const GoalSearch &) = delete;

        /** \brief One generation; appends at most one state to \e found and returns whether it did. */
        bool advance(const ompl::base::PlannerTerminationCondition &ptc, Waypoints &found);

    private:
        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;

        StateChartPtr chart_;
        ompl::base::SpaceInformationPtr si_;
        ompl::base::GoalPtr goal_;
        Waypoints origin_;
        Waypoints satisfying_;
        ompl::base::State *state_;
        std::uint64_t seed_;
        std::uint64_t epoch_{0};
        FireflyOptimizer fireflies_;
    };
}  // namespace ompl_mfa

#endif
