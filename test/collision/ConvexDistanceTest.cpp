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

#include "collision/ConvexDistance.h"

#include <algorithm>
#include <cmath>

#include <fcl/narrowphase/detail/primitive_shape_algorithm/capsule_capsule.h>
#include <gtest/gtest.h>

#include "collision/RandomScenes.h"

namespace ompl_mfa::collision
{
    namespace
    {
        using Geometry = fcl::CollisionGeometryd;

        // Nearest point of a solid, in its own frame, computed without the support points under test.
        fcl::Vector3d project(const Geometry &geometry, const fcl::Vector3d &p)
        {
            switch (geometry.getNodeType())
            {
                case fcl::GEOM_SPHERE:
                {
                    const double radius = static_cast<const fcl::Sphered &>(geometry).radius;
                    return p.norm() <= radius ? p : fcl::Vector3d(radius * p.normalized());
                }
                case fcl::GEOM_BOX:
                {
                    const fcl::Vector3d half = 0.5 * static_cast<const fcl::Boxd &>(geometry).side;
                    return p.cwiseMax(-half).cwiseMin(half);
                }
                case fcl::GEOM_CYLINDER:
                {
                    const auto &cylinder = static_cast<const fcl::Cylinderd &>(geometry);
                    const double radial = p.head<2>().norm();
                    const double scale = radial > cylinder.radius ? cylinder.radius / radial : 1.;
                    return {scale * p.x(), scale * p.y(), std::clamp(p.z(), -cylinder.lz / 2., cylinder.lz / 2.)};
                }
                default:
                {
                    // In the half plane of the point a cone is a triangle: base, slant and axis.
                    const auto &cone = static_cast<const fcl::Coned &>(geometry);
                    const double radial = p.head<2>().norm();
                    const Eigen::Vector2d q(radial, p.z());
                    const Eigen::Vector2d rim(cone.radius, -cone.lz / 2.);
                    const Eigen::Vector2d slant = Eigen::Vector2d(0., cone.lz / 2.) - rim;
                    const Eigen::Vector2d outward(slant.y(), -slant.x());
                    if (q.y() >= -cone.lz / 2. && outward.dot(q - rim) <= 0.)
                    {
                        return p;
                    }
                    const Eigen::Vector2d onSlant =
                        rim + std::clamp(slant.dot(q - rim) / slant.squaredNorm(), 0., 1.) * slant;
                    const Eigen::Vector2d onBase(std::min(radial, cone.radius), -cone.lz / 2.);
                    const Eigen::Vector2d nearest =
                        (onSlant - q).squaredNorm() < (onBase - q).squaredNorm() ? onSlant : onBase;
                    const double scale = radial > 0. ? nearest.x() / radial : 0.;
                    return {scale * p.x(), scale * p.y(), nearest.y()};
                }
            }
        }

        // Alternating projections onto two convex solids converge to their distance from above (W. Cheney, A.
        // Goldstein, 1959).
        double projectedDistance(const Geometry &a, const fcl::Transform3d &poseA, const Geometry &b,
                                 const fcl::Transform3d &poseB)
        {
            fcl::Vector3d onA = poseA.translation();
            fcl::Vector3d onB = poseB.translation();
            for (int i = 0; i < 3000; ++i)
            {
                onB = poseB * project(b, poseB.inverse() * onA);
                onA = poseA * project(a, poseA.inverse() * onB);
            }
            return (onA - onB).norm();
        }

        template <typename A, typename B>
        void expectAgreement(const char *kindA, const char *kindB)
        {
            Random random(7);
            int apart = 0;
            for (int i = 0; i < 200; ++i)
            {
                const auto a = random.primitive(kindA);
                const auto b = random.primitive(kindB);
                const fcl::Transform3d poseA = random.pose(1.5);
                const fcl::Transform3d poseB = random.pose(1.5);
                const auto &shapeA = static_cast<const A &>(*a);
                const auto &shapeB = static_cast<const B &>(*b);
                const ConvexSeparation gap = separate(shapeA, poseA, shapeB, poseB, false);
                const ConvexSeparation decision = separate(shapeA, poseA, shapeB, poseB, true);
                const double projected = projectedDistance(*a, poseA, *b, poseB);
                EXPECT_EQ(gap.lower > 0., decision.lower > 0.) << i;
                EXPECT_LE(gap.lower, projected + 1e-9) << i;
                if (gap.lower > 0.)
                {
                    ++apart;
                    EXPECT_LT(gap.upper - gap.lower, 1e-8) << i;
                    EXPECT_NEAR(gap.lower, projected, 1e-4) << i;
                    EXPECT_NEAR(gap.normal.norm(), 1., 1e-12);
                }
                else
                {
                    EXPECT_LT(projected, 1e-2) << i;
                }
            }
            EXPECT_GT(apart, 50);
        }

