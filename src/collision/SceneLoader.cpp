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
        Scene sceneOf(const std::filesystem::path &file, std::shared_ptr<fcl::CollisionGeometryd> geometry)
        {
            Scene scene;
            scene.add({file.stem().string(), std::move(geometry)});
            return scene;
        }

        Scene loadOccupancyScene(const std::filesystem::path &file)
        {
            return sceneOf(file, loadOccupancyMap(file));
        }

        Scene loadMeshScene(const std::filesystem::path &file)
        {
            return sceneOf(file, makeMeshGeometry(loadMesh(file)));
        }

        RigidBody loadSceneRobot(const std::filesystem::path &file, RobotCentring /*centring*/)
        {
            const Scene scene = loadPlanningScene(file);
            std::vector<RigidBody::Shape> shapes;
            for (const CollisionObject &object : scene.objects())
            {
                shapes.push_back({object.geometry, object.pose});
            }
            return RigidBody(std::move(shapes));
        }

        RigidBody refuseRobot(const std::filesystem::path &file, RobotCentring /*centring*/)
        {
            throw InputError(file.string() +
                             ": an occupancy map cannot be a robot; accepted are meshes and planning "
                             "scenes (.yaml, .yml)");
        }

        RigidBody loadMeshRobot(const std::filesystem::path &file, RobotCentring centring)
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
            return RigidBody({{makeMeshGeometry(mesh, offset)}});
        }

        // A kind of file: how its world and its robot are read.
        struct FileKind
        {
            std::vector<std::string> extensions;
            Scene (*scene)(const std::filesystem::path &);
            RigidBody (*robot)(const std::filesystem::path &, RobotCentring);
        };

        // The one place where kinds of files are listed. The last reads whatever no other claims: assimp knows some
        // fifty formats.
        const std::vector<FileKind> &fileKinds()
        {
            static const std::vector<FileKind> kinds{
                {{".yaml", ".yml"}, loadPlanningScene, loadSceneRobot},
                {{".bt", ".ot"}, loadOccupancyScene, refuseRobot},
                {{}, loadMeshScene, loadMeshRobot},
            };
            return kinds;
        }

        const FileKind &kindOf(const std::filesystem::path &file)
        {
            const std::string extension = lowerCase(file.extension().string());
            for (const FileKind &kind : fileKinds())
            {
                if (std::find(kind.extensions.begin(), kind.extensions.end(), extension) != kind.extensions.end())
                {
                    return kind;
                }
            }
            return fileKinds().back();
        }
    }  // namespace

    Scene loadScene(const std::filesystem::path &file)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": world file not found");
        }
        return kindOf(file).scene(file);
    }

    RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": robot file not found");
        }
        return kindOf(file).robot(file, centring);
    }
}  // namespace ompl_mfa::collision
