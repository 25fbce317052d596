#ifndef OMPL_MFA_COLLISION_CONSERVATIVE_ADVANCEMENT_
#define OMPL_MFA_COLLISION_CONSERVATIVE_ADVANCEMENT_

#include "collision/NarrowPhase.h"
#include "ompl_mfa/collision/BodyMotion.h"

namespace ompl_mfa::collision
{
    /** \brief A shape on its way, or at rest where it has no motion. */
    struct MovingShape
    {
        const fcl::CollisionGeometryd *geometry;

        /** \brief From the shape to its body, or to the world where it is at rest. */
        const fcl::Transform3d *pose;

        /** \brief Motion of the body; null at rest. */
        const BodyMotion *motion{nullptr};

        /** \brief Bound on how far a rotation by one radian displaces the shape. */
        double reach{0.};

        /** \brief Pose in the world at share t. */
        void place(double t, fcl::Transform3d &world) const;
    };

    struct AdvancementGoal
    {
        /** \brief Shapes that are this close touch. */
        double tolerance;

        /** \brief Whether it only matters if the whole motion is free. */
        bool untilFirst;
    };

    /** \brief Share of the motion up to which two shapes stay more than the tolerance apart; `end` where that is all
        of [0, end]. */
    double advancePair(const PairFunctions &functions, const MovingShape &a, const MovingShape &b,
                       const AdvancementGoal &goal, double end);
}  // namespace ompl_mfa::collision

#endif
