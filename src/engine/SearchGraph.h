/*********************************************************************
 * Software License Agreement (BSD License)
 *
 *  Copyright (c) 2026, the ompl_mfa authors
 *  All rights reserved.
 *
 *  Redistribution and use in source and binary forms, with or without
 *  modification, are permitted provided that the following conditions
 *  are met:
 *
 *   * Redistributions of source code must retain the above copyright
 *     notice, this list of conditions and the following disclaimer.
 *   * Redistributions in binary form must reproduce the above
 *     copyright notice, this list of conditions and the following
 *     disclaimer in the documentation and/or other materials provided
 *     with the distribution.
 *   * Neither the name of the copyright holder nor the names of its
 *     contributors may be used to endorse or promote products derived
 *     from this software without specific prior written permission.
 *
 *  THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS
 *  "AS IS" AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT
 *  LIMITED TO, THE IMPLIED WARRANTIES OF MERCHANTABILITY AND FITNESS
 *  FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
 *  COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT,
 *  INCIDENTAL, SPECIAL, EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING,
 *  BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE GOODS OR SERVICES;
 *  LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER
 *  CAUSED AND ON ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT
 *  LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR OTHERWISE) ARISING IN
 *  ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE
 *  POSSIBILITY OF SUCH DAMAGE.
 *********************************************************************/

/* Author: the ompl_mfa authors */

#ifndef OMPL_MFA_ENGINE_SEARCH_GRAPH_
#define OMPL_MFA_ENGINE_SEARCH_GRAPH_

#include <cstddef>
#include <utility>
#include <vector>

#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief Copies of what the parts of a search know, for planner data: states not known to be invalid, and valid
       motions. */
    struct SearchGraph
    {
        explicit SearchGraph(const ompl::base::StateSpacePtr &space)
          : states(space)
        {
        }

        /** \brief Appends the states and motions of \e path, which leads from a start to a goal. */
        void addPath(const path::Waypoints &path)
        {
            const std::size_t first = states.size();
            for (std::size_t i = 0; i < path.size(); ++i)
            {
                states.append(path[i]);
                if (i > 0)
                {
                    edges.emplace_back(first + i - 1, first + i);
                }
            }
            starts.push_back(first);
            goals.push_back(states.size() - 1);
        }

        path::Waypoints states;
        std::vector<std::pair<std::size_t, std::size_t>> edges;  ///< indices into states: from, to
        std::vector<std::size_t> starts;                         ///< indices into states
        std::vector<std::size_t> goals;                          ///< indices into states
    };
}  // namespace ompl_mfa::engine

#endif
