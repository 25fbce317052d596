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

#include "engine/PathHints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Times that a path is tried while there is no path, each with more effort. */
        constexpr unsigned int TRIES = 4;
        /* Points of a path that are compared with one start or goal, and with each of several. */
        constexpr unsigned int FINE = 200;
        constexpr unsigned int COARSE = 10;
    }  // namespace

    PathHints::PathHints(const SearchContext &context, PathMender *mender, bool drafts)
      : context_(context)
      , mender_(mender)
      , drafts_(drafts)
      , scratch_(context.chart->space())
    {
        scratch_.resize(1);
    }

    void PathHints::add(path::Waypoints path, Source source)
    {
        for (std::size_t i = 0; i < path.size(); ++i)
        {
            context_.chart->space()->enforceBounds(path[i]);
        }
        const auto place =
            std::find_if(hints_.begin(), hints_.end(), [source](const Hint &hint) { return hint.source > source; });
        hints_.insert(place, {std::move(path), source, 0});
        if (hints_.size() > CAPACITY)
        {
            hints_.pop_back();
        }
    }

    void PathHints::advance(Findings &findings)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        if (hints_.empty() || !context_.hasEnds() || evaluator.work() < due_ || evaluator.stopped())
        {
            return;
        }
        const std::uint64_t before = evaluator.work();
        const bool known = context_.incumbent.hasFinitePath();
        path::Waypoints path = hints_.front().path;
        const unsigned int effort = hints_.front().effort;
        // what only has to be compared with the best path is made valid as a draft
        const path::StrideScope scope(evaluator, drafts_ ? context_.draftStride() : 1);
        if (mender_ != nullptr)
        {
            joinStart(path);
            joinGoal(path);
        }
        const bool worthwhile = isWorthwhile(path);
        const bool valid = worthwhile && !evaluator.interrupted() && makeValid(path, effort);
        if (evaluator.interrupted())
        {
            return;
        }
        Hint hint = std::move(hints_.front());
        hints_.pop_front();
        if (valid)
        {
            const auto stage = path.size() > 2 ? Proposal::Stage::Raw : Proposal::Stage::Straight;
            findings.paths.push_back({std::move(path), std::nullopt, stage, std::nullopt, evaluator.stride() > 1});
            return;
        }
        due_ = evaluator.work() + (evaluator.work() - before);
        if (worthwhile && mender_ != nullptr && !known && ++hint.effort < TRIES)
        {
            hints_.push_back(std::move(hint));
        }
    }

    /* Whether the path would be of use if it were valid. */
    bool PathHints::isWorthwhile(const path::Waypoints &path) const
    {
        const Incumbent &incumbent = context_.incumbent;
        if (!incumbent.hasFinitePath())
        {
            return true;
        }
        path::PathEvaluator &evaluator = context_.evaluator();
        const ob::Cost most(evaluator.withSlack(incumbent.cost(), PathPool::SLACK));
        return !context_.objective().isCostBetterThan(most, evaluator.cost(path));
    }

    bool PathHints::makeValid(path::Waypoints &path, unsigned int effort)
    {
        if (mender_ != nullptr)
        {
            return mender_->mend(path, effort);
        }
        path::PathEvaluator &evaluator = context_.evaluator();
        return path.size() > 1 && context_.query.isAnsweredBy(path) && evaluator.checkState(path.front()) &&
               evaluator.checkPath(path);
    }

    /* Of several starts or goals the one that is nearest to the path. */
    std::size_t PathHints::nearestEnd(const path::Waypoints &path, const path::Waypoints &ends, bool isStart) const
    {
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; ends.size() > 1 && i < ends.size(); ++i)
        {
            const double distance = nearestPoint(path, ends[i], isStart, COARSE).distance;
            if (distance < least)
            {
                least = distance;
                nearest = i;
            }
        }
        return nearest;
    }

    /* Among about \e samples points at even distances, the vertices included. */
    PathHints::Point PathHints::nearestPoint(const path::Waypoints &path, const ob::State *end, bool isStart,
                                             unsigned int samples) const
    {
        const path::StateChart &chart = *context_.chart;
        path::Waypoints point(chart.space());
        point.resize(1);
        Point nearest{0, 0.0, std::numeric_limits<double>::infinity()};
        const auto compare = [&](std::size_t vertex, double fraction, const ob::State *state)
        {
            const double distance = isStart ? chart.distance(end, state) : chart.distance(state, end);
            // of two equally near points the one that leaves less of the path to do
            if (isStart ? distance <= nearest.distance : distance < nearest.distance)
            {
                nearest = {vertex, fraction, distance};
            }
        };
        compare(0, 1.0, path[0]);
        const auto motions = static_cast<double>(path.size() - 1);
        std::vector<double> lengths(path.size(), 0.0);
        double total = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const double length = chart.distance(path[i - 1], path[i]);
            lengths[i] = std::isfinite(length) ? length : 0.0;
            total += lengths[i];
        }
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const double share = total > 0.0 ? lengths[i] / total : 1.0 / motions;
            const auto pieces = static_cast<unsigned int>(std::ceil(std::max(1.0, samples * share)));
            for (unsigned int j = 1; j < pieces; ++j)
            {
                const double fraction = static_cast<double>(j) / pieces;
                chart.interpolate(path[i - 1], path[i], fraction, point[0]);
                chart.space()->enforceBounds(point[0]);
                compare(i, fraction, point[0]);
            }
            compare(i, 1.0, path[i]);
            context_.evaluator().addDistances(pieces);
        }
        context_.evaluator().addWork(1 + samples / 4);
        return nearest;
    }

    /* Lets the path begin at a start: what is before the point nearest to it is cut off. */
    void PathHints::joinStart(path::Waypoints &path)
    {
        const path::StateChart &chart = *context_.chart;
        const path::Waypoints &starts = context_.query.starts();
        for (std::size_t i = 0; i < starts.size(); ++i)
        {
            if (chart.space()->equalStates(path.front(), starts[i]))
            {
                return;
            }
        }
        const ob::State *start = starts[nearestEnd(path, starts, true)];
        const Point point = nearestPoint(path, start, true, FINE);
        path::Waypoints joined(chart.space());
        joined.append(start);
        // a start on the path needs no vertex beside it
        if (point.fraction < 1.0 && !context_.evaluator().checkMotion(start, path[point.vertex]))
        {
            chart.interpolate(path[point.vertex - 1], path[point.vertex], point.fraction, scratch_[0]);
            chart.space()->enforceBounds(scratch_[0]);
            joined.append(scratch_[0]);
        }
        for (std::size_t i = point.vertex; i < path.size(); ++i)
        {
            joined.append(path[i]);
        }
        path = joined;
    }

    /* Lets the path end at a goal: what is behind the point nearest to it is cut off. */
    void PathHints::joinGoal(path::Waypoints &path)
    {
        const path::StateChart &chart = *context_.chart;
        const path::Waypoints &goals = context_.query.goals();
        if (path.size() > 1 && context_.query.isAnsweredBy(path) && context_.evaluator().checkState(path.back()))
        {
            return;
        }
        const ob::State *goal = goals[nearestEnd(path, goals, false)];
        const Point point = nearestPoint(path, goal, false, FINE);
        path::Waypoints joined(chart.space());
        for (std::size_t i = 0; i < point.vertex; ++i)
        {
            joined.append(path[i]);
        }
        if (point.fraction == 1.0)
        {
            joined.append(path[point.vertex]);
        }
        else if (!context_.evaluator().checkMotion(path[point.vertex - 1], goal))
        {
            chart.interpolate(path[point.vertex - 1], path[point.vertex], point.fraction, scratch_[0]);
            chart.space()->enforceBounds(scratch_[0]);
            joined.append(scratch_[0]);
        }
        joined.append(goal);
        path = joined;
    }
}  // namespace ompl_mfa::engine
