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

#ifndef OMPL_MFA_COLLISION_FCL_STATE_VALIDITY_CHECKER_
#define OMPL_MFA_COLLISION_FCL_STATE_VALIDITY_CHECKER_

#include <memory>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/CollisionQuery.h"
#include "ompl_mfa/collision/StatePlacement.h"

namespace ompl_mfa::collision
{
    /** \brief A state is valid if it is within the bounds of the space, no body touches an obstacle, and no two bodies
        touch.

        Const functions are safe to call from several threads and allocate nothing after a thread's first call. */
    class OMPL_MFA_EXPORT FclStateValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \param si of R^2, R^3, SE(2), SE(3) or a compound of these (see StatePlacement)
            \param scene the obstacles; may be empty, must not be null
            \param bodies one per body of the space
            \param interior whether the inside of a mesh is free, as in OMPL.app, or solid
            \throw InputError if the space cannot place the bodies or places a different number of them, or if interiors
            are solid and a mesh is not closed. */
        FclStateValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const Scene> scene,
                                std::vector<RigidBody> bodies, MeshInterior interior = MeshInterior::Free);

        /** \brief For a single body. */
        FclStateValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const Scene> scene,
                                RigidBody body, MeshInterior interior = MeshInterior::Free);

        bool isValid(const ompl::base::State *state) const override;

        /** \brief Smallest distance between a body and an obstacle or between two bodies, in world units; infinite if
            there is nothing to collide with. In collision, minus the penetration depth for spheres (points, discs,
            balls) in primitives other than cones, and 0 for all other shapes. The bounds of the space are ignored. */
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
