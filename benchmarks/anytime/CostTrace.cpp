#include "anytime/CostTrace.h"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

namespace ob = ompl::base;

namespace ompl_mfa::anytime
{
    namespace
    {
        constexpr double POLL_INTERVAL = 0.0002;

        double seconds(clockid_t clock)
        {
            timespec time{};
            clock_gettime(clock, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        }
    }  // namespace

    std::string clockName(Clock clock)
    {
        return clock == Clock::CPU ? "cpu" : "wall";
    }

    double wallTime()
    {
        return seconds(CLOCK_MONOTONIC);
    }

    double cpuTime()
    {
        return seconds(CLOCK_PROCESS_CPUTIME_ID);
    }

    CostTrace::CostTrace(const Problem &problem, const ob::Planner &planner, Clock clock, double limit,
                         ImprovementLog &log)
      : problem_(problem)
      , clock_(clock)
      , limit_(limit)
      , log_(log)
      , wallStart_(wallTime())
      , cpuStart_(cpuTime())
      , best_(std::numeric_limits<double>::infinity())
    {
        const auto &properties = planner.getPlannerProgressProperties();
        const auto found = properties.find("best cost REAL");
        if (found != properties.end())
            bestCost_ = found->second;
        problem.pdef->setIntermediateSolutionCallback(
            [this](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
            { offer(cost.value()); });
    }

    CostTrace::~CostTrace()
    {
        problem_.pdef->setIntermediateSolutionCallback({});
    }

    bool CostTrace::expired()
    {
        if (expired_.load(std::memory_order_relaxed))
            return true;
        const double wall = wallTime() - wallStart_;
        if (clock_ == Clock::WALL && wall >= limit_)
            expired_ = true;
        else if (wall >= nextPoll_.load(std::memory_order_relaxed))
        {
            nextPoll_ = wall + POLL_INTERVAL;
            poll();
            if (clock_ == Clock::CPU && cpuTime() - cpuStart_ >= limit_)
                expired_ = true;
        }
        return expired_;
    }

    void CostTrace::poll()
    {
        if (!bestCost_)
            return;
        const double cost = std::strtod(bestCost_().c_str(), nullptr);
        // some planners call their cost 0 before they have a path
        if (cost > 0.0)
            offer(cost);
    }

    void CostTrace::offer(double cost)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        // properties are printed with six digits after the point: the same cost may come once more, rounded
        if (!(cost < best_ * (1.0 - 1e-9)) || !std::isfinite(cost))
            return;
        best_ = cost;
        const std::uint32_t count = log_.count;
        const std::uint32_t index = std::min(count, ImprovementLog::CAPACITY - 1);
        log_.entries[index] = {wallTime() - wallStart_, cpuTime() - cpuStart_, cost, problem_.checker->checks()};
        log_.count = index + 1;
    }
}  // namespace ompl_mfa::anytime
