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
        /* More vertices cost more than they gain: each has to be moved, and each motion checked. */
        constexpr std::size_t MAX_VERTICES = 48;
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
        /* Distance that a vertex keeps from where it would be blocked, as a fraction of the distance between two states
           of a motion check. */
        constexpr double MARGIN = 0.125;
        /* Number of moves after a blocked one for which a vertex has to keep the margin; elsewhere the margin is not
           checked. */
        constexpr unsigned int CAUTION = 2;
        /* First random step of a vertex, as a fraction of the distance to the nearer neighbour. */
        constexpr double FIRST_STEP = 0.25;
        /* Number of random steps that may be evaluated for cost until one is checked for validity. */
        constexpr unsigned int COST_TRIES = 4;
    }  // namespace

    PathTightening::PathTightening(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed)
      : chart_(std::move(chart))
      , evaluator_(evaluator)
      , rng_(seed)
      , path_(chart_->space())
      , segment_(chart_->space())
      , a_(chart_->space()->allocState())
      , b_(chart_->space()->allocState())
      , beyond_(chart_->space()->allocState())
      , delta_(chart_->dimension())
      , beyondDelta_(chart_->dimension())
    {
    }

    PathTightening::~PathTightening()
    {
        chart_->space()->freeState(a_);
        chart_->space()->freeState(b_);
        chart_->space()->freeState(beyond_);
    }

    void PathTightening::begin(const path::Waypoints &path)
    {
        path_ = path;
        costs_.clear();
        steps_.clear();
        for (std::size_t i = 0; i < path_.size(); ++i)
        {
            steps_.push_back(firstStep(i));
        }
        converged_ = path_.size() < 2;
        idleRounds_ = 0;
        payoffs_ = {};
    }

    bool PathTightening::advance(std::uint64_t work)
    {
        workLimit_ = evaluator_.work() + work;
        if (!completeCosts())
        {
            return false;
        }
        const ob::Cost first = cost();
        ob::Cost before = first;
        while (canImprove() && evaluator_.work() < workLimit_ && !evaluator_.interrupted())
        {
            const std::size_t infinite = infiniteMotions();
            round();
            const ob::Cost after = cost();
            const bool idle = !(gain(before.value(), after.value()) > IDLE_GAIN * std::abs(after.value())) &&
                              infinite == infiniteMotions();
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
        return evaluator_.objective()->isCostBetterThan(cost(), first);
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

    std::size_t PathTightening::infiniteMotions() const
    {
        return static_cast<std::size_t>(std::count_if(
            costs_.begin(), costs_.end(), [this](ob::Cost cost) { return !evaluator_.objective()->isFinite(cost); }));
    }

    /* A single motion cannot be improved unless its cost is infinite. */
    bool PathTightening::canImprove() const
    {
        return path_.size() > 2 || infiniteMotions() > 0;
    }

    /* Which kind of step pays depends on the world and on the progress so far: each is chosen in proportion to its
       recent gain for its work, but never less often than a lower bound. */
    void PathTightening::round()
    {
        // candidates rejected on cost alone never reach a motion check, which would ask the stop condition
        const auto exhausted = [this] { return evaluator_.work() >= workLimit_ || evaluator_.stopped(); };
        removeVertices();
        bendInfiniteMotions();
        total_ = cost().value();
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
            const double now = cost().value();
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
                return shortcut();
            case PartShortcut:
                return partShortcut();
            case Pull:
                return pull(i);
            case PullPart:
                return pullPart(i);
            default:
                return perturb(i);
        }
    }

    ob::Cost PathTightening::cost() const
    {
        if (costs_.size() + 1 < path_.size())
        {
            return evaluator_.objective()->infiniteCost();
        }
        return evaluator_.cost(path_, costs_);
    }

    bool PathTightening::completeCosts()
    {
        while (costs_.size() + 1 < path_.size())
        {
            const std::size_t i = costs_.size();
            ob::Cost cost;
            evaluator_.addWork(1);
            if (!evaluator_.motionCost(path_[i], path_[i + 1], cost))
            {
                return false;
            }
            costs_.push_back(cost);
        }
        return true;
    }

    ob::Cost PathTightening::cornerCost(std::size_t i) const
    {
        return evaluator_.objective()->combineCosts(costs_[i - 1], costs_[i]);
    }

    PathTightening::Step PathTightening::firstStep(std::size_t i) const
    {
        double spacing = smallestStep();
        if (i > 0 && i + 1 < path_.size())
        {
            spacing = std::max(
                spacing, std::min(chart_->distance(path_[i - 1], path_[i]), chart_->distance(path_[i], path_[i + 1])));
        }
        return Step(VertexSearch(chart_->dimension(),
                                 FIRST_STEP * spacing / std::sqrt(static_cast<double>(chart_->dimension()))));
    }

    /* Replaces the motion that passes the new vertex by two, which cost \e before and \e after. */
    void PathTightening::insertVertex(std::size_t i, const ob::State *state, ob::Cost before, ob::Cost after)
    {
        path_.insert(i, state);
        costs_[i - 1] = before;
        costs_.insert(costs_.begin() + static_cast<std::ptrdiff_t>(i), after);
        steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(i), firstStep(i));
    }

    /* Replaces the motions to and from the vertices by one, which costs \e joined. */
    void PathTightening::eraseVertices(std::size_t first, std::size_t last, ob::Cost joined)
    {
        path_.erase(first, last);
        costs_.erase(costs_.begin() + static_cast<std::ptrdiff_t>(first),
                     costs_.begin() + static_cast<std::ptrdiff_t>(last));
        costs_[first - 1] = joined;
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(first),
                     steps_.begin() + static_cast<std::ptrdiff_t>(last));
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
        const ob::Cost corner = cornerCost(i);
        evaluator_.observePath(path_[i - 1], path_[i + 1], corner);
        evaluator_.addWork(1);
        if (evaluator_.objective()->isCostBetterThan(corner, chord))
        {
            return false;
        }
        if (steps_[i].pull < 0.3 && rng_.uniform01() > 0.1)
        {
            return false;
        }
        if (!evaluator_.checkStrictly({{path_[i - 1], path_[i + 1]}}))
        {
            return false;
        }
        eraseVertices(i, i + 1, chord);
        return true;
    }

    void PathTightening::bendInfiniteMotions()
    {
        for (std::size_t i = 0; i + 1 < path_.size() && evaluator_.work() < workLimit_ && !evaluator_.stopped();)
        {
            if (path_.size() >= MAX_VERTICES || evaluator_.objective()->isFinite(costs_[i]) || !bend(i))
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
        for (unsigned int k = 0; k < COST_TRIES && !evaluator_.interrupted(); ++k)
        {
            chart_->interpolate(path_[i], path_[i + 1], rng_.uniform01(), b_);
            chart_->space()->enforceBounds(b_);
            for (Eigen::Index j = 0; j < delta_.size(); ++j)
            {
                delta_[j] = rng_.gaussian01();
            }
            delta_ *= length * rng_.uniform01() / std::sqrt(static_cast<double>(delta_.size()));
            chart_->displace(b_, delta_, a_);
            ob::Cost before;
            ob::Cost after;
            evaluator_.addWork(2);
            if (!evaluator_.motionCost(path_[i], a_, before) || !evaluator_.motionCost(a_, path_[i + 1], after))
            {
                return false;
            }
            if ((objective->isFinite(before) || objective->isFinite(after)) &&
                evaluator_.checkStrictly({{path_[i], a_}, {a_, path_[i + 1]}}))
            {
                insertVertex(i + 1, a_, before, after);
                return true;
            }
        }
        return false;
    }

    /* Joins two points of the path, vertices or points on motions, by one motion. */
    bool PathTightening::shortcut()
    {
        const auto &space = chart_->space();
        const auto &objective = evaluator_.objective();
        const auto motions = static_cast<int>(path_.size()) - 1;
        int i = rng_.uniformInt(0, motions - 1);
        int j = rng_.uniformInt(0, motions - 1);
        if (i == j)
        {
            return false;
        }
        if (i > j)
        {
            std::swap(i, j);
        }
        const auto first = static_cast<std::size_t>(i);
        const auto last = static_cast<std::size_t>(j);
        // half of the shortcuts begin or end at a vertex, so that no new one is added there
        const bool fromVertex = rng_.uniform01() < 0.5 || path_.size() >= MAX_VERTICES;
        const bool toVertex = rng_.uniform01() < 0.5 || path_.size() >= MAX_VERTICES;
        if (fromVertex && toVertex && last == first + 1 && last == path_.size() - 1)
        {
            return false;
        }
        chart_->interpolate(path_[first], path_[first + 1], fromVertex ? 0.0 : rng_.uniform01(), a_);
        chart_->interpolate(path_[last], path_[last + 1], toVertex ? 1.0 : rng_.uniform01(), b_);
        space->enforceBounds(a_);
        space->enforceBounds(b_);
        if (fromVertex)
        {
            space->copyState(a_, path_[first]);
        }
        if (toVertex)
        {
            space->copyState(b_, path_[last + 1]);
        }

        ob::Cost old = costs_[first];
        for (std::size_t k = first + 1; k <= last; ++k)
        {
            old = objective->combineCosts(old, costs_[k]);
        }
        ob::Cost head;
        ob::Cost bridge;
        ob::Cost tail;
        if (!evaluator_.motionCost(a_, b_, bridge) || (!fromVertex && !evaluator_.motionCost(path_[first], a_, head)) ||
            (!toVertex && !evaluator_.motionCost(b_, path_[last + 1], tail)))
        {
            return false;
        }
        ob::Cost fresh = fromVertex ? bridge : objective->combineCosts(head, bridge);
        if (!toVertex)
        {
            fresh = objective->combineCosts(fresh, tail);
        }
        evaluator_.addWork(last - first + 3);
        if (!objective->isCostBetterThan(fresh, old))
        {
            return false;
        }
        if (!checkShortcut(fromVertex ? nullptr : path_[first], toVertex ? nullptr : path_[last + 1]))
        {
            return false;
        }
        eraseVertices(first + 1, last + 1, bridge);
        if (!toVertex)
        {
            insertVertex(first + 1, b_, bridge, tail);
        }
        if (!fromVertex)
        {
            insertVertex(first + 1, a_, head, bridge);
        }
        return true;
    }

    /* Moves all vertices between two toward the chord of these, in some coordinates only: steps of single vertices
       straighten a long section slowly, and shortcuts in all coordinates are often blocked. R. Geraerts and M. H.
       Overmars, Creating high-quality paths for motion planning, IJRR 26(8), 2007 (partial shortcut). */
    bool PathTightening::partShortcut()
    {
        const auto last = static_cast<int>(path_.size()) - 1;
        if (last < 3 || chart_->dimension() < 2)
        {
            return false;
        }
        const int i = rng_.uniformInt(0, last - 3);
        const int j = rng_.uniformInt(i + 3, last);
        const auto first = static_cast<std::size_t>(i);
        const auto count = static_cast<std::size_t>(j - i);
        Eigen::VectorXd mask;
        if (!selectCoordinates(mask))
        {
            mask.setZero();
            mask[rng_.uniformInt(0, static_cast<int>(mask.size()) - 1)] = 1.0;
        }
        const double part = rng_.uniform01() < 0.5 ? 1.0 : rng_.uniform01();
        double length = 0.0;
        for (std::size_t k = first; k < first + count; ++k)
        {
            length += chart_->distance(path_[k], path_[k + 1]);
        }
        if (!(length > 0.0) || !std::isfinite(length))
        {
            return false;
        }
        segment_.clear();
        segment_.append(path_[first]);
        double behind = 0.0;
        for (std::size_t k = 1; k < count; ++k)
        {
            behind += chart_->distance(path_[first + k - 1], path_[first + k]);
            chart_->interpolate(path_[first], path_[first + count], std::min(1.0, behind / length), b_);
            chart_->space()->enforceBounds(b_);
            chart_->difference(path_[first + k], b_, delta_);
            delta_ = part * delta_.cwiseProduct(mask);
            chart_->displace(path_[first + k], delta_, a_);
            segment_.append(a_);
        }
        segment_.append(path_[first + count]);
        return replaceSegment(first);
    }

    /* Sets \e mask to 1 for the coordinates of one subspace, for all but one, or for half of them; false, with all of
       them, in the remaining quarter of the draws. */
    bool PathTightening::selectCoordinates(Eigen::VectorXd &mask)
    {
        const auto pick = [this](Eigen::Index size)
        { return static_cast<Eigen::Index>(rng_.uniformInt(0, static_cast<int>(size) - 1)); };
        mask.setOnes(chart_->dimension());
        switch (rng_.uniformInt(chart_->leaves() > 1 ? 0 : 1, 3))
        {
            case 0:
            {
                const auto [offset, dimension] =
                    chart_->leafRange(static_cast<std::size_t>(pick(static_cast<Eigen::Index>(chart_->leaves()))));
                mask.setZero();
                mask.segment(offset, dimension).setOnes();
                return true;
            }
            case 1:
                mask[pick(mask.size())] = 0.0;
                return true;
            case 2:
                for (Eigen::Index j = 0; j < mask.size(); ++j)
                {
                    mask[j] = rng_.uniform01() < 0.5 ? 0.0 : 1.0;
                }
                return true;
            default:
                return false;
        }
    }

    /* Replaces the vertices from \e first on by those of segment_ if that is better and valid. */
    bool PathTightening::replaceSegment(std::size_t first)
    {
        const auto &objective = evaluator_.objective();
        const std::size_t motions = segment_.size() - 1;
        segmentCosts_.resize(motions);
        evaluator_.addWork(motions);
        ob::Cost old = costs_[first];
        ob::Cost fresh;
        for (std::size_t k = 0; k < motions; ++k)
        {
            if (!evaluator_.motionCost(segment_[k], segment_[k + 1], segmentCosts_[k]))
            {
                return false;
            }
            fresh = k == 0 ? segmentCosts_[k] : objective->combineCosts(fresh, segmentCosts_[k]);
            old = k == 0 ? old : objective->combineCosts(old, costs_[first + k]);
        }
        if (!objective->isCostBetterThan(fresh, old) || !evaluator_.checkStrictly(segment_))
        {
            return false;
        }
        for (std::size_t k = 0; k < motions; ++k)
        {
            costs_[first + k] = segmentCosts_[k];
            if (k > 0)
            {
                chart_->space()->copyState(path_[first + k], segment_[k]);
            }
        }
        return true;
    }

    /* Whether the motion a_ -> b_ is valid and, where they are needed, those that join it to the path \e before and \e
       after. */
    bool PathTightening::checkShortcut(const ob::State *before, const ob::State *after)
    {
        if (before != nullptr && after != nullptr)
        {
            return evaluator_.checkStrictly({{a_, b_}, {before, a_}, {b_, after}});
        }
        if (before != nullptr)
        {
            return evaluator_.checkStrictly({{a_, b_}, {before, a_}});
        }
        if (after != nullptr)
        {
            return evaluator_.checkStrictly({{a_, b_}, {b_, after}});
        }
        return evaluator_.checkStrictly({{a_, b_}});
    }

    /* Whether moving the vertex to \e state is better; the new motions cost \e before and \e after. */
    bool PathTightening::improves(std::size_t i, const ob::State *state, ob::Cost &before, ob::Cost &after)
    {
        const auto &objective = evaluator_.objective();
        return evaluator_.motionCost(path_[i - 1], state, before) &&
               evaluator_.motionCost(state, path_[i + 1], after) &&
               objective->isCostBetterThan(objective->combineCosts(before, after), cornerCost(i));
    }

    bool PathTightening::moveVertex(std::size_t i, const ob::State *state, ob::Cost before, ob::Cost after)
    {
        unsigned int &caution = steps_[i].caution;
        if (!evaluator_.checkMotions({{path_[i - 1], state}, {state, path_[i + 1]}}))
        {
            caution = CAUTION;
            return false;
        }
        if ((caution > 0 && !hasMargin(i, state)) ||
            !evaluator_.checkBetween({{path_[i - 1], state}, {state, path_[i + 1]}}))
        {
            return false;
        }
        caution -= caution > 0 ? 1 : 0;
        chart_->space()->copyState(path_[i], state);
        costs_[i - 1] = before;
        costs_[i] = after;
        return true;
    }

    /* Whether the vertex could move a little beyond its new state, so that the path does not touch an obstacle. Motions
       to the state itself are checked at twice the resolution, those beyond it at the normal one. */
    bool PathTightening::hasMargin(std::size_t i, const ob::State *state)
    {
        const unsigned int segments = evaluator_.checkedSegments(path_[i - 1], state);
        const double margin = MARGIN * chart_->distance(path_[i - 1], state) / segments;
        const double step = chart_->distance(path_[i], state);
        if (step <= 0.0)
        {
            return false;
        }
        chart_->difference(path_[i], state, beyondDelta_);
        beyondDelta_ *= 1.0 + margin / step;
        chart_->displace(path_[i], beyondDelta_, beyond_);
        return evaluator_.checkMotions({{path_[i - 1], beyond_}, {beyond_, path_[i + 1]}});
    }

    bool PathTightening::replaceVertex(std::size_t i, const ob::State *state)
    {
        ob::Cost before;
        ob::Cost after;
        evaluator_.addWork(2);
        return improves(i, state, before, after) && moveVertex(i, state, before, after);
    }

    double PathTightening::smallestStep() const
    {
        return 1e-6 * chart_->distance(path_.front(), path_.back()) + 1e-12;
    }

    bool PathTightening::pull(std::size_t i)
    {
        const auto &space = chart_->space();
        const double before = chart_->distance(path_[i - 1], path_[i]);
        const double after = chart_->distance(path_[i], path_[i + 1]);
        if (before + after <= 0.0)
        {
            return false;
        }
        chart_->interpolate(path_[i - 1], path_[i + 1], before / (before + after), b_);
        space->enforceBounds(b_);
        if (steps_[i].pull * chart_->distance(path_[i], b_) < smallestStep())
        {
            steps_[i].pull = std::min(1.0, 8.0 * steps_[i].pull);
            return false;
        }
        chart_->interpolate(path_[i], b_, steps_[i].pull, a_);
        space->enforceBounds(a_);
        const bool success = replaceVertex(i, a_);
        steps_[i].pull = success ? std::min(1.0, 1.6 * steps_[i].pull) : 0.4 * steps_[i].pull;
        return success;
    }

    /* Restricts the pull toward the chord to one subspace, to some coordinates, or to all directions but a random one.
       The obstacle is often a surface along which the vertex can slide once the normal direction is left out, and
       unneeded rotation unwinds while the position stays. */
    void PathTightening::selectPart(Step &step)
    {
        step.normal.setZero(chart_->dimension());
        if (selectCoordinates(step.mask))
        {
            return;
        }
        for (Eigen::Index j = 0; j < step.normal.size(); ++j)
        {
            step.normal[j] = rng_.gaussian01();
        }
        step.normal.normalize();
    }

    bool PathTightening::pullPart(std::size_t i)
    {
        const auto &space = chart_->space();
        const double before = chart_->distance(path_[i - 1], path_[i]);
        const double after = chart_->distance(path_[i], path_[i + 1]);
        if (before + after <= 0.0 || chart_->dimension() < 2)
        {
            return false;
        }
        Step &step = steps_[i];
        if (!step.partWorked)
        {
            selectPart(step);
        }
        chart_->interpolate(path_[i - 1], path_[i + 1], before / (before + after), b_);
        space->enforceBounds(b_);
        chart_->difference(path_[i], b_, delta_);
        delta_ = delta_.cwiseProduct(step.mask);
        delta_ -= delta_.dot(step.normal) * step.normal;
        delta_ *= rng_.uniform01() < 0.3 ? 1.0 : step.partPull;
        if (delta_.norm() < smallestStep())
        {
            step.partWorked = false;
            step.partPull = std::min(1.0, 4.0 * step.partPull);
            return false;
        }
        chart_->displace(path_[i], delta_, a_);
        step.partWorked = replaceVertex(i, a_);
        step.partPull = step.partWorked ? std::min(1.0, 1.5 * step.partPull) : std::max(1e-4, 0.8 * step.partPull);
        return step.partWorked;
    }

    bool PathTightening::perturb(std::size_t i)
    {
        VertexSearch &search = steps_[i].search;
        if (search.sigma() < smallestStep())
        {
            search = VertexSearch(chart_->dimension(), 1e3 * smallestStep());
        }
        for (unsigned int k = 0; k < COST_TRIES && !evaluator_.interrupted(); ++k)
        {
            ob::Cost before;
            ob::Cost after;
            search.draw(rng_, delta_);
            chart_->displace(path_[i], delta_, a_);
            evaluator_.addWork(1);
            if (!improves(i, a_, before, after))
            {
                search.failed();
            }
            else if (moveVertex(i, a_, before, after))
            {
                search.succeeded();
                return true;
            }
            else
            {
                search.violated();
                return false;
            }
        }
        return false;
    }

    /* Adds a vertex where the detour over the chord is largest. */
    bool PathTightening::refineWorstCorner()
    {
        if (path_.size() >= MAX_VERTICES || path_.size() < 3)
        {
            return false;
        }
        std::size_t worst = 0;
        double largest = 1e-6 * chart_->distance(path_.front(), path_.back());
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
            chart_->interpolate(path_[i - 1], path_[i], 1.0 - part, a_);
            space->enforceBounds(a_);
            chart_->interpolate(path_[i], path_[i + 1], part, b_);
            space->enforceBounds(b_);
            if (!evaluator_.motionCost(path_[i - 1], a_, before) || !evaluator_.motionCost(a_, b_, cut) ||
                !evaluator_.motionCost(b_, path_[i + 1], after))
            {
                return false;
            }
            const ob::Cost around = objective->combineCosts(objective->combineCosts(before, cut), after);
            if (objective->isCostBetterThan(cornerCost(i), around))
            {
                continue;
            }
            if (evaluator_.checkStrictly({{a_, b_}, {path_[i - 1], a_}, {b_, path_[i + 1]}}))
            {
                space->copyState(path_[i], b_);
                costs_[i] = after;
                steps_[i] = firstStep(i);
                insertVertex(i, a_, before, cut);
                return true;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::engine::refinement
