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

#include "engine/refinement/StrictAnswer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* A path better by this fraction is a notable improvement. */
        constexpr double NOTABLE = 0.01;
        /* Fractions of the work that may be spent on checks in full. For the first answer that is checked so: at a
           notable improvement, growing with the work since and with the duration of the search; for other improvements:
           if the check is worth its work, to which the gain is added; if the answer will probably become better; and if
           that is unlikely. */
        constexpr double FIRST_SHARE = 0.004;
        constexpr double SHARE_A_SECOND = 0.2;
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
    }  // namespace

    StrictAnswer::StrictAnswer(SearchContext &context)
      : context_(context)
      , repair_(context.chart, context.evaluator(),
                static_cast<std::uint_fast32_t>(streamSeed(context.seed, Stream::Strict)))
      , tightening_(context.chart, context.evaluator(),
                    static_cast<std::uint_fast32_t>(streamSeed(context.seed, Stream::StrictTightening)))
      , checked_(context.spaceInformation())
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
            make(CheckLevel::Corners);
        }
        else if (improved ? demanded || isFullCheckDue() : again)
        {
            make(CheckLevel::Everywhere);
        }
        else if (!demanded && isConfirmationDue())
        {
            confirm();
        }
        else if (!demanded && isTighteningDue())
        {
            tighten();
        }
        if (level_ == CheckLevel::Nowhere && begin_ > 0 && context_.evaluator().work() >= GRACE_FACTOR * begin_ + GRACE)
        {
            giveUp();
        }
    }

    void StrictAnswer::giveUp()
    {
        const Incumbent &incumbent = context_.incumbent;
        if (incumbent.hasPath() && (level_ == CheckLevel::Nowhere || !isActive()))
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
        if (isSingleMotion() && level_ != CheckLevel::Everywhere)
        {
            return true;
        }
        const auto work = static_cast<double>(context_.evaluator().work());
        // most motions of the next one may be known
        const std::uint64_t expected = full_.succeeded ? full_.last : fullCheckWork(context_.incumbent.path());
        if (level_ != CheckLevel::Everywhere && full_.attempts == 0)
        {
            return isAffordable(full_.spent + expected, firstShare());
        }
        const double gain = expectedGain();
        const double share = gain >= WORTH * static_cast<double>(expected) / work ? WORTH_SHARE + gain
                             : gain > 0.0                                         ? PROMISING_SHARE
                                                                                  : HOPELESS_SHARE;
        return isAffordable(full_.spent + expected, share);
    }

    double StrictAnswer::firstShare() const
    {
        const double quiet = static_cast<double>(context_.evaluator().work()) / notable_.work;
        return std::min(MAX_FIRST_SHARE, std::max(FIRST_SHARE * quiet, SHARE_A_SECOND * context_.progress.time()));
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
        const bool allowed = level_ != CheckLevel::Everywhere && (full_.attempts == 0 || isBetterBy(NOTABLE));
        return allowed && corners_.tried != context_.incumbent.improvements() && isBetterBy(CORNER_NOTABLE) &&
               (begin_ == 0 || isAffordable(corners_.spent + corners_.last, CORNER_SHARE));
    }

    /* Where the incumbent cannot be repaired at so little cost that the answer becomes better, the last repaired path
       is tightened instead. */
    bool StrictAnswer::isTighteningDue() const
    {
        const double share = level_ == CheckLevel::Everywhere ? TIGHTEN_SHARE : std::max(TIGHTEN_SHARE, firstShare());
        return canTighten_ && !tightening_.converged() && expectedGain() <= 0.0 &&
               (level_ != CheckLevel::Everywhere || isBetterBy(TIGHTEN_EXCESS)) &&
               isAffordable(tighteningSpent_ + TIGHTEN_FACTOR * fullCheckWork(tightening_.path()), share);
    }

    /* Every motion that is replaced is checked in full. */
    void StrictAnswer::tighten()
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const std::uint64_t before = evaluator.work();
        {
            const path::FinenessScope fine(evaluator, context_.settings.strictness, false);
            tightening_.advance(TIGHTEN_FACTOR * fullCheckWork(tightening_.path()));
        }
        if (context_.answer.offer(tightening_.path(), tightening_.cost().value(), context_.answer.origin()))
        {
            level_ = CheckLevel::Everywhere;
        }
        tighteningSpent_ += evaluator.work() - before;
    }

    bool StrictAnswer::isConfirmationDue() const
    {
        return level_ != CheckLevel::Everywhere && context_.answer.hasPath() && full_.attempts > 0 &&
               confirmed_ != context_.answer.improvements() &&
               isAffordable(full_.spent + fullCheckWork(context_.answer.path()), 2.0 * firstShare());
    }

    void StrictAnswer::make(CheckLevel level)
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const Incumbent &incumbent = context_.incumbent;
        Effort &effort = level == CheckLevel::Everywhere ? full_ : corners_;
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
        if (level == CheckLevel::Everywhere)
        {
            lastFull_ = {incumbent.cost(), cost.value()};
        }
        if (effort.succeeded)
        {
            accept(path, cost.value(), level, incumbent.path(), incumbent.origin());
        }
    }

    /* Checks the answer in full, where the incumbent cannot be made to hold at so little cost. */
    void StrictAnswer::confirm()
    {
        path::PathEvaluator &evaluator = context_.evaluator();
        const Incumbent &answer = context_.answer;
        const std::uint64_t before = evaluator.work();
        const path::Waypoints original = answer.path();
        path::Waypoints path = original;
        const bool holds = check(CheckLevel::Everywhere, path);
        full_.spent += evaluator.work() - before;
        if (evaluator.interrupted())
        {
            return;
        }
        confirmed_ = answer.improvements();
        if (holds)
        {
            accept(path, evaluator.cost(path).value(), CheckLevel::Everywhere, original, answer.origin());
        }
    }

    /* Makes a checked path the answer, if it is better, or the start of a better one. */
    void StrictAnswer::accept(const path::Waypoints &path, double cost, CheckLevel level,
                              const path::Waypoints &original, std::optional<PartKind> origin)
    {
        checked_.set(path, level, original);
        const CheckLevel before = level_;
        const bool better = context_.answer.offer(path, cost, origin);
        if (better || cost == context_.answer.cost())
        {
            level_ = better ? level : std::max(level_, level);
        }
        if (level == CheckLevel::Everywhere && (better || before != CheckLevel::Everywhere))
        {
            tightening_.begin(path);
            canTighten_ = true;
        }
    }

    /* Repairs \e path where a check of \e level fails. */
    bool StrictAnswer::check(CheckLevel level, path::Waypoints &path)
    {
        using Knowledge = PathRepair::Knowledge;
        checked_.insertRepairs(path);
        std::size_t hint = 0;
        const path::FinenessScope fine(context_.evaluator(), context_.settings.strictness,
                                       level == CheckLevel::Corners);
        return repair_.repair(path,
                              [&](const ob::State *from, const ob::State *to)
                              {
                                  const CheckLevel known = checked_.levelOf(from, to);
                                  if (known >= level)
                                  {
                                      return Knowledge::FinelyValid;
                                  }
                                  return known != CheckLevel::Nowhere ||
                                                 checked_.isMotionOf(context_.incumbent.path(), hint, from, to)
                                             ? Knowledge::Valid
                                             : Knowledge::Nothing;
                              });
    }
}  // namespace ompl_mfa::engine::refinement
