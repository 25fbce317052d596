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

#ifndef OMPL_MFA_COLLISION_SCENE_
#define OMPL_MFA_COLLISION_SCENE_

#include <memory>
#include <string>
#include <vector>

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/bv/AABB.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief Largest coordinate or length accepted from a file. Distance computations use its eighth power, which has
        to be finite. */
    constexpr double LARGEST_COORDINATE = 1e30;

    /** \brief An obstacle: a geometry and its pose in the world. */
    struct CollisionObject
    {
        /** \brief Name of the obstacle in its file. */
        std::string id;

        /** \brief The shape in its own frame. Never null, never empty. */
        std::shared_ptr<fcl::CollisionGeometryd> geometry;

        /** \brief Pose of the shape in the world. */
        fcl::Transform3d pose{fcl::Transform3d::Identity()};

        /** \brief Number of points and lines in the mesh file besides the triangles. They are not obstacles. */
        std::size_t skippedFaces{0};
    };

    /** \brief The static obstacles of a world: primitives, meshes and occupancy maps. */
    class OMPL_MFA_EXPORT Scene
    {
    public:
        /** \brief Add an obstacle.
            \throw std::invalid_argument if the object has no geometry. */
        void add(CollisionObject object);

        /** \brief The obstacles in the order in which they were added. */
        const std::vector<CollisionObject> &objects() const
        {
            return objects_;
        }

        /** \brief Smallest axis-aligned bounding box of all obstacles; min_ > max_ if there are none. Free and unknown
            cells of an occupancy map do not count. */
        fcl::AABBd bounds() const;

        /** \brief Number of points and lines in the mesh files of all obstacles, which are not obstacles themselves. */
        std::size_t skippedFaces() const;

    private:
        std::vector<CollisionObject> objects_;
    };

    /** \brief Smallest axis-aligned bounding box of `geometry` at `pose`. FCL's own box bounds a bounding sphere if the
        pose has a rotation, and the whole addressable space of an occupancy map. */
    OMPL_MFA_EXPORT fcl::AABBd boundingBox(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose);
}  // namespace ompl_mfa::collision

#endif
