#ifndef OMPL_MFA_ENGINE_SEARCH_GRAPH_
#define OMPL_MFA_ENGINE_SEARCH_GRAPH_

#include <cstddef>
#include <utility>
#include <vector>

#include "path/Waypoints.h"

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

        /** \brief Appends the states and motions of \e path, which leads from a start to a goal. */
        void addPath(const Waypoints &path)
        {
            const std::size_t first = states.size();
            for (std::size_t i = 0; i < path.size(); ++i)
            {
                states.append(path[i]);
                if (i > 0)
                    edges.emplace_back(first + i - 1, first + i);
            }
            starts.push_back(first);
            goals.push_back(states.size() - 1);
        }

        Waypoints states;
        std::vector<std::pair<std::size_t, std::size_t>> edges;  ///< from and to, into states
        std::vector<std::size_t> starts;                         ///< into states
        std::vector<std::size_t> goals;                          ///< into states
    };
}  // namespace ompl_mfa

#endif
