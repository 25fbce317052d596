#include "ompl_mfa/planner/Guide.h"

namespace ompl_mfa
{
    void Guide::explain(SearchGraph &) const
    {
    }
}  // namespace ompl_mfa
