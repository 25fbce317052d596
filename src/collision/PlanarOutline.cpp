#include "ompl_mfa/collision/PlanarOutline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fcl/geometry/octree/octree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        constexpr int roundCorners = 96;

        struct Slab
        {
            double zMin;
            double zMax;
        };

        using Points = std::vector<fcl::Vector3d>;

        // Points of the segment ab within the slab: its ends, and where it crosses the two planes.
        void clipSegment(const fcl::Vector3d &a, const fcl::Vector3d &b, const Slab &slab, Polygon &kept)
        {
            if (a.z() >= slab.zMin && a.z() <= slab.zMax)
            {
                kept.emplace_back(a.head<2>());
            }
            for (const double z : {slab.zMin, slab.zMax})
            {
                if ((a.z() - z) * (b.z() - z) < 0.)
                {
                    const double share = (z - a.z()) / (b.z() - a.z());
                    kept.emplace_back((a + share * (b - a)).head<2>());
                }
            }
        }

        double cross(const Eigen::Vector2d &o, const Eigen::Vector2d &a, const Eigen::Vector2d &b)
        {
            return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
        }

        // Andrew's monotone chain, counter-clockwise; a segment where all points are on a line. Points that only
        // rounding puts off an edge are no corners.
        Polygon convexHull(Polygon points)
        {
            std::sort(points.begin(), points.end(),
                      [](const Eigen::Vector2d &a, const Eigen::Vector2d &b)
                      { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
            points.erase(std::unique(points.begin(), points.end()), points.end());
            if (points.size() < 3)
            {
                return points;
            }
            const double rounding = 1e-12 * (points.back() - points.front()).squaredNorm();
            Polygon hull;
            for (int pass = 0; pass < 2; ++pass)
            {
                const std::size_t start = hull.size();
                for (const Eigen::Vector2d &point : points)
                {
                    while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= rounding)
                    {
                        hull.pop_back();
                    }
                    hull.push_back(point);
                }
                hull.pop_back();
                std::reverse(points.begin(), points.end());
            }
            return hull;
        }

        // Two rings of corners around z, and every segment between corners of the two: the hull of what the slab
        // keeps of them is the hull of what it keeps of the solid.
        Points ring(double radius, double z)
        {
            Points points;
            for (int i = 0; i < roundCorners; ++i)
            {
                const double angle = 2. * M_PI * i / roundCorners;
                points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
            }
            return points;
        }

        Points boxCorners(const fcl::Vector3d &side)
        {
            Points points;
            for (int corner = 0; corner < 8; ++corner)
            {
                points.emplace_back(((corner & 1) != 0 ? 0.5 : -0.5) * side[0],
                                    ((corner & 2) != 0 ? 0.5 : -0.5) * side[1],
                                    ((corner & 4) != 0 ? 0.5 : -0.5) * side[2]);
            }
            return points;
        }

        Points solidCorners(const fcl::CollisionGeometryd &geometry)
        {
            switch (geometry.getNodeType())
            {
                case fcl::GEOM_BOX:
                    return boxCorners(static_cast<const fcl::Boxd &>(geometry).side);
                case fcl::GEOM_CYLINDER:
                {
                    const auto &cylinder = static_cast<const fcl::Cylinderd &>(geometry);
                    Points points = ring(cylinder.radius, -cylinder.lz / 2.);
                    const Points top = ring(cylinder.radius, cylinder.lz / 2.);
                    points.insert(points.end(), top.begin(), top.end());
                    return points;
                }
                case fcl::GEOM_CONE:
                {
                    const auto &cone = static_cast<const fcl::Coned &>(geometry);
                    Points points = ring(cone.radius, -cone.lz / 2.);
                    points.emplace_back(0., 0., cone.lz / 2.);
                    return points;
                }
                default:
                    throw std::invalid_argument("planarOutline: no outline is known for this kind of FCL geometry");
            }
        }

        void appendOutline(Polygon polygon, std::vector<Polygon> &outlines)
        {
            if (polygon.size() >= 2)
            {
                outlines.push_back(std::move(polygon));
            }
        }

        void appendConvex(const Points &corners, const fcl::Transform3d &pose, const Slab &slab,
                          std::vector<Polygon> &outlines)
        {
            Points placed;
            for (const fcl::Vector3d &corner : corners)
            {
                placed.emplace_back(pose * corner);
            }
            Polygon kept;
            for (const fcl::Vector3d &a : placed)
            {
                for (const fcl::Vector3d &b : placed)
                {
                    if (&a != &b)
                    {
                        clipSegment(a, b, slab, kept);
                    }
                }
            }
            appendOutline(convexHull(std::move(kept)), outlines);
        }

        void appendSphere(const fcl::Sphered &sphere, const fcl::Vector3d &centre, const Slab &slab,
                          std::vector<Polygon> &outlines)
        {
            const double height = std::clamp(centre.z(), slab.zMin, slab.zMax) - centre.z();
            if (std::abs(height) >= sphere.radius)
            {
                return;
            }
            Polygon circle;
            for (const fcl::Vector3d &point : ring(std::sqrt(sphere.radius * sphere.radius - height * height), 0.))
            {
                circle.emplace_back(centre.head<2>() + point.head<2>());
            }
            outlines.push_back(std::move(circle));
        }

        void appendMesh(const MeshGeometry &mesh, const fcl::Transform3d &pose, const Slab &slab,
                        std::vector<Polygon> &outlines)
        {
            for (int i = 0; i < mesh.num_tris; ++i)
            {
                const fcl::Triangle &triangle = mesh.tri_indices[i];
                const Points corners{mesh.vertices[triangle[0]], mesh.vertices[triangle[1]],
                                     mesh.vertices[triangle[2]]};
                appendConvex(corners, pose, slab, outlines);
            }
        }

        void appendCells(const fcl::OcTree<double> &map, const fcl::Transform3d &pose, const Slab &slab,
                         std::vector<Polygon> &outlines)
        {
            for (const auto &cell : map.toBoxes())
            {
                const fcl::Transform3d cellPose = pose * Eigen::Translation3d(cell[0], cell[1], cell[2]);
                appendConvex(boxCorners(fcl::Vector3d::Constant(cell[3])), cellPose, slab, outlines);
            }
        }
    }  // namespace

    std::vector<Polygon> planarOutline(const CollisionObject &object, double zMin, double zMax)
    {
        if (!(zMin <= zMax))
        {
            throw std::invalid_argument("planarOutline: zMin must not exceed zMax");
        }
        const Slab slab{zMin, zMax};
        std::vector<Polygon> outlines;
        switch (object.geometry->getNodeType())
        {
            case fcl::GEOM_SPHERE:
                appendSphere(static_cast<const fcl::Sphered &>(*object.geometry), object.pose.translation(), slab,
                             outlines);
                break;
            case fcl::BV_OBBRSS:
                appendMesh(static_cast<const MeshGeometry &>(*object.geometry), object.pose, slab, outlines);
                break;
            case fcl::GEOM_OCTREE:
                appendCells(static_cast<const fcl::OcTree<double> &>(*object.geometry), object.pose, slab, outlines);
                break;
            default:
                appendConvex(solidCorners(*object.geometry), object.pose, slab, outlines);
        }
        return outlines;
    }
}  // namespace ompl_mfa::collision
