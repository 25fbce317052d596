#ifndef OMPL_MFA_COLLISION_SHAPE_REACH_
#define OMPL_MFA_COLLISION_SHAPE_REACH_

#include <fcl/geometry/collision_geometry.h>

namespace ompl_mfa::collision
{
    /** \brief How far a shape reaches from the origin of a frame: bounds, exact for balls, boxes and meshes. */
    struct ShapeReach
    {
        /** \brief Distance of its core from the origin, and so how far a rotation by one radian displaces the shape. */
        double core{0.};

        /** \brief The same from the z axis, and for rotations about it. */
        double planarCore{0.};

        /** \brief What the shape has around its core. */
        double margin{0.};
    };

    /** \param pose from the shape to the frame. */
    ShapeReach shapeReach(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose);
}  // namespace ompl_mfa::collision

#endif
