#ifndef OMPL_MFA_PLANNER_QUERY_
#define OMPL_MFA_PLANNER_QUERY_

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/Goal.h>
#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>

#include "ompl_mfa/path/StateChart.h"
#include "ompl_mfa/path/Waypoints.h"
#include "ompl_mfa/planner/GoalSearch.h"

namespace ompl_mfa
{
    /** \brief The start and goal states of a problem definition, as they are known so far. Goals may arrive late. */
    class Query
    {
    public:
        explicit Query(const ompl::base::StateSpacePtr &space);
        ~Query();

        /** \brief Whether \e pdef asks something else than when reset() was last called: other start states, another
            goal or goal state, or another objective. */
        bool differsFrom(const ompl::base::ProblemDefinition &pdef) const;

        /** \brief Forgets all states and remembers what \e pdef asks. */
        void reset(const ompl::base::ProblemDefinition &pdef);
        void reset();

        /** \brief Reads all start states and waits for a first goal state where the goal can be sampled. Returns
            EXACT_SOLUTION if planning can begin, else the status that says why not. A goal that cannot be sampled but
            tells distances is searched for with fireflies, a generation at a time, by poll(). */
        ompl::base::PlannerStatus::StatusType begin(ompl::base::PlannerInputStates &inputs,
                                                    const ompl::base::PlannerTerminationCondition &ptc,
                                                    const StateChartPtr &chart,
                                                    const ompl::base::SpaceInformationPtr &si, std::uint64_t seed);

        /** \brief Takes start and goal states that have arrived since; true if there were any. */
        bool poll(ompl::base::PlannerInputStates &inputs, const ompl::base::PlannerTerminationCondition &ptc);

        const Waypoints &starts() const
        {
            return starts_;
        }

        const Waypoints &goals() const
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
        bool pollGoal(ompl::base::PlannerInputStates &inputs, const ompl::base::PlannerTerminationCondition &ptc);

        Waypoints starts_;
        Waypoints goals_;
        Waypoints askedStarts_;
        ompl::base::GoalPtr goal_;
        Waypoints askedGoal_;
        ompl::base::OptimizationObjectivePtr askedObjective_;
        std::unique_ptr<GoalSearch> goalSearch_;
        std::uint64_t polls_{0};
        std::uint64_t nextGoalPoll_{0};
    };
}  // namespace ompl_mfa

#endif
