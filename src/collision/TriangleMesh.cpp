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

#include "ompl_mfa/collision/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "collision/PlyFile.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/Scene.h"
#include "text/CLocaleScope.h"

namespace ompl_mfa::collision
{
    namespace
    {
        struct VertexSum
        {
            fcl::Vector3d sum{fcl::Vector3d::Zero()};
            std::size_t count{0};
        };

        void appendMesh(const aiMesh &source, const aiMatrix4x4 &transform, TriangleMesh &mesh, VertexSum &all)
        {
            const std::size_t first = mesh.vertices.size();
            const bool hasTriangles = (source.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0;
            for (unsigned int i = 0; i < source.mNumVertices; ++i)
            {
                const aiVector3D v = transform * source.mVertices[i];
                const fcl::Vector3d vertex(v.x, v.y, v.z);
                all.sum += vertex;
                ++all.count;
                if (hasTriangles)
                {
                    mesh.vertices.push_back(vertex);
                }
            }
            for (unsigned int i = 0; hasTriangles && i < source.mNumFaces; ++i)
            {
                const aiFace &face = source.mFaces[i];
                if (face.mNumIndices == 3)
                {
                    mesh.triangles.emplace_back(first + face.mIndices[0], first + face.mIndices[1],
                                                first + face.mIndices[2]);
                }
            }
        }

        void appendNode(const aiScene &scene, const aiNode &node, const aiMatrix4x4 &parent, TriangleMesh &mesh,
                        VertexSum &all)
        {
            const aiMatrix4x4 transform = parent * node.mTransformation;
            for (unsigned int i = 0; i < node.mNumMeshes; ++i)
            {
                appendMesh(*scene.mMeshes[node.mMeshes[i]], transform, mesh, all);
            }
            for (unsigned int i = 0; i < node.mNumChildren; ++i)
            {
                appendNode(scene, *node.mChildren[i], transform, mesh, all);
            }
        }

        void requireFinite(const fcl::Vector3d &vertex, const std::string &file)
        {
            if (!vertex.allFinite())
            {
                throw InputError(file + ": mesh has a vertex with a coordinate that is not a finite number");
            }
            if (vertex.cwiseAbs().maxCoeff() > LARGEST_COORDINATE)
            {
                throw InputError(file +
                                 ": mesh has a vertex with a coordinate beyond 1e30, of which distances overflow");
            }
        }

        // Joining vertices merges a NaN vertex with any other and reads vertex indices without a check. So both are
        // checked first.
        void requireSound(const aiScene &scene, const std::string &file)
        {
            std::size_t wild = 0;
            for (unsigned int i = 0; i < scene.mNumMeshes; ++i)
            {
                const aiMesh &mesh = *scene.mMeshes[i];
                for (unsigned int j = 0; j < mesh.mNumVertices; ++j)
                {
                    requireFinite({mesh.mVertices[j].x, mesh.mVertices[j].y, mesh.mVertices[j].z}, file);
                }
                for (unsigned int j = 0; j < mesh.mNumFaces; ++j)
                {
                    const aiFace &face = mesh.mFaces[j];
                    wild += std::any_of(face.mIndices, face.mIndices + face.mNumIndices,
                                        [&mesh](unsigned int index) { return index >= mesh.mNumVertices; })
                                ? 1
                                : 0;
                }
            }
            if (wild > 0)
            {
                throw InputError(file + ": mesh has " + std::to_string(wild) + (wild == 1 ? " face" : " faces") +
                                 " with a vertex that does not exist");
            }
        }

        struct FaceCount
        {
            // A polygon of n corners gives n - 2 triangles. assimp has lost a face without corners.
            std::size_t triangles{0};
            std::size_t pointsAndLines{0};
        };

        // A mesh referenced by several nodes is counted for each.
        FaceCount countFaces(const aiScene &scene, const aiNode &node)
        {
            FaceCount count;
            for (unsigned int i = 0; i < node.mNumMeshes; ++i)
            {
                const aiMesh &mesh = *scene.mMeshes[node.mMeshes[i]];
                for (unsigned int j = 0; j < mesh.mNumFaces; ++j)
                {
                    const unsigned int corners = mesh.mFaces[j].mNumIndices;
                    const bool flat = corners == 1 || corners == 2;
                    count.pointsAndLines += flat ? 1 : 0;
                    count.triangles += flat ? 0 : std::max(corners, 3U) - 2;
                }
            }
            for (unsigned int i = 0; i < node.mNumChildren; ++i)
            {
                const FaceCount below = countFaces(scene, *node.mChildren[i]);
                count.triangles += below.triangles;
                count.pointsAndLines += below.pointsAndLines;
            }
            return count;
        }

        // The faces as they are in the file. Throws if assimp cannot read it.
        const aiScene &readScene(Assimp::Importer &importer, const std::string &file)
        {
            // Some of assimp's readers (AMF, X3D, 3MF) convert numbers with strtod().
            const text::CLocaleScope plainNumbers;
            // Otherwise assimp makes a mesh of bones from a file without geometry.
            importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
            const aiScene *scene = importer.ReadFile(file, 0);
            if (scene == nullptr || scene->mRootNode == nullptr)
            {
                throw InputError(file + ": not a readable mesh: " + importer.GetErrorString());
            }
            if (scene->mNumMeshes == 0)
            {
                throw InputError(file + ": mesh has no triangles");
            }
            requireSound(*scene, file);
            return *scene;
        }

        const aiScene &makeTriangles(Assimp::Importer &importer, const std::string &file)
        {
            const aiScene *scene = importer.ApplyPostProcessing(aiProcess_GenNormals | aiProcess_Triangulate |
                                                                aiProcess_JoinIdenticalVertices |
                                                                aiProcess_SortByPType | aiProcess_OptimizeGraph);
            if (scene == nullptr || scene->mRootNode == nullptr)
            {
                throw InputError(file + ": not a readable mesh: " + importer.GetErrorString());
            }
            return *scene;
        }

        void requireAll(const FaceCount &faces, const TriangleMesh &mesh, const std::string &file)
        {
            if (mesh.triangles.size() < faces.triangles)
            {
                throw InputError(file + ": " + std::to_string(faces.triangles - mesh.triangles.size()) + " of " +
                                 std::to_string(faces.triangles) +
                                 " triangles of the mesh are lost; accepted are faces that do not cross themselves");
            }
            if (mesh.triangles.empty())
            {
                throw InputError(file + ": mesh has no triangles");
            }
        }
    }  // namespace

