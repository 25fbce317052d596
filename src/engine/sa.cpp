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

#include "engine/StrictAnswer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* A path better by this fraction is a notable improvement. */
        constexpr double NOTABLE = 0.01;
        /* Fractions of the work that may be spent on checks in full. For the first answer that is checked so: at a
           notable improvement, growing with the work since; for other improvements: if the check is worth its work, to
           which the gain is added; if the answer will probably become better; and if that is unlikely. */
        constexpr double FIRST_SHARE = 0.004;
        constexpr double MAX_FIRST_SHARE = 0.1;
        constexpr double WORTH_SHARE = 0.03;
        constexpr double PROMISING_SHARE = 0.015;
        constexpr double HOPELESS_SHARE = 0.003;
        /* A check is worth its fraction of the work so far if the answer becomes better by this times that. */
        constexpr double WORTH = 0.3;
        /* Improvement after which a repair that failed is promising again. */
        constexpr double RETRY = 0.001;
        /* The same for checks near corners, and the least improvement. */
        constexpr double CORNER_SHARE = 0.1;
        constexpr double CORNER_NOTABLE = 0.001;
        /* Share of the work for tightening the answer, in turns of this many checks of it, and the least excess over
           the incumbent that is worth it. */
        constexpr double TIGHTEN_SHARE = 0.02;
        constexpr std::uint64_t TIGHTEN_FACTOR = 2;
        constexpr double TIGHTEN_EXCESS = 1e-4;
        /* Attempts for one improvement that are made on demand; each draws other random states. */
        constexpr unsigned int MAX_ATTEMPTS = 5;
        /* Without an answer, the incumbent is returned once the work has grown by this factor and by this amount since
           the first attempt. */
        constexpr std::uint64_t GRACE_FACTOR = 2;
        constexpr std::uint64_t GRACE = 20000;
        /* States that a repair may have inserted into one motion. */
        constexpr std::size_t MAX_INSERTED = 16;
    }  // namespace

    StrictAnswer::StrictAnswer(SearchContext &context)
      : context_(context)
      , repair_(context.chart, context.evaluator(),
                static_cast<std::uint_fast32_t>(streamSeed(context.seed, Stream::Strict)))
      , tightening_(context.chart, context.evaluator(),
                    static_cast<std::uint_fast32_t>(streamSeed(context.seed, Stream::StrictTightening)))
      , checked_(context.chart->space())
    {
    }

    bool StrictAnswer::isActive() const
    {
        const SearchSettings &settings = context_.settings;
        return settings.strictness > 1 && !settings.isPaper() && context_.evaluator().isDiscrete();
    }

    void StrictAnswer::update(bool demanded)
    {
        const Incumbent &incumbent = context_.incumbent;
        if (!incumbent.hasPath())
        {
            return;
        }
        if (!isActive())
        {
            giveUp();
            return;
        }
        watchImprovements();
        const bool improved = full_.tried != incumbent.improvements();
        const bool again = demanded && !full_.succeeded && full_.attempts < MAX_ATTEMPTS;
        if (!demanded && !isSingleMotion() && areCornersDue())
        {
            make(Level::Corners);
        }
        else if (improved ? demanded || isFullCheckDue() : again)
        {
            make(Level::Everywhere);
        }
        else if (!demanded && isTighteningDue())
        {
            tighten();
        }
        if (level_ == Level::Nowhere && begin_ > 0 && context_.evaluator().work() >= GRACE_FACTOR * begin_ + GRACE)
        {
            giveUp();
        }
    }

    void StrictAnswer::giveUp()
    {
        const Incumbent &incumbent = context_.incumbent;
        if (incumbent.hasPath() && (level_ == Level::Nowhere || !isActive()))
        {
            context_.answer.offer(incumbent.path(), incumbent.cost(), incumbent.origin());
        }
    }

    bool StrictAnswer::isBetterBy(double fraction) const
    {
        const double before = context_.answer.cost();
        const double now = context_.incumbent.cost();
        return !std::isfinite(before) || !std::isfinite(now) || std::abs(before - now) >= fraction * std::abs(before);
    }

    /* Probably the shortest path, which ends the search. */
    bool StrictAnswer::isSingleMotion() const
    {
        return context_.incumbent.path().size() == 2;
    }

    bool StrictAnswer::isAffordable(std::uint64_t work, double share) const
    {
        return static_cast<double>(work) <= share * static_cast<double>(context_.evaluator().work());
    }

    bool StrictAnswer::isFullCheckDue() const
    {
        if (isSingleMotion() && level_ != Level::Everywhere)
        {
            return true;
        }
        const auto work = static_cast<double>(context_.evaluator().work());
        // most motions of the next one may be known
        const std::uint64_t expected = full_.succeeded ? full_.last : fullCheckWork(context_.incumbent.path());
        if (level_ != Level::Everywhere && full_.attempts == 0)
        {
            const double share = std::min(MAX_FIRST_SHARE, FIRST_SHARE * work / notable_.work);
            return isAffordable(full_.spent + expected, share);
        }
        const double gain = expectedGain();
        const double share = gain >= WORTH * static_cast<double>(expected) / work ? WORTH_SHARE + gain
                             : gain > 0.0                                         ? PROMISING_SHARE
                                                                                  : HOPELESS_SHARE;
        return isAffordable(full_.spent + expected, share);
    }

    /* Relative gain of the answer by a repair that costs as much as the last one; 0 if that failed. */
    double StrictAnswer::expectedGain() const
    {
        const double before = context_.answer.cost();
        const double now = context_.incumbent.cost();
        if (!std::isfinite(before) || !std::isfinite(now))
        {
            return 1.0;
        }
        const double scale = std::max(std::abs(before), 1e-12);
        if (!full_.succeeded)
        {
            return std::abs(lastFull_.incumbent - now) >= RETRY * scale ? RETRY : 0.0;
        }
        return (std::abs(before - now) - std::abs(lastFull_.repaired - lastFull_.incumbent)) / scale;
    }

    std::uint64_t StrictAnswer::fullCheckWork(const path::Waypoints &path) const
    {
        return context_.settings.strictness * context_.evaluator().checkWork(path);
    }

    void StrictAnswer::watchImprovements()
    {
        const double cost = context_.incumbent.cost();
        if (notable_.work == 0.0 || !std::isfinite(notable_.cost) ||
            std::abs(notable_.cost - cost) >= NOTABLE * std::abs(notable_.cost))
        {
            notable_ = {cost, static_cast<double>(context_.evaluator().work())};
        }
    }

    bool StrictAnswer::areCornersDue() const
    {
        // once a path that was checked in full is worse than the answer, others would be worse than the next one, too
        const bool allowed = level_ != Level::Everywhere && (full_.attempts == 0 || isBetterBy(NOTABLE));
        return allowed && corners_.tried != context_.incumbent.improvements() && isBetterBy(CORNER_NOTABLE) &&
               (begin_ == 0 || isAffordable(corners_.spent + corners_.last, CORNER_SHARE));
    }

    /* Where the incumbent cannot be repaired at so little cost that the answer becomes better, the last repaired path
       is tightened instead. */
    bool StrictAnswer::isTighteningDue() const
    {
        if (level_ != Level::Everywhere && !full_.succeeded)
        {
            return false;
        }
        const bool done = !restart_ && tightened_ == context_.answer.improvements() && tightening_.converged();
        return !done && expectedGain() <= 0.0 && (level_ != Level::Everywhere || isBetterBy(TIGHTEN_EXCESS)) &&
               isAffordable(tighteningSpent_ + TIGHTEN_FACTOR * fullCheckWork(context_.answer.path()), TIGHTEN_SHARE);
    }

    /* Every motion that is replaced is checked in full. */
    void StrictAnswer::tighten()
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        Incumbent &answer = context_.answer;
        const std::uint64_t before = evaluator.work();
        if (level_ == Level::Everywhere ? tightened_ != answer.improvements() : restart_)
        {
            tightening_.begin(level_ == Level::Everywhere ? answer.path() : checked_);
        }
        restart_ = false;
        {
            const path::FinenessScope fine(evaluator, context_.settings.strictness, false);
            tightening_.advance(TIGHTEN_FACTOR * fullCheckWork(answer.path()));
        }
        if (answer.offer(tightening_.path(), tightening_.cost().value(), answer.origin()))
        {
            level_ = Level::Everywhere;
        }
        tightened_ = answer.improvements();
        tighteningSpent_ += evaluator.work() - before;
    }

    void StrictAnswer::make(Level level)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const Incumbent &incumbent = context_.incumbent;
        Effort &effort = level == Level::Everywhere ? full_ : corners_;
        const std::uint64_t before = evaluator.work();
        path::Waypoints path = incumbent.path();
        effort.succeeded = check(level, path);
        const ob::Cost cost = effort.succeeded ? evaluator.cost(path) : context_.objective().infiniteCost();
        evaluator.addWork(path.size());
        effort.last = evaluator.work() - before;
        effort.spent += effort.last;
        begin_ = begin_ == 0 ? std::max<std::uint64_t>(before, 1) : begin_;
        if (evaluator.interrupted())
        {
            effort.succeeded = false;
            return;
        }
        effort.attempts = effort.tried == incumbent.improvements() ? effort.attempts + 1 : 1;
        effort.tried = incumbent.improvements();
        if (level == Level::Everywhere)
        {
            lastFull_ = {incumbent.cost(), cost.value()};
            restart_ = effort.succeeded;
        }
        if (!effort.succeeded)
        {
            return;
        }
        remember(path, level);
        if (context_.answer.offer(path, cost.value(), incumbent.origin()))
        {
            level_ = level;
        }
        else if (cost.value() == context_.answer.cost())
        {
            level_ = std::max(level_, level);
        }
    }

    /* Repairs \e path where a check of \e level fails. */
    bool StrictAnswer::check(Level level, path::Waypoints &path)
    {
        using Knowledge = refinement::PathRepair::Knowledge;
        insertKnownRepairs(path);
        incumbentHint_ = 0;
        checkedHint_ = 0;
        const path::FinenessScope fine(context_.evaluator(), context_.settings.strictness, level == Level::Corners);
        return repair_.repair(path,
                              [&](const ob::State *from, const ob::State *to)
                              {
                                  const Level known = levelOf(from, to);
                                  if (known >= level)
                                  {
                                      return Knowledge::FinelyValid;
                                  }
                                  return known != Level::Nowhere ||
                                                 isMotionOf(context_.incumbent.path(), incumbentHint_, from, to)
                                             ? Knowledge::Valid
                                             : Knowledge::Nothing;
                              });
    }

    /* A motion of the incumbent that was repaired before is repaired in the same way. */
    void StrictAnswer::insertKnownRepairs(path::Waypoints &path)
    {
        const auto &si = *context_.spaceInformation();
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const std::size_t from = find(checked_, checkedHint_, path[i - 1]);
            std::size_t to = from + 1;
            while (to < checked_.size() && !original_[to] && to <= from + MAX_INSERTED)
            {
                ++to;
            }
            if (to >= checked_.size() || !si.equalStates(checked_[to], path[i]))
            {
                continue;
            }
            for (std::size_t k = from + 1; k < to; ++k, ++i)
            {
                path.insert(i, checked_[k]);
            }
        }
    }

    /* The index of \e state in \e path, its size if it is not there. The search begins at \e hint, where the last one
       ended. */
    std::size_t StrictAnswer::find(const path::Waypoints &path, std::size_t &hint, const ob::State *state) const
    {
        for (std::size_t k = 0; k < path.size(); ++k)
        {
            const std::size_t i = (hint + k) % path.size();
            if (context_.spaceInformation()->equalStates(path[i], state))
            {
                hint = i;
                return i;
            }
        }
        return path.size();
    }

    bool StrictAnswer::isMotionOf(const path::Waypoints &path, std::size_t &hint, const ob::State *from,
                                  const ob::State *to) const
    {
        const std::size_t i = find(path, hint, from);
        return i + 1 < path.size() && context_.spaceInformation()->equalStates(path[i + 1], to);
    }

    StrictAnswer::Level StrictAnswer::levelOf(const ob::State *from, const ob::State *to)
    {
        return isMotionOf(checked_, checkedHint_, from, to) ? levels_[checkedHint_ + 1] : Level::Nowhere;
    }

    void StrictAnswer::remember(const path::Waypoints &path, Level level)
    {
        const path::Waypoints &incumbent = context_.incumbent.path();
        std::vector<Level> levels{level};
        std::vector<bool> original;
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            levels.push_back(std::max(level, levelOf(path[i - 1], path[i])));
        }
        for (std::size_t i = 0, next = 0; i < path.size(); ++i)
        {
            const bool same =
                next < incumbent.size() && context_.spaceInformation()->equalStates(path[i], incumbent[next]);
            next += same ? 1 : 0;
            original.push_back(same);
        }
        checked_ = path;
        levels_ = std::move(levels);
        original_ = std::move(original);
    }
}  // namespace ompl_mfa::engine
