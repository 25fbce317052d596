#ifndef OMPL_MFA_COLLISION_SHAPE_SEPARATION_
#define OMPL_MFA_COLLISION_SHAPE_SEPARATION_

#include <type_traits>

#include "collision/ConvexDistance.h"

namespace ompl_mfa::collision
{
    template <typename Shape>
    constexpr bool isBall = std::is_same_v<Shape, fcl::Sphered>;

    /** \brief Whether the depth of an overlap is known, in closed form. */
    template <typename A, typename B>
    constexpr bool depthIsKnown = (isBall<A> && ShapeTraits<B>::hasSignedDistance) ||
                                  (isBall<B> && ShapeTraits<A>::hasSignedDistance);

    /** \brief In closed form: a ball meets a shape where that is nearest to its centre. Where they overlap, both bounds
        are minus the depth. */
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

    /** \brief As separate() does, in closed form where there is one. */
    template <typename A, typename B>
    ConvexSeparation separateShapes(const A &a, const fcl::Transform3d &poseA, const B &b,
                                    const fcl::Transform3d &poseB, bool decideOnly)
    {
        if constexpr (isBall<A> && ShapeTraits<B>::hasSignedDistance)
        {
            return separateBall(a, poseA, b, poseB);
        }
        else if constexpr (isBall<B> && ShapeTraits<A>::hasSignedDistance)
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
