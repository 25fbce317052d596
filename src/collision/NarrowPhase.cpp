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

#include "collision/NarrowPhase.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <type_traits>

#include "collision/FclTraversal.h"

namespace ompl_mfa::collision
{
    namespace
    {
        using Geometry = fcl::CollisionGeometryd;
        using Pose = fcl::Transform3d;

        // FCL stores the contact in a vector, whose memory is reused by the next query of the thread.
        fcl::CollisionResultd &clearedResult()
        {
            thread_local fcl::CollisionResultd result;
            result.clear();
            return result;
        }

        // Upper bound on a distance from the triangles that were closest last time; infinite if there are none.
        template <typename A, typename B>
        double rememberedDistance(const A &a, const Pose &poseA, const B &b, const Pose &poseB,
                                  const DistanceSearch &search)
        {
            if constexpr (std::is_same_v<A, MeshGeometry>)
            {
                if (search.nearestA >= 0)
                {
                    const fcl::TrianglePd triangle = triangleOf(a, search.nearestA);
                    if constexpr (IS_PRIMITIVE<B>)
                    {
                        return separate(b, poseB, triangle, poseA, false).upper;
                    }
                    else if constexpr (std::is_same_v<B, MeshGeometry>)
                    {
                        return separate(triangle, poseA, triangleOf(b, search.nearestB), poseB, false).upper;
                    }
                }
            }
            return std::numeric_limits<double>::infinity();
        }

        // FCL expects a mesh before a primitive, and a map before both.
        template <typename A, typename B>
        constexpr bool IN_ORDER = std::is_same_v<A, OccupancyTree> ||
                                  (std::is_same_v<A, MeshGeometry> && !std::is_same_v<B, OccupancyTree>);

        template <typename A, typename B>
        bool collidePair(const Geometry &a, const Pose &poseA, const Geometry &b, const Pose &poseB)
        {
            if constexpr (IS_PRIMITIVE<A> && IS_PRIMITIVE<B>)
            {
                return separateShapes(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, true).lower <=
                       0.;
            }
            else if constexpr (IN_ORDER<A, B>)
            {
                static const fcl::CollisionRequestd REQUEST;
                fcl::CollisionResultd &result = clearedResult();
                Traversal<A, B>::collide(&a, poseA, &b, poseB, REQUEST, result);
                return result.isCollision();
            }
            else
            {
                return collidePair<B, A>(b, poseB, a, poseA);
            }
        }

        template <typename A, typename B>
        double distancePair(const Geometry &a, const Pose &poseA, const Geometry &b, const Pose &poseB,
                            DistanceSearch &search)
        {
            if constexpr (IS_PRIMITIVE<A> && IS_PRIMITIVE<B>)
            {
                const double distance =
                    separateShapes(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, false).lower;
                // A plane that does not separate two shapes says little about their penetration depth.
                return std::min(search.limit, DEPTH_IS_KNOWN<A, B> ? distance : std::max(0., distance));
            }
            else if constexpr (IN_ORDER<A, B>)
            {
                const double remembered =
                    rememberedDistance(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, search);
                const double known = std::min(search.limit, remembered);
                fcl::DistanceResultd result(known);
                Traversal<A, B>::distance(&a, poseA, &b, poseB, result);
                if (result.min_distance < known)
                {
                    search.nearestA = result.b1;
                    search.nearestB = result.b2;
                }
                return std::max(0., result.min_distance);
            }
            else
            {
                return distancePair<B, A>(b, poseB, a, poseA, search);
            }
        }

        template <typename A, typename B>
        ConvexSeparation separatePair(const Geometry &a, const Pose &poseA, const Geometry &b, const Pose &poseB)
        {
            return separateShapes(static_cast<const A &>(a), poseA, static_cast<const B &>(b), poseB, false);
        }

        template <typename A, typename B>
        constexpr PairFunctions makePair()
        {
            if constexpr (IS_PRIMITIVE<A> && IS_PRIMITIVE<B>)
            {
                return {collidePair<A, B>, distancePair<A, B>, separatePair<A, B>};
            }
            else
            {
                return {collidePair<A, B>, distancePair<A, B>, nullptr};
            }
        }

        constexpr std::size_t KIND_COUNT = std::tuple_size_v<ShapeKinds>;
        using Row = std::array<PairFunctions, KIND_COUNT>;

        template <typename A, std::size_t... B>
        constexpr Row makeRow(std::index_sequence<B...> /*columns*/)
        {
            return {makePair<A, std::tuple_element_t<B, ShapeKinds>>()...};
        }

        template <std::size_t... A>
        constexpr std::array<Row, KIND_COUNT> makeTable(std::index_sequence<A...> rows)
        {
            return {makeRow<std::tuple_element_t<A, ShapeKinds>>(rows)...};
        }
    }  // namespace

    const PairFunctions &pairFunctions(const Geometry &a, const Geometry &b)
    {
        static constexpr std::array<Row, KIND_COUNT> TABLE = makeTable(std::make_index_sequence<KIND_COUNT>());
        return TABLE[kindOf(a)][kindOf(b)];
    }
}  // namespace ompl_mfa::collision
