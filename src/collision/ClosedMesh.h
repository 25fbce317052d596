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

#ifndef OMPL_MFA_COLLISION_CLOSED_MESH_
#define OMPL_MFA_COLLISION_CLOSED_MESH_

#include <memory>
#include <string>
#include <vector>

#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    /** \brief The solid that a closed surface mesh bounds.

        To FCL a mesh is a surface, so a body entirely inside touches nothing. A point is inside if an upward ray
        crosses the surface an odd number of times. Const functions are safe to call from several threads and allocate
        nothing. */
    class ClosedMesh
    {
    public:
        /** \param mesh its vertices are referenced, so it must outlive this object.
            \param name used in error messages.
            \throw InputError if an edge belongs to an odd number of triangles: the surface has a boundary. */
        ClosedMesh(const MeshGeometry &mesh, const std::string &name);
        ~ClosedMesh();
        ClosedMesh(const ClosedMesh &) = delete;
        ClosedMesh &operator=(const ClosedMesh &) = delete;

        /** \brief Whether a point, in the frame of the mesh, is inside. Undefined for points on the surface. */
        bool contains(const fcl::Vector3d &point) const;

        /** \brief One vertex of each connected component of the surface. If the surface touches no solid, each
            component is inside or outside a solid exactly if its vertex is. */
        static std::vector<fcl::Vector3d> partVertices(const MeshGeometry &mesh);

    private:
        struct Index;

        const MeshGeometry &mesh_;
        std::unique_ptr<Index> index_;
    };
}  // namespace ompl_mfa::collision

#endif
