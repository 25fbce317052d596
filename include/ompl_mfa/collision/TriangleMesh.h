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
    /** \brief Bounding volume hierarchy of a mesh. */
    using MeshGeometry = fcl::BVHModel<fcl::OBBRSS<double>>;

    /** \brief Triangles of a mesh file, with all nodes merged. */
    struct TriangleMesh
    {
        std::vector<fcl::Vector3d> vertices;
        std::vector<fcl::Triangle> triangles;

        /** \brief Mean of all vertices after assimp's post-processing, including those of lines and points: OMPL.app's
            centre of a robot. */
        fcl::Vector3d vertexMean{fcl::Vector3d::Zero()};

        /** \brief Number of points and lines in the file. They are left out, as in OMPL.app. */
        std::size_t skippedFaces{0};
    };

    /** \brief Treatment of the transform of a file's root node, in which assimp stores the up axis and the unit
        declared by Collada and other formats. */
    enum class RootTransform
    {
        /** \brief OMPL.app's convention: applied, so that y is up and the unit is the metre. */
        Applied,

        /** \brief MoveIt's convention (`mesh_operations.cpp` of geometric_shapes): reset to identity, so that the
            coordinates are those of the file. */
        Reset
    };

    /** \brief Read a mesh with assimp: the transforms of all nodes are applied, that of the root according to `root`,
        and polygons are triangulated. Points and lines are left out but counted.
        \throw InputError naming the file, if it is missing or unreadable, has no triangle, contains faces that assimp
        loses (triangle strips of PLY, self-intersecting polygons), or has a coordinate that is not finite. */
    OMPL_MFA_EXPORT TriangleMesh loadMesh(const std::filesystem::path &file,
                                          RootTransform root = RootTransform::Applied);

    /** \brief Whether assimp reads files with this extension. */
    OMPL_MFA_EXPORT bool isMeshFile(const std::filesystem::path &file);

    /** \brief Build the hierarchy over a mesh, shifted by `offset`.
        \throw std::invalid_argument if the mesh has no triangle. */
    OMPL_MFA_EXPORT std::shared_ptr<MeshGeometry> makeMeshGeometry(const TriangleMesh &mesh,
                                                                   const fcl::Vector3d &offset = fcl::Vector3d::Zero());
}  // namespace ompl_mfa::collision

#endif
