#include "paper/Recorder.h"

#include <limits>

namespace
{
    constexpr std::uint64_t TRACE_POINTS = 100;
}

ompl_mfa::paper::Recorder::Recorder(ObjectiveFunction &objective, double target)
  : objective_(objective)
  , target_(target)
{
    run_.trace.reserve(TRACE_POINTS);
}

ompl_mfa::Brightness ompl_mfa::paper::Recorder::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x,
                                                         const Brightness *rival)
{
    const Brightness brightness = objective_.evaluate(x, rival);
    ++run_.evaluations;
    if (run_.x.size() == 0 || objective_.isBrighter(brightness, run_.best))
    {
        run_.best = brightness;
        run_.x = x;
    }
    if (run_.evaluationsToTarget == 0 && run_.best.isFeasible() && run_.best.cost <= target_)
    {
        run_.evaluationsToTarget = run_.evaluations;
        run_.secondsToTarget = secondsSinceStart();
    }
    if (run_.trace.size() < TRACE_POINTS && run_.evaluations * TRACE_POINTS >= BUDGET * (run_.trace.size() + 1))
        run_.trace.push_back(run_.best.isFeasible() ? run_.best.cost : std::numeric_limits<double>::infinity());
    return brightness;
}

bool ompl_mfa::paper::Recorder::isBrighter(const Brightness &a, const Brightness &b) const
{
    return objective_.isBrighter(a, b);
}

ompl_mfa::paper::Run ompl_mfa::paper::Recorder::finish()
{
    run_.seconds = secondsSinceStart();
    run_.trace.resize(TRACE_POINTS, run_.best.isFeasible() ? run_.best.cost : std::numeric_limits<double>::infinity());
    return run_;
}

double ompl_mfa::paper::Recorder::secondsSinceStart() const
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}
