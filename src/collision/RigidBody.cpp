#include "ompl_mfa/collision/RigidBody.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fcl/geometry/shape/sphere.h>

#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/Scene.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // Points whose convex hull, grown by `margin`, holds the shape: then the farthest of them bounds the reach.
        struct Reach
        {
            std::vector<fcl::Vector3d> points;
            double margin{0.};
        };

        void addCorners(Reach &reach, const fcl::Vector3d &half)
        {
            for (int corner = 0; corner < 8; ++corner)
            {
                reach.points.emplace_back((corner & 1) != 0 ? half[0] : -half[0],
                                          (corner & 2) != 0 ? half[1] : -half[1],
                                          (corner & 4) != 0 ? half[2] : -half[2]);
            }
        }

        Reach reachOf(const fcl::CollisionGeometryd &geometry)
        {
            Reach reach;
            switch (geometry.getNodeType())
            {
                case fcl::GEOM_SPHERE:
                    reach.points.emplace_back(fcl::Vector3d::Zero());
                    reach.margin = static_cast<const fcl::Sphered &>(geometry).radius;
                    break;
                case fcl::BV_OBBRSS:
                {
                    const auto &mesh = static_cast<const MeshGeometry &>(geometry);
                    reach.points.assign(mesh.vertices, mesh.vertices + mesh.num_vertices);
                    break;
                }
                default:
                {
                    const fcl::AABBd box = boundingBox(geometry, fcl::Transform3d::Identity());
                    addCorners(reach, (box.max_ - box.min_) / 2.);
                    for (fcl::Vector3d &corner : reach.points)
                    {
                        corner += box.center();
                    }
                }
            }
            return reach;
        }
    }  // namespace

    RigidBody::RigidBody(std::vector<Shape> shapes)
      : shapes_(std::move(shapes))
    {
        if (shapes_.empty())
        {
            throw std::invalid_argument("RigidBody: a body needs at least one shape");
        }
        for (const Shape &shape : shapes_)
        {
            if (!shape.geometry)
            {
                throw std::invalid_argument("RigidBody: a shape has no geometry");
            }
            const Reach reach = reachOf(*shape.geometry);
            for (const fcl::Vector3d &point : reach.points)
            {
                const fcl::Vector3d inBody = shape.pose * point;
                radius_ = std::max(radius_, inBody.norm() + reach.margin);
                planarRadius_ = std::max(planarRadius_, inBody.head<2>().norm() + reach.margin);
            }
        }
    }

    RigidBody RigidBody::sphere(double radius)
    {
        return RigidBody({{makePrimitive(*findPrimitiveKind("sphere"), {radius})}});
    }

    RigidBody RigidBody::box(double lengthX, double lengthY, double lengthZ)
    {
        return RigidBody({{makePrimitive(*findPrimitiveKind("box"), {lengthX, lengthY, lengthZ})}});
    }
}  // namespace ompl_mfa::collision
