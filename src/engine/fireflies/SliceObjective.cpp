#include "engine/fireflies/SliceObjective.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ompl_mfa
{
    SliceObjective::SliceObjective(const SliceFrame &frame, const SliceModes *modes, PathEvaluator &evaluator,
                                   ValidPathEvent validPath)
      : frame_(frame)
      , modes_(modes)
      , evaluator_(evaluator)
      , validPath_(std::move(validPath))
      , path_(frame.chart()->space())
      , coordinates_(frame.dimension())
      , bound_(std::numeric_limits<double>::infinity())
      , beyondBound_(frame.chart()->space()->getMaximumExtent() * static_cast<double>(frame.slices() + 1))
    {
    }

    bool SliceObjective::setBound(double bound)
    {
        const bool changed = bound != bound_;
        bound_ = bound;
        return changed;
    }

    void SliceObjective::setStride(unsigned int stride)
    {
        stride_ = stride;
    }

    bool SliceObjective::toOffsets(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> offsets)
    {
        if (modes_ == nullptr)
        {
            offsets = x;
            return true;
        }
        const std::size_t atOnce = modes_->slicesAtOnce();
        for (std::size_t k = 0; k < frame_.slices(); k += atOnce)
        {
            if (k > 0 && evaluator_.stopped())
                return false;
            modes_->toCoordinates(x, k, std::min(atOnce, frame_.slices() - k), offsets);
        }
        return true;
    }

    Brightness SliceObjective::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival)
    {
        if (!toOffsets(x, coordinates_))
            return {};
        frame_.toWaypoints(coordinates_, path_, scratch_);
        const ompl::base::Cost cost = evaluator_.cost(path_);
        if (evaluator_.interrupted())
            return {};
        if (!withinBound(cost.value()))
            return {std::numeric_limits<double>::infinity(), cost.value()};
        // a rival that is beyond the bound now has lost to every path within it
        const bool lost = rival != nullptr && !withinBound(rival->cost);
        const Brightness brightness = evaluator_.evaluate(path_, cost, lost ? nullptr : rival, stride_);
        if (brightness.isFeasible())
            validPath_(path_, brightness);
        return brightness;
    }

    bool SliceObjective::withinBound(double cost) const
    {
        return !std::isfinite(bound_) ||
               evaluator_.objective()->isCostBetterThan(ompl::base::Cost(cost), ompl::base::Cost(bound_));
    }

    /* Brightness is stored as it was computed, and the bound moves: only one judged by the bound of now can be compared
       with another. */
    Brightness SliceObjective::underBound(const Brightness &brightness) const
    {
        if (withinBound(brightness.cost))
            return brightness;
        return {beyondBound_ + std::abs(brightness.cost - bound_), brightness.cost};
    }

    bool SliceObjective::isBrighter(const Brightness &a, const Brightness &b) const
    {
        return evaluator_.isBrighter(underBound(a), underBound(b));
    }
}  // namespace ompl_mfa
