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

#ifndef OMPL_MFA_PATH_TREE_STEP_
#define OMPL_MFA_PATH_TREE_STEP_

#include <ompl/base/State.h>

#include "path/PathEvaluator.h"
#include "path/StateChart.h"

namespace ompl_mfa::path
{
    /** \brief Steps by which a tree of motions grows. With \e forward its motions lead away from the root, else toward
        it; distances and motions may depend on the direction. */
    struct TreeStep
    {
        const StateChart &chart;
        bool forward;

        /** \brief The distance of a motion between the state \e near of the tree and another. */
        double distance(const ompl::base::State *near, const ompl::base::State *other) const
        {
            return forward ? chart.distance(near, other) : chart.distance(other, near);
        }

        /** \brief Computes \e state, a step from \e near toward \e target, their distance being \e distance: \e target
            if that is at most \e range (greater than 0) away, else the state at that distance, clipped to the bounds.
            Returns whether it is \e target. */
        bool toward(const ompl::base::State *near, const ompl::base::State *target, double distance, double range,
                    ompl::base::State *state) const;

        /** \brief Whether the motion between \e near, which must be valid, and \e state is valid. */
        bool check(PathEvaluator &evaluator, const ompl::base::State *near, const ompl::base::State *state) const;
    };
}  // namespace ompl_mfa::path

#endif
