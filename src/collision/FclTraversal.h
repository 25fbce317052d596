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

#ifndef OMPL_MFA_COLLISION_FCL_TRAVERSAL_
#define OMPL_MFA_COLLISION_FCL_TRAVERSAL_

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include "collision/ShapeKinds.h"
#include "collision/ShapeSeparation.h"

namespace ompl_mfa::collision
{
    using BoundingVolume = fcl::OBBRSS<double>;

    // FCL copies the closest points even if no request of ours reads them.
    inline void clearPoints(fcl::Vector3d *first, fcl::Vector3d *second)
    {
        for (fcl::Vector3d *point : {first, second})
        {
            if (point != nullptr)
            {
                point->setZero();
            }
        }
    }

    // The solver that FCL's traversals of meshes and occupancy maps use for single triangles and cells.
    struct CertifiedSolver : fcl::detail::GJKSolver_libccd<double>
    {
        template <typename A, typename B>
        bool shapeIntersect(const A &a, const fcl::Transform3d &poseA, const B &b, const fcl::Transform3d &poseB,
                            std::vector<fcl::ContactPointd> * /*contacts*/) const
        {
            return separateShapes(a, poseA, b, poseB, true).lower <= 0.;
        }

        template <typename A, typename B>
        bool shapeDistance(const A &a, const fcl::Transform3d &poseA, const B &b, const fcl::Transform3d &poseB,
                           double *distance, fcl::Vector3d *nearestA, fcl::Vector3d *nearestB) const
        {
            clearPoints(nearestA, nearestB);
            *distance = separateShapes(a, poseA, b, poseB, false).lower;
            return *distance > 0.;
        }

        template <typename Shape>
        bool shapeTriangleIntersect(const Shape &shape, const fcl::Transform3d &pose, const fcl::Vector3d &p1,
                                    const fcl::Vector3d &p2, const fcl::Vector3d &p3, fcl::Vector3d *contact,
                                    double *depth, fcl::Vector3d *normal) const
        {
            return shapeTriangleIntersect(shape, pose, p1, p2, p3, fcl::Transform3d::Identity(), contact, depth,
                                          normal);
        }

        template <typename Shape>
        bool shapeTriangleIntersect(const Shape &shape, const fcl::Transform3d &pose, const fcl::Vector3d &p1,
                                    const fcl::Vector3d &p2, const fcl::Vector3d &p3,
                                    const fcl::Transform3d &trianglePose, fcl::Vector3d *contact, double *depth,
                                    fcl::Vector3d *normal) const
        {
            clearPoints(contact, normal);
            if (depth != nullptr)
            {
                *depth = 0.;
            }
            return separate(shape, pose, fcl::TrianglePd(p1, p2, p3), trianglePose, true).lower <= 0.;
        }

        template <typename Shape>
        bool shapeTriangleDistance(const Shape &shape, const fcl::Transform3d &pose, const fcl::Vector3d &p1,
                                   const fcl::Vector3d &p2, const fcl::Vector3d &p3, double *distance,
                                   fcl::Vector3d *nearestShape, fcl::Vector3d *nearestTriangle) const
        {
            return shapeTriangleDistance(shape, pose, p1, p2, p3, fcl::Transform3d::Identity(), distance, nearestShape,
                                         nearestTriangle);
        }

        template <typename Shape>
        bool shapeTriangleDistance(const Shape &shape, const fcl::Transform3d &pose, const fcl::Vector3d &p1,
                                   const fcl::Vector3d &p2, const fcl::Vector3d &p3,
                                   const fcl::Transform3d &trianglePose, double *distance, fcl::Vector3d *nearestShape,
                                   fcl::Vector3d *nearestTriangle) const
        {
            clearPoints(nearestShape, nearestTriangle);
            *distance = separate(shape, pose, fcl::TrianglePd(p1, p2, p3), trianglePose, false).lower;
            return *distance > 0.;
        }
    };

    // FCL fits the bounding volume of a primitive in each query, on the heap. Its bounding box serves as well; its
    // thinnest side becomes the radius of the rectangle swept sphere that distances are measured to.
    template <typename Shape>
    BoundingVolume volumeAround(const Shape &shape, const fcl::Transform3d &pose)
    {
        const fcl::AABBd core = coreBox(shape);
        const double margin = ShapeTraits<Shape>::margin(shape);
        const fcl::Vector3d half = 0.5 * (core.max_ - core.min_);
        int thin = 0;
        half.minCoeff(&thin);
        const int second = (thin + 1) % 3;
        const int third = (thin + 2) % 3;
        BoundingVolume volume;
        volume.obb.axis.col(0) = pose.linear().col(second);
        volume.obb.axis.col(1) = pose.linear().col(third);
        volume.obb.axis.col(2) = pose.linear().col(thin);
        volume.obb.To = pose * core.center();
        volume.obb.extent << half[second] + margin, half[third] + margin, half[thin] + margin;
        volume.rss.axis = volume.obb.axis;
        volume.rss.l[0] = 2. * half[second];
        volume.rss.l[1] = 2. * half[third];
        volume.rss.r = half[thin] + margin;
        volume.rss.To = volume.obb.To - half[second] * volume.rss.axis.col(0) - half[third] * volume.rss.axis.col(1);
        return volume;
    }

