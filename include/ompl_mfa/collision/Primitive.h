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

#ifndef OMPL_MFA_COLLISION_PRIMITIVE_
#define OMPL_MFA_COLLISION_PRIMITIVE_

#include <memory>
#include <string>
#include <vector>

#include <fcl/geometry/collision_geometry.h>
#include <fcl/math/geometry.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief A kind of primitive shape in planning scenes. docs/collision.md explains how to add one. */
    struct PrimitiveKind
    {
        /** \brief Name in planning scenes, in lower case. */
        const char *name;

        /** \brief Number in `shape_msgs/SolidPrimitive`; empty if MoveIt has no such shape. */
        const char *number;

        /** \brief Names of the dimensions, in their order. Every dimension is a length. */
        std::vector<const char *> dimensions;

        /** \brief Whether dimensions may be 0: a sphere of radius 0 is a point. */
        bool mayVanish;

        /** \brief Make the shape. \param dimensions one value per name in `dimensions`, already checked. */
        std::shared_ptr<fcl::CollisionGeometryd> (*make)(const std::vector<double> &dimensions);
    };

    /** \brief All kinds of primitives. */
    OMPL_MFA_EXPORT const std::vector<PrimitiveKind> &primitiveKinds();

    /** \brief The kind with this name (in lower case) or number; null if there is none. */
    OMPL_MFA_EXPORT const PrimitiveKind *findPrimitiveKind(const std::string &nameOrNumber);

    /** \brief The names of all kinds, for an error message. */
    OMPL_MFA_EXPORT std::string primitiveNames();

    /** \brief Make a primitive.
        \throw std::invalid_argument if the number of dimensions is wrong, or naming a dimension that is negative, not
        finite, or zero without PrimitiveKind::mayVanish. */
    OMPL_MFA_EXPORT std::shared_ptr<fcl::CollisionGeometryd> makePrimitive(const PrimitiveKind &kind,
                                                                           const std::vector<double> &dimensions);
}  // namespace ompl_mfa::collision

#endif
