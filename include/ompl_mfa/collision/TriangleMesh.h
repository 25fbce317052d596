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

#ifndef OMPL_MFA_COLLISION_TRIANGLE_MESH_
#define OMPL_MFA_COLLISION_TRIANGLE_MESH_

#include <filesystem>
#include <memory>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/math/triangle.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief The bounding volume hierarchy that every mesh is held in. */
    using MeshGeometry = fcl::BVHModel<fcl::OBBRSS<double>>;

    /** \brief Triangles of a mesh file, all nodes merged. */
    struct TriangleMesh
    {
        std::vector<fcl::Vector3d> vertices;
        std::vector<fcl::Triangle> triangles;

        /** \brief Mean over all vertices that assimp leaves after its post-processing, those of lines and points
            included: what OMPL.app takes as the centre of a robot. */
        fcl::Vector3d vertexMean{fcl::Vector3d::Zero()};

        /** \brief How many points and lines the file holds, which are left out, as OMPL.app does. */
        std::size_t skippedFaces{0};
    };

    /** \brief What becomes of the transform of a file's root node, where assimp puts the up axis and the unit that
        Collada and other formats declare. */
    enum class RootTransform
    {
        /** \brief OMPL.app's convention: it is applied, so that y is up and the unit is the metre. */
        Applied,

        /** \brief MoveIt's convention (`mesh_operations.cpp` of geometric_shapes): it is reset to identity, so that
            coordinates stay as the file has them. */
        Reset
    };

    /** \brief Read a mesh with assimp: the transforms of all nodes are applied, that of the root as `root` says, and
        polygons are cut into triangles. Points and lines are left out and counted.
        \throw InputError naming the file, where it is missing or unreadable, has no triangle, holds faces of which
        assimp loses some (triangle strips of PLY, polygons that cross themselves), or has a coordinate that is not
        finite. */
    OMPL_MFA_EXPORT TriangleMesh loadMesh(const std::filesystem::path &file,
                                          RootTransform root = RootTransform::Applied);

    /** \brief Whether assimp has a reader for the extension of this file's name. */
    OMPL_MFA_EXPORT bool isMeshFile(const std::filesystem::path &file);

    /** \brief Build the hierarchy over a mesh, shifted by `offset`.
        \throw std::invalid_argument where the mesh has no triangle. */
    OMPL_MFA_EXPORT std::shared_ptr<MeshGeometry> makeMeshGeometry(const TriangleMesh &mesh,
                                                                   const fcl::Vector3d &offset = fcl::Vector3d::Zero());
}  // namespace ompl_mfa::collision

#endif
