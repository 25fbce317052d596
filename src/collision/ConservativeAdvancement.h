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

#ifndef OMPL_MFA_COLLISION_CONSERVATIVE_ADVANCEMENT_
#define OMPL_MFA_COLLISION_CONSERVATIVE_ADVANCEMENT_

#include "collision/NarrowPhase.h"
#include "ompl_mfa/collision/BodyMotion.h"

namespace ompl_mfa::collision
{
    /** \brief A shape that moves with its body, or is at rest. */
    struct MovingShape
    {
        const fcl::CollisionGeometryd *geometry;

        /** \brief Pose of the shape relative to its body, or in the world if at rest. */
        const fcl::Transform3d *pose;

        /** \brief Motion of the body; null at rest. */
        const BodyMotion *motion{nullptr};

        /** \brief Upper bound on the displacement of the shape by a rotation of one radian. */
        double reach{0.};

        /** \brief Pose in the world at t in [0, 1]. */
        void place(double t, fcl::Transform3d &world) const;
    };

    struct AdvancementGoal
    {
        /** \brief Shapes at most this far apart count as touching. */
        double tolerance;

        /** \brief Whether only a motion that is free as a whole is of interest. */
        bool untilFirst;
    };

    /** \brief Fraction of the motion up to which two shapes stay more than the tolerance apart; `end` if they do so in
        all of [0, end]. */
    double advancePair(const PairFunctions &functions, const MovingShape &a, const MovingShape &b,
                       const AdvancementGoal &goal, double end);
}  // namespace ompl_mfa::collision

#endif
