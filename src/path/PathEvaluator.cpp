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

#include "path/PathEvaluator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/util/Exception.h>

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        /* OMPL bisects a motion: an invalid one is usually detected after this fraction (1 / INVALID_EARLY) of its
           states. */
        constexpr std::uint64_t INVALID_EARLY = 6;
        /* Motion costs that are mere distances, computed between two evaluations of the stop condition. */
        constexpr std::uint64_t DISTANCES_BETWEEN_STOPS = 64;
        /* States of a strict check between two evaluations of the stop condition. */
        constexpr unsigned int STATES_BETWEEN_STOPS = 64;

        /* The work of checking \e states one after the other until one is invalid. */
        std::uint64_t bisectionWork(std::uint64_t states, bool valid)
        {
            return valid ? states : 1 + states / INVALID_EARLY;
        }
    }  // namespace

    PathEvaluator::PathEvaluator(ob::SpaceInformationPtr si, ob::OptimizationObjectivePtr objective,
                                 unsigned int threads)
      : si_(std::move(si))
      , objective_(std::move(objective))
      , guard_(si_->getStateSpace())
      , bounds_(si_, objective_)
      , parallel_(threads > 1 ? std::make_unique<ParallelChecks>(si_, threads) : nullptr)
      , scratch_(si_->allocState())
    {
    }

    PathEvaluator::~PathEvaluator()
    {
        si_->freeState(scratch_);
    }

    void PathEvaluator::setStopCondition(StopCondition stop)
    {
        stop_ = std::move(stop);
        interrupted_ = false;
    }

    void PathEvaluator::setPartialPathEvent(PartialPathEvent event)
    {
        partialPath_ = std::move(event);
    }

    bool PathEvaluator::motionCost(const ob::State *from, const ob::State *to, ob::Cost &cost)
    {
        ++distances_;
        if ((!bounds_.certain() || ++costs_ % DISTANCES_BETWEEN_STOPS == 0) && stopped())
        {
            cost = objective_->infiniteCost();
            return false;
        }
        if (!guard_.allows(from, to))
        {
            cost = objective_->infiniteCost();
            return true;
        }
        cost = objective_->motionCost(from, to);
        // integral of an infinite cost over a length of 0
        if (std::isnan(cost.value()) && si_->equalStates(from, to))
        {
            cost = objective_->identityCost();
        }
        number(cost, "motion cost");
        bounds_.observeMotion(from, to, cost);
        return true;
    }

    ob::Cost PathEvaluator::cost(const Waypoints &path)
    {
        bookkeeping_ += path.size();
        motionCosts_.resize(path.size() - 1);
        for (std::size_t i = 0; i < motionCosts_.size(); ++i)
        {
            if (!motionCost(path[i], path[i + 1], motionCosts_[i]))
            {
                return objective_->infiniteCost();
            }
        }
        return cost(path, motionCosts_);
    }

    ob::Cost PathEvaluator::cost(const Waypoints &path, const std::vector<ob::Cost> &motionCosts)
    {
        ob::Cost motions = objective_->identityCost();
        ob::Cost cost = objective_->initialCost(path.front());
        for (const ob::Cost motion : motionCosts)
        {
            motions = objective_->combineCosts(motions, motion);
            cost = objective_->combineCosts(cost, motion);
        }
        bounds_.observePath(path.front(), path.back(), motions);
        return number(objective_->combineCosts(cost, objective_->terminalCost(path.back())), "path cost");
    }

    /* NaN is neither better nor worse than any cost, so no search would end with it. */
    ob::Cost PathEvaluator::number(ob::Cost cost, const char *what) const
    {
        if (std::isnan(cost.value()))
        {
            throw ompl::Exception("MFA", "the objective '" + objective_->getDescription() + "' computed a " + what +
                                             " that is not a number");
        }
        return cost;
    }

    bool PathEvaluator::stopped()
    {
        interrupted_ = interrupted_ || (stop_ && stop_());
        return interrupted_;
    }

    bool PathEvaluator::checkState(const ob::State *state)
    {
        ++checks_;
        return si_->satisfiesBounds(state) && si_->isValid(state);
    }

    bool PathEvaluator::checkMotion(const ob::State *from, const ob::State *to)
    {
        failed_ = 0;
        if (stopped() || !guard_.allows(from, to))
        {
            return false;
        }
        if (stride_ > 1)
        {
            return checkDraft({from, to});
        }
        const bool valid = parallel_ ? parallel_->checkMotion({from, to}) : si_->checkMotion(from, to);
        checks_ += motionWork(*si_, {from, to}, valid);
        return valid && (fineness_ == 1 || checkFineStates({from, to}));
    }

    unsigned int PathEvaluator::checkedSegments(const ob::State *from, const ob::State *to) const
    {
        const unsigned int segments = guard_.validSegmentCount(from, to);
        return stride_ > 1 ? std::max(1U, segments / stride_) : std::max(1U, segments) * fineness_;
    }

    std::uint64_t PathEvaluator::checkWork(const Waypoints &path) const
    {
        std::uint64_t work = path.size();
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            work += checkedSegments(path[i - 1], path[i]);
        }
        return work;
    }

    /* The end first, then the states inside in bisection order. */
    bool PathEvaluator::checkDraft(const Motion &motion)
    {
        if (!checkState(motion.to))
        {
            return false;
        }
        const unsigned int most = checkedSegments(motion.from, motion.to);
        unsigned int count = 1;
        while (3 * count <= 2 * most)
        {
            count *= 2;
        }
        const bool valid = parallel_ ? parallel_->checkInside(motion, count) : checkInside(motion, count);
        checks_ += bisectionWork(count - 1, valid);
        return valid;
    }

    bool PathEvaluator::screenMotion(const ob::State *from, const ob::State *to, unsigned int stride)
    {
        if (stopped() || !guard_.allows(from, to))
        {
            return false;
        }
        const unsigned int most = si_->getStateSpace()->validSegmentCount(from, to) / stride;
        unsigned int count = 1;
        while (2 * count <= most)
        {
            count *= 2;
        }
        const Motion motion{from, to};
        const bool valid = parallel_ ? parallel_->checkInside(motion, count) : checkInside(motion, count);
        checks_ += bisectionWork(count, valid);
        return valid;
    }

    /* Checks the states that divide a motion into \e count segments, a power of two, in bisection order. */
    bool PathEvaluator::checkInside(const Motion &motion, unsigned int count)
    {
        for (unsigned int pieces = 2; pieces <= count; pieces *= 2)
        {
            for (unsigned int j = 1; j < pieces; j += 2)
            {
                si_->getStateSpace()->interpolate(motion.from, motion.to, static_cast<double>(j) / pieces, scratch_);
                if (!si_->isValid(scratch_))
                {
                    return false;
                }
            }
        }
        return true;
    }

    std::uint64_t PathEvaluator::motionWork(const ob::SpaceInformation &si, const Motion &motion, bool valid)
    {
        return bisectionWork(si.getStateSpace()->validSegmentCount(motion.from, motion.to), valid);
    }

    /* Whether motions_[i] is valid; to be called for increasing i. Checks ahead by other threads are neither counted as
       work nor acted upon until they are asked for here. */
    bool PathEvaluator::checkNext(std::size_t i)
    {
        if (!parallel_ || stride_ > 1 || fineness_ > 1)
        {
            return checkMotion(motions_[i].from, motions_[i].to);
        }
        if (stopped())
        {
            return false;
        }
        if (i == 0)
        {
            checked_ = 0;
        }
        if (!guard_.allows(motions_[i].from, motions_[i].to))
        {
            checked_ = i + 1;
            return false;
        }
        if (i == checked_)
        {
            valid_.resize(motions_.size());
            checked_ += parallel_->checkMotions(&motions_[i], allowedFrom(i), &valid_[i]);
        }
        checks_ += motionWork(*si_, motions_[i], valid_[i] != 0);
        return valid_[i] != 0;
    }

    /* The number of motions from index i on, before one that OMPL cannot compute. */
    std::size_t PathEvaluator::allowedFrom(std::size_t i) const
    {
        const auto first = motions_.begin() + static_cast<std::ptrdiff_t>(i);
        const auto refused = std::find_if(
            first, motions_.end(), [this](const Motion &motion) { return !guard_.allows(motion.from, motion.to); });
        return static_cast<std::size_t>(refused - first);
    }

    bool PathEvaluator::checkAll()
    {
        for (std::size_t i = 0; i < motions_.size(); ++i)
        {
            if (!checkNext(i))
            {
                return false;
            }
        }
        return true;
    }

    bool PathEvaluator::checkMotions(std::initializer_list<Motion> motions)
    {
        motions_.assign(motions);
        return checkAll();
    }

    bool PathEvaluator::checkStrictly(std::initializer_list<Motion> motions)
    {
        return checkMotions(motions) && checkBetween(motions);
    }

    bool PathEvaluator::checkStrictly(const Waypoints &path)
    {
        if (!checkPath(path))
        {
            return false;
        }
        for (std::size_t i = 1; stride_ == 1 && fineness_ == 1 && i < path.size(); ++i)
        {
            if (!checkBetween({path[i - 1], path[i]}))
            {
                return false;
            }
        }
        return true;
    }

    bool PathEvaluator::checkBetween(std::initializer_list<Motion> motions)
    {
        return stride_ > 1 || fineness_ > 1 ||
               std::all_of(motions.begin(), motions.end(),
                           [this](const Motion &motion) { return checkBetween(motion); });
    }

    bool PathEvaluator::checkBetween(const Motion &motion)
    {
        if (!guard_.allows(motion.from, motion.to))
        {
            return false;
        }
        const auto &space = si_->getStateSpace();
        const unsigned int states = space->validSegmentCount(motion.from, motion.to);
        for (unsigned int j = 0; j < states; ++j)
        {
            if (j % STATES_BETWEEN_STOPS == STATES_BETWEEN_STOPS - 1 && stopped())
            {
                return false;
            }
            space->interpolate(motion.from, motion.to, (j + 0.5) / states, scratch_);
            ++checks_;
            if (!si_->isValid(scratch_))
            {
                return false;
            }
        }
        return true;
    }

    bool PathEvaluator::checkPath(const Waypoints &path)
    {
        motions_.clear();
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            motions_.push_back({path[i - 1], path[i]});
        }
        return checkAll();
    }

    bool PathEvaluator::isBrighter(const Brightness &a, const Brightness &b) const
    {
        if (a.violation != b.violation)
        {
            return a.violation < b.violation;
        }
        return isBetter(a.cost, b.cost);
    }

    double PathEvaluator::withSlack(double cost, double factor) const
    {
        if (!std::isfinite(cost) || cost <= 0.0)
        {
            return cost;
        }
        const double slack = factor * cost;
        return std::isfinite(slack) && isBetter(cost, slack) ? slack : cost;
    }

    Brightness PathEvaluator::evaluate(const Waypoints &path, const Brightness *rival)
    {
        const ob::Cost known = cost(path);
        return interrupted_ ? Brightness() : evaluate(path, known, rival);
    }

    Brightness PathEvaluator::evaluate(const Waypoints &path, ob::Cost cost, const Brightness *rival)
    {
        Brightness result{0.0, cost.value()};
        const bool feasibleRival = rival != nullptr && rival->isFeasible();
        if (feasibleRival && !isBrighter(result, *rival))
        {
            return {};
        }
        const std::size_t motions = path.size() - 1;
        // a path that repeatedly fails often fails at the same motion
        const std::size_t first = partialPath_ || lastInvalid_ >= motions ? 0 : lastInvalid_;
        const auto number = [first](std::size_t k) { return k == 0 ? first : (k <= first ? k - 1 : k); };
        motions_.clear();
        for (std::size_t k = 0; k < motions; ++k)
        {
            motions_.push_back({path[number(k)], path[number(k) + 1]});
        }
        for (std::size_t k = 0; k < motions; ++k)
        {
            if (checkNext(k))
            {
                continue;
            }
            const std::size_t i = number(k);
            if (interrupted_)
            {
                return {};
            }
            lastInvalid_ = i;
            if (feasibleRival)
            {
                return {};
            }
            if (partialPath_ && result.violation == 0.0)
            {
                reportPartialPath(path, i);
            }
            // a motion that only the motion validator rejects still counts
            result.violation += invalidLength({path[i], path[i + 1]});
            if (rival != nullptr && result.violation > rival->violation)
            {
                return {};
            }
        }
        return result;
    }

    void PathEvaluator::reportPartialPath(const Waypoints &path, std::size_t motion)
    {
        si_->copyState(scratch_, path[motion]);
        std::pair<ob::State *, double> lastValid(scratch_, 0.0);
        if (guard_.allows(path[motion], path[motion + 1]))
        {
            checks_ += si_->getStateSpace()->validSegmentCount(path[motion], path[motion + 1]);
            si_->checkMotion(path[motion], path[motion + 1], lastValid);
        }
        partialPath_(path, motion, scratch_);
    }

    /* Of the states that divide a motion into \e count segments, and its end. */
    unsigned int PathEvaluator::countInvalid(const ob::State *from, const ob::State *to, unsigned int count)
    {
        checks_ += count;
        if (parallel_)
        {
            return parallel_->countInvalid({from, to}, count);
        }
        unsigned int invalid = 0;
        for (unsigned int j = 1; j <= count; ++j)
        {
            si_->getStateSpace()->interpolate(from, to, static_cast<double>(j) / count, scratch_);
            if (!si_->isValid(scratch_))
            {
                ++invalid;
            }
        }
        return invalid;
    }

    /* The length of the invalid segments of the motion, at least one; the whole length if OMPL cannot compute it. */
    double PathEvaluator::invalidLength(const Motion &motion)
    {
        if (!guard_.allows(motion.from, motion.to))
        {
            return guard_.distance(motion.from, motion.to);
        }
        const unsigned int count = std::max(1U, si_->getStateSpace()->validSegmentCount(motion.from, motion.to));
        const unsigned int invalid = std::max(1U, countInvalid(motion.from, motion.to, count));
        return si_->distance(motion.from, motion.to) * invalid / count;
    }
}  // namespace ompl_mfa::path
