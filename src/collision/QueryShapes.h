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

#ifndef OMPL_MFA_COLLISION_QUERY_SHAPES_
#define OMPL_MFA_COLLISION_QUERY_SHAPES_

#include <memory>
#include <vector>

#include "collision/ConservativeAdvancement.h"
#include "collision/NarrowPhase.h"
#include "collision/ShapeReach.h"
#include "collision/SolidInterior.h"
#include "ompl_mfa/collision/CollisionQuery.h"

namespace ompl_mfa::collision
{
    // An obstacle with its tightest bounding box; FCL's own box bounds a bounding sphere if there is a rotation.
    struct CollisionQuery::Obstacle : fcl::CollisionObjectd
    {
        Obstacle(const collision::CollisionObject &object, std::size_t position)
          : fcl::CollisionObjectd(object.geometry, object.pose)
          , index(position)
          , geometry(object.geometry.get())
          , pose(object.pose)
        {
            aabb = boundingBox(*geometry, pose);
        }

        MovingShape atRest() const
        {
            return {geometry, &pose};
        }

        std::size_t index;
        const fcl::CollisionGeometryd *geometry;
        fcl::Transform3d pose;
        std::unique_ptr<SolidInterior> solid;
    };

    // One shape of a body. Its geometry is not shared-owned, so that the copies made by queries update no reference
    // counts.
    struct CollisionQuery::Part : fcl::CollisionObjectd
    {
        Part(std::size_t bodyIndex, const RigidBody::Shape &shape)
          : fcl::CollisionObjectd(
                std::shared_ptr<fcl::CollisionGeometryd>(std::shared_ptr<void>(), shape.geometry.get()))
          , body(bodyIndex)
          , geometry(shape.geometry.get())
          , pose(shape.pose)
          , isCentred(shape.pose.matrix().isIdentity(0.))
          , reach(shapeReach(*shape.geometry, shape.pose))
        {
        }

        void place(const fcl::Transform3d *poses, fcl::Transform3d &world) const
        {
            world = poses[body];
            if (!isCentred)
            {
                world = world * pose;
            }
        }

        MovingShape moving(const BodyMotion *motions) const
        {
            const bool planar = motions[body].axis.head<2>().isZero(0.);
            return {geometry, &pose, &motions[body], planar ? reach.planarCore : reach.core};
        }

        std::size_t body;
        const fcl::CollisionGeometryd *geometry;
        fcl::Transform3d pose;
        bool isCentred;
        ShapeReach reach;

        // Functions for the pairs with each obstacle and each Part.
        std::vector<PairFunctions> obstacleFunctions;
        std::vector<PairFunctions> partFunctions;
        std::unique_ptr<SolidInterior> solid;
    };

    // A Part as passed to the broadphase. Its bounding box is FCL's, or that of its swept motion.
    struct PlacedShape : fcl::CollisionObjectd
    {
        PlacedShape(const fcl::CollisionObjectd &shape, const fcl::Transform3d &world)
          : fcl::CollisionObjectd(shape)
        {
            t = world;
            computeAABB();
        }

        PlacedShape(const fcl::CollisionObjectd &shape, const BodyMotion &motion, double radius)
          : fcl::CollisionObjectd(shape)
        {
            const fcl::AABBd path(motion.start, motion.start + motion.displacement);
            aabb.min_ = path.min_ - fcl::Vector3d::Constant(radius);
            aabb.max_ = path.max_ + fcl::Vector3d::Constant(radius);
        }
    };
}  // namespace ompl_mfa::collision

#endif
