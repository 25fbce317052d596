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

#ifndef OMPL_MFA_COLLISION_SHAPE_KINDS_
#define OMPL_MFA_COLLISION_SHAPE_KINDS_

#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

#include <fcl/geometry/octree/octree.h>

#include "collision/PrimitiveShapes.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    using OccupancyTree = fcl::OcTree<double>;

    /** \brief All types of obstacles and of the shapes of bodies. */
    using ShapeKinds =
        decltype(std::tuple_cat(std::declval<Primitives>(), std::declval<std::tuple<MeshGeometry, OccupancyTree>>()));

    template <typename Shape>
    constexpr bool IS_PRIMITIVE = !std::is_same_v<Shape, MeshGeometry> && !std::is_same_v<Shape, OccupancyTree>;

    template <typename Shape>
    constexpr fcl::NODE_TYPE nodeType()
    {
        if constexpr (IS_PRIMITIVE<Shape>)
        {
            return ShapeTraits<Shape>::TYPE;
        }
        else
        {
            return std::is_same_v<Shape, MeshGeometry> ? fcl::BV_OBBRSS : fcl::GEOM_OCTREE;
        }
    }

    /** \brief Position in ShapeKinds.
        \throw std::invalid_argument if FCL's geometry is of another type. */
    template <std::size_t Kind = 0>
    std::size_t kindOf(const fcl::CollisionGeometryd &geometry)
    {
        if constexpr (Kind == std::tuple_size_v<ShapeKinds>)
        {
            throw std::invalid_argument("ompl_mfa::collision: this kind of FCL geometry is not supported");
        }
        else
        {
            return geometry.getNodeType() == nodeType<std::tuple_element_t<Kind, ShapeKinds>>()
                       ? Kind
                       : kindOf<Kind + 1>(geometry);
        }
    }

    /** \brief Overload set of several lambdas. */
    template <typename... Lambdas>
    struct Overloaded : Lambdas...
    {
        using Lambdas::operator()...;
    };

    template <typename... Lambdas>
    Overloaded(Lambdas...) -> Overloaded<Lambdas...>;

    /** \brief Result of `visitor` for the geometry, cast to its actual type ShapeKinds[kind]. */
    template <std::size_t Kind = 0, typename Visitor>
    auto visitShape(const fcl::CollisionGeometryd &geometry, std::size_t kind, const Visitor &visitor)
        -> std::invoke_result_t<const Visitor &, const MeshGeometry &>
    {
        if constexpr (Kind + 1 < std::tuple_size_v<ShapeKinds>)
        {
            if (kind != Kind)
            {
                return visitShape<Kind + 1>(geometry, kind, visitor);
            }
        }
        return visitor(static_cast<const std::tuple_element_t<Kind, ShapeKinds> &>(geometry));
    }

    /** \throw std::invalid_argument as kindOf() does. */
    template <typename Visitor>
    auto visitShape(const fcl::CollisionGeometryd &geometry, const Visitor &visitor)
    {
        return visitShape(geometry, kindOf(geometry), visitor);
    }

    /** \brief Smallest bounding box of the core of a primitive (the shape without its margin), in its own frame. */
    template <typename Shape>
    fcl::AABBd coreBox(const Shape &primitive)
    {
        fcl::AABBd box;
        for (int axis = 0; axis < 3; ++axis)
        {
            box.min_[axis] = ShapeTraits<Shape>::support(primitive, -fcl::Vector3d::Unit(axis))[axis];
            box.max_[axis] = ShapeTraits<Shape>::support(primitive, fcl::Vector3d::Unit(axis))[axis];
        }
        return box;
    }
}  // namespace ompl_mfa::collision

#endif
