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

#include "engine/refinement/PathTightening.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* A round that gains less than this fraction of the cost counts as idle. */
        constexpr double IDLE_GAIN = 1e-5;
        constexpr unsigned int IDLE_ROUNDS = 4;
        constexpr unsigned int IDLE_ROUNDS_A_DIMENSION = 2;
        /* Steps per round for each vertex that can move. */
        constexpr std::size_t STEPS_A_VERTEX = 6;
        /* Factor by which the weight of a step in the payoff of its kind decays with each later step. */
        constexpr double PAYOFF_MEMORY = 0.95;
        /* Lower bound of the share of steps of each kind. */
        constexpr double PAYOFF_FLOOR = 0.08;
        /* Number of vertices that are tried to bend a motion of infinite cost. */
        constexpr unsigned int BEND_TRIES = 4;

        /* Indices in PathTightening::scratch_. */
        constexpr std::size_t FIRST = 0;
        constexpr std::size_t SECOND = 1;
    }  // namespace

    PathTightening::PathTightening(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , rng_(seed)
      , path_(chart_, evaluator_)
      , shortcuts_(path_, rng_)
      , moves_(path_, rng_)
      , scratch_(chart_->space())
      , delta_(chart_->dimension())
    {
        scratch_.resize(2);
    }

    void PathTightening::begin(const path::Waypoints &path)
    {
        path_.begin(path);
        converged_ = path_.size() < 2;
        idleRounds_ = 0;
        payoffs_ = {};
    }

    bool PathTightening::advance(std::uint64_t work)
    {
        workLimit_ = evaluator_.work() + work;
        if (!path_.completeCosts())
        {
            return false;
        }
        const ob::Cost first = path_.cost();
        ob::Cost before = first;
        while (canImprove() && evaluator_.work() < workLimit_ && !evaluator_.interrupted())
        {
            const std::size_t infinite = path_.infiniteMotions();
            round();
            const ob::Cost after = path_.cost();
            const bool idle = !(gain(before.value(), after.value()) > IDLE_GAIN * std::abs(after.value())) &&
                              infinite == path_.infiniteMotions();
            idleRounds_ = idle ? idleRounds_ + 1 : 0;
            before = after;
            if (idleRounds_ > 0 && evaluator_.work() < workLimit_)
            {
                const bool refined = refineWorstCorner();
                const unsigned int enough =
                    IDLE_ROUNDS + IDLE_ROUNDS_A_DIMENSION * static_cast<unsigned int>(chart_->dimension());
                converged_ = idleRounds_ >= (refined ? 3 * enough : enough);
            }
        }
        // compared with the first cost: a corner may have been cut since the last round
        return evaluator_.objective()->isCostBetterThan(path_.cost(), first);
    }

    /* The gain of a step. Between two infinite costs it is unknown; from an infinite to a finite one it is the
       remaining cost. */
    double PathTightening::gain(double before, double after)
    {
        if (!std::isfinite(after))
        {
            return 0.0;
        }
        return std::abs(std::isfinite(before) ? before - after : after);
    }

    /* A single motion cannot be improved unless its cost is infinite. */
    bool PathTightening::canImprove() const
    {
        return path_.size() > 2 || path_.infiniteMotions() > 0;
    }

    /* Which kind of step pays depends on the world and on the progress so far: each is chosen in proportion to its
       recent gain for its work, but never less often than a lower bound. */
    void PathTightening::round()
    {
        // candidates rejected on cost alone never reach a motion check, which would ask the stop condition
        const auto exhausted = [this] { return evaluator_.work() >= workLimit_ || evaluator_.stopped(); };
        removeVertices();
        bendInfiniteMotions();
        total_ = path_.cost().value();
        const std::size_t steps = path_.size() > 2 ? STEPS_A_VERTEX * (path_.size() - 2) : 0;
        for (std::size_t k = 0; k < steps && path_.size() > 2 && !exhausted(); ++k)
        {
            const StepKind kind = chooseStep();
            const std::uint64_t work = evaluator_.work();
            const bool success = makeStep(kind, 1 + k % (path_.size() - 2));
            Payoff &payoff = payoffs_[kind];
            payoff.gain *= PAYOFF_MEMORY;
            payoff.work = PAYOFF_MEMORY * payoff.work + static_cast<double>(evaluator_.work() - work + 1);
            if (!success)
            {
                continue;
            }
            const double now = path_.cost().value();
            payoff.gain += gain(total_, now);
            total_ = now;
        }
    }

    PathTightening::StepKind PathTightening::chooseStep()
    {
        double sum = 0.0;
        for (const Payoff &payoff : payoffs_)
        {
            sum += payoff.rate();
        }
        double draw = rng_.uniform01();
        for (std::size_t k = 0; k + 1 < StepKinds; ++k)
        {
            const double part = sum > 0.0 ? payoffs_[k].rate() / sum : 1.0 / StepKinds;
            draw -= PAYOFF_FLOOR + (1.0 - StepKinds * PAYOFF_FLOOR) * part;
            if (draw < 0.0)
            {
                return static_cast<StepKind>(k);
            }
        }
        return static_cast<StepKind>(StepKinds - 1);
    }

    bool PathTightening::makeStep(StepKind kind, std::size_t i)
    {
        switch (kind)
        {
            case Shortcut:
                return shortcuts_.shortcut();
            case PartShortcut:
                return shortcuts_.partShortcut();
            case Pull:
                return moves_.pull(i);
            case PullPart:
                return moves_.pullPart(i);
            default:
                return moves_.perturb(i);
        }
    }

    void PathTightening::removeVertices()
    {
        for (std::size_t i = 1; i + 1 < path_.size() && evaluator_.work() < workLimit_ && !evaluator_.stopped();)
        {
            if (!remove(i))
            {
                ++i;
            }
        }
    }

    bool PathTightening::remove(std::size_t i)
    {
        // where the chord is far better than the corner, it is probably blocked: try it rarely
        ob::Cost chord;
        if (!evaluator_.motionCost(path_[i - 1], path_[i + 1], chord))
        {
            return false;
        }
        const ob::Cost corner = path_.cornerCost(i);
        evaluator_.observePath(path_[i - 1], path_[i + 1], corner);
        evaluator_.addWork(1);
        if (evaluator_.objective()->isCostBetterThan(corner, chord))
        {
            return false;
        }
        if (path_.step(i).pull < 0.3 && rng_.uniform01() > 0.1)
        {
            return false;
        }
        if (!evaluator_.checkStrictly({{path_[i - 1], path_[i + 1]}}))
        {
            return false;
        }
        path_.erase(i, i + 1, chord);
        return true;
    }

    void PathTightening::bendInfiniteMotions()
    {
        for (std::size_t i = 0; i + 1 < path_.size() && evaluator_.work() < workLimit_ && !evaluator_.stopped();)
        {
            if (path_.full() || evaluator_.objective()->isFinite(path_.motionCost(i)) || !bend(i))
            {
                ++i;
            }
        }
    }

    /* Leads a motion of infinite cost over a new vertex beside it, at most as far away as the motion is long, so that
       at least one of the two new motions has a finite cost. */
    bool PathTightening::bend(std::size_t i)
    {
        const auto &objective = evaluator_.objective();
        const double length = chart_->distance(path_[i], path_[i + 1]);
        if (!std::isfinite(length))
        {
            return false;
        }
        for (unsigned int k = 0; k < BEND_TRIES && !evaluator_.interrupted(); ++k)
        {
            chart_->interpolate(path_[i], path_[i + 1], rng_.uniform01(), scratch_[SECOND]);
            chart_->space()->enforceBounds(scratch_[SECOND]);
            for (Eigen::Index j = 0; j < delta_.size(); ++j)
            {
                delta_[j] = rng_.gaussian01();
            }
            delta_ *= length * rng_.uniform01() / std::sqrt(static_cast<double>(delta_.size()));
            chart_->displace(scratch_[SECOND], delta_, scratch_[FIRST]);
            ob::Cost before;
            ob::Cost after;
            evaluator_.addWork(2);
            if (!evaluator_.motionCost(path_[i], scratch_[FIRST], before) ||
                !evaluator_.motionCost(scratch_[FIRST], path_[i + 1], after))
            {
                return false;
            }
            if ((objective->isFinite(before) || objective->isFinite(after)) &&
                evaluator_.checkStrictly({{path_[i], scratch_[FIRST]}, {scratch_[FIRST], path_[i + 1]}}))
            {
                path_.insert(i + 1, scratch_[FIRST], before, after);
                return true;
            }
        }
        return false;
    }

    /* Adds a vertex where the detour over the chord is largest. */
    bool PathTightening::refineWorstCorner()
    {
        if (path_.full() || path_.size() < 3)
        {
            return false;
        }
        std::size_t worst = 0;
        double largest = 1e-6 * chart_->distance(path_.states().front(), path_.states().back());
        for (std::size_t i = 1; i + 1 < path_.size(); ++i)
        {
            const double detour = chart_->distance(path_[i - 1], path_[i]) + chart_->distance(path_[i], path_[i + 1]) -
                                  chart_->distance(path_[i - 1], path_[i + 1]);
            if (detour > largest)
            {
                largest = detour;
                worst = i;
            }
        }
        return worst > 0 && cutCorner(worst);
    }

    /* Replaces a vertex by two, one on each of its motions, as near to it as validity requires. */
    bool PathTightening::cutCorner(std::size_t i)
    {
        const auto &space = chart_->space();
        const auto &objective = evaluator_.objective();
        ob::Cost before;
        ob::Cost cut;
        ob::Cost after;
        for (double part = 0.5; part > 0.01; part *= 0.4)
        {
            chart_->interpolate(path_[i - 1], path_[i], 1.0 - part, scratch_[FIRST]);
            space->enforceBounds(scratch_[FIRST]);
            chart_->interpolate(path_[i], path_[i + 1], part, scratch_[SECOND]);
            space->enforceBounds(scratch_[SECOND]);
            if (!evaluator_.motionCost(path_[i - 1], scratch_[FIRST], before) ||
                !evaluator_.motionCost(scratch_[FIRST], scratch_[SECOND], cut) ||
                !evaluator_.motionCost(scratch_[SECOND], path_[i + 1], after))
            {
                return false;
            }
            const ob::Cost around = objective->combineCosts(objective->combineCosts(before, cut), after);
            if (objective->isCostBetterThan(path_.cornerCost(i), around))
            {
                continue;
            }
            if (evaluator_.checkStrictly({{scratch_[FIRST], scratch_[SECOND]},
                                          {path_[i - 1], scratch_[FIRST]},
                                          {scratch_[SECOND], path_[i + 1]}}))
            {
                path_.move(i, scratch_[SECOND], cut, after);
                path_.restartSteps(i);
                path_.insert(i, scratch_[FIRST], before, cut);
                return true;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::engine::refinement
