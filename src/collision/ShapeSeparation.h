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

#ifndef OMPL_MFA_COLLISION_SHAPE_SEPARATION_
#define OMPL_MFA_COLLISION_SHAPE_SEPARATION_

#include <type_traits>

#include "collision/ConvexDistance.h"

namespace ompl_mfa::collision
{
    template <typename Shape>
    constexpr bool IS_BALL = std::is_same_v<Shape, fcl::Sphered>;

    /** \brief Whether the penetration depth is known in closed form. */
    template <typename A, typename B>
    constexpr bool DEPTH_IS_KNOWN = (IS_BALL<A> && ShapeTraits<B>::HAS_SIGNED_DISTANCE) ||
                                    (IS_BALL<B> && ShapeTraits<A>::HAS_SIGNED_DISTANCE);

    /** \brief Distance of a ball to a shape in closed form, from the shape's nearest point to its centre. If they
        overlap, both bounds are minus the depth. */
    template <typename Shape>
    ConvexSeparation separateBall(const fcl::Sphered &ball, const fcl::Transform3d &ballPose, const Shape &shape,
                                  const fcl::Transform3d &shapePose)
    {
        const fcl::Vector3d offset = ballPose.translation() - shapePose.translation();
        const fcl::Vector3d centre = shapePose.linear().transpose() * offset;
        fcl::Vector3d nearest;
        const double distance = ShapeTraits<Shape>::signedDistance(shape, centre, nearest);
        ConvexSeparation result;
        result.lower = result.upper = distance - ball.radius - ShapeTraits<Shape>::margin(shape);
        if (distance > 0.)
        {
            result.normal = shapePose.linear() * ((centre - nearest) / distance);
        }
        return result;
    }

    /** \brief As separate(), in closed form if there is one. */
    template <typename A, typename B>
    ConvexSeparation separateShapes(const A &a, const fcl::Transform3d &poseA, const B &b,
                                    const fcl::Transform3d &poseB, bool decideOnly)
    {
        if constexpr (IS_BALL<A> && ShapeTraits<B>::HAS_SIGNED_DISTANCE)
        {
            return separateBall(a, poseA, b, poseB);
        }
        else if constexpr (IS_BALL<B> && ShapeTraits<A>::HAS_SIGNED_DISTANCE)
        {
            ConvexSeparation result = separateBall(b, poseB, a, poseA);
            result.normal = -result.normal;
            return result;
        }
        else
        {
            return separate(a, poseA, b, poseB, decideOnly);
        }
    }
}  // namespace ompl_mfa::collision

#endif
