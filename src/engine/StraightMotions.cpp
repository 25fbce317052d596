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

#include "engine/StraightMotions.h"

#include <cmath>

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Lateral distance of the intermediate state for a motion that OMPL cannot compute, as a fraction of its
           length. */
        constexpr double ASIDE = 1e-4;
        /* Work before the first straight motion is checked for a partial path, if there are guides. */
        constexpr std::uint64_t FIRST_WORK = 14000;
    }  // namespace

    StraightMotions::StraightMotions(const SearchContext &context, bool guided)
      : context_(context)
      , guided_(guided)
    {
    }

    void StraightMotions::advance(Findings &findings)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        while (const auto pair = pairs_.next(context_.query))
        {
            if (evaluator.stopped())
            {
                pairs_.putBack();
                return;
            }
            path::Waypoints straight = path(context_.query.starts()[pair->first], context_.query.goals()[pair->second]);
            const ob::Cost cost = evaluator.cost(straight);
            const bool valid = evaluator.checkPath(straight);
            if (evaluator.interrupted())
            {
                pairs_.putBack();
                return;
            }
            ++context_.progress.evaluations;
            if (!valid && !guided_)
            {
                evaluator.evaluate(straight, nullptr);  // for the partial path
            }
            if (valid)
            {
                findings.paths.push_back({std::move(straight), cost, Proposal::Stage::Straight, std::nullopt});
                return;
            }
        }
        followFirst();
    }

    void StraightMotions::followFirst()
    {
        if (followed_ || !guided_ || context_.incumbent.hasPath() || context_.evaluator().work() < FIRST_WORK ||
            context_.query.goals().empty())
        {
            return;
        }
        context_.evaluator().evaluate(path(context_.query.starts().front(), context_.query.goals().front()), nullptr);
        followed_ = true;
    }

    /* The motion from start to goal or, if OMPL cannot compute it, two motions through a state slightly beside it. */
    path::Waypoints StraightMotions::path(const ob::State *start, const ob::State *goal) const
    {
        const path::StateChart &chart = *context_.chart;
        const auto &space = chart.space();
        path::Waypoints path(space);
        path.append(start);
        path.append(goal);
        const path::DubinsGuard &guard = chart.guard();
        const double aside = ASIDE * chart.distance(start, goal);
        if (guard.allows(start, goal) || !std::isfinite(aside))
        {
            return path;
        }
        path.insert(1, start);
        for (Eigen::Index i = 0; i < 2 * chart.positionDimension(); ++i)
        {
            chart.interpolate(start, goal, 0.5, path[1]);
            space->enforceBounds(path[1]);
            const Eigen::VectorXd step = Eigen::VectorXd::Unit(chart.dimension(), i / 2);
            chart.displace(path[1], (i % 2 == 0 ? aside : -aside) * step, path[1]);
            if (guard.allows(start, path[1]) && guard.allows(path[1], goal))
            {
                break;
            }
        }
        return path;
    }
}  // namespace ompl_mfa::engine
