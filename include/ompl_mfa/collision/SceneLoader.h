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

#ifndef OMPL_MFA_COLLISION_SCENE_LOADER_
#define OMPL_MFA_COLLISION_SCENE_LOADER_

#include <filesystem>
#include <vector>

#include "ompl_mfa/Export.h"
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
    OMPL_MFA_EXPORT Scene loadScene(const std::filesystem::path &file,
                                    const std::vector<std::filesystem::path> &packageFolders = {});

    /** \brief Read a robot: a mesh, or a planning scene whose objects are taken as the shapes of one rigid body about
        the origin of the file.
        \param file .yaml, .yml, .scene or a mesh.
        \param centring for meshes only; a planning scene names its own reference point.
        \param packageFolders as for loadScene()
        \throw InputError naming the file and the fault. */
    OMPL_MFA_EXPORT RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring,
                                        const std::vector<std::filesystem::path> &packageFolders = {});
}  // namespace ompl_mfa::collision

#endif
