#include "planner/PublishingSchedule.h"

#include <cmath>

namespace ompl_mfa
{
    namespace
    {
        /* An improvement by this part of the cost is published at once. */
        constexpr double NOTABLE = 0.01;
        constexpr unsigned int MAX_NOTABLES = 1000;
        /* Growth of the work after which a smaller improvement is published. */
        constexpr double GROWTH = 1.05;
    }  // namespace

    void PublishingSchedule::reset()
    {
        *this = PublishingSchedule();
    }

    bool PublishingSchedule::notable(double cost) const
    {
        // a finite cost after an infinite one, and the other way round for costs without a lower end
        if (!std::isfinite(cost_) || !std::isfinite(cost))
            return true;
        return std::abs(cost_ - cost) >= NOTABLE * std::abs(cost_);
    }

    bool PublishingSchedule::due(double cost, std::uint64_t work) const
    {
        if (!any_ || (notables_ < MAX_NOTABLES && notable(cost)))
            return true;
        return static_cast<double>(work) >= GROWTH * static_cast<double>(work_);
    }

    void PublishingSchedule::published(double cost, std::uint64_t work)
    {
        if (any_ && notable(cost))
            ++notables_;
        any_ = true;
        cost_ = cost;
        work_ = work;
    }
}  // namespace ompl_mfa
