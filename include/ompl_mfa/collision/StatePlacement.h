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

#ifndef OMPL_MFA_COLLISION_STATE_PLACEMENT_
#define OMPL_MFA_COLLISION_STATE_PLACEMENT_

#include <vector>

#include <fcl/common/types.h>
#include <ompl/base/StateSpace.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/BodyMotion.h"

namespace ompl_mfa::collision
{
    /** \brief Poses of the bodies in a state. The mapping is determined once, from the state space.

        - R^2: at (x, y, 0), not rotated. R^3: at (x, y, z), not rotated.
        - SE(2), Dubins and Reeds-Shepp spaces: at (x, y, 0), rotated by theta about z.
        - SE(3): at the pose of the state.
        - A compound space of these, nested or not: one body per component, in their order.

        Const functions are safe to call from several threads. */
    class OMPL_MFA_EXPORT StatePlacement
    {
    public:
        /** \throw InputError naming the space or component that cannot place a body, and the supported ones. */
        explicit StatePlacement(const ompl::base::StateSpacePtr &space);

        /** \brief Number of bodies of a state, at least 1. */
        std::size_t bodyCount() const
        {
            return components_.size();
        }

        /** \brief Pose of body `body` < bodyCount(). */
        void place(const ompl::base::State *state, std::size_t body, fcl::Transform3d &pose) const;

        /** \brief Whether the space interpolates positions along a segment and orientations along the shortest
            rotation, both at constant speed. True for all but Dubins and Reeds-Shepp spaces. */
        bool interpolatesStraight() const
        {
            return straight_;
        }

        /** \brief Motion of body `body` between two states as the space interpolates it. Requires
            interpolatesStraight(). */
        BodyMotion motion(const ompl::base::State *from, const ompl::base::State *to, std::size_t body) const;

    private:
        enum class Kind
        {
            R2,
            R3,
            SE2,
            SE3
        };

        struct Component
        {
            Kind kind;

            // Indices of subspaces, from the whole state down to the component that places the body.
            std::vector<unsigned int> path;
        };

        static const ompl::base::State *descend(const ompl::base::State *state, const Component &component);
        void collect(const ompl::base::StateSpacePtr &space, std::vector<unsigned int> &path);

        std::vector<Component> components_;
        bool straight_{true};
    };
}  // namespace ompl_mfa::collision

#endif
