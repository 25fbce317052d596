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

#include "ompl_mfa/collision/PlanarOutline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "collision/ConvexDistance.h"
#include "collision/ShapeKinds.h"

namespace ompl_mfa::collision
{
    namespace
    {
        struct Slab
        {
            double zMin;
            double zMax;
        };

        // The section of a convex solid within the slab, seen from above.
        template <typename Shape>
        class ConvexOutline
        {
        public:
            ConvexOutline(const Shape &shape, const fcl::Transform3d &pose, const Slab &slab)
              : shape_(shape)
              , pose_(pose)
              , slab_(slab)
            {
            }

            // Counter-clockwise. Empty if there is no section, two corners if it is a segment.
            Polygon trace()
            {
                Polygon sides;
                for (const Eigen::Vector2d &side : {Eigen::Vector2d(1., 0.), Eigen::Vector2d(0., 1.),
                                                    Eigen::Vector2d(-1., 0.), Eigen::Vector2d(0., -1.)})
                {
                    const auto corner = farthestInSlab(side);
                    if (!corner)
                    {
                        return {};
                    }
                    sides.push_back(*corner);
                }
                const double size = (sides[0] - sides[2]).norm() + (sides[1] - sides[3]).norm();
                rounding_ = 1e-10 * size + 1e-14 * sides[0].norm();
                for (std::size_t i = 0; i < sides.size(); ++i)
                {
                    addCorner(sides[i]);
                    refine(sides[i], sides[(i + 1) % sides.size()], REFINEMENTS);
                }
                closeOutline();
                return std::move(corners_);
            }

        private:
            fcl::Vector3d farthest(const fcl::Vector3d &direction) const
            {
                const fcl::Vector3d local = pose_.linear().transpose() * direction;
                return pose_ * (ShapeTraits<Shape>::support(shape_, local) +
                                ShapeTraits<Shape>::margin(shape_) * local.normalized());
            }

            std::optional<Eigen::Vector2d> farthestInSlab(const Eigen::Vector2d &direction) const
            {
                const fcl::Vector3d outward(direction.x(), direction.y(), 0.);
                const fcl::Vector3d point = farthest(outward);
                if (point.z() > slab_.zMax)
                {
                    return farthestOnPlane(outward, point, slab_.zMax, -fcl::Vector3d::UnitZ());
                }
                if (point.z() < slab_.zMin)
                {
                    return farthestOnPlane(outward, point, slab_.zMin, fcl::Vector3d::UnitZ());
                }
                return point.head<2>();
            }

            // `beyond` is the farthest point, but on the far side of the plane. As the direction turns towards the
            // plane, the farthest point of the solid approaches it; the two points between which it crosses the plane
            // are the ends of an edge, or neighbours on a curve.
            std::optional<Eigen::Vector2d> farthestOnPlane(const fcl::Vector3d &outward, fcl::Vector3d beyond, double z,
                                                           const fcl::Vector3d &towards) const
            {
                fcl::Vector3d within = farthest(towards);
                const auto isWithin = [z, &towards](const fcl::Vector3d &point)
                { return (point.z() - z) * towards.z() >= 0.; };
                if (!isWithin(within))
                {
                    return std::nullopt;
                }
                double low = 0.;
                double high = M_PI / 2.;
                for (int halving = 0; halving < 64; ++halving)
                {
                    const double turn = 0.5 * (low + high);
                    const fcl::Vector3d point = farthest(std::cos(turn) * outward + std::sin(turn) * towards);
                    (isWithin(point) ? high : low) = turn;
                    (isWithin(point) ? within : beyond) = point;
                }
                const double share = (z - beyond.z()) / (within.z() - beyond.z());
                const fcl::Vector3d crossing = beyond + share * (within - beyond);
                return crossing.head<2>();
            }

            // Adds the corners between two others recursively: first the farthest point from the edge between them.
            void refine(const Eigen::Vector2d &a, const Eigen::Vector2d &b, int depth)
            {
                const Eigen::Vector2d edge = b - a;
                if (depth == 0 || edge.norm() <= rounding_)
                {
                    return;
                }
                const Eigen::Vector2d outward = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
                const auto corner = farthestInSlab(outward);
                if (!corner || outward.dot(*corner - a) <= rounding_)
                {
                    return;
                }
                refine(a, *corner, depth - 1);
                addCorner(*corner);
                refine(*corner, b, depth - 1);
            }

            // Whether `corner` lies on the segment between its neighbours.
            bool isOnEdge(const Eigen::Vector2d &before, const Eigen::Vector2d &corner,
                          const Eigen::Vector2d &after) const
            {
                const Eigen::Vector2d a = before - corner;
                const Eigen::Vector2d b = after - corner;
                return a.norm() <= rounding_ || b.norm() <= rounding_ ||
                       (std::abs(a.x() * b.y() - a.y() * b.x()) <= rounding_ * (b - a).norm() && a.dot(b) < 0.);
            }

