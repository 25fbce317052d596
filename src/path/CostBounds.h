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

#ifndef OMPL_MFA_PATH_COST_BOUNDS_
#define OMPL_MFA_PATH_COST_BOUNDS_

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>

#include "path/DubinsGuard.h"

namespace ompl_mfa::path
{
    /** \brief The worst finite cost: all others are better. */
    double worstFiniteCost(const ompl::base::OptimizationObjective &objective);

    /** \brief Lower bounds of costs, used until a computed cost contradicts them.

        OMPL requires OptimizationObjective::motionCostHeuristic to be a lower bound, but an objective may violate
        this. The default is identityCost, which is wrong with negative motion costs; an objective derived from
        PathLengthOptimizationObjective inherits its own motionCost as heuristic, which is wrong if a detour costs
        less than the straight motion. So every computed cost is compared with the bounds, and once one is better, no
        bound is used any more. */
    class CostBounds
    {
    public:
        CostBounds(const ompl::base::SpaceInformationPtr &si, ompl::base::OptimizationObjectivePtr objective);

        /** \brief Whether the bounds are certain, so that costs need not be observed: path length over one of OMPL's
            own metrics. */
        bool certain() const
        {
            return certain_;
        }

        /** \brief Whether no observed path was better than the heuristic. */
        bool admissible() const
        {
            return admissible_;
        }

        /** \brief Whether no observed motion was better than identityCost, so that extending a path never improves its
            cost. */
        bool monotone() const
        {
            return monotone_;
        }

        /** \brief Compares the cost of the motion \e from -> \e to, valid or not, with the bounds. */
        void observeMotion(const ompl::base::State *from, const ompl::base::State *to, ompl::base::Cost cost);

        /** \brief Compares the combined cost of consecutive motions from \e from to \e to, valid or not, with the
            bounds. */
        void observePath(const ompl::base::State *from, const ompl::base::State *to, ompl::base::Cost cost);

        /** \brief Lower bound of the cost of paths from \e start to \e goal, with initial and terminal cost. */
        double lowerBound(const ompl::base::State *start, const ompl::base::State *goal) const;

        /** \brief Lower bound of the cost of paths from \e start to \e state, with initial cost. */
        double lowerBoundTo(const ompl::base::State *start, const ompl::base::State *state) const;

        /** \brief Lower bound of the cost of paths from \e state to \e goal, with terminal cost. */
        double lowerBoundFrom(const ompl::base::State *state, const ompl::base::State *goal) const;

        /** \brief The combination of lowerBoundTo() and lowerBoundFrom(). */
        double combine(double to, double from) const;

        /** \brief Whether a path with this \e lowerBound can be better than \e bound (infinity: any), a cost with
            initial and terminal cost. True if \e lowerBound is NaN. */
        bool canBeat(double lowerBound, double bound) const;

        /** \brief Whether a path from \e start through \e state to \e goal can be better than \e bound (infinity:
            any). */
        bool canBeat(const ompl::base::State *start, const ompl::base::State *state, const ompl::base::State *goal,
                     double bound) const;

        const ompl::base::OptimizationObjectivePtr &objective() const
        {
            return objective_;
        }

    private:
        double motionBound(const ompl::base::State *from, const ompl::base::State *to) const;
        bool beats(ompl::base::Cost cost, ompl::base::Cost bound) const;

        ompl::base::OptimizationObjectivePtr objective_;
        DubinsGuard guard_;
        bool certain_;
        bool admissible_{true};
        bool monotone_{true};
    };
}  // namespace ompl_mfa::path

#endif
