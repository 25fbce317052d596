#ifndef OMPL_MFA_COLLISION_PLANNING_SCENE_
#define OMPL_MFA_COLLISION_PLANNING_SCENE_

#include <filesystem>

#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief Read a planning scene in MoveIt's layout (`moveit_msgs/PlanningScene` as YAML).

        The obstacles are `world.collision_objects[]`, each with an `id`, an optional `pose`, and
        - `primitives[]` (`type`: the name of one of primitiveKinds() or its number; `dimensions`: in its order) with
          `primitive_poses[]`;
        - `meshes[]` (`resource`: a mesh file beside the scene, with an optional `scale`; or `vertices[]` and
          `triangles[]`) with `mesh_poses[]`.

        A pose is `position` (x y z) and an optional `orientation` (x y z w), as lists or as maps; a missing list of
        poses means that every shape sits at the pose of its object. Orientations are normalised. Other fields of
        MoveIt's messages do not describe obstacles and are passed over; a field that MoveIt does not have is an error.
        \throw InputError naming file, line, key and value. */
    Scene loadPlanningScene(const std::filesystem::path &file);
}  // namespace ompl_mfa::collision

#endif