            void addCorner(const Eigen::Vector2d &corner)
            {
                while (corners_.size() >= 2 && isOnEdge(corners_[corners_.size() - 2], corners_.back(), corner))
                {
                    corners_.pop_back();
                }
                if (corners_.empty() || (corner - corners_.back()).norm() > rounding_)
                {
                    corners_.push_back(corner);
                }
            }

            void closeOutline()
            {
                while (corners_.size() >= 2 &&
                       isOnEdge(corners_[corners_.size() - 2], corners_.back(), corners_.front()))
                {
                    corners_.pop_back();
                }
                while (corners_.size() >= 2 && isOnEdge(corners_.back(), corners_.front(), corners_[1]))
                {
                    corners_.erase(corners_.begin());
                }
            }

            // Per quarter of the outline: a circle gets 128 corners.
            static constexpr int REFINEMENTS = 5;

            const Shape &shape_;
            const fcl::Transform3d &pose_;
            Slab slab_;
            double rounding_{0.};
            Polygon corners_;
        };

        template <typename Shape>
        void append(const Shape &shape, const fcl::Transform3d &pose, const Slab &slab, std::vector<Polygon> &outlines)
        {
            Polygon outline = ConvexOutline<Shape>(shape, pose, slab).trace();
            if (outline.size() >= 2)
            {
                outlines.push_back(std::move(outline));
            }
        }

        void append(const MeshGeometry &mesh, const fcl::Transform3d &pose, const Slab &slab,
                    std::vector<Polygon> &outlines)
        {
            for (int i = 0; i < mesh.num_tris; ++i)
            {
                const fcl::Triangle &corners = mesh.tri_indices[i];
                append(fcl::TrianglePd(mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]),
                       pose, slab, outlines);
            }
        }

        void append(const OccupancyTree &map, const fcl::Transform3d &pose, const Slab &slab,
                    std::vector<Polygon> &outlines)
        {
            for (const auto &cell : map.toBoxes())
            {
                append(fcl::Boxd(fcl::Vector3d::Constant(cell[3])),
                       pose * Eigen::Translation3d(cell[0], cell[1], cell[2]), slab, outlines);
            }
        }

        // A shape is connected, so it reaches all heights between its lowest and its highest point.
        template <typename Shape>
        bool reaches(const Shape &shape, const fcl::Transform3d &pose, const Slab &slab)
        {
            const fcl::AABBd box = boundingBox(shape, pose);
            return box.min_[2] <= slab.zMax && box.max_[2] >= slab.zMin;
        }

        bool reaches(const MeshGeometry &mesh, const fcl::Transform3d &pose, const Slab &slab)
        {
            const auto height = [&mesh, &pose](std::size_t vertex) { return (pose * mesh.vertices[vertex]).z(); };
            return std::any_of(mesh.tri_indices, mesh.tri_indices + mesh.num_tris,
                               [&height, &slab](const fcl::Triangle &corners)
                               {
                                   const auto [lowest, highest] =
                                       std::minmax({height(corners[0]), height(corners[1]), height(corners[2])});
                                   return lowest <= slab.zMax && highest >= slab.zMin;
                               });
        }

        bool reaches(const OccupancyTree &map, const fcl::Transform3d &pose, const Slab &slab)
        {
            const auto cells = map.toBoxes();
            return std::any_of(cells.begin(), cells.end(),
                               [&pose, &slab](const auto &cell)
                               {
                                   return reaches(fcl::Boxd(fcl::Vector3d::Constant(cell[3])),
                                                  pose * Eigen::Translation3d(cell[0], cell[1], cell[2]), slab);
                               });
        }
    }  // namespace

    std::vector<Polygon> planarOutline(const CollisionObject &object, double zMin, double zMax)
    {
        if (!(zMin <= zMax))
        {
            throw std::invalid_argument("planarOutline: zMin must not exceed zMax");
        }
        std::vector<Polygon> outlines;
        visitShape(*object.geometry,
                   [&object, zMin, zMax, &outlines](const auto &shape) {
                       append(shape, object.pose, {zMin, zMax}, outlines);
                   });
        return outlines;
    }

    bool reachesHeights(const CollisionObject &object, double zMin, double zMax)
    {
        return visitShape(*object.geometry,
                          [&object, zMin, zMax](const auto &shape) {
                              return reaches(shape, object.pose, {zMin, zMax});
                          });
    }
}  // namespace ompl_mfa::collision
