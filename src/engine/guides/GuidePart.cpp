#include "engine/guides/GuidePart.h"

#include <utility>

namespace ompl_mfa
{
    void GuidePart::advance(std::uint64_t work, Findings &findings)
    {
        Waypoints path(context().chart->space());
        if (search(context().incumbent.bound(), work, path))
            propose(std::move(path), findings);
    }
}  // namespace ompl_mfa
