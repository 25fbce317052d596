#ifndef OMPL_MFA_ENGINE_FIREFLIES_GOAL_SEARCH_
#define OMPL_MFA_ENGINE_FIREFLIES_GOAL_SEARCH_

#include <cstdint>

#include <ompl/base/Goal.h>
#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

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
        bool advance(const FireflyOptimizer::StopCondition &stop, Waypoints &found);

        /** \brief States that were compared with the goal so far. */
        std::uint64_t evaluations() const
        {
            return earlierEvaluations_ + fireflies_.evaluations();
        }

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
        std::uint64_t earlierEvaluations_{0};  ///< of former epochs
        FireflyOptimizer fireflies_;
    };
}  // namespace ompl_mfa

#endif
