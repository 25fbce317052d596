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

#include "collision/SceneReader.h"

#include <utility>

#include "collision/ResourceFolders.h"
#include "collision/SceneWarnings.h"
#include "collision/YamlOctomap.h"
#include "collision/YamlShapes.h"
#include "ompl_mfa/PlainText.h"

namespace ompl_mfa::collision
{
    namespace
    {
        // MoveIt's name of the occupancy map among the objects of a world.
        const std::string OCTOMAP_ID = "<octomap>";

        // In the order of their numbers in moveit_msgs/CollisionObject.
        const std::vector<std::string> OPERATIONS{"add", "remove", "append", "move"};
    }  // namespace

    SceneReader::SceneReader(const std::filesystem::path &file, const Folders &packageFolders, OtherFrames otherFrames)
      : yaml_(file)
      , folders_{yaml_.folder()}
      , otherFrames_(std::move(otherFrames))
    {
        folders_.insert(folders_.end(), packageFolders.begin(), packageFolders.end());
        const Folders named = resourceFolders();
        folders_.insert(folders_.end(), named.begin(), named.end());
    }

    YAML::Node SceneReader::message() const
    {
        YAML::Node root = yaml_.message();
        yaml_.checkKeys(root, "planning scene",
                        {"world", "name", "robot_state", "robot_model_name", "fixed_frame_transforms",
                         "allowed_collision_matrix", "link_padding", "link_scale", "object_colors", "is_diff"});
        if (YamlFile::has(root, "robot_state"))
        {
            yaml_.checkKeys(root["robot_state"], "robot_state",
                            {"joint_state", "multi_dof_joint_state", "attached_collision_objects", "is_diff"});
        }
        for (const YAML::Node &body : yaml_.list(YamlFile::optional(root, "robot_state"), "attached_collision_objects"))
        {
            yaml_.checkKeys(body, "attached_collision_objects",
                            {"link_name", "object", "touch_links", "detach_posture", "weight"});
        }
        if (lowerCase(yaml_.text(root, "is_diff")) == "true")
        {
            warnOfScene(yaml_.place(root["is_diff"]) +
                        ": is_diff = true: the scene that this is a difference "
                        "to is not in the file; its own obstacles are read "
                        "alone");
        }
        return root;
    }

    void SceneReader::readWorld(const YAML::Node &root)
    {
        readFixedFrames(root);
        const YAML::Node world = yaml_.required(root, "world");
        yaml_.checkKeys(world, "world", {"collision_objects", "octomap"});
        for (const YAML::Node &object : yaml_.list(world, "collision_objects"))
        {
            readObject(object);
        }
        if (YamlFile::has(world, "octomap"))
        {
            readOctomap(world["octomap"]);
        }
    }

    void SceneReader::readFixedFrames(const YAML::Node &root)
    {
        std::vector<FixedTransform> transforms;
        for (const YAML::Node &node : yaml_.list(root, "fixed_frame_transforms"))
        {
            yaml_.checkKeys(node, "fixed_frame_transforms", {"header", "child_frame_id", "transform"});
            FixedTransform transform;
            transform.place = yaml_.place(node);
            transform.parent = frameName(node);
            transform.child = withoutSlash(yaml_.text(node, "child_frame_id"));
            if (transform.child.empty())
            {
                yaml_.fail(node, "key 'child_frame_id' is missing or empty");
            }
            transform.pose = readTransform(yaml_.required(node, "transform"), "transform", "translation", "rotation");
            unset_.warn(transform.place + ": fixed_frame_transforms: '" + transform.child + "'");
            transforms.push_back(std::move(transform));
        }
        frames_ = FixedFrames(transforms);
    }

    // The frame in the header of a message; empty if there is none.
    std::string SceneReader::frameName(const YAML::Node &message) const
    {
        if (!YamlFile::has(message, "header"))
        {
            return "";
        }
        yaml_.checkKeys(message["header"], "header", {"seq", "stamp", "frame_id"});
        return withoutSlash(yaml_.text(message["header"], "frame_id"));
    }

