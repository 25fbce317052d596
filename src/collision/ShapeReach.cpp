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
