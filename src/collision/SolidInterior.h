#ifndef OMPL_MFA_COLLISION_SOLID_INTERIOR_
#define OMPL_MFA_COLLISION_SOLID_INTERIOR_

#include <memory>
#include <string>
#include <vector>

#include "collision/ClosedMesh.h"

namespace ompl_mfa::collision
{
    /** \brief A shape where meshes stand for solids: its inside, if it is a mesh, and a point of each connected part of
        it, of which a solid that nothing touches holds all or nothing. */
    class SolidInterior
    {
    public:
        /** \param name what an error calls the shape
            \throw InputError where the shape is a mesh that is not closed. */
        SolidInterior(const fcl::CollisionGeometryd &geometry, const std::string &name);

        /** \brief Whether one of two shapes is wholly inside the other. Their surfaces must not touch. */
        static bool oneHoldsTheOther(const SolidInterior &a, const fcl::Transform3d &poseA, const SolidInterior &b,
                                     const fcl::Transform3d &poseB);

    private:
        bool holds(const fcl::Transform3d &pose, const SolidInterior &other, const fcl::Transform3d &otherPose) const;

        // Null where the shape is no mesh: primitives and cells hold what they touch.
        std::unique_ptr<ClosedMesh> inside_;
        std::vector<fcl::Vector3d> witnesses_;
    };
}  // namespace ompl_mfa::collision

#endif
