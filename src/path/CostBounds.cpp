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

#include "path/CostBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/base/spaces/SO3StateSpace.h>
#include <ompl/util/Console.h>

#include "path/ExactType.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        /* A cost beats a bound only by more than this fraction of the cost; less is rounding. */
        constexpr double ROUNDING = 1e-9;

        /* Whether the distance obeys the triangle inequality. That of symmetric Dubins curves does not: several motions
           with a cusp in between may be shorter than a single one. */
        bool obeysTriangleInequality(const ob::StateSpace &space)
        {
            if (isExactly<ob::RealVectorStateSpace, ob::SO2StateSpace, ob::SO3StateSpace, ob::ReedsSheppStateSpace>(
                    space))
            {
                return true;
            }
            if (isExactly<ob::DubinsStateSpace>(space))
            {
                return !space.hasSymmetricDistance();
            }
            if (!isExactly<ob::CompoundStateSpace, ob::SE2StateSpace, ob::SE3StateSpace>(space))
            {
                return false;
            }
            const auto &compound = *space.as<ob::CompoundStateSpace>();
            for (unsigned int i = 0; i < compound.getSubspaceCount(); ++i)
            {
                if (compound.getSubspaceWeight(i) < 0.0 || !obeysTriangleInequality(*compound.getSubspace(i)))
                {
                    return false;
                }
            }
            return true;
        }
    }  // namespace

    double worstFiniteCost(const ob::OptimizationObjective &objective)
    {
        constexpr double LARGEST = std::numeric_limits<double>::max();
        return objective.isCostBetterThan(ob::Cost(-LARGEST), ob::Cost(LARGEST)) ? LARGEST : -LARGEST;
    }

    CostBounds::CostBounds(const ob::SpaceInformationPtr &si, ob::OptimizationObjectivePtr objective)
      : objective_(std::move(objective))
      , guard_(si->getStateSpace())
      , certain_(isExactly<ob::PathLengthOptimizationObjective>(*objective_) &&
                 obeysTriangleInequality(*si->getStateSpace()))
    {
    }

    bool CostBounds::beats(ob::Cost cost, ob::Cost bound) const
    {
        if (!objective_->isCostBetterThan(cost, bound))
        {
            return false;
        }
        if (!std::isfinite(cost.value()) || !std::isfinite(bound.value()))
        {
            return true;
        }
        return std::abs(cost.value() - bound.value()) >
               ROUNDING * std::max(std::abs(cost.value()), std::abs(bound.value()));
    }

    void CostBounds::observeMotion(const ob::State *from, const ob::State *to, ob::Cost cost)
    {
        if (certain_)
        {
            return;
        }
        if (monotone_ && beats(cost, objective_->identityCost()))
        {
            monotone_ = false;
        }
        observePath(from, to, cost);
    }

    void CostBounds::observePath(const ob::State *from, const ob::State *to, ob::Cost cost)
    {
        if (certain_ || !admissible_ || !beats(cost, ob::Cost(motionBound(from, to))))
        {
            return;
        }
        admissible_ = false;
        OMPL_INFORM(
            "MFA: a path of cost %g is better than the objective's motionCostHeuristic allows: lower bounds are "
            "not used for this query",
            cost.value());
    }

    /* NaN if OMPL cannot compute the motion, whose length the objective may need. */
    double CostBounds::motionBound(const ob::State *from, const ob::State *to) const
    {
        return guard_.computes(from, to) ? objective_->motionCostHeuristic(from, to).value()
                                         : std::numeric_limits<double>::quiet_NaN();
    }

    double CostBounds::combine(double to, double from) const
    {
        // an objective whose combination is a minimum or maximum might drop a NaN
        if (std::isnan(to) || std::isnan(from))
        {
            return std::numeric_limits<double>::quiet_NaN();
        }
        return objective_->combineCosts(ob::Cost(to), ob::Cost(from)).value();
    }

    double CostBounds::lowerBoundTo(const ob::State *start, const ob::State *state) const
    {
        const double motions = motionBound(start, state);
        return certain_ ? motions : combine(objective_->initialCost(start).value(), motions);
    }

    double CostBounds::lowerBoundFrom(const ob::State *state, const ob::State *goal) const
    {
        const double motions = motionBound(state, goal);
        return certain_ ? motions : combine(motions, objective_->terminalCost(goal).value());
    }

    double CostBounds::lowerBound(const ob::State *start, const ob::State *goal) const
    {
        const double to = lowerBoundTo(start, goal);
        return certain_ ? to : combine(to, objective_->terminalCost(goal).value());
    }

    bool CostBounds::canBeat(double lowerBound, double bound) const
    {
        return std::isinf(bound) || !admissible_ || std::isnan(lowerBound) ||
               objective_->isCostBetterThan(ob::Cost(lowerBound), ob::Cost(bound));
    }

    bool CostBounds::canBeat(const ob::State *start, const ob::State *state, const ob::State *goal, double bound) const
    {
        if (std::isinf(bound) || !admissible_)
        {
            return true;
        }
        return canBeat(combine(lowerBoundTo(start, state), lowerBoundFrom(state, goal)), bound);
    }
}  // namespace ompl_mfa::path