    fcl::Transform3d SceneReader::findFrame(const YAML::Node &message, const std::string &owner) const
    {
        const std::string name = frameName(message);
        if (const auto fixed = frames_.find(name))
        {
            return *fixed;
        }
        if (const auto onObject = world_.findFrame(name))
        {
            return *onObject;
        }
        if (const auto other = otherFrames_ ? otherFrames_(name) : std::nullopt)
        {
            return *other;
        }
        yaml_.fail(message["header"]["frame_id"], owner + ": the frame '" + name +
                                                      "' is not known; accepted are objects before this one, " +
                                                      frames_.names() + ", and what fixed_frame_transforms place");
    }

    // An unset map has no data.
    void SceneReader::readOctomap(const YAML::Node &octomap)
    {
        yaml_.checkKeys(octomap, "octomap", {"header", "origin", "octomap"});
        if (!YamlFile::has(octomap, "octomap"))
        {
            return;
        }
        const YAML::Node map = octomap["octomap"];
        yaml_.checkKeys(map, "octomap.octomap", {"header", "binary", "id", "resolution", "data"});
        // A map of free space only is not an obstacle.
        const auto geometry = readOctree(yaml_, map);
        if (!geometry)
        {
            return;
        }
        // MoveIt uses the outer header.
        fcl::Transform3d pose = findFrame(frameName(octomap).empty() ? map : octomap, "octomap");
        if (YamlFile::has(octomap, "origin"))
        {
            pose = pose * readPose(octomap["origin"]);
        }
        unset_.warn(yaml_.place(octomap) + ": octomap");
        world_.add({OCTOMAP_ID, pose, {{geometry}}, {}});
    }

    void SceneReader::readObject(const YAML::Node &node)
    {
        yaml_.checkKeys(node, "collision object",
                        {"id", "header", "type", "pose", "operation", "primitives", "primitive_poses", "meshes",
                         "mesh_poses", "planes", "plane_poses", "subframe_names", "subframe_poses"});
        if (!node["id"] || node["id"].IsNull())
        {
            yaml_.fail(node, "key 'id' is missing or empty");
        }
        const std::string id = yaml_.text(node, "id");
        if (id == OCTOMAP_ID)
        {
            yaml_.fail(node["id"], "id = " + id + " is MoveIt's name of the occupancy map");
        }
        const Operation operation = readOperation(node);
        if (operation == Operation::Add || operation == Operation::Append)
        {
            const MoveItWorld::Object object = readShapesOf(node, id);
            put(node, object, operation);
        }
        else
        {
            change(node, id, operation);
        }
        unset_.warn(yaml_.place(node) + ": object '" + id + "'");
    }

    // By number or name. Some tools print the byte of the message as text.
    SceneReader::Operation SceneReader::readOperation(const YAML::Node &node) const
    {
        if (!YamlFile::has(node, "operation"))
        {
            return Operation::Add;
        }
        const std::string text = lowerCase(yaml_.text(node, "operation"));
        for (std::size_t i = 0; i < OPERATIONS.size(); ++i)
        {
            if (text == OPERATIONS[i] || text == std::to_string(i) || text == std::string(1, static_cast<char>(i)))
            {
                return static_cast<Operation>(i);
            }
        }
        yaml_.fail(node["operation"],
                   "operation = " + text + ": must be 0 or 'add', 1 or 'remove', 2 or 'append', 3 or 'move'");
    }

    void SceneReader::put(const YAML::Node &node, const MoveItWorld::Object &object, Operation operation)
    {
        if (operation == Operation::Append)
        {
            world_.append(object);
        }
        else if (world_.add(object))
        {
            warnOfScene(yaml_.place(node) + ": object '" + object.id +
                        "' takes the place of the one of this name before it, as in MoveIt; 'append' would "
                        "keep both");
        }
    }

    void SceneReader::change(const YAML::Node &node, const std::string &id, Operation operation)
    {
        const bool present = operation == Operation::Remove
                                 ? world_.remove(id)
                                 : world_.move(id, findFrame(node, "object '" + id + "'") * readPoseOf(node));
        if (!present)
        {
            const auto number = static_cast<std::size_t>(operation);
            yaml_.fail(node["operation"], "operation = " + std::to_string(number) + " ('" + OPERATIONS[number] +
                                              "'): there is no object '" + id + "' before it");
        }
    }

