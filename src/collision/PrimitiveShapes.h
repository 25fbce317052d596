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

#ifndef OMPL_MFA_COLLISION_PRIMITIVE_SHAPES_
#define OMPL_MFA_COLLISION_PRIMITIVE_SHAPES_

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_box.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_cylinder.h>

#include "ompl_mfa/collision/Primitive.h"

/* The definitions of all kinds of primitives. To add a kind, specialise ShapeTraits for FCL's shape and list the shape
   in Primitives at the end: files, bounding boxes, radii, pictures, collisions and distances all derive from these. */

namespace ompl_mfa::collision
{
    /** \brief Make FCL's shape. \tparam Order index of the dimension for each argument of its constructor. */
    template <typename Shape, std::size_t... Order>
    std::shared_ptr<fcl::CollisionGeometryd> makeShape(const std::vector<double> &dimensions)
    {
        return std::make_shared<Shape>(dimensions[Order]...);
    }

    /** \brief Defaults for the optional members of ShapeTraits. */
    struct ShapeDefaults
    {
        /** \brief The shape is its core, swept by a ball of this radius. */
        static double margin(const fcl::ShapeBased & /*shape*/)
        {
            return 0.;
        }

        /** \brief Whether there is a signedDistance() of a point, in the frame of the shape, to the core: negative
            inside. For a point outside it sets the nearest point of the core. */
        static constexpr bool HAS_SIGNED_DISTANCE = false;
    };

    /** \brief A kind of primitive: convex, with its origin inside. Each has
        - `type`: FCL's node type of the shape,
        - `kind`: its description in planning scenes,
        - `support`: the farthest point of its core in a direction of its own frame, not the zero vector. */
    template <typename Shape>
    struct ShapeTraits;

    template <>
    struct ShapeTraits<fcl::Boxd> : ShapeDefaults
    {
        static constexpr fcl::NODE_TYPE TYPE = fcl::GEOM_BOX;

        static PrimitiveKind kind()
        {
            return {"box", "1", {"x", "y", "z"}, false, makeShape<fcl::Boxd, 0, 1, 2>};
        }

        static fcl::Vector3d support(const fcl::Boxd &box, const fcl::Vector3d &direction)
        {
            return {std::copysign(0.5 * box.side[0], direction[0]), std::copysign(0.5 * box.side[1], direction[1]),
                    std::copysign(0.5 * box.side[2], direction[2])};
        }

        static constexpr bool HAS_SIGNED_DISTANCE = true;

        static double signedDistance(const fcl::Boxd &box, const fcl::Vector3d &point, fcl::Vector3d &nearest)
        {
            return fcl::detail::nearestPointInBox<double>(box.side, point, &nearest)
                       ? (point - nearest).norm()
                       : -(0.5 * box.side - point.cwiseAbs()).minCoeff();
        }
    };

    template <>
    struct ShapeTraits<fcl::Sphered> : ShapeDefaults
    {
        static constexpr fcl::NODE_TYPE TYPE = fcl::GEOM_SPHERE;

        // A sphere of radius 0 is a point.
        static PrimitiveKind kind()
        {
            return {"sphere", "2", {"radius"}, true, makeShape<fcl::Sphered, 0>};
        }

        static fcl::Vector3d support(const fcl::Sphered & /*sphere*/, const fcl::Vector3d & /*direction*/)
        {
            return fcl::Vector3d::Zero();
        }

        static double margin(const fcl::Sphered &sphere)
        {
            return sphere.radius;
        }

        static constexpr bool HAS_SIGNED_DISTANCE = true;

        static double signedDistance(const fcl::Sphered & /*sphere*/, const fcl::Vector3d &point,
                                     fcl::Vector3d &nearest)
        {
            nearest.setZero();
            return point.norm();
        }
    };

    template <>
    struct ShapeTraits<fcl::Cylinderd> : ShapeDefaults
    {
        static constexpr fcl::NODE_TYPE TYPE = fcl::GEOM_CYLINDER;

        // shape_msgs/SolidPrimitive lists the height first, FCL the radius.
        static PrimitiveKind kind()
        {
            return {"cylinder", "3", {"height", "radius"}, false, makeShape<fcl::Cylinderd, 1, 0>};
        }

        static fcl::Vector3d support(const fcl::Cylinderd &cylinder, const fcl::Vector3d &direction)
        {
            const double radial = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
            const double scale = radial > 0. ? cylinder.radius / radial : 0.;
            return {scale * direction[0], scale * direction[1], std::copysign(0.5 * cylinder.lz, direction[2])};
        }

        static constexpr bool HAS_SIGNED_DISTANCE = true;

        static double signedDistance(const fcl::Cylinderd &cylinder, const fcl::Vector3d &point, fcl::Vector3d &nearest)
        {
            return fcl::detail::nearestPointInCylinder<double>(cylinder.lz, cylinder.radius, point, &nearest)
                       ? (point - nearest).norm()
                       : -std::min(cylinder.radius - point.head<2>().norm(), 0.5 * cylinder.lz - std::abs(point.z()));
        }
    };

    template <>
    struct ShapeTraits<fcl::Coned> : ShapeDefaults
    {
        static constexpr fcl::NODE_TYPE TYPE = fcl::GEOM_CONE;

        static PrimitiveKind kind()
        {
            return {"cone", "4", {"height", "radius"}, false, makeShape<fcl::Coned, 1, 0>};
        }

        static fcl::Vector3d support(const fcl::Coned &cone, const fcl::Vector3d &direction)
        {
            const double radial = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
            if (cone.lz * direction[2] > cone.radius * radial)
            {
                return {0., 0., 0.5 * cone.lz};
            }
            const double scale = radial > 0. ? cone.radius / radial : 0.;
            return {scale * direction[0], scale * direction[1], -0.5 * cone.lz};
        }
    };

    template <>
    struct ShapeTraits<fcl::Capsuled> : ShapeDefaults
    {
        static constexpr fcl::NODE_TYPE TYPE = fcl::GEOM_CAPSULE;

        // Not in MoveIt. The height is that of the cylinder between the two hemispheres.
        static PrimitiveKind kind()
        {
            return {"capsule", "", {"height", "radius"}, false, makeShape<fcl::Capsuled, 1, 0>};
        }

        static fcl::Vector3d support(const fcl::Capsuled &capsule, const fcl::Vector3d &direction)
        {
            return {0., 0., std::copysign(0.5 * capsule.lz, direction[2])};
        }

        static double margin(const fcl::Capsuled &capsule)
        {
            return capsule.radius;
        }

        static constexpr bool HAS_SIGNED_DISTANCE = true;

        static double signedDistance(const fcl::Capsuled &capsule, const fcl::Vector3d &point, fcl::Vector3d &nearest)
        {
            nearest = {0., 0., std::clamp(point.z(), -0.5 * capsule.lz, 0.5 * capsule.lz)};
            return (point - nearest).norm();
        }
    };

    using Primitives = std::tuple<fcl::Boxd, fcl::Sphered, fcl::Cylinderd, fcl::Coned, fcl::Capsuled>;
}  // namespace ompl_mfa::collision

#endif
