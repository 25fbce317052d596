#include "ompl_mfa/path/SliceObjective.h"

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

    void SliceObjective::setBound(double bound)
    {
        bound_ = bound;
    }

    void SliceObjective::setStride(unsigned int stride)
    {
        stride_ = stride;
    }

    Brightness SliceObjective::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival)
    {
        if (modes_ != nullptr)
        {
            modes_->toCoordinates(x, coordinates_);
            frame_.toWaypoints(coordinates_, path_);
        }
        else
            frame_.toWaypoints(x, path_);
        if (std::isfinite(bound_))
        {
            const ompl::base::Cost cost = evaluator_.cost(path_);
            if (evaluator_.interrupted())
                return {};
            if (!evaluator_.objective()->isCostBetterThan(cost, ompl::base::Cost(bound_)))
                return {beyondBound_ + std::abs(cost.value() - bound_), cost.value()};
        }
        const Brightness brightness = evaluator_.evaluate(path_, rival, stride_);
        if (brightness.isFeasible())
            validPath_(path_, brightness);
        return brightness;
    }

    bool SliceObjective::isBrighter(const Brightness &a, const Brightness &b) const
    {
        return evaluator_.isBrighter(a, b);
    }
}  // namespace ompl_mfa
