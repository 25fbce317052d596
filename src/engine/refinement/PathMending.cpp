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

#include "engine/refinement/PathMending.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* Gaps that are bridged before a path is given up. */
        constexpr unsigned int MAX_GAPS = 24;
        /* Budget of the trees over one gap; it doubles with the effort. */
        constexpr std::uint64_t GAP_WORK = 1500;
        /* Valid states in a row that end a gap, at full resolution. */
        constexpr unsigned int RUN_END = 8;
        /* For each unit of effort, the trees begin and end farther from the gap by this fraction of the path. */
        constexpr double MARGIN = 0.05;
        /* A bridge may be longer than the gap by this factor, and by this fraction of the path, which doubles with the
           effort. */
        constexpr double BRIDGE = 1.5;
        constexpr double SLACK = 0.15;

        /* Indices in PathMending::scratch_. */
        constexpr std::size_t FROM = 0;
        constexpr std::size_t TO = 1;
        constexpr std::size_t BETWEEN = 2;
    }  // namespace

    PathMending::PathMending(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , trees_(chart_, evaluator, seed)
      , mended_(chart_->space())
      , detour_(chart_->space())
      , scratch_(chart_->space())
    {
        scratch_.resize(3);
    }

    bool PathMending::mend(path::Waypoints &path, unsigned int effort)
    {
        length_ = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const double distance = chart_->distance(path[i - 1], path[i]);
            length_ += std::isfinite(distance) ? distance : 0.0;
        }
        mended_.clear();
        mended_.append(path.front());
        unsigned int gaps = 0;
        for (std::size_t next = 1; next < path.size();)
        {
            if (evaluator_.stopped())
            {
                return false;
            }
            if (evaluator_.checkState(path[next]) && evaluator_.checkMotion(mended_.back(), path[next]))
            {
                append(path[next]);
                ++next;
            }
            else if (evaluator_.interrupted() || ++gaps > MAX_GAPS || !bridge(path, next, effort))
            {
                return false;
            }
        }
        if (mended_.size() < 2)
        {
            mended_.append(path.back());
        }
        path = mended_;
        return !evaluator_.interrupted();
    }

    void PathMending::append(const ob::State *state)
    {
        if (!chart_->space()->equalStates(mended_.back(), state))
        {
            mended_.append(state);
        }
    }

    /* Leads the valid path over the gap that begins before vertex \e next of the path; that is then the next vertex
       behind the gap. */
    bool PathMending::bridge(const path::Waypoints &path, std::size_t &next, unsigned int effort)
    {
        const double margin = effort * MARGIN * length_;
        chart_->space()->copyState(scratch_[FROM], mended_.back());
        if (!findGap(path, next, margin))
        {
            return false;
        }
        if (evaluator_.checkMotion(mended_.back(), scratch_[FROM]))
        {
            append(scratch_[FROM]);
        }
        retreat(margin);
        const ob::State *to = scratch_[TO];
        if (!evaluator_.checkMotion(mended_.back(), to))
        {
            chart_->space()->copyState(scratch_[FROM], mended_.back());
            const double distance = chart_->distance(scratch_[FROM], to);
            const double longest = BRIDGE * distance + SLACK * std::ldexp(length_, static_cast<int>(effort));
            if (evaluator_.interrupted() || !std::isfinite(distance) ||
                !trees_.connect(scratch_[FROM], to, longest, GAP_WORK << effort, detour_))
            {
                return false;
            }
            for (std::size_t i = 1; i + 1 < detour_.size(); ++i)
            {
                append(detour_[i]);
            }
        }
        append(to);
        return true;
    }

    /* Walks along the path from the end of the valid path: FROM becomes the last valid state before the first invalid
       one, TO a valid state behind it that follows \e margin of valid states, or else the end of the path. A motion
       that is invalid although its states are not is a gap, too. */
    bool PathMending::findGap(const path::Waypoints &path, std::size_t &next, double margin)
    {
        const ob::State *state = scratch_[BETWEEN];
        Walk walk{next, 0, evaluator_.checkedSegments(mended_.back(), path[next])};
        bool collided = false;
        const unsigned int least = 1 + (RUN_END - 1) / evaluator_.stride();
        unsigned int run = 0;
        double valid = 0.0;
        for (; walk.vertex < path.size() && !evaluator_.stopped(); advance(path, walk))
        {
            const ob::State *from = walk.vertex == next ? mended_.back() : path[walk.vertex - 1];
            stateOn(from, path[walk.vertex], walk);
            if (!evaluator_.checkState(state))
            {
                collided = true;
                run = 0;
                valid = 0.0;
                continue;
            }
            const bool atVertex = walk.number + 1 == walk.segments;
            if (!collided && !atVertex)
            {
                chart_->space()->copyState(scratch_[FROM], state);
                continue;
            }
            ++run;
            valid += chart_->distance(from, path[walk.vertex]) / walk.segments;
            if (!collided)
            {
                chart_->space()->copyState(scratch_[FROM], mended_.back());
            }
            if (!collided || (atVertex && walk.vertex + 1 == path.size()) || (run >= least && valid >= margin))
            {
                chart_->space()->copyState(scratch_[TO], state);
                next = atVertex ? walk.vertex + 1 : walk.vertex;
                return true;
            }
        }
        return false;
    }

    void PathMending::advance(const path::Waypoints &path, Walk &walk) const
    {
        if (++walk.number < walk.segments || ++walk.vertex == path.size())
        {
            return;
        }
        walk.number = 0;
        walk.segments = evaluator_.checkedSegments(path[walk.vertex - 1], path[walk.vertex]);
    }

    /* Sets BETWEEN to the state of the walk on the motion to its vertex. */
    void PathMending::stateOn(const ob::State *from, const ob::State *to, const Walk &walk)
    {
        const unsigned int number = walk.number + 1;
        if (number == walk.segments)
        {
            chart_->space()->copyState(scratch_[BETWEEN], to);
            return;
        }
        chart_->interpolate(from, to, static_cast<double>(number) / walk.segments, scratch_[BETWEEN]);
        chart_->space()->enforceBounds(scratch_[BETWEEN]);
    }

    /* Shortens the valid path by about \e margin. */
    void PathMending::retreat(double margin)
    {
        while (mended_.size() > 1 && margin > 0.0)
        {
            const ob::State *before = mended_[mended_.size() - 2];
            const double distance = chart_->distance(before, mended_.back());
            if (distance > margin)
            {
                chart_->interpolate(before, mended_.back(), 1.0 - margin / distance, scratch_[BETWEEN]);
                chart_->space()->enforceBounds(scratch_[BETWEEN]);
                if (evaluator_.checkState(scratch_[BETWEEN]) && evaluator_.checkMotion(before, scratch_[BETWEEN]))
                {
                    chart_->space()->copyState(mended_[mended_.size() - 1], scratch_[BETWEEN]);
                    return;
                }
            }
            mended_.erase(mended_.size() - 1, mended_.size());
            margin -= std::max(distance, 0.0);
        }
    }
}  // namespace ompl_mfa::engine::refinement
