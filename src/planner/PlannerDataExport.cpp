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

#include "planner/PlannerDataExport.h"

#include <vector>

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        using States = std::vector<const ob::State *>;

        /* The first of the ends that is equal to the state, which is added to them if there is none. */
        const ob::State *shared(const ob::StateSpace &space, States &ends, const ob::State *state)
        {
            for (const ob::State *end : ends)
            {
                if (space.equalStates(end, state))
                {
                    return end;
                }
            }
            ends.push_back(state);
            return state;
        }
    }  // namespace

    void exportTo(ob::PlannerData &data, const engine::SearchGraph &graph)
    {
        const ob::StateSpace &space = *graph.states.space();
        States states = graph.states.pointers();
        States starts;
        States goals;
        for (const std::size_t i : graph.starts)
        {
            states[i] = shared(space, starts, states[i]);
            data.addStartVertex(ob::PlannerDataVertex(states[i]));
        }
        for (const std::size_t i : graph.goals)
        {
            states[i] = shared(space, goals, states[i]);
            data.addGoalVertex(ob::PlannerDataVertex(states[i]));
        }
        for (const ob::State *state : states)
        {
            data.addVertex(ob::PlannerDataVertex(state));
        }
        for (const auto &[from, to] : graph.edges)
        {
            data.addEdge(ob::PlannerDataVertex(states[from]), ob::PlannerDataVertex(states[to]));
        }
        data.decoupleFromPlanner();
    }
}  // namespace ompl_mfa::planner
