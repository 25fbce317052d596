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
    // An obstacle with the tightest box around it; FCL's own box is a box around a sphere once there is a rotation.
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

    // One shape of a body. It owns no geometry, so that copying it, which a query does, counts no references.
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

        // How it is checked against each obstacle, and against each part.
        std::vector<PairFunctions> obstacleFunctions;
        std::vector<PairFunctions> partFunctions;
        std::unique_ptr<SolidInterior> solid;
    };

    // What the broadphase sees of a part. Its box is that of FCL, or the one that it sweeps.
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
