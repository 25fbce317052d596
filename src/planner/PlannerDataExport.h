#ifndef OMPL_MFA_PLANNER_PLANNER_DATA_EXPORT_
#define OMPL_MFA_PLANNER_PLANNER_DATA_EXPORT_

#include <ompl/base/PlannerData.h>

#include "engine/SearchGraph.h"

namespace ompl_mfa
{
    /** \brief Appends \e graph to \e data, with one vertex for all starts that are equal and one for all goals that
       are. All states of \e data are copies of its own afterwards: the search goes on, and what it has now may be gone
       when the caller looks. */
    void exportTo(ompl::base::PlannerData &data, const SearchGraph &graph);
}  // namespace ompl_mfa

#endif
