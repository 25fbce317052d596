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

#include "engine/refinement/PathRepair.h"

#include <algorithm>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* Runs of invalid states that are bridged before a path is given up. */
        constexpr unsigned int MAX_RUNS = 24;
        /* States that are tried beside each run, with a spread that grows from one to the next. */
        constexpr unsigned int TRIES = 40;
        constexpr double GROWTH = 1.08;
        constexpr double FIRST_SPREAD = 0.5;
        /* Valid states in a row that end a run. */
        constexpr unsigned int RUN_END = 8;

        /* Indices in PathRepair::states_. */
        constexpr std::size_t FROM = 0;
        constexpr std::size_t TO = 1;
        constexpr std::size_t BETWEEN = 2;
        constexpr std::size_t VIA = 3;
    }  // namespace

    PathRepair::PathRepair(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , rng_(seed)
      , states_(chart_->space())
      , step_(chart_->dimension())
    {
        states_.resize(4);
    }

    PathRepair::~PathRepair() = default;

    bool PathRepair::repair(path::Waypoints &path)
    {
        unsigned int runs = 0;
        for (std::size_t i = 1; i < path.size() && !evaluator_.stopped();)
        {
            if (evaluator_.checkMotion(path[i - 1], path[i]))
            {
                ++i;
            }
            else if (evaluator_.interrupted() || ++runs > MAX_RUNS || !bridge(path, i))
            {
                return false;
            }
        }
        return !evaluator_.interrupted();
    }

    /* The state at fraction \e number / \e segments of the motion to vertex \e motion. */
    void PathRepair::stateOn(const path::Waypoints &path, std::size_t motion, unsigned int segments,
                             unsigned int number, ob::State *state) const
    {
        if (number == 0 || number == segments)
        {
            chart_->space()->copyState(state, path[number == 0 ? motion - 1 : motion]);
            return;
        }
        chart_->interpolate(path[motion - 1], path[motion], static_cast<double>(number) / segments, state);
        chart_->space()->enforceBounds(state);
    }

    /* The first run of invalid states; false if the states give no reason why the motion is invalid. */
    bool PathRepair::findGap(const path::Waypoints &path, std::size_t motion, unsigned int segments, Gap &gap)
    {
        unsigned int first = segments;
        unsigned int last = 0;
        for (unsigned int j = 1; j < segments && (first == segments || j <= last + RUN_END); ++j)
        {
            stateOn(path, motion, segments, j, states_[BETWEEN]);
            if (evaluator_.checkState(states_[BETWEEN]))
            {
                continue;
            }
            first = std::min(first, j);
            last = j;
        }
        if (first == segments)
        {
            return false;
        }
        gap.length = last - first + 1;
        const unsigned int room = std::max(2U, gap.length);
        gap.before = first > room ? first - room : 0;
        gap.after = std::min(segments, last + room);
        stateOn(path, motion, segments, gap.after, states_[TO]);
        // further behind there may be another run, but all states before the run and RUN_END behind it are valid
        if (room > RUN_END && !evaluator_.checkState(states_[TO]))
        {
            gap.after = std::min(segments, last + RUN_END);
        }
        return true;
    }

    bool PathRepair::bridge(path::Waypoints &path, std::size_t motion)
    {
        const unsigned int segments = evaluator_.checkedSegments(path[motion - 1], path[motion]);
        Gap gap{};
        if (!findGap(path, motion, segments, gap))
        {
            return false;
        }
        stateOn(path, motion, segments, gap.before, states_[FROM]);
        stateOn(path, motion, segments, gap.after, states_[TO]);
        const double run = chart_->distance(path[motion - 1], path[motion]) / segments * gap.length;
        if (!evaluator_.checkState(states_[FROM]) || !evaluator_.checkState(states_[TO]) ||
            !findVia(FIRST_SPREAD * run))
        {
            return false;
        }
        if (gap.after < segments)
        {
            path.insert(motion, states_[TO]);
        }
        path.insert(motion, states_[VIA]);
        if (gap.before > 0)
        {
            path.insert(motion, states_[FROM]);
        }
        return true;
    }

    /* Draws a state near the middle of the gap from which both its ends can be reached. */
    bool PathRepair::findVia(double spread)
    {
        for (unsigned int k = 0; k < TRIES && !evaluator_.interrupted(); ++k, spread *= GROWTH)
        {
            chart_->interpolate(states_[FROM], states_[TO], rng_.uniformReal(0.3, 0.7), states_[BETWEEN]);
            chart_->space()->enforceBounds(states_[BETWEEN]);
            for (Eigen::Index j = 0; j < step_.size(); ++j)
            {
                step_[j] = spread * rng_.gaussian01();
            }
            chart_->displace(states_[BETWEEN], step_, states_[VIA]);
            if (evaluator_.checkState(states_[VIA]) && evaluator_.checkMotion(states_[FROM], states_[VIA]) &&
                evaluator_.checkMotion(states_[VIA], states_[TO]))
            {
                return true;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::engine::refinement
