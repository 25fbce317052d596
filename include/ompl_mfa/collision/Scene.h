#ifndef OMPL_MFA_COLLISION_SCENE_
#define OMPL_MFA_COLLISION_SCENE_

#include <memory>
#include <string>
#include <vector>

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/bv/AABB.h>

namespace ompl_mfa::collision
{
    /** \brief What a file may hold at most as a coordinate or a length. Distances take its eighth power, which has to
        stay finite. */
    constexpr double largestCoordinate = 1e30;

    /** \brief One obstacle: a geometry and where it stands in the world. */
    struct CollisionObject
    {
        /** \brief Name of the obstacle in its file. */
        std::string id;

        /** \brief The shape in its own frame. Never null, never empty. */
        std::shared_ptr<fcl::CollisionGeometryd> geometry;

        /** \brief From the frame of the shape to the world. */
        fcl::Transform3d pose{fcl::Transform3d::Identity()};

        /** \brief How many points and lines its mesh file holds beside the triangles. They are no obstacle. */
        std::size_t skippedFaces{0};
    };

    /** \brief The obstacles of a world: primitives, meshes and occupancy maps together. Nothing in it moves. */
    class Scene
    {
    public:
        /** \brief Add an obstacle.
            \throw std::invalid_argument where the object has no geometry. */
        void add(CollisionObject object);

        /** \brief The obstacles in the order in which they were added. */
        const std::vector<CollisionObject> &objects() const
        {
            return objects_;
        }

        /** \brief The smallest axis-aligned box that holds every obstacle; min_ > max_ where there is none. Free and
            unknown space of an occupancy map does not count. */
        fcl::AABBd bounds() const;

        /** \brief How many points and lines the mesh files of its obstacles hold, which are no obstacle. */
        std::size_t skippedFaces() const;

    private:
        std::vector<CollisionObject> objects_;
    };

    /** \brief The smallest axis-aligned box around `geometry` at `pose`. FCL's own box is a box around a sphere
        wherever the pose has a rotation, and the whole addressable space for an occupancy map. */
    fcl::AABBd boundingBox(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose);
}  // namespace ompl_mfa::collision

#endif