    template <typename ReadShape>
    void SceneReader::readShapes(const YAML::Node &node, const std::string &shapesKey, const std::string &posesKey,
                                 MoveItWorld::Object &object, const ReadShape &readShape)
    {
        const YAML::Node shapes = yaml_.list(node, shapesKey);
        const YAML::Node poses = yaml_.list(node, posesKey);
        if (poses.size() > 0 && poses.size() != shapes.size())
        {
            yaml_.fail(poses, posesKey + " has " + std::to_string(poses.size()) + " entries for " +
                                  std::to_string(shapes.size()) + " " + shapesKey);
        }
        if (poses.size() == 0 && shapes.size() > 0 && YamlFile::has(node, posesKey))
        {
            unset_.add(posesKey + " ([])");
        }
        for (std::size_t i = 0; i < shapes.size(); ++i)
        {
            MoveItWorld::Shape shape = readShape(shapes[i]);
            if (poses.size() > 0)
            {
                shape.pose = readPose(poses[i]);
            }
            object.shapes.push_back(std::move(shape));
        }
    }

    MoveItWorld::Object SceneReader::readShapesOf(const YAML::Node &node, const std::string &id, bool mayBeEmpty)
    {
        if (yaml_.list(node, "planes").size() > 0)
        {
            yaml_.fail(node["planes"], "planes are not supported; accepted are primitives and meshes");
        }
        if (yaml_.list(node, "plane_poses").size() > 0)
        {
            yaml_.fail(node["plane_poses"], "plane_poses has entries, but there are no planes");
        }
        MoveItWorld::Object object;
        object.id = id;
        object.pose = readPoseOf(node);
        readShapes(node, "primitives", "primitive_poses", object,
                   [this](const YAML::Node &shape) { return MoveItWorld::Shape{readPrimitive(yaml_, shape)}; });
        readShapes(
            node, "meshes", "mesh_poses", object,
            [this](const YAML::Node &shape)
            {
                const TriangleMesh mesh = readMesh(yaml_, shape, folders_);
                return MoveItWorld::Shape{makeMeshGeometry(mesh), fcl::Transform3d::Identity(), mesh.skippedFaces};
            });
        if (object.shapes.empty() && !mayBeEmpty)
        {
            yaml_.fail(node, "object '" + id + "' has no primitives and no meshes");
        }
        if (object.shapes.size() == 1 && object.pose.matrix().isIdentity(0.))
        {
            // As in MoveIt; other objects may be placed in the frame of this one.
            std::swap(object.pose, object.shapes.front().pose);
        }
        object.pose = findFrame(node, "object '" + id + "'") * object.pose;
        readSubframes(node, object);
        return object;
    }

    void SceneReader::readSubframes(const YAML::Node &node, MoveItWorld::Object &object)
    {
        const YAML::Node names = yaml_.list(node, "subframe_names");
        const YAML::Node poses = yaml_.list(node, "subframe_poses");
        if (names.size() != poses.size())
        {
            yaml_.fail(names.size() > 0 ? names : poses, "subframe_names has " + std::to_string(names.size()) +
                                                             " entries and subframe_poses " +
                                                             std::to_string(poses.size()));
        }
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            if (!names[i].IsScalar())
            {
                yaml_.fail(names[i], "subframe_names must be names");
            }
            object.subframes[names[i].Scalar()] = readPose(poses[i]);
        }
    }

    fcl::Transform3d SceneReader::readPoseOf(const YAML::Node &node)
    {
        return YamlFile::has(node, "pose") ? readPose(node["pose"]) : fcl::Transform3d::Identity();
    }

    fcl::Transform3d SceneReader::readPose(const YAML::Node &node)
    {
        return readTransform(node, "pose", "position", "orientation");
    }

    fcl::Transform3d SceneReader::readTransform(const YAML::Node &node, const std::string &what,
                                                const std::string &translation, const std::string &rotation)
    {
        yaml_.checkKeys(node, what, {translation, rotation});
        fcl::Transform3d pose = fcl::Transform3d::Identity();
        if (node[translation])
        {
            pose.translation() = yaml_.vector<3>(node[translation], translation, {"x", "y", "z"});
        }
        if (node[rotation])
        {
            const auto matrix =
                rotationOf(yaml_.vector<4>(node[rotation], rotation, {"x", "y", "z", "w"}), rotation, unset_);
            if (!matrix)
            {
                yaml_.fail(node[rotation], rotation +
                                               ": a quaternion of a length near 0 is no rotation; accepted are others, "
                                               "and 0 0 0 0 for none");
            }
            pose.linear() = *matrix;
        }
        return pose;
    }
}  // namespace ompl_mfa::collision
