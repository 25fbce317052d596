#include "ompl_mfa/path/SliceObjective.h"

#include <utility>

namespace ompl_mfa
{
    SliceObjective::SliceObjective(const SliceFrame &frame, PathEvaluator &evaluator, ValidPathEvent validPath)
      : frame_(frame)
      , evaluator_(evaluator)
      , validPath_(std::move(validPath))
      , path_(frame.chart()->space())
    {
    }

    Brightness SliceObjective::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival)
    {
        frame_.toWaypoints(x, path_);
        const Brightness brightness = evaluator_.evaluate(path_, rival);
        if (brightness.isFeasible())
            validPath_(path_, brightness);
        return brightness;
    }

    bool SliceObjective::isBrighter(const Brightness &a, const Brightness &b) const
    {
        return evaluator_.isBrighter(a, b);
    }
}  // namespace ompl_mfa
