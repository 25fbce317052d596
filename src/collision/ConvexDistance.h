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

#ifndef OMPL_MFA_COLLISION_CONVEX_DISTANCE_
#define OMPL_MFA_COLLISION_CONVEX_DISTANCE_

#include <algorithm>
#include <array>
#include <limits>

#include <fcl/geometry/shape/triangle_p.h>

#include "collision/PrimitiveShapes.h"

namespace ompl_mfa::collision
{
    /** \brief A triangle of a mesh, given by its corners. */
    template <>
    struct ShapeTraits<fcl::TrianglePd> : ShapeDefaults
    {
        static fcl::Vector3d support(const fcl::TrianglePd &triangle, const fcl::Vector3d &direction)
        {
            const double a = triangle.a.dot(direction);
            const double b = triangle.b.dot(direction);
            const double c = triangle.c.dot(direction);
            return a >= b && a >= c ? triangle.a : b >= c ? triangle.b : triangle.c;
        }
    };

    /** \brief Bounds on the distance between two convex shapes. */
    struct ConvexSeparation
    {
        /** \brief Certified lower bound, proved by a separating plane. At most 0 if none was found. */
        double lower{-std::numeric_limits<double>::infinity()};

        /** \brief Certified upper bound: the distance of two points of the shapes. */
        double upper{std::numeric_limits<double>::infinity()};

        /** \brief Unit normal of the separating plane in world coordinates, from the second shape to the first. */
        fcl::Vector3d normal{fcl::Vector3d::UnitX()};
    };

    /** \brief A simplex of up to four points of a Minkowski difference, and its closest point to the origin. */
    class ClosestSimplex
    {
    public:
        /** \brief Add a point, and keep only the corners of the feature closest to the origin. */
        void add(const fcl::Vector3d &point);

        const fcl::Vector3d &closest() const
        {
            return closest_;
        }

        /** \brief Whether the origin lies inside a tetrahedron. */
        bool containsOrigin() const
        {
            return containsOrigin_;
        }

        bool holds(const fcl::Vector3d &point) const;

    private:
        struct Feature
        {
            std::array<fcl::Vector3d, 3> corners;
            int size{0};
            fcl::Vector3d closest;
        };

        static Feature onSegment(const fcl::Vector3d &a, const fcl::Vector3d &b);
        static Feature onTriangle(const fcl::Vector3d &a, const fcl::Vector3d &b, const fcl::Vector3d &c);
        void keep(const Feature &feature);

        std::array<fcl::Vector3d, 4> corners_;
        int size_{0};
        fcl::Vector3d closest_{fcl::Vector3d::Zero()};
        bool containsOrigin_{false};
    };

    /** \brief Bound the distance of two convex shapes from both sides until the bounds agree to 1e-11 of the shapes'
        size or, with `decideOnly`, until it is known whether they touch.

        FCL's own solvers terminate on small progress, which does not bound the error: distances of cones and cylinders
        are wrong by up to their size (docs/collision.md). Here the lower bound holds whenever the iteration ends.
        Source: E. Gilbert, D. Johnson, S. Keerthi, A fast procedure for computing the distance between complex objects
        in three-dimensional space, IEEE J. Robotics and Automation 4(2), 1988. */
    template <typename ShapeA, typename ShapeB>
    ConvexSeparation separate(const ShapeA &a, const fcl::Transform3d &poseA, const ShapeB &b,
                              const fcl::Transform3d &poseB, bool decideOnly)
    {
        constexpr int MAXIMUM_ITERATIONS = 100;
        constexpr double ACCURACY = 1e-11;
        const fcl::Matrix3d rotation = poseA.linear().transpose() * poseB.linear();
        const fcl::Vector3d offset = poseA.linear().transpose() * (poseB.translation() - poseA.translation());
        const double margin = ShapeTraits<ShapeA>::margin(a) + ShapeTraits<ShapeB>::margin(b);

        ConvexSeparation result;
        ClosestSimplex simplex;
        fcl::Vector3d direction = -offset;
        if (direction.squaredNorm() == 0.)
        {
            direction = fcl::Vector3d::UnitX();
        }
        for (int i = 0; i < MAXIMUM_ITERATIONS; ++i)
        {
            const double length = direction.norm();
            const fcl::Vector3d onB = rotation * ShapeTraits<ShapeB>::support(b, rotation.transpose() * direction);
            const fcl::Vector3d point = ShapeTraits<ShapeA>::support(a, -direction) - (onB + offset);
            const double lower = point.dot(direction) / length - margin;
            if (lower > result.lower)
            {
                result.lower = lower;
                result.normal = direction / length;
            }
            const double size = point.norm();
            const bool decided = decideOnly && (result.lower > 0. || result.upper <= 0.);
            if (decided || result.upper - result.lower <= ACCURACY * (size + margin) || simplex.holds(point))
            {
                break;
            }
            simplex.add(point);
            direction = simplex.closest();
            const double upper = direction.norm() - margin;
            if (simplex.containsOrigin() || direction.squaredNorm() <= ACCURACY * ACCURACY * size * size)
            {
                result.upper = std::min(result.upper, -margin);
                break;
            }
            if (upper >= result.upper)
            {
                break;
            }
            result.upper = upper;
        }
        result.normal = poseA.linear() * result.normal;
        return result;
    }
}  // namespace ompl_mfa::collision

#endif
