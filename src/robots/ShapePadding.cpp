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

#include "robots/ShapePadding.h"

#include <vector>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/TriangleMesh.h"
#include "text/NumberText.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

        double enlarged(double length, double scale, double padding)
        {
            const double result = scale * length + padding;
            if (!(result > 0.))
            {
                throw InputError("a shape of size " + text::numberText(length, 6) + " vanishes with scale " +
                                 text::numberText(scale) + " and padding " + text::numberText(padding));
            }
            return result;
        }

        Geometry paddedMesh(const collision::MeshGeometry &mesh, double scale, double padding)
        {
            collision::TriangleMesh result;
            result.vertices.assign(mesh.vertices, mesh.vertices + mesh.num_vertices);
            result.triangles.assign(mesh.tri_indices, mesh.tri_indices + mesh.num_tris);
            fcl::Vector3d mean = fcl::Vector3d::Zero();
            for (const fcl::Vector3d &vertex : result.vertices)
            {
                mean += vertex / static_cast<double>(result.vertices.size());
            }
            constexpr double AT_MEAN = 1e-6;
            for (fcl::Vector3d &vertex : result.vertices)
            {
                const fcl::Vector3d offset = vertex - mean;
                const double length = offset.norm();
                vertex = mean + offset * (length > AT_MEAN ? scale + padding / length : scale);
            }
            return collision::makeMeshGeometry(result);
        }
    }  // namespace

    Geometry paddedShape(const Geometry &shape, double scale, double padding)
    {
        if (scale == 1. && padding == 0.)
        {
            return shape;
        }
        switch (shape->getNodeType())
        {
            case fcl::GEOM_BOX:
            {
                const fcl::Vector3d &side = static_cast<const fcl::Boxd &>(*shape).side;
                return std::make_shared<fcl::Boxd>(enlarged(side[0], scale, 2. * padding),
                                                   enlarged(side[1], scale, 2. * padding),
                                                   enlarged(side[2], scale, 2. * padding));
            }
            case fcl::GEOM_SPHERE:
                return std::make_shared<fcl::Sphered>(
                    enlarged(static_cast<const fcl::Sphered &>(*shape).radius, scale, padding));
            case fcl::GEOM_CYLINDER:
            {
                const auto &cylinder = static_cast<const fcl::Cylinderd &>(*shape);
                return std::make_shared<fcl::Cylinderd>(enlarged(cylinder.radius, scale, padding),
                                                        enlarged(cylinder.lz, scale, 2. * padding));
            }
            case fcl::GEOM_CONE:
            {
                const auto &cone = static_cast<const fcl::Coned &>(*shape);
                return std::make_shared<fcl::Coned>(enlarged(cone.radius, scale, padding),
                                                    enlarged(cone.lz, scale, 2. * padding));
            }
            case fcl::GEOM_CAPSULE:
            {
                const auto &capsule = static_cast<const fcl::Capsuled &>(*shape);
                return std::make_shared<fcl::Capsuled>(enlarged(capsule.radius, scale, padding),
                                                       enlarged(capsule.lz, scale, 0.));
            }
            case fcl::BV_OBBRSS:
                return paddedMesh(static_cast<const collision::MeshGeometry &>(*shape), scale, padding);
            default:
                throw InputError("an occupancy map cannot be padded or scaled");
        }
    }
}  // namespace ompl_mfa::robots
