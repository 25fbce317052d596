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

#include "collision/ClosedMesh.h"

#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <boost/function_output_iterator.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include "ompl_mfa/InputError.h"

namespace bg = boost::geometry;

namespace ompl_mfa::collision
{
    namespace
    {
        using Point = bg::model::point<double, 3, bg::cs::cartesian>;
        using Box = bg::model::box<Point>;

        // Mesh files repeat a vertex for each of its normals, so vertices are merged by position.
        std::vector<std::size_t> weld(const MeshGeometry &mesh)
        {
            std::map<std::array<double, 3>, std::size_t> first;
            std::vector<std::size_t> welded;
            for (int i = 0; i < mesh.num_vertices; ++i)
            {
                const fcl::Vector3d &v = mesh.vertices[i];
                welded.push_back(first.emplace(std::array<double, 3>{v[0], v[1], v[2]}, welded.size()).first->second);
            }
            return welded;
        }

        std::size_t rimEdges(const MeshGeometry &mesh)
        {
            const std::vector<std::size_t> welded = weld(mesh);
            std::map<std::pair<std::size_t, std::size_t>, int> triangles;
            for (int i = 0; i < mesh.num_tris; ++i)
            {
                for (int side = 0; side < 3; ++side)
                {
                    const std::size_t a = welded[mesh.tri_indices[i][side]];
                    const std::size_t b = welded[mesh.tri_indices[i][(side + 1) % 3]];
                    ++triangles[std::minmax(a, b)];
                }
            }
            std::size_t rim = 0;
            for (const auto &[edge, count] : triangles)
            {
                rim += edge.first != edge.second && count % 2 != 0 ? 1 : 0;
            }
            return rim;
        }

        // Whether a ray from the origin along +x crosses the edge. The ends are sorted first, so that both triangles of
        // an edge yield exactly the same result.
        bool crossesEdge(Eigen::Vector2d a, Eigen::Vector2d b)
        {
            if (a.y() > b.y() || (a.y() == b.y() && a.x() > b.x()))
            {
                a.swap(b);
            }
            return (a.y() > 0.) != (b.y() > 0.) && a.x() * b.y() - a.y() * b.x() > 0.;
        }

        bool isBelow(const fcl::Vector3d &point, const fcl::Vector3d &a, const fcl::Vector3d &b, const fcl::Vector3d &c)
        {
            const fcl::Vector3d normal = (b - a).cross(c - a);
            return normal.dot(point - a) * normal.z() < 0.;
        }
    }  // namespace

    struct ClosedMesh::Index
    {
        bg::index::rtree<std::pair<Box, int>, bg::index::quadratic<16>> triangles;
        fcl::AABBd bounds;
    };

    ClosedMesh::ClosedMesh(const MeshGeometry &mesh, const std::string &name)
      : mesh_(mesh)
      , index_(std::make_unique<Index>())
    {
        const std::size_t rim = rimEdges(mesh);
        if (rim > 0)
        {
            throw InputError(name + ": the mesh is not closed (" + std::to_string(rim) +
                             " edges belong to an odd number of triangles), so it has no inside");
        }
        std::vector<std::pair<Box, int>> boxes;
        for (int i = 0; i < mesh.num_tris; ++i)
        {
            fcl::AABBd box;
            for (int corner = 0; corner < 3; ++corner)
            {
                box += mesh.vertices[mesh.tri_indices[i][corner]];
            }
            index_->bounds += box;
            boxes.emplace_back(Box({box.min_[0], box.min_[1], box.min_[2]}, {box.max_[0], box.max_[1], box.max_[2]}),
                               i);
        }
        index_->triangles = decltype(index_->triangles)(boxes);
    }

    ClosedMesh::~ClosedMesh() = default;

    bool ClosedMesh::contains(const fcl::Vector3d &point) const
    {
        if (!index_->bounds.contain(point))
        {
            return false;
        }
        bool inside = false;
        const auto crossing = [this, &point, &inside](const std::pair<Box, int> &entry)
        {
            const fcl::Triangle &triangle = mesh_.tri_indices[entry.second];
            const fcl::Vector3d &a = mesh_.vertices[triangle[0]];
            const fcl::Vector3d &b = mesh_.vertices[triangle[1]];
            const fcl::Vector3d &c = mesh_.vertices[triangle[2]];
            const Eigen::Vector2d pa = (a - point).head<2>();
            const Eigen::Vector2d pb = (b - point).head<2>();
            const Eigen::Vector2d pc = (c - point).head<2>();
            const bool under = (crossesEdge(pa, pb) != crossesEdge(pb, pc)) != crossesEdge(pc, pa);
            inside = inside != (under && isBelow(point, a, b, c));
        };
        const Box ray({point[0], point[1], point[2]}, {point[0], point[1], std::numeric_limits<double>::max()});
        index_->triangles.query(bg::index::intersects(ray), boost::make_function_output_iterator(crossing));
        return inside;
    }

    std::vector<fcl::Vector3d> ClosedMesh::partVertices(const MeshGeometry &mesh)
    {
        std::vector<std::size_t> parent = weld(mesh);
        const auto root = [&parent](std::size_t i)
        {
            while (parent[i] != i)
            {
                i = parent[i];
            }
            return i;
        };
        for (int i = 0; i < mesh.num_tris; ++i)
        {
            const fcl::Triangle &triangle = mesh.tri_indices[i];
            parent[root(triangle[1])] = root(triangle[0]);
            parent[root(triangle[2])] = root(triangle[0]);
        }
        std::vector<bool> used(parent.size(), false);
        for (int i = 0; i < mesh.num_tris; ++i)
        {
            used[root(mesh.tri_indices[i][0])] = true;
        }
        std::vector<fcl::Vector3d> vertices;
        for (std::size_t i = 0; i < parent.size(); ++i)
        {
            if (used[i])
            {
                vertices.push_back(mesh.vertices[i]);
            }
        }
        return vertices;
    }
}  // namespace ompl_mfa::collision
