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

#include "ompl_mfa/collision/RobotScene.h"

#include "collision/SceneReader.h"
#include "collision/YamlRobotState.h"
#include "ompl_mfa/PlainText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        std::pair<std::string, std::string> inOrder(const std::string &first, const std::string &second)
        {
            return first < second ? std::make_pair(first, second) : std::make_pair(second, first);
        }

        std::vector<std::string> readNames(const YamlFile &yaml, const YAML::Node &map, const std::string &key)
        {
            std::vector<std::string> names;
            for (const YAML::Node &name : yaml.list(map, key))
            {
                if (!name.IsScalar())
                {
                    yaml.fail(name, key + " must be names");
                }
                names.push_back(name.Scalar());
            }
            return names;
        }

        // YAML writes booleans as words; ROS 1 prints those of lists as numbers.
        bool readSwitch(const YamlFile &yaml, const YAML::Node &node, const std::string &key)
        {
            const std::string text = node.IsScalar() ? lowerCase(node.Scalar()) : "";
            if (text != "true" && text != "false" && text != "1" && text != "0")
            {
                yaml.fail(node, key + (node.IsScalar() ? " = " + node.Scalar() : "") + ": must be true or false");
            }
            return text == "true" || text == "1";
        }

        // Printed as a list of lists, or of maps with the key `enabled`.
        YAML::Node rowOf(const YamlFile &yaml, const YAML::Node &row)
        {
            if (row.IsMap())
            {
                yaml.checkKeys(row, "entry_values", {"enabled"});
                return yaml.list(row, "enabled");
            }
            if (!row.IsSequence())
            {
                yaml.fail(row, "entry_values must be lists of true and false");
            }
            return row;
        }

        [[noreturn]] void failSize(const YamlFile &yaml, const YAML::Node &node, const std::string &key,
                                   std::size_t size, std::size_t names, const std::string &what)
        {
            yaml.fail(node,
                      key + " has " + std::to_string(size) + " entries for " + std::to_string(names) + " " + what);
        }

        AllowedCollisions readAllowed(const YamlFile &yaml, const YAML::Node &node)
        {
            yaml.checkKeys(node, "allowed_collision_matrix",
                           {"entry_names", "entry_values", "default_entry_names", "default_entry_values"});
            AllowedCollisions allowed;
            const std::vector<std::string> names = readNames(yaml, node, "entry_names");
            const YAML::Node rows = yaml.list(node, "entry_values");
            if (rows.size() != names.size())
            {
                failSize(yaml, node, "entry_values", rows.size(), names.size(), "entry_names");
            }
            for (std::size_t i = 0; i < names.size(); ++i)
            {
                const YAML::Node row = rowOf(yaml, rows[i]);
                if (row.size() != names.size())
                {
                    failSize(yaml, rows[i], "a row of entry_values", row.size(), names.size(), "entry_names");
                }
                for (std::size_t j = i + 1; j < names.size(); ++j)
                {
                    allowed.set(names[i], names[j], readSwitch(yaml, row[j], "entry_values"));
                }
            }
            const std::vector<std::string> others = readNames(yaml, node, "default_entry_names");
            const YAML::Node values = yaml.list(node, "default_entry_values");
            if (values.size() != others.size())
            {
                failSize(yaml, node, "default_entry_values", values.size(), others.size(), "default_entry_names");
            }
            for (std::size_t i = 0; i < others.size(); ++i)
            {
                allowed.setDefault(others[i], readSwitch(yaml, values[i], "default_entry_values"));
            }
            return allowed;
        }

        std::map<std::string, double> readLinkValues(const YamlFile &yaml, const YAML::Node &root,
                                                     const std::string &key, const std::string &property,
                                                     bool mustBePositive)
        {
            std::map<std::string, double> values;
            for (const YAML::Node &link : yaml.list(root, key))
            {
                yaml.checkKeys(link, key, {"link_name", property});
                const YAML::Node value = yaml.required(link, property);
                const double number = yaml.number(value, property);
                if (mustBePositive && number <= 0.)
                {
                    yaml.fail(value, key + ": " + property + " = " + value.Scalar() + ": must be greater than 0");
                }
                values[yaml.text(link, "link_name")] = number;
            }
            return values;
        }

        class RobotSceneReader
        {
        public:
            RobotSceneReader(const std::filesystem::path &file, const RobotFrames &frames, const Folders &folders)
              : reader_(file, folders, [this, &frames](const std::string &name) { return frames(name, scene_.state); })
              , frames_(frames)
            {
            }

            RobotScene read()
            {
                const YamlFile &yaml = reader_.yaml();
                const YAML::Node root = reader_.message();
                scene_.robotName = yaml.text(root, "robot_model_name");
                if (YamlFile::has(root, "robot_state"))
                {
                    scene_.state = readRobotState(yaml, root["robot_state"]);
                }
                if (YamlFile::has(root, "allowed_collision_matrix"))
                {
                    scene_.allowed = readAllowed(yaml, root["allowed_collision_matrix"]);
                }
                scene_.padding = readLinkValues(yaml, root, "link_padding", "padding", false);
                scene_.scale = readLinkValues(yaml, root, "link_scale", "scale", true);
                reader_.readWorld(root);
                for (const YAML::Node &body :
                     yaml.list(YamlFile::optional(root, "robot_state"), "attached_collision_objects"))
                {
                    scene_.attached.push_back(readAttached(body));
                }
                scene_.world = reader_.world().scene();
                return std::move(scene_);
            }

        private:
            AttachedObject readAttached(const YAML::Node &body)
            {
                const YamlFile &yaml = reader_.yaml();
                const YAML::Node node = yaml.required(body, "object");
                AttachedObject attached;
                attached.place = yaml.place(body);
                attached.link = yaml.text(body, "link_name");
                attached.id = yaml.text(node, "id");
                attached.touchLinks = readNames(yaml, body, "touch_links");
                const auto link = frames_(attached.link, scene_.state);
                if (!link)
                {
                    yaml.fail(body, "attached_collision_objects: '" + attached.id + "' is attached to the link '" +
                                        attached.link + "', which the robot does not have");
                }
                MoveItWorld::Object object = reader_.readShapesOf(node, attached.id, true);
                reader_.warnOfUnset(attached.place + ": attached object '" + attached.id + "'");
                if (object.shapes.empty())
                {
                    // As in MoveIt: the object is taken from the world.
                    object = takeFromWorld(body, attached.id);
                }
                const fcl::Transform3d toLink = link->inverse() * object.pose;
                for (const MoveItWorld::Shape &shape : object.shapes)
                {
                    attached.shapes.push_back({shape.geometry, toLink * shape.pose, shape.skippedFaces});
                }
                return attached;
            }

            MoveItWorld::Object takeFromWorld(const YAML::Node &body, const std::string &id)
            {
                const MoveItWorld::Object *found = reader_.world().object(id);
                if (found == nullptr)
                {
                    reader_.yaml().fail(body, "attached_collision_objects: '" + id +
                                                  "' has no shapes, and the world has no object of this name");
                }
                MoveItWorld::Object object = *found;
                reader_.world().remove(id);
                return object;
            }

            RobotScene scene_;
            SceneReader reader_;
            const RobotFrames &frames_;
        };
    }  // namespace

    void AllowedCollisions::set(const std::string &first, const std::string &second, bool allowed)
    {
        pairs_[inOrder(first, second)] = allowed;
    }

    void AllowedCollisions::setDefault(const std::string &name, bool allowed)
    {
        defaults_[name] = allowed;
    }

    std::optional<bool> AllowedCollisions::find(const std::string &first, const std::string &second) const
    {
        const auto pair = pairs_.find(inOrder(first, second));
        if (pair != pairs_.end())
        {
            return pair->second;
        }
        const auto one = defaults_.find(first);
        const auto other = defaults_.find(second);
        if (one == defaults_.end() && other == defaults_.end())
        {
            return std::nullopt;
        }
        return (one == defaults_.end() || one->second) && (other == defaults_.end() || other->second);
    }

    fcl::Transform3d readTransform(const YamlFile &yaml, const YAML::Node &node, const std::string &what,
                                   const std::string &translation, const std::string &rotation)
    {
        yaml.checkKeys(node, what, {translation, rotation});
        fcl::Transform3d pose = fcl::Transform3d::Identity();
        if (node[translation])
        {
            pose.translation() = yaml.vector<3>(node[translation], translation, {"x", "y", "z"});
        }
        if (node[rotation])
        {
            UnsetFields unset;
            const auto matrix =
                rotationOf(yaml.vector<4>(node[rotation], rotation, {"x", "y", "z", "w"}), rotation, unset);
            if (!matrix)
            {
                yaml.fail(node[rotation], rotation + ": a quaternion of a length near 0 is no rotation");
            }
            pose.linear() = *matrix;
        }
        return pose;
    }

    RobotState readRobotState(const YamlFile &yaml, const YAML::Node &node)
    {
        yaml.checkKeys(node, "robot_state",
                       {"joint_state", "multi_dof_joint_state", "attached_collision_objects", "is_diff"});
        RobotState state;
        state.place = yaml.place(node);
        const YAML::Node joints = YamlFile::optional(node, "joint_state");
        yaml.checkKeys(joints, "joint_state", {"header", "name", "position", "velocity", "effort"});
        const std::vector<std::string> names = readNames(yaml, joints, "name");
        const YAML::Node positions = yaml.list(joints, "position");
        if (positions.size() != names.size())
        {
            failSize(yaml, joints, "joint_state.position", positions.size(), names.size(), "names");
        }
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            state.joints.emplace_back(names[i], yaml.number(positions[i], "position of the joint '" + names[i] + "'"));
        }
        const YAML::Node bases = YamlFile::optional(node, "multi_dof_joint_state");
        yaml.checkKeys(bases, "multi_dof_joint_state", {"header", "joint_names", "transforms", "twist", "wrench"});
        const std::vector<std::string> baseNames = readNames(yaml, bases, "joint_names");
        const YAML::Node transforms = yaml.list(bases, "transforms");
        if (transforms.size() != baseNames.size())
        {
            failSize(yaml, bases, "multi_dof_joint_state.transforms", transforms.size(), baseNames.size(),
                     "joint_names");
        }
        for (std::size_t i = 0; i < baseNames.size(); ++i)
        {
            state.bases[baseNames[i]] =
                readTransform(yaml, transforms[i], "multi_dof_joint_state.transforms", "translation", "rotation");
        }
        return state;
    }

    RobotScene loadRobotScene(const std::filesystem::path &file, const RobotFrames &frames,
                              const std::vector<std::filesystem::path> &packageFolders)
    {
        return RobotSceneReader(file, frames, packageFolders).read();
    }
}  // namespace ompl_mfa::collision
