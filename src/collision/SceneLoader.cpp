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

#include "ompl_mfa/collision/SceneLoader.h"

#include <algorithm>
#include <string>
#include <vector>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "ompl_mfa/collision/OccupancyMap.h"
#include "ompl_mfa/collision/PlanningScene.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    namespace
    {
        using Folders = std::vector<std::filesystem::path>;

        Scene sceneOf(const std::filesystem::path &file, std::shared_ptr<fcl::CollisionGeometryd> geometry,
                      std::size_t skippedFaces = 0)
        {
            Scene scene;
            scene.add({file.stem().string(), std::move(geometry), fcl::Transform3d::Identity(), skippedFaces});
            return scene;
        }

        Scene loadOccupancyScene(const std::filesystem::path &file, const Folders & /*packageFolders*/)
        {
            return sceneOf(file, loadOccupancyMap(file));
        }

        Scene loadMeshScene(const std::filesystem::path &file, const Folders & /*packageFolders*/)
        {
            const TriangleMesh mesh = loadMesh(file);
            return sceneOf(file, makeMeshGeometry(mesh), mesh.skippedFaces);
        }

        Scene loadTextScene(const std::filesystem::path &file, const Folders & /*packageFolders*/)
        {
            return collision::loadTextScene(file);
        }

        RigidBody bodyOf(const Scene &scene)
        {
            std::vector<RigidBody::Shape> shapes;
            for (const CollisionObject &object : scene.objects())
            {
                shapes.push_back({object.geometry, object.pose, object.skippedFaces});
            }
            return RigidBody(std::move(shapes));
        }

        RigidBody loadSceneRobot(const std::filesystem::path &file, RobotCentring /*centring*/,
                                 const Folders &packageFolders)
        {
            return bodyOf(loadPlanningScene(file, packageFolders));
        }

        RigidBody loadTextRobot(const std::filesystem::path &file, RobotCentring /*centring*/,
                                const Folders & /*packageFolders*/)
        {
            return bodyOf(collision::loadTextScene(file));
        }

        RigidBody loadMeshRobot(const std::filesystem::path &file, RobotCentring centring,
                                const Folders & /*packageFolders*/)
        {
            const TriangleMesh mesh = loadMesh(file);
            fcl::Vector3d offset = fcl::Vector3d::Zero();
            if (centring != RobotCentring::None)
            {
                offset = -mesh.vertexMean;
            }
            if (centring == RobotCentring::PlanarVertexMean)
            {
                offset.z() = 0.;
            }
            return RigidBody({{makeMeshGeometry(mesh, offset), fcl::Transform3d::Identity(), mesh.skippedFaces}});
        }

        // A kind of file, with its readers for worlds and robots.
        struct FileKind
        {
            const char *name;
            std::vector<std::string> extensions;
            Scene (*scene)(const std::filesystem::path &, const Folders &);

            // Null if such a file cannot describe a robot.
            RigidBody (*robot)(const std::filesystem::path &, RobotCentring, const Folders &);
        };

        // All kinds of files. The last one reads any other of the some fifty formats that assimp supports; its
        // extensions are those listed in an error.
        const std::vector<FileKind> &fileKinds()
        {
            static const std::vector<FileKind> KINDS{
                {"planning scenes", {".yaml", ".yml"}, loadPlanningScene, loadSceneRobot},
                {"planning scenes as text", {".scene"}, loadTextScene, loadTextRobot},
                {"OctoMaps", {".bt", ".ot"}, loadOccupancyScene, nullptr},
                {"meshes", {".dae", ".obj", ".ply", ".stl", "others that assimp reads"}, loadMeshScene, loadMeshRobot},
            };
            return KINDS;
        }

        const FileKind *findKind(const std::filesystem::path &file)
        {
            const std::string extension = lowerCase(file.extension().string());
            for (const FileKind &kind : fileKinds())
            {
                if (std::find(kind.extensions.begin(), kind.extensions.end(), extension) != kind.extensions.end())
                {
                    return &kind;
                }
            }
            return isMeshFile(file) ? &fileKinds().back() : nullptr;
        }

        std::string acceptedKinds(bool robots)
        {
            std::string kinds;
            for (const FileKind &kind : fileKinds())
            {
                if (robots && kind.robot == nullptr)
                {
                    continue;
                }
                std::string extensions;
                for (const std::string &extension : kind.extensions)
                {
                    extensions += (extensions.empty() ? "" : ", ") + extension;
                }
                kinds += (kinds.empty() ? "" : ", ") + std::string(kind.name) + " (" + extensions + ")";
            }
            return kinds;
        }

        const FileKind &kindOf(const std::filesystem::path &file, bool robot)
        {
            const FileKind *kind = findKind(file);
            if (kind == nullptr)
            {
                const std::string extension = file.extension().string();
                throw InputError(file.string() + ": unknown kind of file" +
                                 (extension.empty() ? " without an extension" : " '" + extension + "'") +
                                 "; accepted are " + acceptedKinds(robot));
            }
            return *kind;
        }
    }  // namespace

    Scene loadScene(const std::filesystem::path &file, const std::vector<std::filesystem::path> &packageFolders)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": world file not found");
        }
        return kindOf(file, false).scene(file, packageFolders);
    }

    RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring,
                        const std::vector<std::filesystem::path> &packageFolders)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": robot file not found");
        }
        const FileKind &kind = kindOf(file, true);
        if (kind.robot == nullptr)
        {
            throw InputError(file.string() + ": " + kind.name + " cannot be a robot; accepted are " +
                             acceptedKinds(true));
        }
        return kind.robot(file, centring, packageFolders);
    }
}  // namespace ompl_mfa::collision
