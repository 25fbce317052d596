#include "ompl_mfa/planner/TurnMeter.h"

namespace ompl_mfa
{
    namespace
    {
        /* Time of a unit of bookkeeping, in s: that of computing a distance and comparing it. */
        constexpr double BOOKKEEPING_TIME = 1e-7;
    }  // namespace

    TurnMeter::TurnMeter(const PathEvaluator &evaluator, double stateCheckTime)
      : evaluator_(evaluator)
      , stateCheckTime_(stateCheckTime)
      , checks_(evaluator.checks())
      , bookkeeping_(evaluator.bookkeeping())
      , begin_(std::chrono::steady_clock::now())
    {
    }

    double TurnMeter::spent() const
    {
        if (stateCheckTime_ > 0.0)
            return stateCheckTime_ * static_cast<double>(evaluator_.checks() - checks_) +
                   BOOKKEEPING_TIME * static_cast<double>(evaluator_.bookkeeping() - bookkeeping_ + 1);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
}  // namespace ompl_mfa
