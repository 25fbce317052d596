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

#include "ompl_mfa/robots/RobotSemantics.h"

#include <cmath>

#include "ompl_mfa/InputError.h"
#include "robots/UnknownName.h"
#include "robots/XmlFile.h"
#include "text/NumberText.h"

namespace ompl_mfa::robots
{
    class SrdfReader
    {
    public:
        SrdfReader(const RobotModel &model, const std::filesystem::path &file, RobotSemantics &semantics)
          : model_(model)
          , xml_(file, "SRDF file")
          , semantics_(semantics)
        {
        }

        void read()
        {
            const tinyxml2::XMLElement &root = xml_.root();
            if (XmlFile::attribute(root, "name") != model_.name())
            {
                xml_.fail(root, "the file is for the robot '" + XmlFile::attribute(root, "name") +
                                    "', and the URDF file describes '" + model_.name() + "'");
            }
            XmlFile::forEach(root, "virtual_joint", [this](const auto &joint) { readVirtualJoint(joint); });
            XmlFile::forEach(root, "passive_joint",
                             [this](const auto &joint) { semantics_.passive_.insert(jointNamed(joint, "name")); });
            XmlFile::forEach(root, "group",
                             [this](const auto &group)
                             {
                                 const std::string name = xml_.required(group, "name");
                                 semantics_.groups_.push_back(name);
                                 addGroup(group, semantics_.groupJoints_[name], 0);
                             });
            XmlFile::forEach(root, "group_state", [this](const auto &state) { readState(state); });
            readPairs(root);
        }

    private:
        void readVirtualJoint(const tinyxml2::XMLElement &joint)
        {
            const std::string child = xml_.required(joint, "child_link");
            if (child != model_.links().front().name)
            {
                xml_.fail(joint, "virtual joint '" + XmlFile::attribute(joint, "name") + "' carries the link '" +
                                     child + "'; accepted is the root of the robot, '" + model_.links().front().name +
                                     "'");
            }
            semantics_.virtualJoint_ = xml_.required(joint, "name");
            semantics_.worldFrame_ = xml_.required(joint, "parent_frame");
            virtualType_ = XmlFile::attribute(joint, "type");
        }

        std::size_t jointNamed(const tinyxml2::XMLElement &element, const char *attribute) const
        {
            const std::string name = xml_.required(element, attribute);
            const auto joint = model_.findJoint(name);
            if (!joint)
            {
                xml_.fail(element, unknownName("joint", name, namesOf(model_.joints())));
            }
            return *joint;
        }

        std::size_t linkNamed(const tinyxml2::XMLElement &element, const char *attribute) const
        {
            const std::string name = xml_.required(element, attribute);
            const auto link = model_.findLink(name);
            if (!link)
            {
                xml_.fail(element, unknownName("link", name, namesOf(model_.links())));
            }
            return *link;
        }

        void addGroup(const tinyxml2::XMLElement &group, std::set<std::size_t> &joints, std::size_t depth) const
        {
            const std::string name = XmlFile::attribute(group, "name");
            if (depth > 100)
            {
                xml_.fail(group, "the group '" + name + "' contains itself");
            }
            XmlFile::forEach(group, "joint", [&](const auto &joint) { addJoint(joint, name, joints); });
            XmlFile::forEach(group, "link",
                             [&](const auto &link)
                             {
                                 // The joint that carries the link, which the root does not have.
                                 const std::size_t index = linkNamed(link, "name");
                                 if (index > 0)
                                 {
                                     joints.insert(index - 1);
                                 }
                             });
            XmlFile::forEach(group, "chain", [&](const auto &chain) { addChain(chain, joints); });
            XmlFile::forEach(group, "group",
                             [&](const auto &reference)
                             {
                                 const std::string other = xml_.required(reference, "name");
                                 const auto *found = XmlFile::findNamed(xml_.root(), "group", other);
                                 if (found == nullptr)
                                 {
                                     xml_.fail(reference, "unknown group '" + other + "' in the group '" + name + "'");
                                 }
                                 addGroup(*found, joints, depth + 1);
                             });
        }

        void addJoint(const tinyxml2::XMLElement &joint, const std::string &group, std::set<std::size_t> &joints) const
        {
            const std::string name = xml_.required(joint, "name");
            if (name != semantics_.virtualJoint_)
            {
                joints.insert(jointNamed(joint, "name"));
            }
            else if (virtualType_ != "fixed")
            {
                xml_.fail(joint, "the group '" + group + "' contains the virtual joint '" + name + "', which is " +
                                     virtualType_ + "; accepted are fixed ones");
            }
        }

