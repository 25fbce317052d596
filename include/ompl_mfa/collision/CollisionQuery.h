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

#ifndef OMPL_MFA_COLLISION_COLLISION_QUERY_
#define OMPL_MFA_COLLISION_COLLISION_QUERY_

#include <memory>
#include <utility>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision_object.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/BodyMotion.h"
#include "ompl_mfa/collision/RigidBody.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief How a mesh is interpreted. */
    enum class MeshInterior
    {
        /** \brief As a surface: a body entirely inside is collision-free, as in OMPL.app. */
        Free,

        /** \brief As the solid that it bounds. Every mesh must be closed. */
        Solid
    };

    /** \brief Collisions and distances between a scene and moving bodies, and among these bodies.

        The broadphase and the traversal of meshes and maps are FCL's; docs/collision.md lists the accuracy for each
        pair of shapes. Const functions are safe to call from several threads and allocate nothing after a thread's
        first call. */
    class OMPL_MFA_EXPORT CollisionQuery
    {
    public:
        /** \throw std::invalid_argument if the scene is null or there is no body.
            \throw InputError naming a mesh that is not closed, if interiors are solid. */
        CollisionQuery(std::shared_ptr<const Scene> scene, std::vector<RigidBody> bodies,
                       MeshInterior interior = MeshInterior::Free);
        ~CollisionQuery();
        CollisionQuery(const CollisionQuery &) = delete;
        CollisionQuery &operator=(const CollisionQuery &) = delete;

        const Scene &scene() const
        {
            return *scene_;
        }

        const std::vector<RigidBody> &bodies() const
        {
            return bodies_;
        }

        /** \brief Whether a body touches an obstacle or another body. \param poses one pose per body. */
        bool collides(const fcl::Transform3d *poses) const;

        /** \brief Smallest distance between a body and an obstacle or between two bodies, in world units, or `limit` >
            0 if it is at least that.

            If shapes overlap, the result is minus the largest penetration depth. The depth is known in closed form for
            a sphere in any primitive but the cone; for all other pairs it counts as 0, as no reliable depth is
            available.
            \param poses one for each body. */
        double distance(const fcl::Transform3d *poses, double limit) const;

        /** \brief Fraction of a motion, in [0, 1], up to which no body comes within `tolerance` > 0 (world units) of an
            obstacle or another body; 1 if the whole motion is free. Uses conservative advancement for each pair. A pair
            that needs more than 1000 steps counts as touching where the last step ends.
            \param motions one for each body
            \param untilFirst return any fraction below 1 as soon as one pair touches. */
        double advance(const BodyMotion *motions, double tolerance, bool untilFirst) const;

    private:
        struct Obstacle;
        struct Part;
        struct PartQuery;
        struct Sweep;

        void addObstacles();
        void findPairs();
        bool hitsObstacle(const Part &part, const fcl::Transform3d &world) const;
        double distanceToObstacles(const Part &part, const fcl::Transform3d &world, double smallest) const;
        double deepestOverlap(const fcl::Transform3d *worlds) const;
        bool isInside(const fcl::Transform3d *worlds) const;

        static bool collideCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd *part, void *query);
        static bool distanceCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd *part, void *query,
                                     double &searchRadius);
        static bool overlapCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd *part, void *query);
        static bool advanceCallback(fcl::CollisionObjectd *object, fcl::CollisionObjectd *part, void *query);

        std::shared_ptr<const Scene> scene_;
        std::vector<RigidBody> bodies_;
        bool solidInteriors_;
        std::vector<std::unique_ptr<Obstacle>> obstacles_;
        std::vector<Part> parts_;

        // Indices of shapes of different bodies.
        std::vector<std::pair<std::size_t, std::size_t>> bodyPairs_;
        fcl::DynamicAABBTreeCollisionManager<double> broadphase_;
    };
}  // namespace ompl_mfa::collision

#endif
