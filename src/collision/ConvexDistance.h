#ifndef OMPL_MFA_COLLISION_CONVEX_DISTANCE_
#define OMPL_MFA_COLLISION_CONVEX_DISTANCE_

#include <array>
#include <cmath>
#include <limits>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/triangle_p.h>

namespace ompl_mfa::collision
{
    // Farthest point of a shape along a direction of its own frame. A sphere is a point with a margin.
    inline fcl::Vector3d supportPoint(const fcl::Sphered & /*sphere*/, const fcl::Vector3d & /*direction*/)
    {
        return fcl::Vector3d::Zero();
    }

    inline fcl::Vector3d supportPoint(const fcl::Boxd &box, const fcl::Vector3d &direction)
    {
        return {std::copysign(0.5 * box.side[0], direction[0]), std::copysign(0.5 * box.side[1], direction[1]),
                std::copysign(0.5 * box.side[2], direction[2])};
    }

    inline fcl::Vector3d supportPoint(const fcl::Cylinderd &cylinder, const fcl::Vector3d &direction)
    {
        const double radial = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
        const double scale = radial > 0. ? cylinder.radius / radial : 0.;
        return {scale * direction[0], scale * direction[1], std::copysign(0.5 * cylinder.lz, direction[2])};
    }

    inline fcl::Vector3d supportPoint(const fcl::Coned &cone, const fcl::Vector3d &direction)
    {
        const double radial = std::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
        if (cone.lz * direction[2] > cone.radius * radial)
        {
            return {0., 0., 0.5 * cone.lz};
        }
        const double scale = radial > 0. ? cone.radius / radial : 0.;
        return {scale * direction[0], scale * direction[1], -0.5 * cone.lz};
    }

    inline fcl::Vector3d supportPoint(const fcl::TrianglePd &triangle, const fcl::Vector3d &direction)
    {
        const double a = triangle.a.dot(direction);
        const double b = triangle.b.dot(direction);
        const double c = triangle.c.dot(direction);
        return a >= b && a >= c ? triangle.a : b >= c ? triangle.b : triangle.c;
    }

    template <typename Shape>
    double marginOf(const Shape & /*shape*/)
    {
        return 0.;
    }

    inline double marginOf(const fcl::Sphered &sphere)
    {
        return sphere.radius;
    }

    /** \brief What is known of the distance between two convex shapes. */
    struct ConvexSeparation
    {
        /** \brief Certified: a plane between the shapes keeps them this far apart. At most 0 where none was found. */
        double lower{-std::numeric_limits<double>::infinity()};

        /** \brief Certified: two points of the shapes are this close. */
        double upper{std::numeric_limits<double>::infinity()};

        /** \brief Unit normal of that plane, from the second shape to the first, in the world. */
        fcl::Vector3d normal{fcl::Vector3d::UnitX()};
    };

    /** \brief A simplex of up to four points of a Minkowski difference, and its point closest to the origin. */
    class ClosestSimplex
    {
    public:
        /** \brief Add a point, and keep only the corners of the feature that is then closest to the origin. */
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

    /** \brief Distance of two convex shapes, closed in from both sides until the bounds agree to 1e-11 of their size,
        or, with `decideOnly`, until it is known whether they touch.

        FCL's own solvers stop on small progress, which bounds nothing: distances of cones and cylinders came out wrong
        by up to their size (docs/collision.md). Here the lower bound holds whenever the iteration ends.
        Source: E. Gilbert, D. Johnson, S. Keerthi, A fast procedure for computing the distance between complex
        objects in three-dimensional space, IEEE J. Robotics and Automation 4(2), 1988. */
    template <typename ShapeA, typename ShapeB>
    ConvexSeparation separate(const ShapeA &a, const fcl::Transform3d &poseA, const ShapeB &b,
                              const fcl::Transform3d &poseB, bool decideOnly)
    {
        constexpr int maximumIterations = 100;
        constexpr double accuracy = 1e-11;
        const fcl::Matrix3d rotation = poseA.linear().transpose() * poseB.linear();
        const fcl::Vector3d offset = poseA.linear().transpose() * (poseB.translation() - poseA.translation());
        const double margin = marginOf(a) + marginOf(b);

        ConvexSeparation result;
        ClosestSimplex simplex;
        fcl::Vector3d direction = -offset;
        if (direction.squaredNorm() == 0.)
        {
            direction = fcl::Vector3d::UnitX();
        }
        for (int i = 0; i < maximumIterations; ++i)
        {
            const double length = direction.norm();
            const fcl::Vector3d point =
                supportPoint(a, -direction) - (rotation * supportPoint(b, rotation.transpose() * direction) + offset);
            const double lower = point.dot(direction) / length - margin;
            if (lower > result.lower)
            {
                result.lower = lower;
                result.normal = direction / length;
            }
            const double size = point.norm();
            const bool decided = decideOnly && (result.lower > 0. || result.upper <= 0.);
            if (decided || result.upper - result.lower <= accuracy * (size + margin) || simplex.holds(point))
            {
                break;
            }
            simplex.add(point);
            direction = simplex.closest();
            const double upper = direction.norm() - margin;
            if (simplex.containsOrigin() || direction.squaredNorm() <= accuracy * accuracy * size * size)
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