        void addChain(const tinyxml2::XMLElement &chain, std::set<std::size_t> &joints) const
        {
            const std::size_t base = linkNamed(chain, "base_link");
            for (std::size_t link = linkNamed(chain, "tip_link"); link != base;)
            {
                if (link == 0)
                {
                    xml_.fail(chain, "the chain's base '" + XmlFile::attribute(chain, "base_link") +
                                         "' is not above its tip '" + XmlFile::attribute(chain, "tip_link") + "'");
                }
                joints.insert(link - 1);
                link = model_.joints()[link - 1].parentLink;
            }
        }

        void readState(const tinyxml2::XMLElement &element)
        {
            GroupState state;
            state.name = xml_.required(element, "name");
            state.group = xml_.required(element, "group");
            if (semantics_.groupJoints_.count(state.group) == 0)
            {
                xml_.fail(element, unknownName("group", state.group, semantics_.groups_));
            }
            XmlFile::forEach(element, "joint",
                             [&](const auto &joint)
                             {
                                 const std::string name = xml_.required(joint, "name");
                                 const std::string value = xml_.required(joint, "value");
                                 double number = 0.;
                                 if (!text::readNumber(value, number) || !std::isfinite(number))
                                 {
                                     xml_.fail(joint, "joint '" + name + "': value = " + value + ": must be a number");
                                 }
                                 if (name != semantics_.virtualJoint_)
                                 {
                                     state.values[jointNamed(joint, "name")] = number;
                                 }
                             });
            semantics_.states_.push_back(std::move(state));
        }

        void readPairs(const tinyxml2::XMLElement &root)
        {
            XmlFile::forEach(root, "disable_default_collisions",
                             [this](const auto &link)
                             { semantics_.allowed_.setDefault(model_.links()[linkNamed(link, "link")].name, true); });
            const auto set = [this](const tinyxml2::XMLElement &pair, bool allowed)
            {
                // Robots are often simplified without their SRDF file, so links may be missing.
                semantics_.allowed_.set(xml_.required(pair, "link1"), xml_.required(pair, "link2"), allowed);
            };
            XmlFile::forEach(root, "disable_collisions", [&set](const auto &pair) { set(pair, true); });
            XmlFile::forEach(root, "enable_collisions", [&set](const auto &pair) { set(pair, false); });
        }

        const RobotModel &model_;
        XmlFile xml_;
        RobotSemantics &semantics_;
        std::string virtualType_;
    };

    RobotSemantics::RobotSemantics(const RobotModel &model)
      : joints_(model.joints())
      , place_("the robot '" + model.name() + "'")
    {
        for (const Joint &joint : model.joints())
        {
            allowed_.set(model.links()[joint.parentLink].name, model.links()[joint.childLink].name, true);
        }
    }

    RobotSemantics::RobotSemantics(const RobotModel &model, const std::filesystem::path &file)
      : joints_(model.joints())
      , place_(file.string())
    {
        SrdfReader(model, file, *this).read();
    }

    std::vector<std::size_t> RobotSemantics::jointsOf(const std::string &name) const
    {
        const auto group = groupJoints_.find(name);
        if (!name.empty() && group == groupJoints_.end())
        {
            throw InputError(place_ + ": " + unknownName("group", name, groups_));
        }
        std::vector<std::size_t> joints;
        for (std::size_t i = 0; i < joints_.size(); ++i)
        {
            const bool isActive = joints_[i].isMoving() && !joints_[i].mimic && passive_.count(i) == 0;
            if (isActive && (name.empty() || group->second.count(i) > 0))
            {
                joints.push_back(i);
            }
        }
        if (joints.empty())
        {
            throw InputError(place_ + ": " + (name.empty() ? "the robot" : "the group '" + name + "'") +
                             " has no joint that moves");
        }
        return joints;
    }

    const GroupState &RobotSemantics::state(const std::string &group, const std::string &name) const
    {
        std::vector<std::string> known;
        for (const GroupState &state : states_)
        {
            if (state.group == group && state.name == name)
            {
                return state;
            }
            if (state.group == group)
            {
                known.push_back(state.name);
            }
        }
        throw InputError(place_ + ": " + unknownName("state of the group '" + group + "'", name, known));
    }
}  // namespace ompl_mfa::robots
