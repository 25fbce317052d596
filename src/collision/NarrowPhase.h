#ifndef OMPL_MFA_COLLISION_NARROW_PHASE_
#define OMPL_MFA_COLLISION_NARROW_PHASE_

#include <cstdint>

#include <fcl/geometry/collision_geometry.h>

#include "collision/ConvexDistance.h"

namespace ompl_mfa::collision
{
    /** \brief What a distance is asked for, and what is remembered for the next question about the same pair. */
    struct DistanceSearch
    {
        /** \brief Distances from here on are all the same. */
        double limit;

        /** \brief Triangles of the two meshes that were closest last; they bound the distance from above. */
        intptr_t nearestA{-1};
        intptr_t nearestB{-1};
    };

    /** \brief How one pair of shapes is checked. The geometries are given in the order of the table. */
    struct PairFunctions
    {
        /** \brief Whether the two touch. */
        bool (*collide)(const fcl::CollisionGeometryd &, const fcl::Transform3d &, const fcl::CollisionGeometryd &,
                        const fcl::Transform3d &);

        /** \brief Distance; minus the depth where the two overlap and it is known in closed form, else 0; the limit
         * where it is no less than that. */
        double (*distance)(const fcl::CollisionGeometryd &, const fcl::Transform3d &, const fcl::CollisionGeometryd &,
                           const fcl::Transform3d &, DistanceSearch &search);

        /** \brief Distance with the plane that proves it; null where one of the two is not convex. */
        ConvexSeparation (*separate)(const fcl::CollisionGeometryd &, const fcl::Transform3d &,
                                     const fcl::CollisionGeometryd &, const fcl::Transform3d &);
    };

    /** \brief The functions for a pair. Primitives, meshes and occupancy maps go with each other in any order.
        \throw std::invalid_argument where FCL's geometry is of another kind. */
    const PairFunctions &pairFunctions(const fcl::CollisionGeometryd &a, const fcl::CollisionGeometryd &b);
}  // namespace ompl_mfa::collision

#endif
