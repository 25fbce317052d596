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
#include <limits>
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
        /* The same for runs that are invalid at a finer resolution only, of paths that touch: a smaller detour than the
           length of the run is usually enough. */
        constexpr double FINE_SPREAD = 0.05;
        constexpr double FINE_GROWTH = 1.15;
        /* Such a detour may be longer than the gap by this factor; curves of bounded curvature would insert a loop. */
        constexpr double MAX_DETOUR = 2.0;
        /* Steps of the vertices beside a run that cannot be bypassed; most of them are rejected by one state check. */
        constexpr unsigned int SHIFTS = 100;
        constexpr double SHIFT_GROWTH = 1.06;
        /* Attempts to shorten such a detour. */
        constexpr unsigned int BISECTIONS = 4;
        /* Valid states in a row that end a run. */
        constexpr unsigned int RUN_END = 8;

        constexpr double INFINITE_LENGTH = std::numeric_limits<double>::infinity();

        /* Indices in PathRepair::states_. */
        constexpr std::size_t FROM = 0;
        constexpr std::size_t TO = 1;
        constexpr std::size_t BETWEEN = 2;
        constexpr std::size_t VIA = 3;
        constexpr std::size_t FARTHEST = 4;
        constexpr std::size_t NEARER = 5;
        constexpr std::size_t OLD = 6;      // and 7: the vertices of a motion
        constexpr std::size_t SHIFTED = 8;  // and 9
        constexpr std::size_t BETTER = 10;  // and 11
        constexpr std::size_t STATES = 12;
    }  // namespace

    PathRepair::PathRepair(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , rng_(seed)
      , states_(chart_->space())
      , step_(chart_->dimension())
    {
        states_.resize(STATES);
    }

    PathRepair::~PathRepair() = default;

    bool PathRepair::repair(path::Waypoints &path, const Known &known)
    {
        unsigned int runs = 0;
        const std::size_t maxRuns = MAX_RUNS + (evaluator_.fineness() > 1 ? 2 * path.size() : 0);
        for (std::size_t i = 1; i < path.size() && !evaluator_.stopped();)
        {
            if (check(path[i - 1], path[i], known ? known(path[i - 1], path[i]) : Knowledge::Nothing))
            {
                ++i;
            }
            else if (evaluator_.interrupted() || ++runs > maxRuns || !bridge(path, i))
            {
                return false;
            }
        }
        return !evaluator_.interrupted();
    }

    bool PathRepair::check(const ob::State *from, const ob::State *to, Knowledge knowledge)
    {
        switch (knowledge)
        {
            case Knowledge::FinelyValid:
                return true;
            case Knowledge::Valid:
                return evaluator_.checkFinely(from, to);
            default:
                return evaluator_.checkMotion(from, to);
        }
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

    bool PathRepair::isValidOn(const path::Waypoints &path, std::size_t motion, unsigned int segments,
                               unsigned int number)
    {
        stateOn(path, motion, segments, number, states_[BETWEEN]);
        return evaluator_.checkState(states_[BETWEEN]);
    }

    /* The run of invalid states around the one at which the check failed, or else the first; false if the states give
       no reason why the motion is invalid. */
    bool PathRepair::findGap(const path::Waypoints &path, std::size_t motion, unsigned int segments, Gap &gap)
    {
        const unsigned int failed = evaluator_.failedState();
        unsigned int first = failed > 0 ? failed : segments;
        unsigned int last = failed;
        for (unsigned int j = failed + 1; j < segments && (first == segments || j <= last + RUN_END); ++j)
        {
            if (isValidOn(path, motion, segments, j))
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
        for (unsigned int j = failed; failed > 0 && j-- > 1 && j + RUN_END >= first;)
        {
            first = isValidOn(path, motion, segments, j) ? first : j;
        }
        gap.length = last - first + 1;
        // the states before the run are valid as far as they were checked, and RUN_END behind it
        const unsigned int room = failed > 0 ? RUN_END : std::max(2U, gap.length);
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
        if (!evaluator_.checkState(states_[FROM]) || !evaluator_.checkState(states_[TO]))
        {
            return false;
        }
        const bool fine = evaluator_.fineness() > 1;
        longest_ = fine ? MAX_DETOUR * chart_->distance(states_[FROM], states_[TO]) : INFINITE_LENGTH;
        if (!findVia((fine ? FINE_SPREAD : FIRST_SPREAD) * run))
        {
            const double middle = 0.5 * (gap.before + gap.after) / segments;
            return fine && shiftVertices(path, motion, FINE_SPREAD * run, middle);
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
        const double growth = evaluator_.fineness() > 1 ? FINE_GROWTH : GROWTH;
        for (unsigned int k = 0; k < TRIES && !evaluator_.interrupted(); ++k, spread *= growth)
        {
            chart_->interpolate(states_[FROM], states_[TO], rng_.uniformReal(0.3, 0.7), states_[BETWEEN]);
            chart_->space()->enforceBounds(states_[BETWEEN]);
            for (Eigen::Index j = 0; j < step_.size(); ++j)
            {
                step_[j] = spread * rng_.gaussian01();
            }
            chart_->displace(states_[BETWEEN], step_, states_[VIA]);
            if (leadsOver(states_[VIA]))
            {
                shortenDetour();
                return true;
            }
        }
        return false;
    }

    bool PathRepair::leadsOver(const ob::State *via)
    {
        return chart_->distance(states_[FROM], via) + chart_->distance(via, states_[TO]) <= longest_ &&
               evaluator_.checkState(via) && evaluator_.checkMotion(states_[FROM], via) &&
               evaluator_.checkMotion(via, states_[TO]);
    }

    /* Moves the vertices of a motion, other than the ends of the path, so that it and its neighbours are valid: where
       its curvature does not allow a detour. \e middle is the fraction of the motion at the gap. */
    bool PathRepair::shiftVertices(path::Waypoints &path, std::size_t motion, double spread, double middle)
    {
        const auto &space = chart_->space();
        path::Waypoints &s = states_;
        space->copyState(s[OLD], path[motion - 1]);
        space->copyState(s[OLD + 1], path[motion]);
        longest_ += lengthAround(path, motion, OLD);
        for (unsigned int k = 0; k < SHIFTS && !evaluator_.interrupted(); ++k, spread *= SHIFT_GROWTH)
        {
            for (const std::size_t end : {std::size_t(0), std::size_t(1)})
            {
                space->copyState(s[SHIFTED + end], s[OLD + end]);
                for (Eigen::Index j = 0; j < step_.size(); ++j)
                {
                    step_[j] = spread * rng_.gaussian01();
                }
                if (isMovable(path, motion - 1 + end))
                {
                    chart_->displace(s[OLD + end], step_, s[SHIFTED + end]);
                }
            }
            if (!isShiftValid(path, motion, SHIFTED, middle))
            {
                continue;
            }
            shortenShift(path, motion, middle);
            space->copyState(path[motion - 1], s[SHIFTED]);
            space->copyState(path[motion], s[SHIFTED + 1]);
            return true;
        }
        return false;
    }

    bool PathRepair::isMovable(const path::Waypoints &path, std::size_t vertex)
    {
        return vertex > 0 && vertex + 1 < path.size();
    }

    /* Length of a motion and of its neighbours if its vertices are the states \e first and the one after that. */
    double PathRepair::lengthAround(const path::Waypoints &path, std::size_t motion, std::size_t first)
    {
        path::Waypoints &s = states_;
        const bool before = isMovable(path, motion - 1);
        const bool after = isMovable(path, motion);
        return (before ? chart_->distance(path[motion - 2], s[first]) : 0.0) +
               chart_->distance(s[first], s[first + 1]) +
               (after ? chart_->distance(s[first + 1], path[motion + 1]) : 0.0);
    }

    bool PathRepair::isShiftValid(const path::Waypoints &path, std::size_t motion, std::size_t first, double middle)
    {
        path::Waypoints &s = states_;
        const ob::State *const from = s[first];
        const ob::State *const to = s[first + 1];
        if (lengthAround(path, motion, first) > longest_)
        {
            return false;
        }
        chart_->interpolate(from, to, middle, s[BETWEEN]);
        chart_->space()->enforceBounds(s[BETWEEN]);
        return evaluator_.checkState(s[BETWEEN]) && evaluator_.checkState(from) && evaluator_.checkMotion(from, to) &&
               (!isMovable(path, motion - 1) || evaluator_.checkMotion(path[motion - 2], from)) &&
               (!isMovable(path, motion) || evaluator_.checkMotion(to, path[motion + 1]));
    }

    /* Moves the shifted vertices back as far as that stays valid. */
    void PathRepair::shortenShift(const path::Waypoints &path, std::size_t motion, double middle)
    {
        path::Waypoints &s = states_;
        for (unsigned int k = 0; k < BISECTIONS && !evaluator_.interrupted(); ++k)
        {
            for (const std::size_t end : {std::size_t(0), std::size_t(1)})
            {
                chart_->interpolate(s[OLD + end], s[SHIFTED + end], 0.5, s[BETTER + end]);
                chart_->space()->enforceBounds(s[BETTER + end]);
            }
            const bool valid = lengthAround(path, motion, BETTER) < lengthAround(path, motion, SHIFTED) &&
                               isShiftValid(path, motion, BETTER, middle);
            for (const std::size_t end : {std::size_t(0), std::size_t(1)})
            {
                chart_->space()->copyState(valid ? s[SHIFTED + end] : s[OLD + end], s[BETTER + end]);
            }
        }
    }

    /* Pulls the state of the detour toward the gap as far as it stays valid. A draft's repair is tightened later. */
    void PathRepair::shortenDetour()
    {
        double low = 0.0;
        double high = 1.0;
        path::Waypoints &s = states_;
        chart_->space()->copyState(s[FARTHEST], s[VIA]);
        for (unsigned int k = 0; evaluator_.fineness() > 1 && k < BISECTIONS && !evaluator_.interrupted(); ++k)
        {
            const double middle = 0.5 * (low + high);
            chart_->interpolate(s[BETWEEN], s[FARTHEST], middle, s[NEARER]);
            chart_->space()->enforceBounds(s[NEARER]);
            const bool shorter = leadsOver(s[NEARER]);
            (shorter ? high : low) = middle;
            if (shorter)
            {
                chart_->space()->copyState(s[VIA], s[NEARER]);
            }
        }
    }
}  // namespace ompl_mfa::engine::refinement
