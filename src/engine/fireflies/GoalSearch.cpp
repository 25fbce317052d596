#include "engine/fireflies/GoalSearch.h"

#include <cmath>
#include <limits>
#include <utility>

#include "engine/Streams.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* The box of coordinates around the origin that holds the whole space. */
        Eigen::VectorXd reachAlong(const StateChart &chart, const ob::State *origin, double sign)
        {
            Eigen::VectorXd reach(chart.dimension());
            for (Eigen::Index i = 0; i < chart.positionDimension(); ++i)
            {
                const double r = chart.reach(origin, sign * Eigen::VectorXd::Unit(chart.dimension(), i));
                reach[i] = sign * (std::isfinite(r) ? r : chart.space()->getMaximumExtent());
            }
            reach.tail(chart.rotationDimension()) = sign * chart.rotationReach();
            return reach;
        }

        FireflyOptimizer::Settings searchSettings()
        {
            FireflyOptimizer::Settings settings;
            settings.populationSize = 30;
            return settings;
        }
    }  // namespace

    GoalSearch::GoalSearch(const StateChartPtr &chart, const ob::SpaceInformationPtr &si, ob::GoalPtr goal,
                           const ob::State *origin, std::uint64_t seed)
      : chart_(chart)
      , si_(si)
      , goal_(std::move(goal))
      , origin_(chart->space())
      , satisfying_(chart->space())
      , state_(si->allocState())
      , seed_(seed)
      , fireflies_(searchSettings(), reachAlong(*chart, origin, -1.0), reachAlong(*chart, origin, 1.0),
                   streamSeed(seed, Stream::Epoch))
    {
        origin_.append(origin);
    }

    GoalSearch::~GoalSearch()
    {
        si_->freeState(state_);
    }

    Brightness GoalSearch::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness * /*rival*/)
    {
        chart_->displace(origin_.front(), x, state_);
        double distance = 0.0;
        const bool satisfied = goal_->isSatisfied(state_, &distance);
        if (satisfied && si_->isValid(state_))
        {
            if (satisfying_.empty())
                satisfying_.append(state_);
            return {0.0, 0.0};
        }
        return {std::max(distance, std::numeric_limits<double>::min()), 0.0};
    }

    bool GoalSearch::advance(const FireflyOptimizer::StopCondition &stop, Waypoints &found)
    {
        satisfying_.clear();
        // a swarm that gathered short of the goal stays there
        if (fireflies_.generation() >= fireflies_.settings().generations)
        {
            earlierEvaluations_ += fireflies_.evaluations();
            fireflies_ = FireflyOptimizer(fireflies_.settings(), fireflies_.lower(), fireflies_.upper(),
                                          streamSeed(seed_, Stream::Epoch, ++epoch_));
        }
        fireflies_.step(*this, [&] { return !satisfying_.empty() || stop(); });
        if (satisfying_.empty())
            return false;
        found.append(satisfying_.front());
        return true;
    }
}  // namespace ompl_mfa
