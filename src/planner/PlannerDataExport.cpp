#include "planner/PlannerDataExport.h"

#include <vector>

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        using States = std::vector<const ob::State *>;

        /* The first of the ends that equals the state, which becomes one of them if there is none. */
        const ob::State *shared(const ob::StateSpace &space, States &ends, const ob::State *state)
        {
            for (const ob::State *end : ends)
            {
                if (space.equalStates(end, state))
                    return end;
            }
            ends.push_back(state);
            return state;
        }
    }  // namespace

    void exportTo(ob::PlannerData &data, const SearchGraph &graph)
    {
        const ob::StateSpace &space = *graph.states.space();
        States states = graph.states.pointers();
        States starts;
        States goals;
        for (const std::size_t i : graph.starts)
        {
            states[i] = shared(space, starts, states[i]);
            data.addStartVertex(ob::PlannerDataVertex(states[i]));
        }
        for (const std::size_t i : graph.goals)
        {
            states[i] = shared(space, goals, states[i]);
            data.addGoalVertex(ob::PlannerDataVertex(states[i]));
        }
        for (const ob::State *state : states)
            data.addVertex(ob::PlannerDataVertex(state));
        for (const auto &[from, to] : graph.edges)
            data.addEdge(ob::PlannerDataVertex(states[from]), ob::PlannerDataVertex(states[to]));
        data.decoupleFromPlanner();
    }
}  // namespace ompl_mfa
