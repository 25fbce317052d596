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

        /* Adds the states of a path as vertices, one for all paths that begin or end alike, and its motions as edges
           where they were found valid. */
        void addPath(const Waypoints &path, bool checked, States &starts, States &goals, ob::PlannerData &data)
        {
            States states = path.pointers();
            states.front() = shared(*path.space(), starts, states.front());
            states.back() = shared(*path.space(), goals, states.back());
            data.addStartVertex(ob::PlannerDataVertex(states.front()));
            data.addGoalVertex(ob::PlannerDataVertex(states.back()));
            for (std::size_t i = 1; i < states.size(); ++i)
            {
                data.addVertex(ob::PlannerDataVertex(states[i]));
                if (checked)
                    data.addEdge(ob::PlannerDataVertex(states[i - 1]), ob::PlannerDataVertex(states[i]));
            }
        }
    }  // namespace

    void MFA::getPlannerData(ob::PlannerData &data) const
    {
        Planner::getPlannerData(data);
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        // planner data point to states of the planner: these copies live until the next call
        plannerDataPaths_.clear();
        std::vector<bool> checked;
        const auto addSwarm = [&](const Swarm &swarm, const WindowSwarm *window)
        {
            const FireflyOptimizer &fireflies = swarm.fireflies();
            Waypoints path(si_->getStateSpace());
            for (const unsigned int i : fireflies.order())
            {
                swarm.pathOf(i, path);
                plannerDataPaths_.push_back(window != nullptr ? window->withWay(path) : path);
                checked.push_back(fireflies.brightness(i).isFeasible());
            }
        };
        for (const auto &swarm : swarms_)
            addSwarm(*swarm, nullptr);
        if (window_)
            addSwarm(window_->swarm(), window_.get());
        if (incumbent_->hasPath())
        {
            plannerDataPaths_.push_back(incumbent_->path());
            checked.push_back(true);
        }
        States starts;
        States goals;
        for (std::size_t i = 0; i < plannerDataPaths_.size(); ++i)
            addPath(plannerDataPaths_[i], checked[i], starts, goals, data);
    }

    std::vector<double> MFA::shares() const
    {
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        const double sum = std::accumulate(spent_.begin(), spent_.end(), 0.0);
        std::vector<double> shares = spent_;
        for (double &share : shares)
            share = sum > 0.0 ? share / sum : 0.0;
        return shares;
    }

    std::vector<og::PathGeometric> MFA::getSwarmPaths() const
    {
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
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
        const std::lock_guard<std::recursive_mutex> lock(mutex_);
        std::vector<og::PathGeometric> paths;
        if (activeSwarm_ == nullptr)
            return paths;
        const SliceFrame &frame = activeSwarm_->frame();
        Waypoints ends(si_->getStateSpace());
        ends.resize(2);
        for (std::size_t k = 0; k < frame.slices(); ++k)
        {
            const auto [first, count] = frame.sliceRange(k);
            for (Eigen::Index i = first; i < first + count; ++i)
            {
                Eigen::VectorXd x = Eigen::VectorXd::Zero(frame.dimension());
                x[i] = frame.lower()[i];
                frame.toState(k, x, ends[0]);
                x[i] = frame.upper()[i];
                frame.toState(k, x, ends[1]);
                paths.emplace_back(si_, ends[0], ends[1]);
            }
        }
        return paths;
    }
}  // namespace ompl_mfa
