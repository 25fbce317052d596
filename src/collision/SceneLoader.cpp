#include "ompl_mfa/collision/SceneLoader.h"

#include <algorithm>
#include <cctype>
#include <functional>

#include "ompl_mfa/InputError.h"
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

        Scene loadMeshScene(const std::filesystem::path &file)
        {
            return sceneOf(file, makeMeshGeometry(loadMesh(file)));
        }

        Scene loadOccupancyScene(const std::filesystem::path &file)
        {
            return sceneOf(file, loadOccupancyMap(file));
        }

        struct SceneReader
        {
            std::vector<std::string> extensions;
            Scene (*read)(const std::filesystem::path &);
        };

        const SceneReader &readerFor(const std::filesystem::path &file)
        {
            // The last one reads whatever no other claims: assimp knows some fifty formats.
            static const std::vector<SceneReader> readers{
                {{".yaml", ".yml"}, loadPlanningScene}, {{".bt", ".ot"}, loadOccupancyScene}, {{}, loadMeshScene}};
            std::string extension = file.extension().string();
            std::transform(extension.begin(), extension.end(), extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
            for (const SceneReader &reader : readers)
            {
                if (std::find(reader.extensions.begin(), reader.extensions.end(), extension) != reader.extensions.end())
                {
                    return reader;
                }
            }
            return readers.back();
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
    }  // namespace

    Scene loadScene(const std::filesystem::path &file)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": world file not found");
        }
        return readerFor(file).read(file);
    }

    RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring)
    {
        if (!std::filesystem::is_regular_file(file))
        {
            throw InputError(file.string() + ": robot file not found");
        }
        const SceneReader &reader = readerFor(file);
        if (reader.read == loadMeshScene)
        {
            return loadMeshRobot(file, centring);
        }
        if (reader.read == loadOccupancyScene)
        {
            throw InputError(file.string() +
                             ": an occupancy map cannot be a robot; accepted are meshes and planning "
                             "scenes (.yaml, .yml)");
        }
        const Scene scene = reader.read(file);
        std::vector<RigidBody::Shape> shapes;
        for (const CollisionObject &object : scene.objects())
        {
            shapes.push_back({object.geometry, object.pose});
        }
        return RigidBody(std::move(shapes));
    }
}  // namespace ompl_mfa::collision
