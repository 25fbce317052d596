#ifndef OMPL_MFA_COLLISION_SCENE_LOADER_
#define OMPL_MFA_COLLISION_SCENE_LOADER_

#include <filesystem>

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
        (loadPlanningScene), .bt and .ot OctoMaps (loadOccupancyMap), everything else a mesh read by assimp, which
        stays where it is in the file.
        \throw InputError naming the file and the fault. A world is never empty. */
    Scene loadScene(const std::filesystem::path &file);

    /** \brief Read a robot: a mesh, or a planning scene whose objects are taken as the shapes of one rigid body about
        the origin of the file.
        \param file .yaml, .yml or a mesh.
        \param centring for meshes only; a planning scene names its own reference point.
        \throw InputError naming the file and the fault. */
    RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring);
}  // namespace ompl_mfa::collision

#endif
