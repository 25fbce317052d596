#ifndef OMPL_MFA_COLLISION_NARROW_PHASE_
#define OMPL_MFA_COLLISION_NARROW_PHASE_

#include <fcl/geometry/collision_geometry.h>

#include "ConvexDistance.h"

namespace ompl_mfa::collision
{
    /** \brief How one pair of shapes is checked. The geometries are given in the order of the table. */
    struct PairFunctions
    {
        /** \brief Whether the two touch. */
        bool (*collide)(const fcl::CollisionGeometryd &, const fcl::Transform3d &, const fcl::CollisionGeometryd &,
                        const fcl::Transform3d &);

        /** \brief Distance, at most 0 where they touch; `limit` where it is no less than that. */
        double (*distance)(const fcl::CollisionGeometryd &, const fcl::Transform3d &, const fcl::CollisionGeometryd &,
                           const fcl::Transform3d &, double limit);

        /** \brief Distance with the plane that proves it; null where one of the two is not convex. */
        ConvexSeparation (*separate)(const fcl::CollisionGeometryd &, const fcl::Transform3d &,
                                     const fcl::CollisionGeometryd &, const fcl::Transform3d &);
    };

    /** \brief The functions for a pair. Primitives, meshes and occupancy maps go with each other in any order; adding
        a kind of shape is adding it to the lists in NarrowPhase.cpp.
        \throw std::invalid_argument where FCL's geometry is of another kind. */
    const PairFunctions &pairFunctions(const fcl::CollisionGeometryd &a, const fcl::CollisionGeometryd &b);
}  // namespace ompl_mfa::collision

#endif