    TriangleMesh loadMesh(const std::filesystem::path &file, RootTransform root)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": mesh file not found");
        }
        requireWholePly(file);
        Assimp::Importer importer;
        const aiScene &read = readScene(importer, file.string());
        const FaceCount faces = countFaces(read, *read.mRootNode);
        if (root == RootTransform::Reset)
        {
            // Before the nodes are merged.
            read.mRootNode->mTransformation = aiMatrix4x4();
        }
        const aiScene &scene = makeTriangles(importer, file.string());
        TriangleMesh mesh;
        VertexSum all;
        appendNode(scene, *scene.mRootNode, aiMatrix4x4(), mesh, all);
        requireAll(faces, mesh, file.string());
        // A transform may be invalid although all vertices are valid.
        for (const fcl::Vector3d &vertex : mesh.vertices)
        {
            requireFinite(vertex, file.string());
        }
        mesh.vertexMean = all.sum / static_cast<double>(all.count);
        mesh.skippedFaces = faces.pointsAndLines;
        return mesh;
    }

    bool isMeshFile(const std::filesystem::path &file)
    {
        const std::string extension = file.extension().string();
        return !extension.empty() && Assimp::Importer().IsExtensionSupported(extension);
    }

    std::shared_ptr<MeshGeometry> makeMeshGeometry(const TriangleMesh &mesh, const fcl::Vector3d &offset)
    {
        if (mesh.triangles.empty())
        {
            throw std::invalid_argument("makeMeshGeometry: a mesh needs at least one triangle");
        }
        std::vector<fcl::Vector3d> vertices = mesh.vertices;
        for (fcl::Vector3d &vertex : vertices)
        {
            vertex += offset;
        }
        auto geometry = std::make_shared<MeshGeometry>();
        geometry->beginModel(static_cast<int>(mesh.triangles.size()), static_cast<int>(vertices.size()));
        geometry->addSubModel(vertices, mesh.triangles);
        geometry->endModel();
        geometry->computeLocalAABB();
        return geometry;
    }
}  // namespace ompl_mfa::collision
