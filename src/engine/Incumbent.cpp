#include "engine/Incumbent.h"

#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa
{
    Incumbent::Incumbent(ob::OptimizationObjectivePtr objective, const ob::StateSpacePtr &space,
                         std::atomic<double> &cost)
      : objective_(std::move(objective))
      , path_(space)
      , partial_(space)
      , cost_(cost)
    {
        cost_.store(std::numeric_limits<double>::infinity(), std::memory_order_relaxed);
    }

    bool Incumbent::hasFinitePath() const
    {
        return hasPath() && objective_->isFinite(ob::Cost(cost()));
    }

    double Incumbent::bound() const
    {
        if (!hasPath() || hasFinitePath())
            return cost();
        const double largest = std::numeric_limits<double>::max();
        return objective_->infiniteCost().value() > 0.0 ? largest : -largest;
    }

    bool Incumbent::improvedBy(double cost) const
    {
        return path_.empty() || objective_->isCostBetterThan(ob::Cost(cost), ob::Cost(this->cost()));
    }

    bool Incumbent::offer(const Waypoints &path, double cost, std::optional<PartKind> origin)
    {
        if (!improvedBy(cost))
            return false;
        path_ = path;
        cost_.store(cost, std::memory_order_relaxed);
        ++improvements_;
        origin_ = origin;
        return true;
    }

    bool Incumbent::offerPartial(const Waypoints &path, std::size_t count, const ob::State *last, double distance)
    {
        if (!(distance < partialDistance_))
            return false;
        partial_.clear();
        for (std::size_t i = 0; i < count; ++i)
            partial_.append(path[i]);
        partial_.append(last);
        partialDistance_ = distance;
        return true;
    }
}  // namespace ompl_mfa
