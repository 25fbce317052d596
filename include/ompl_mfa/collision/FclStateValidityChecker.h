#ifndef OMPL_MFA_COLLISION_FCL_STATE_VALIDITY_CHECKER_
#define OMPL_MFA_COLLISION_FCL_STATE_VALIDITY_CHECKER_

#include <memory>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "ompl_mfa/collision/CollisionQuery.h"
#include "ompl_mfa/collision/StatePlacement.h"

namespace ompl_mfa::collision
{
    /** \brief A state is valid where it is within the bounds of the space, no body touches an obstacle, and no two
        bodies touch.

        Const functions are safe to call from several threads and allocate nothing after a thread's first call. */
    class FclStateValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \param si of R^2, R^3, SE(2), SE(3) or a compound of these (see StatePlacement)
            \param scene the obstacles; may be empty, must not be null
            \param bodies one for each body that the space places
            \param interior whether the inside of a mesh is free, as in OMPL.app, or solid
            \throw InputError where the space cannot place the bodies, or places another number of them, or where
            interiors are solid and a mesh is not closed. */
        FclStateValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const Scene> scene,
                                std::vector<RigidBody> bodies, MeshInterior interior = MeshInterior::Free);

        /** \brief For a single body. */
        FclStateValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const Scene> scene,
                                RigidBody body, MeshInterior interior = MeshInterior::Free);

        bool isValid(const ompl::base::State *state) const override;

        /** \brief The smallest distance between a body and an obstacle or between two bodies, in the units of the
            world; infinity where there is nothing to hit. Where they overlap it is minus the depth for spheres (points,
            discs, balls) in primitives other than cones, and 0 for all other shapes. The bounds of the space do not
            count. */
        double clearance(const ompl::base::State *state) const override;

        const StatePlacement &placement() const
        {
            return placement_;
        }

        const CollisionQuery &query() const
        {
            return query_;
        }

    private:
        const fcl::Transform3d *place(const ompl::base::State *state) const;

        StatePlacement placement_;
        CollisionQuery query_;
    };
}  // namespace ompl_mfa::collision

#endif
