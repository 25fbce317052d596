#include "ompl_mfa/collision/Scene.h"

#include <stdexcept>

#include <fcl/geometry/octree/octree.h>
#include <fcl/geometry/shape/utility.h>

#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        template <typename Shape>
        fcl::AABBd shapeBox(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose)
        {
            fcl::AABBd box;
            fcl::computeBV(static_cast<const Shape &>(geometry), pose, box);
            return box;
        }

        fcl::AABBd meshBox(const MeshGeometry &mesh, const fcl::Transform3d &pose)
        {
            fcl::AABBd box;
            for (int i = 0; i < mesh.num_vertices; ++i)
            {
                box += fcl::Vector3d(pose * mesh.vertices[i]);
            }
            return box;
        }

        fcl::AABBd occupiedBox(const fcl::OcTree<double> &map, const fcl::Transform3d &pose)
        {
            fcl::AABBd box;
            for (const auto &cell : map.toBoxes())
            {
                const fcl::Boxd shape(fcl::Vector3d::Constant(cell[3]));
                const fcl::Transform3d cellPose = pose * Eigen::Translation3d(cell[0], cell[1], cell[2]);
                box += shapeBox<fcl::Boxd>(shape, cellPose);
            }
            return box;
        }
    }  // namespace

    void Scene::add(CollisionObject object)
    {
        if (!object.geometry)
        {
            throw std::invalid_argument("Scene: obstacle '" + object.id + "' has no geometry");
        }
        objects_.push_back(std::move(object));
    }

    fcl::AABBd Scene::bounds() const
    {
        fcl::AABBd box;
        for (const CollisionObject &object : objects_)
        {
            box += boundingBox(*object.geometry, object.pose);
        }
        return box;
    }

    fcl::AABBd boundingBox(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose)
    {
        switch (geometry.getNodeType())
        {
            case fcl::GEOM_BOX:
                return shapeBox<fcl::Boxd>(geometry, pose);
            case fcl::GEOM_SPHERE:
                return shapeBox<fcl::Sphered>(geometry, pose);
            case fcl::GEOM_CYLINDER:
                return shapeBox<fcl::Cylinderd>(geometry, pose);
            case fcl::GEOM_CONE:
                return shapeBox<fcl::Coned>(geometry, pose);
            case fcl::BV_OBBRSS:
                return meshBox(static_cast<const MeshGeometry &>(geometry), pose);
            case fcl::GEOM_OCTREE:
                return occupiedBox(static_cast<const fcl::OcTree<double> &>(geometry), pose);
            default:
                throw std::invalid_argument("boundingBox: no box is known for this kind of FCL geometry");
        }
    }
}  // namespace ompl_mfa::collision
