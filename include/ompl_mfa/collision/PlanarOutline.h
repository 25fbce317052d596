#ifndef OMPL_MFA_COLLISION_PLANAR_OUTLINE_
#define OMPL_MFA_COLLISION_PLANAR_OUTLINE_

#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief Corners of a polygon in the plane, in order, not closed. Two corners are a segment. */
    using Polygon = std::vector<Eigen::Vector2d>;

    /** \brief What a picture of the plane draws for an obstacle: the part of it with zMin <= z <= zMax, seen from
        above.

        A primitive gives one convex polygon (round outlines have up to 128 corners, all of them on the curve), a mesh
        one polygon or segment a triangle, an occupancy map one square an occupied cell. Nothing comes back for an
        obstacle outside the slab.
        \throw std::invalid_argument where zMin > zMax. */
    std::vector<Polygon> planarOutline(const CollisionObject &object, double zMin = 0., double zMax = 0.);

    /** \brief Whether any part of an obstacle (a triangle of a mesh, an occupied cell of a map) has zMin <= z <= zMax.
     */
    bool reachesHeights(const CollisionObject &object, double zMin, double zMax);
}  // namespace ompl_mfa::collision

#endif
