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

#include "planner/HintPath.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Exception.h>

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        bool haveSameStructure(const ob::StateSpace &a, const ob::StateSpace &b)
        {
            std::vector<int> structureOfA;
            std::vector<int> structureOfB;
            a.computeSignature(structureOfA);
            b.computeSignature(structureOfB);
            return structureOfA == structureOfB;
        }
    }  // namespace

    path::Waypoints hintOf(const ompl::geometric::PathGeometric &path, const ob::StateSpacePtr &space,
                           const std::string &planner)
    {
        const auto &from = path.getSpaceInformation()->getStateSpace();
        if (from != space && !haveSameStructure(*from, *space))
        {
            throw ompl::Exception(planner, "a path hint is in the state space '" + from->getName() +
                                               "', which has another structure than '" + space->getName() + "'");
        }
        if (path.getStateCount() == 0)
        {
            throw ompl::Exception(planner, "a path hint has no states");
        }
        path::Waypoints hint(space);
        hint.resize(path.getStateCount());
        for (const auto &either : {from, space})
        {
            if (either->getValueLocations().empty())
            {
                either->computeLocations();  // the space is not set up yet
            }
        }
        std::vector<double> values;
        for (std::size_t i = 0; i < hint.size(); ++i)
        {
            const ob::State *state = path.getState(static_cast<unsigned int>(i));
            from->copyToReals(values, state);
            if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
            {
                throw ompl::Exception(planner, "state " + std::to_string(i) + " of a path hint is not finite");
            }
            if (from == space)
            {
                space->copyState(hint[i], state);
            }
            else
            {
                space->copyFromReals(hint[i], values);
            }
        }
        return hint;
    }
}  // namespace ompl_mfa::planner
