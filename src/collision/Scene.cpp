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

#include "ompl_mfa/collision/Scene.h"

#include <stdexcept>

#include "collision/ShapeKinds.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // The farthest points along the axes of the world, in both directions.
        template <typename Shape>
        fcl::AABBd primitiveBox(const Shape &primitive, const fcl::Transform3d &pose)
        {
            const double margin = ShapeTraits<Shape>::margin(primitive);
            fcl::AABBd box;
            for (int axis = 0; axis < 3; ++axis)
            {
                const fcl::Vector3d up = pose.linear().row(axis);
                const double centre = pose.translation()[axis];
                box.min_[axis] = centre + up.dot(ShapeTraits<Shape>::support(primitive, -up)) - margin;
                box.max_[axis] = centre + up.dot(ShapeTraits<Shape>::support(primitive, up)) + margin;
            }
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

        fcl::AABBd occupiedBox(const OccupancyTree &map, const fcl::Transform3d &pose)
        {
            fcl::AABBd box;
            for (const auto &cell : map.toBoxes())
            {
                const fcl::Boxd shape(fcl::Vector3d::Constant(cell[3]));
                const fcl::Transform3d cellPose = pose * Eigen::Translation3d(cell[0], cell[1], cell[2]);
                box += primitiveBox(shape, cellPose);
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

    std::size_t Scene::skippedFaces() const
    {
        std::size_t faces = 0;
        for (const CollisionObject &object : objects_)
        {
            faces += object.skippedFaces;
        }
        return faces;
    }

    fcl::AABBd boundingBox(const fcl::CollisionGeometryd &geometry, const fcl::Transform3d &pose)
    {
        return visitShape(geometry,
                          Overloaded{[&pose](const MeshGeometry &mesh) { return meshBox(mesh, pose); },
                                     [&pose](const OccupancyTree &map) { return occupiedBox(map, pose); },
                                     [&pose](const auto &primitive) { return primitiveBox(primitive, pose); }});
    }
}  // namespace ompl_mfa::collision
