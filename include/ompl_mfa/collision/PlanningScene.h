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

#ifndef OMPL_MFA_COLLISION_PLANNING_SCENE_
#define OMPL_MFA_COLLISION_PLANNING_SCENE_

#include <filesystem>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief Read a planning scene in MoveIt's layout: a `moveit_msgs/PlanningScene` as YAML, written by hand or as
        `rostopic echo` and `ros2 topic echo` print it.

        The obstacles are `world.octomap` and `world.collision_objects[]`, each of these with an `id`, an optional
        `pose`, and
        - `primitives[]` (`type`: the name or number of one of primitiveKinds(); `dimensions`: in the order listed
          there) with `primitive_poses[]`;
        - `meshes[]` (`resource`: a mesh file, read with RootTransform::Reset, and an optional `scale`, which may be
          called `dimensions`; or `vertices[]` and `triangles[]`) with `mesh_poses[]`.

        A pose is `position` (x y z) and `orientation` (x y z w), as lists or as maps. A missing field means identity,
        and so does an unset one (an orientation of four zeros, an empty list of poses), with one warning per object on
        OMPL's console. Orientations are normalised.

        Poses are relative to the frame `header.frame_id`: the planning frame (also the empty name), one defined by
        `fixed_frame_transforms`, or a previous object or one of its subframes. Operations on objects (add, remove,
        append, move) are applied. Unsupported content that affects collisions is an error: other frames, planes,
        attached objects, padding and scale of links, other kinds of OctoMaps.
        \param file the scene.
        \param packageFolders searched for a `resource` that is `package://PACKAGE/PATH` or a relative name, after the
        folder of the scene and before resourceFolders(); each contains packages or is a package.
        \throw InputError naming file, line, key and value. */
    OMPL_MFA_EXPORT Scene loadPlanningScene(const std::filesystem::path &file,
                                            const std::vector<std::filesystem::path> &packageFolders = {});

    /** \brief Read a planning scene in MoveIt's text format (`.scene`), as RViz exports it: a line with the name; for
        each object a line `* ID`, its pose (newer format only), the number of shapes, the shapes (`box`, `sphere`,
        `cylinder`, `cone`, `mesh`) with their poses and colours, and its subframes (newer format only); finally a line
        `.`.

        An orientation of four zeros means identity, with one warning per object on OMPL's console.
        \throw InputError naming file, line and value. */
    OMPL_MFA_EXPORT Scene loadTextScene(const std::filesystem::path &file);
}  // namespace ompl_mfa::collision

#endif
