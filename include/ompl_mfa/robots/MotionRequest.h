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

#ifndef OMPL_MFA_ROBOTS_MOTION_REQUEST_
#define OMPL_MFA_ROBOTS_MOTION_REQUEST_

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/RobotScene.h"

namespace ompl_mfa::robots
{
    /** \brief A `moveit_msgs/JointConstraint`: an interval of values, radians or metres. */
    struct JointTarget
    {
        std::string joint;
        double position{0.};
        double above{0.};
        double below{0.};

        /** \brief File and line, for errors. */
        std::string place;
    };

    /** \brief A pose that a link is to reach, from a `moveit_msgs/PositionConstraint` and an `OrientationConstraint`.
     */
    struct PoseTarget
    {
        std::string link;

        /** \brief Name of the frame of `pose`; empty for the planning frame. */
        std::string frame;

        /** \brief Pose of the link. */
        fcl::Transform3d pose{fcl::Transform3d::Identity()};

        /** \brief Point of the link that is to be at the position, in the frame of the link. */
        fcl::Vector3d offset{fcl::Vector3d::Zero()};

        /** \brief Half the sides of a box about the position or, if `isBall`, the radius of a ball, metres. */
        fcl::Vector3d positionTolerance{fcl::Vector3d::Zero()};
        bool isBall{true};

        /** \brief Largest rotations about the axes of the link, radians; empty if any orientation is accepted. */
        std::optional<fcl::Vector3d> rotationTolerance;

        /** \brief File and line, for errors. */
        std::string place;
    };

    /** \brief A `moveit_msgs/Constraints` as a goal: joints or a pose, not both. */
    struct RequestedGoal
    {
        std::vector<JointTarget> joints;
        std::optional<PoseTarget> pose;
        std::string place;
    };

    /** \brief A `moveit_msgs/MotionPlanRequest`. */
    struct MotionRequest
    {
        std::string group;
        collision::RobotState start;

        /** \brief Any of them may be reached. */
        std::vector<RequestedGoal> goals;

        /** \brief Factors for the limits of speed and acceleration, in (0, 1]. */
        double velocityScale{1.};
        double accelerationScale{1.};

        std::filesystem::path file;
    };

    /** \brief Read a `moveit_msgs/MotionPlanRequest` as YAML. Planner, attempts, time and the workspace, which bounds
       only robots that drive, are not used. \throw InputError naming file, line, key and value: constraints of paths
       and trajectories, objects attached in the start state, goals without constraints or of visibility. */
    OMPL_MFA_EXPORT MotionRequest loadMotionRequest(const std::filesystem::path &file);
}  // namespace ompl_mfa::robots

#endif
