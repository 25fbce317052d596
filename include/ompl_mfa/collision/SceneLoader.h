#ifndef OMPL_MFA_COLLISION_SCENE_LOADER_
#define OMPL_MFA_COLLISION_SCENE_LOADER_

#include <filesystem>
#include <vector>

#include "ompl_mfa/collision/RigidBody.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief Where the reference point of a robot mesh goes. */
    enum class RobotCentring
    {
        /** \brief It stays at the origin of the file. */
        None,

        /** \brief OMPL.app in SE(3): the mean of all vertices. */
        VertexMean,

        /** \brief OMPL.app in SE(2): the mean of all vertices in x and y; z stays as in the file. */
        PlanarVertexMean
    };

    /** \brief Read a world. The file's extension selects the reader: .yaml and .yml are planning scenes
        (loadPlanningScene), .scene planning scenes as text (loadTextScene), .bt and .ot OctoMaps (loadOccupancyMap),
        and what else assimp has a reader for a mesh, which stays where it is in the file by OMPL.app's conventions
        (RootTransform::Applied).
        \param file the world
        \param packageFolders where the meshes of a planning scene are sought, as in loadPlanningScene()
        \throw InputError naming the file and the fault; for an unknown extension, the kinds that are read. A world is
        never empty. */
    Scene loadScene(const std::filesystem::path &file, const std::vector<std::filesystem::path> &packageFolders = {});

    /** \brief Read a robot: a mesh, or a planning scene whose objects are taken as the shapes of one rigid body about
        the origin of the file.
        \param file .yaml, .yml, .scene or a mesh.
        \param centring for meshes only; a planning scene names its own reference point.
        \param packageFolders as for loadScene()
        \throw InputError naming the file and the fault. */
    RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring,
                        const std::vector<std::filesystem::path> &packageFolders = {});
}  // namespace ompl_mfa::collision

#endif
