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

#ifndef OMPL_MFA_ROBOTS_ROBOT_MODEL_
#define OMPL_MFA_ROBOTS_ROBOT_MODEL_

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/RigidBody.h"

namespace ompl_mfa::robots
{
    enum class JointType
    {
        Fixed,
        Revolute,
        Continuous,
        Prismatic
    };

    /** \brief A joint that follows another one: its value is `multiplier` times that of the other plus `offset`. */
    struct Mimic
    {
        /** \brief Index of the joint that it follows, which follows none itself. */
        std::size_t joint{0};

        double multiplier{1.};
        double offset{0.};
    };

    /** \brief A joint. Values, limits and speeds are in radians, for prismatic joints in metres. */
    struct Joint
    {
        std::string name;
        JointType type{JointType::Fixed};

        /** \brief Indices of the links that it connects. */
        std::size_t parentLink{0};
        std::size_t childLink{0};

        /** \brief Pose of the joint in the frame of the parent link. At value 0 it is that of the child link. */
        fcl::Transform3d origin{fcl::Transform3d::Identity()};

        /** \brief Unit axis in the frame of the joint. */
        fcl::Vector3d axis{fcl::Vector3d::UnitX()};

        /** \brief Smallest and largest value; infinite for continuous joints. The soft limits of a safety controller
            do not count. */
        double lower{-std::numeric_limits<double>::infinity()};
        double upper{std::numeric_limits<double>::infinity()};

        /** \brief Largest speed per second, and acceleration per second squared; 0 if the file gives none. */
        double velocity{0.};
        double acceleration{0.};

        std::optional<Mimic> mimic;

        bool isMoving() const
        {
            return type != JointType::Fixed;
        }
    };

    struct Link
    {
        std::string name;

        /** \brief Index of the joint that carries it; empty for the root. */
        std::optional<std::size_t> parentJoint;

        /** \brief Collision geometry, with its poses in the frame of the link. */
        std::vector<collision::RigidBody::Shape> shapes;
    };

    /** \brief A tree of links and joints, as described by a URDF file. */
    class OMPL_MFA_EXPORT RobotModel
    {
    public:
        /** \param links parents before their children; the first one is the root.
            \param joints in the order of the links that they carry, all but the root.
            \throw std::invalid_argument if they do not form such a tree. */
        RobotModel(std::string name, std::vector<Link> links, std::vector<Joint> joints);

        const std::string &name() const
        {
            return name_;
        }

        const std::vector<Link> &links() const
        {
            return links_;
        }

        const std::vector<Joint> &joints() const
        {
            return joints_;
        }

        std::optional<std::size_t> findLink(const std::string &name) const;
        std::optional<std::size_t> findJoint(const std::string &name) const;

        /** \brief Value of a joint of which nothing is known: 0, or the middle of its limits if 0 is outside. */
        double defaultValue(std::size_t joint) const;

        /** \brief Poses of all links relative to the root.
            \param values one for each joint. Those of fixed joints and of joints that follow others are not used. */
        std::vector<fcl::Transform3d> linkPoses(const std::vector<double> &values) const;

    private:
        std::string name_;
        std::vector<Link> links_;
        std::vector<Joint> joints_;
    };

    /** \brief Motion of a joint: pose of its child relative to its frame at `value`. */
    OMPL_MFA_EXPORT fcl::Transform3d jointMotion(const Joint &joint, double value);

    /** \brief Read a URDF file: revolute, continuous, prismatic and fixed joints, mimicry, limits, and the collision
        geometry of links. Visual geometry is not read.
        \param file the robot.
        \param packageFolders searched for meshes after the folder of the file and before the folders of the environment
        variable OMPL_MFA_RESOURCE_DIR; each contains packages or is a package.
        \throw InputError naming file and fault: a missing or malformed file, a xacro file, planar and floating joints,
        contradictory limits, a loop of joints, a missing mesh. */
    OMPL_MFA_EXPORT RobotModel loadRobotModel(const std::filesystem::path &file,
                                              const std::vector<std::filesystem::path> &packageFolders = {});
}  // namespace ompl_mfa::robots

#endif