    // As FCL's initialize() for both kinds of node, except for the bounding volume.
    template <typename Node, typename Shape, typename Request, typename Result>
    void setUpTraversal(Node &node, const MeshGeometry &mesh, const fcl::Transform3d &meshPose, const Shape &shape,
                        const fcl::Transform3d &shapePose, const CertifiedSolver &solver, const Request &request,
                        Result &result)
    {
        node.request = request;
        node.result = &result;
        node.model1 = &mesh;
        node.tf1 = meshPose;
        node.model2 = &shape;
        node.tf2 = shapePose;
        node.nsolver = &solver;
        node.model2_bv = volumeAround(shape, shapePose);
        node.vertices = mesh.vertices;
        node.tri_indices = mesh.tri_indices;
    }

    inline fcl::TrianglePd triangleOf(const MeshGeometry &mesh, intptr_t index)
    {
        const fcl::Triangle &triangle = mesh.tri_indices[index];
        return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
    }

    // FCL's distance of two triangles treats those with sides below 2e-4, in any unit, as their edges.
    struct MeshDistanceNode : fcl::detail::MeshDistanceTraversalNodeOBBRSS<double>
    {
        // Any pair of triangles yields an initial upper bound.
        void preprocess() override
        {
            testTriangles(0, 0);
        }

        void leafTesting(int first, int second) const override
        {
            testTriangles(model1->getBV(first).primitiveId(), model2->getBV(second).primitiveId());
        }

    private:
        void testTriangles(int first, int second) const
        {
            const double gap = separate(triangleOf(*model1, first), fcl::Transform3d::Identity(),
                                        triangleOf(*model2, second), tf, false)
                                   .lower;
            result->update(std::max(0., gap), model1, model2, first, second);
        }
    };

    // FCL's traversal for a pair with a mesh or a map on at least one side.
    template <typename A, typename B>
    struct Traversal
    {
        static void collide(const fcl::CollisionGeometryd *a, const fcl::Transform3d &poseA,
                            const fcl::CollisionGeometryd *b, const fcl::Transform3d &poseB,
                            const fcl::CollisionRequestd &request, fcl::CollisionResultd &result)
        {
            static const CertifiedSolver SOLVER;
            if constexpr (std::is_same_v<A, MeshGeometry> && std::is_same_v<B, MeshGeometry>)
            {
                fcl::detail::BVHCollide<BoundingVolume>(a, poseA, b, poseB, request, result);
            }
            else if constexpr (std::is_same_v<A, MeshGeometry>)
            {
                fcl::detail::MeshShapeCollisionTraversalNodeOBBRSS<B, CertifiedSolver> node;
                setUpTraversal(node, *static_cast<const A *>(a), poseA, *static_cast<const B *>(b), poseB, SOLVER,
                               request, result);
                fcl::detail::collide(&node);
            }
            else if constexpr (std::is_same_v<B, MeshGeometry>)
            {
                fcl::detail::OcTreeBVHCollide<BoundingVolume, CertifiedSolver>(a, poseA, b, poseB, &SOLVER, request,
                                                                               result);
            }
            else if constexpr (std::is_same_v<B, OccupancyTree>)
            {
                fcl::detail::OcTreeCollide<CertifiedSolver>(a, poseA, b, poseB, &SOLVER, request, result);
            }
            else
            {
                fcl::detail::OcTreeShapeCollide<B, CertifiedSolver>(a, poseA, b, poseB, &SOLVER, request, result);
            }
        }

        static void distance(const fcl::CollisionGeometryd *a, const fcl::Transform3d &poseA,
                             const fcl::CollisionGeometryd *b, const fcl::Transform3d &poseB,
                             fcl::DistanceResultd &result)
        {
            static const CertifiedSolver SOLVER;
            static const fcl::DistanceRequestd REQUEST;
            if constexpr (std::is_same_v<A, MeshGeometry> && std::is_same_v<B, MeshGeometry>)
            {
                MeshDistanceNode node;
                fcl::detail::initialize(node, *static_cast<const A *>(a), poseA, *static_cast<const B *>(b), poseB,
                                        REQUEST, result);
                fcl::detail::distance(&node);
            }
            else if constexpr (std::is_same_v<A, MeshGeometry>)
            {
                fcl::detail::MeshShapeDistanceTraversalNodeOBBRSS<B, CertifiedSolver> node;
                setUpTraversal(node, *static_cast<const A *>(a), poseA, *static_cast<const B *>(b), poseB, SOLVER,
                               REQUEST, result);
                fcl::detail::distance(&node);
            }
            else if constexpr (std::is_same_v<B, MeshGeometry>)
            {
                fcl::detail::OcTreeBVHDistance<BoundingVolume, CertifiedSolver>(a, poseA, b, poseB, &SOLVER, REQUEST,
                                                                                result);
            }
            else if constexpr (std::is_same_v<B, OccupancyTree>)
            {
                fcl::detail::OcTreeDistance<CertifiedSolver>(a, poseA, b, poseB, &SOLVER, REQUEST, result);
            }
            else
            {
                fcl::detail::OcTreeShapeDistance<B, CertifiedSolver>(a, poseA, b, poseB, &SOLVER, REQUEST, result);
            }
        }
    };
}  // namespace ompl_mfa::collision

#endif
