/* What MFA tells of its search: planner data, the swarm's paths and its slices. */

#include <numeric>

#include <ompl/base/PlannerData.h>

#include "ompl_mfa/planner/MFA.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

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

        /* Adds the states of a valid path as vertices, one for all paths that begin or end alike, and its motions as
           edges. */
        void addPath(const Waypoints &path, States &starts, States &goals, ob::PlannerData &data)
        {
            States states = path.pointers();
            states.front() = shared(*path.space(), starts, states.front());
            states.back() = shared(*path.space(), goals, states.back());
            data.addStartVertex(ob::PlannerDataVertex(states.front()));
            data.addGoalVertex(ob::PlannerDataVertex(states.back()));
            for (std::size_t i = 1; i < states.size(); ++i)
            {
                data.addVertex(ob::PlannerDataVertex(states[i]));
                data.addEdge(ob::PlannerDataVertex(states[i - 1]), ob::PlannerDataVertex(states[i]));
            }
        }

        /* Adds what a guide knows. */
        void addGraph(const SearchGraph &graph, States &starts, States &goals, ob::PlannerData &data)
        {
            States states = graph.states.pointers();
            for (const std::size_t i : graph.starts)
            {
                states[i] = shared(*graph.states.space(), starts, states[i]);
                data.addStartVertex(ob::PlannerDataVertex(states[i]));
            }
            for (const std::size_t i : graph.goals)
            {
                states[i] = shared(*graph.states.space(), goals, states[i]);
                data.addGoalVertex(ob::PlannerDataVertex(states[i]));
            }
            for (const ob::State *state : states)
                data.addVertex(ob::PlannerDataVertex(state));
            for (const auto &[from, to] : graph.edges)
                data.addEdge(ob::PlannerDataVertex(states[from]), ob::PlannerDataVertex(states[to]));
        }
    }  // namespace

    void MFA::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        const SearchLock::Reader lock(lock_);
        std::vector<Waypoints> paths;
        const auto addSwarm = [&](const Swarm &swarm, const WindowSwarm *window)
        {
            const FireflyOptimizer &fireflies = swarm.fireflies();
            Waypoints path(si_->getStateSpace());
            for (const unsigned int i : fireflies.order())
            {
                // of the others nobody knows which states are valid
                if (!fireflies.brightness(i).isFeasible())
                    continue;
                swarm.pathOf(i, path);
                paths.push_back(window != nullptr ? window->withWay(path) : path);
            }
        };
        for (const auto &swarm : swarms_)
            addSwarm(*swarm, nullptr);
        if (window_)
            addSwarm(window_->swarm(), window_.get());
        if (incumbent_->hasPath())
            paths.push_back(incumbent_->path());
        States starts;
        States goals;
        for (const Waypoints &path : paths)
            addPath(path, starts, goals, data);
        SearchGraph graph(si_->getStateSpace());
        if (trees_)
            trees_->explain(graph);
        if (roadmap_)
            roadmap_->explain(graph);
        addGraph(graph, starts, goals, data);
        // the search goes on, and what it has now may be gone when the caller looks
        data.decoupleFromPlanner();
    }

    std::vector<double> MFA::shares() const
    {
        const SearchLock::Reader lock(lock_);
        const double sum = std::accumulate(spent_.begin(), spent_.end(), 0.0);
        std::vector<double> shares = spent_;
        for (double &share : shares)
            share = sum > 0.0 ? share / sum : 0.0;
        return shares;
    }

    std::vector<og::PathGeometric> MFA::getSwarmPaths() const
    {
        const SearchLock::Reader lock(lock_);
        std::vector<og::PathGeometric> paths;
        if (activeSwarm_ == nullptr)
            return paths;
        const Swarm &swarm = *activeSwarm_;
        const bool window = window_ && &swarm == &window_->swarm();
        Waypoints waypoints(si_->getStateSpace());
        for (const unsigned int i : swarm.fireflies().order())
        {
            swarm.pathOf(i, waypoints);
            paths.emplace_back(si_);
            (window ? window_->withWay(waypoints) : waypoints).appendTo(paths.back());
        }
        return paths;
    }

    std::vector<og::PathGeometric> MFA::getSlicePaths() const
    {
        const SearchLock::Reader lock(lock_);
        std::vector<og::PathGeometric> paths;
        if (activeSwarm_ == nullptr)
            return paths;
        const SliceFrame &frame = activeSwarm_->frame();
        Waypoints ends(si_->getStateSpace());
        ends.resize(2);
        Eigen::VectorXd scratch;
        for (std::size_t k = 0; k < frame.slices(); ++k)
        {
            const auto [first, count] = frame.sliceRange(k);
            for (Eigen::Index i = first; i < first + count; ++i)
            {
                Eigen::VectorXd x = Eigen::VectorXd::Zero(frame.dimension());
                x[i] = frame.lower()[i];
                frame.toState(k, x, ends[0], scratch);
                x[i] = frame.upper()[i];
                frame.toState(k, x, ends[1], scratch);
                paths.emplace_back(si_, ends[0], ends[1]);
            }
        }
        return paths;
    }
}  // namespace ompl_mfa
