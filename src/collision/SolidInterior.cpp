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

#include "collision/SolidInterior.h"

#include <algorithm>

#include "collision/ShapeKinds.h"

namespace ompl_mfa::collision
{
    SolidInterior::SolidInterior(const fcl::CollisionGeometryd &geometry, const std::string &name)
    {
        visitShape(geometry,
                   Overloaded{[this, &name](const MeshGeometry &mesh)
                              {
                                  inside_ = std::make_unique<ClosedMesh>(mesh, name);
                                  witnesses_ = ClosedMesh::partVertices(mesh);
                              },
                              [this](const OccupancyTree &map)
                              {
                                  for (const auto &cell : map.toBoxes())
                                  {
                                      witnesses_.emplace_back(cell[0], cell[1], cell[2]);
                                  }
                              },
                              [this](const auto & /*primitive*/) { witnesses_.emplace_back(fcl::Vector3d::Zero()); }});
    }

    bool SolidInterior::holds(const fcl::Transform3d &pose, const SolidInterior &other,
                              const fcl::Transform3d &otherPose) const
    {
        if (!inside_)
        {
            return false;
        }
        const fcl::Transform3d relative = pose.inverse() * otherPose;
        return std::any_of(other.witnesses_.begin(), other.witnesses_.end(),
                           [this, &relative](const fcl::Vector3d &witness)
                           { return inside_->contains(relative * witness); });
    }

    bool SolidInterior::oneHoldsTheOther(const SolidInterior &a, const fcl::Transform3d &poseA, const SolidInterior &b,
                                         const fcl::Transform3d &poseB)
    {
        return a.holds(poseA, b, poseB) || b.holds(poseB, a, poseA);
    }
}  // namespace ompl_mfa::collision
