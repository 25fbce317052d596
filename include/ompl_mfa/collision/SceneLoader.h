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
    /** \brief Where the reference point of a robot mesh is placed. */
    enum class RobotCentring
    {
        /** \brief At the origin of the file. */
        None,

        /** \brief At the mean of all vertices, as in OMPL.app for SE(3). */
        VertexMean,

        /** \brief At the mean of all vertices in x and y, and at z = 0 of the file, as in OMPL.app for SE(2). */
        PlanarVertexMean
    };

    /** \brief Read a world. The file's extension selects the reader: .yaml and .yml are planning scenes
        (loadPlanningScene), .scene planning scenes as text (loadTextScene), .bt and .ot OctoMaps (loadOccupancyMap),
        and any other format that assimp reads is a mesh, placed by OMPL.app's conventions (RootTransform::Applied).
        \param file the world.
        \param packageFolders searched for the meshes of a planning scene, as in loadPlanningScene().
        \throw InputError naming the file and the error, and for an unknown extension the supported ones. A world
        without obstacles is an error. */
    OMPL_MFA_EXPORT Scene loadScene(const std::filesystem::path &file,
                                    const std::vector<std::filesystem::path> &packageFolders = {});

    /** \brief Read a robot: a mesh, or a planning scene whose objects become the shapes of one rigid body with its
        reference point at the origin of the file.
        \param file .yaml, .yml, .scene or a mesh.
        \param centring for meshes only; the reference point of a planning scene is its origin.
        \param packageFolders as for loadScene().
        \throw InputError naming the file and the error. */
    OMPL_MFA_EXPORT RigidBody loadRobot(const std::filesystem::path &file, RobotCentring centring,
                                        const std::vector<std::filesystem::path> &packageFolders = {});
}  // namespace ompl_mfa::collision

#endif