        TEST(ConvexDistance, AgreesWithAlternatingProjections)
        {
            using fcl::Boxd;
            using fcl::Coned;
            using fcl::Cylinderd;
            using fcl::Sphered;
            expectAgreement<Sphered, Sphered>("sphere", "sphere");
            expectAgreement<Sphered, Boxd>("sphere", "box");
            expectAgreement<Sphered, Cylinderd>("sphere", "cylinder");
            expectAgreement<Sphered, Coned>("sphere", "cone");
            expectAgreement<Boxd, Boxd>("box", "box");
            expectAgreement<Boxd, Cylinderd>("box", "cylinder");
            expectAgreement<Boxd, Coned>("box", "cone");
            expectAgreement<Cylinderd, Cylinderd>("cylinder", "cylinder");
            expectAgreement<Cylinderd, Coned>("cylinder", "cone");
            expectAgreement<Coned, Coned>("cone", "cone");
        }

        // A capsule is a segment with a margin, so the distance of two capsules follows from that of their segments.
        TEST(ConvexDistance, CapsulesAgreeWithTheirSegments)
        {
            Random random(8);
            int apart = 0;
            for (int i = 0; i < 2000; ++i)
            {
                const fcl::Capsuled a(random.uniform(0.1, 0.5), random.uniform(0.1, 2.));
                const fcl::Capsuled b(random.uniform(0.1, 0.5), random.uniform(0.1, 2.));
                const fcl::Transform3d poseA = random.pose(1.5);
                const fcl::Transform3d poseB = random.pose(1.5);
                fcl::Vector3d nearestA;
                fcl::Vector3d nearestB;
                double shareA = 0.;
                double shareB = 0.;
                const fcl::Vector3d halfA = 0.5 * a.lz * poseA.linear().col(2);
                const fcl::Vector3d halfB = 0.5 * b.lz * poseB.linear().col(2);
                const double squared = fcl::detail::closestPtSegmentSegment<double>(
                    poseA.translation() - halfA, poseA.translation() + halfA, poseB.translation() - halfB,
                    poseB.translation() + halfB, &shareA, &shareB, &nearestA, &nearestB);
                const double expected = std::sqrt(squared) - a.radius - b.radius;
                const ConvexSeparation gap = separate(a, poseA, b, poseB, false);
                EXPECT_NEAR(std::max(0., gap.lower), std::max(0., expected), 1e-9) << i;
                apart += expected > 0. ? 1 : 0;
            }
            EXPECT_GT(apart, 500);
        }

        // The separating plane has all support points of each solid on that solid's side.
        TEST(ConvexDistance, PlaneSeparates)
        {
            Random random(11);
            for (int i = 0; i < 500; ++i)
            {
                const auto cylinder = random.primitive("cylinder");
                const auto cone = random.primitive("cone");
                const auto &a = static_cast<const fcl::Cylinderd &>(*cylinder);
                const auto &b = static_cast<const fcl::Coned &>(*cone);
                const fcl::Transform3d poseA = random.pose(2.);
                const fcl::Transform3d poseB = random.pose(2.);
                const ConvexSeparation gap = separate(a, poseA, b, poseB, false);
                const fcl::Vector3d n = gap.normal;
                const fcl::Vector3d lowestA =
                    poseA * ShapeTraits<fcl::Cylinderd>::support(a, -(poseA.linear().transpose() * n));
                const fcl::Vector3d highestB =
                    poseB * ShapeTraits<fcl::Coned>::support(b, poseB.linear().transpose() * n);
                EXPECT_NEAR(n.dot(lowestA - highestB), gap.lower, 1e-12);
            }
        }

        TEST(ConvexDistance, IsExactWhereShapesAreParallel)
        {
            const fcl::Boxd box(1., 1., 1.);
            const fcl::Cylinderd cylinder(0.5, 1.);
            for (const double gap : {1., 1e-3, 1e-6, 1e-9})
            {
                fcl::Transform3d pose = fcl::Transform3d::Identity();
                pose.translation().z() = 1. + gap;
                EXPECT_NEAR(separate(box, fcl::Transform3d::Identity(), box, pose, false).lower, gap, 1e-12);
                EXPECT_NEAR(separate(box, fcl::Transform3d::Identity(), cylinder, pose, false).lower, gap, 1e-12);
                pose.translation().z() = 1. - gap;
                EXPECT_LE(separate(box, fcl::Transform3d::Identity(), box, pose, true).lower, 0.);
                EXPECT_LE(separate(box, fcl::Transform3d::Identity(), cylinder, pose, true).lower, 0.);
            }
            EXPECT_LE(separate(box, fcl::Transform3d::Identity(), box, fcl::Transform3d::Identity(), false).lower, 0.);
        }
    }  // namespace
}  // namespace ompl_mfa::collision
