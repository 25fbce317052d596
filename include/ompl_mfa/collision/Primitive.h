#ifndef OMPL_MFA_COLLISION_PRIMITIVE_
#define OMPL_MFA_COLLISION_PRIMITIVE_

#include <memory>
#include <string>
#include <vector>

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/geometry.h>

namespace ompl_mfa::collision
{
    /** \brief A kind of primitive shape, as a planning scene names it. docs/collision.md tells how to add another. */
    struct PrimitiveKind
    {
        /** \brief Name in a planning scene, in lower case. */
        const char *name;

        /** \brief Number in `shape_msgs/SolidPrimitive`; empty where MoveIt has no such shape. */
        const char *number;

        /** \brief Names of the dimensions, in their order. Every dimension is a length. */
        std::vector<const char *> dimensions;

        /** \brief Whether a dimension may be 0, as the radius of a point. */
        bool mayVanish;

        /** \brief Make the shape. \param dimensions as many values as `dimensions` names, checked. */
        std::shared_ptr<fcl::CollisionGeometryd> (*make)(const std::vector<double> &dimensions);
    };

    /** \brief The primitives that scenes and robots may be made of. */
    const std::vector<PrimitiveKind> &primitiveKinds();

    /** \brief The kind with this name (in lower case) or number; null where there is none. */
    const PrimitiveKind *findPrimitiveKind(const std::string &nameOrNumber);

    /** \brief The names of all kinds, for an error message. */
    std::string primitiveNames();

    /** \brief Make a primitive.
        \throw std::invalid_argument naming the dimension and its value, where their number is wrong, or one is
        negative, not finite, or zero where it may not vanish. */
    std::shared_ptr<fcl::CollisionGeometryd> makePrimitive(const PrimitiveKind &kind,
                                                           const std::vector<double> &dimensions);
}  // namespace ompl_mfa::collision

#endif
