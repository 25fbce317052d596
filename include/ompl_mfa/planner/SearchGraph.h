#ifndef OMPL_MFA_PLANNER_SEARCH_GRAPH_
#define OMPL_MFA_PLANNER_SEARCH_GRAPH_

#include <cstddef>
#include <utility>
#include <vector>

#include "ompl_mfa/path/Waypoints.h"

namespace ompl_mfa
{
    /** \brief What parts of the search know, as copies: states that are valid as far as they know, and motions that
       were found valid. */
    struct SearchGraph
    {
        explicit SearchGraph(const ompl::base::StateSpacePtr &space)
          : states(space)
        {
        }

        Waypoints states;
        std::vector<std::pair<std::size_t, std::size_t>> edges;  ///< from and to, into states
        std::vector<std::size_t> starts;                         ///< into states
        std::vector<std::size_t> goals;                          ///< into states
    };
}  // namespace ompl_mfa

#endif
