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

#ifndef OMPL_MFA_COLLISION_NARROW_PHASE_
#define OMPL_MFA_COLLISION_NARROW_PHASE_

#include <cstdint>

#include <fcl/geometry/collision_geometry.h>

#include "collision/ConvexDistance.h"
#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief Options of a distance query, and data kept for the next query of the same pair. */
    struct DistanceSearch
    {
        /** \brief Distances of at least this are not resolved. */
        double limit;

        /** \brief Triangles of the two meshes that were closest last time; they bound the distance from above. */
        intptr_t nearestA{-1};
        intptr_t nearestB{-1};
    };

    /** \brief Functions that check a pair of shapes, whose geometries are passed in the order of the table. */
    struct PairFunctions
    {
        /** \brief Whether the two touch. */
        bool (*collide)(const fcl::CollisionGeometryd &, const fcl::Transform3d &, const fcl::CollisionGeometryd &,
                        const fcl::Transform3d &);

        /** \brief Distance, or the limit if that is smaller. If the two overlap, minus the depth if it is known in
            closed form, else 0. */
        double (*distance)(const fcl::CollisionGeometryd &, const fcl::Transform3d &, const fcl::CollisionGeometryd &,
                           const fcl::Transform3d &, DistanceSearch &search);

        /** \brief Distance with the separating plane that proves it; null if one of the two is not convex. */
        ConvexSeparation (*separate)(const fcl::CollisionGeometryd &, const fcl::Transform3d &,
                                     const fcl::CollisionGeometryd &, const fcl::Transform3d &);
    };

    /** \brief The functions for a pair. Primitives, meshes and occupancy maps may be combined in any order.
        \throw std::invalid_argument if FCL's geometry is of another kind. */
    OMPL_MFA_EXPORT const PairFunctions &pairFunctions(const fcl::CollisionGeometryd &a,
                                                       const fcl::CollisionGeometryd &b);
}  // namespace ompl_mfa::collision

#endif
