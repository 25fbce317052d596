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

#ifndef OMPL_MFA_COLLISION_ROBOT_SCENE_
#define OMPL_MFA_COLLISION_ROBOT_SCENE_

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/RigidBody.h"
#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief A `moveit_msgs/RobotState`: values of joints, by their names. */
    struct RobotState
    {
        /** \brief Radians or metres, in the order of the message. */
        std::vector<std::pair<std::string, double>> joints;

        /** \brief Transforms of joints with several degrees of freedom: the robot's base. */
        std::map<std::string, fcl::Transform3d> bases;

        /** \brief File and line, for errors; empty if no state was given. */
        std::string place;
    };

    /** \brief A body held by a link of the robot. */
    struct AttachedObject
    {
        std::string id;

        /** \brief Name of the link that holds it. */
        std::string link;

        /** \brief The shapes, with their poses in the frame of the link. */
        std::vector<RigidBody::Shape> shapes;

        /** \brief Names of links that it may touch, besides its own. */
        std::vector<std::string> touchLinks;

        /** \brief File and line, for errors. */
        std::string place;
    };

    /** \brief A `moveit_msgs/AllowedCollisionMatrix`: which pairs of links and objects may touch. */
    class OMPL_MFA_EXPORT AllowedCollisions
    {
    public:
        /** \brief Set whether this pair may touch, in either order. */
        void set(const std::string &first, const std::string &second, bool allowed);

        /** \brief Set the default for pairs with this name that are not listed. */
        void setDefault(const std::string &name, bool allowed);

        /** \brief Whether the pair may touch; empty if neither an entry nor a default names it. A listed pair counts
            before defaults, and of two defaults that differ the stricter. */
        std::optional<bool> find(const std::string &first, const std::string &second) const;

    private:
        std::map<std::pair<std::string, std::string>, bool> pairs_;
        std::map<std::string, bool> defaults_;
    };

    /** \brief A planning scene with what it says about the robot. */
    struct RobotScene
    {
        /** \brief The obstacles, in the planning frame; may be empty. */
        Scene world;

        /** \brief `robot_model_name`; may be empty. */
        std::string robotName;

        RobotState state;
        AllowedCollisions allowed;
        std::vector<AttachedObject> attached;

        /** \brief Lengths by which links are enlarged, and factors by which they are scaled, by the names of links. */
        std::map<std::string, double> padding;
        std::map<std::string, double> scale;
    };

    /** \brief Pose of a frame of the robot, by its name, in the planning frame when the robot is in this state; empty
       if the robot has no such frame. */
    using RobotFrames = std::function<std::optional<fcl::Transform3d>(const std::string &, const RobotState &)>;

    /** \brief Read a planning scene in MoveIt's layout as loadPlanningScene() does, and all it says about the robot:
        its state, attached objects, the allowed collision matrix, padding and scale of links. A world without obstacles
        is accepted.
        \param file the scene.
        \param frames frames of the robot, in which objects may be placed.
        \param packageFolders as for loadPlanningScene().
        \throw InputError naming file, line, key and value. */
    OMPL_MFA_EXPORT RobotScene loadRobotScene(const std::filesystem::path &file, const RobotFrames &frames,
                                              const std::vector<std::filesystem::path> &packageFolders = {});
}  // namespace ompl_mfa::collision

#endif
