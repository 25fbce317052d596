#ifndef OMPL_MFA_COLLISION_YAML_SHAPES_
#define OMPL_MFA_COLLISION_YAML_SHAPES_

#include <memory>

#include <fcl/geometry/collision_geometry.h>

#include "collision/MeshResource.h"
#include "collision/YamlFile.h"
#include "ompl_mfa/collision/TriangleMesh.h"

namespace ompl_mfa::collision
{
    /** \brief A `shape_msgs/SolidPrimitive`. */
    std::shared_ptr<fcl::CollisionGeometryd> readPrimitive(const YamlFile &yaml, const YAML::Node &node);

    /** \brief A `shape_msgs/Mesh`, or a file with a scale as robowflex writes it.
        \param folders where files are sought. */
    TriangleMesh readMesh(const YamlFile &yaml, const YAML::Node &node, const Folders &folders);
}  // namespace ompl_mfa::collision

#endif
