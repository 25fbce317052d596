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

#ifndef OMPL_MFA_ROBOTS_ROBOT_SEMANTICS_
#define OMPL_MFA_ROBOTS_ROBOT_SEMANTICS_

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/collision/RobotScene.h"
#include "ompl_mfa/robots/RobotModel.h"

namespace ompl_mfa::robots
{
    /** \brief Named values of joints. */
    struct GroupState
    {
        /** \brief Name of the group that it belongs to. */
        std::string group;

        std::string name;

        /** \brief Values by joint index, radians or metres. */
        std::map<std::size_t, double> values;
    };

    /** \brief What an SRDF file adds to a robot: groups of joints, named states, pairs of links that may touch. */
    class OMPL_MFA_EXPORT RobotSemantics
    {
    public:
        /** \brief Without a file: no groups, no states, and pairs of links that a joint connects may touch. */
        explicit RobotSemantics(const RobotModel &model);

        /** \brief Read an SRDF file for `model`: groups (joints, links, chains, subgroups), group states, disabled
            pairs, passive joints, and virtual joints, which are taken as fixed.
            \throw InputError naming file, line and fault: a missing or malformed file, a file for another robot, an
            unknown joint, link or group, a group that contains itself or a virtual joint that is not fixed. */
        RobotSemantics(const RobotModel &model, const std::filesystem::path &file);

        /** \brief Names of the groups, in the order of the file. */
        const std::vector<std::string> &groups() const
        {
            return groups_;
        }

        /** \brief Moving joints of a group by their indices, in the order of the model: without passive joints and
            those that follow others.
            \param name of the group; if empty, of all moving joints.
            \throw InputError if there is no such group, or if it has no moving joint. */
        std::vector<std::size_t> jointsOf(const std::string &name) const;

        /** \brief The state `name` of the group.
            \throw InputError if there is none. */
        const GroupState &state(const std::string &group, const std::string &name) const;

        const std::vector<GroupState> &states() const
        {
            return states_;
        }

        /** \brief Pairs of links that may touch. */
        const collision::AllowedCollisions &allowed() const
        {
            return allowed_;
        }

        /** \brief Name of the joint that connects the robot to the world; empty if there is none. */
        const std::string &virtualJoint() const
        {
            return virtualJoint_;
        }

        /** \brief Name of the frame that the robot stands in; empty if the file names none. */
        const std::string &worldFrame() const
        {
            return worldFrame_;
        }

    private:
        friend class SrdfReader;

        std::vector<Joint> joints_;
        std::vector<std::string> groups_;
        std::map<std::string, std::set<std::size_t>> groupJoints_;
        std::set<std::size_t> passive_;
        std::vector<GroupState> states_;
        collision::AllowedCollisions allowed_;
        std::string virtualJoint_;
        std::string worldFrame_;
        std::string place_;
    };
}  // namespace ompl_mfa::robots

#endif
