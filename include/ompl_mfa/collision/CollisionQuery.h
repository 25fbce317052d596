#ifndef OMPL_MFA_COLLISION_COLLISION_QUERY_
#define OMPL_MFA_COLLISION_COLLISION_QUERY_

#include <memory>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision_object.h>

#include "ompl_mfa/collision/RigidBody.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief Collision and distance between a scene and the bodies that move in it, and between these bodies.

        The answers are FCL's; docs/collision.md tells how exact they are for each pair of shapes. Const functions are
        safe to call from several threads and allocate nothing after a thread's first call. */
    class CollisionQuery
    {
    public:
        /** \throw std::invalid_argument where there is no body. */
        CollisionQuery(std::shared_ptr<const Scene> scene, std::vector<RigidBody> bodies);
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

        /** \brief Whether a body touches an obstacle or another body. \param poses one for each body. */
        bool collides(const fcl::Transform3d *poses) const;

        /** \brief The smallest distance from any body to any obstacle and between bodies, in the units of the world;
            `limit` where it is no less than that. \param poses one for each body. */
        double distance(const fcl::Transform3d *poses, double limit) const;

    private:
        struct Obstacle;
        struct Part;

        std::shared_ptr<const Scene> scene_;
        std::vector<RigidBody> bodies_;
        std::vector<std::unique_ptr<Obstacle>> obstacles_;
        std::vector<Part> parts_;
        fcl::DynamicAABBTreeCollisionManager<double> broadphase_;
    };
}  // namespace ompl_mfa::collision

#endif
