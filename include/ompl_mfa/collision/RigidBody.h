#ifndef OMPL_MFA_COLLISION_RIGID_BODY_
#define OMPL_MFA_COLLISION_RIGID_BODY_

#include <memory>
#include <vector>

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/bv/AABB.h>

namespace ompl_mfa::collision
{
    /** \brief A body that a state places: one or several shapes, fixed to each other.

        The origin of the body's frame is its reference point, which a state moves and about which it rotates. */
    class RigidBody
    {
    public:
        /** \brief A shape and where it sits in the frame of the body. */
        struct Shape
        {
            std::shared_ptr<fcl::CollisionGeometryd> geometry;
            fcl::Transform3d pose{fcl::Transform3d::Identity()};

            /** \brief How many points and lines its mesh file holds beside the triangles. They do not collide. */
            std::size_t skippedFaces{0};
        };

        /** \throw std::invalid_argument where there is no shape, or a shape without geometry. */
        explicit RigidBody(std::vector<Shape> shapes);

        /** \brief A ball, or in the plane a disc, about the reference point; radius 0 is a point.
            \throw std::invalid_argument where the radius is negative or not finite. */
        static RigidBody sphere(double radius);

        /** \brief A box centred at the reference point, with its sides along the axes of the body.
            \throw std::invalid_argument where a length is not positive and finite. */
        static RigidBody box(double lengthX, double lengthY, double lengthZ);

        const std::vector<Shape> &shapes() const
        {
            return shapes_;
        }

        /** \brief How many points and lines the mesh files of its shapes hold, which do not collide. */
        std::size_t skippedFaces() const;

        /** \brief The smallest axis-aligned box that holds every shape, in the frame of the body. */
        fcl::AABBd bounds() const;

        /** \brief Radius of a ball about the reference point that holds the body: the smallest for spheres, boxes and
            meshes, otherwise that of the boxes around the shapes. */
        double radius() const
        {
            return radius_;
        }

        /** \brief Radius of an upright cylinder about the reference point that holds the body, as close as radius():
            what a rotation about z can displace. */
        double planarRadius() const
        {
            return planarRadius_;
        }

    private:
        std::vector<Shape> shapes_;
        double radius_{0.};
        double planarRadius_{0.};
    };
}  // namespace ompl_mfa::collision

#endif
