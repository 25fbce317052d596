#include "collision/ShapeReach.h"

#include <algorithm>

#include "collision/ShapeKinds.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    namespace
    {
        void extend(ShapeReach &reach, const fcl::Vector3d &point)
        {
            reach.core = std::max(reach.core, point.norm());
            reach.planarCore = std::max(reach.planarCore, point.head<2>().norm());
        }

        void extend(ShapeReach &reach, const fcl::AABBd &box, const fcl::Transform3d &pose)
        {
            for (int corner = 0; corner < 8; ++corner)
            {
                extend(reach, pose * fcl::Vector3d((corner & 1) != 0 ? box.max_[0] : box.min_[0],
                                                   (corner & 2) != 0 ? box.max_[1] : box.min_[1],
                                                   (corner & 4) != 0 ? box.max_[2] : box.min_[2]));
            }
        }
    }  // namespace

    ShapeReach shapeReach(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose)
    {
        ShapeReach reach;
        visitShape(geometry, Overloaded{[&reach, &pose](const MeshGeometry &mesh)
                                        {
                                            for (int i = 0; i < mesh.num_vertices; ++i)
                                            {
                                                extend(reach, pose * mesh.vertices[i]);
                                            }
                                        },
                                        [&reach, &pose](const OccupancyTree &map)
                                        { extend(reach, boundingBox(map, fcl::Transform3d::Identity()), pose); },
                                        [&reach, &pose](const auto &primitive)
                                        {
                                            using Shape = std::decay_t<decltype(primitive)>;
                                            reach.margin = ShapeTraits<Shape>::margin(primitive);
                                            extend(reach, coreBox(primitive), pose);
                                        }});
        return reach;
    }
}  // namespace ompl_mfa::collision
