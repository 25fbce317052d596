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

#include "ompl_mfa/robots/MotionRequest.h"

#include <cmath>

#include "collision/YamlFile.h"
#include "collision/YamlRobotState.h"
#include "ompl_mfa/PlainText.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using collision::YamlFile;

        const YamlFile::Names CONSTRAINTS{"joint_constraints", "position_constraints", "orientation_constraints",
                                          "visibility_constraints"};

        class RequestReader
        {
        public:
            explicit RequestReader(const std::filesystem::path &file)
              : yaml_(file, "motion plan request")
            {
                request_.file = file;
            }

            MotionRequest read()
            {
                const YAML::Node root = yaml_.message();
                yaml_.checkKeys(
                    root, "motion plan request",
                    {"workspace_parameters", "start_state", "goal_constraints", "path_constraints",
                     "trajectory_constraints", "reference_trajectories", "pipeline_id", "planner_id", "group_name",
                     "num_planning_attempts", "allowed_planning_time", "max_velocity_scaling_factor",
                     "max_acceleration_scaling_factor", "cartesian_speed_end_effector_link",
                     "cartesian_speed_limited_link", "max_cartesian_speed"});
                refuse(YamlFile::optional(root, "path_constraints"), "path_constraints");
                const YAML::Node trajectory = YamlFile::optional(root, "trajectory_constraints");
                yaml_.checkKeys(trajectory, "trajectory_constraints", {"constraints"});
                for (const YAML::Node &constraints : yaml_.list(trajectory, "constraints"))
                {
                    refuse(constraints, "trajectory_constraints");
                }
                if (yaml_.list(root, "reference_trajectories").size() > 0)
                {
                    yaml_.fail(root["reference_trajectories"], "reference_trajectories are not supported");
                }
                request_.group = yaml_.text(root, "group_name");
                request_.velocityScale = readScale(root, "max_velocity_scaling_factor");
                request_.accelerationScale = readScale(root, "max_acceleration_scaling_factor");
                readStart(root);
                readGoals(root);
                return std::move(request_);
            }

        private:
            // Constraints along the path, which the planner does not know.
            void refuse(const YAML::Node &constraints, const std::string &owner) const
            {
                checkConstraints(constraints, owner);
                for (const std::string &kind : CONSTRAINTS)
                {
                    if (yaml_.list(constraints, kind).size() > 0)
                    {
                        yaml_.fail(constraints[kind],
                                   owner + "." + kind + ": the path cannot be constrained; accepted is an empty list");
                    }
                }
            }

            void checkConstraints(const YAML::Node &constraints, const std::string &owner) const
            {
                YamlFile::Names keys = CONSTRAINTS;
                keys.insert("name");
                yaml_.checkKeys(constraints, owner, keys);
            }

            // As in MoveIt, 0 means 1.
            double readScale(const YAML::Node &root, const std::string &key) const
            {
                const double scale = YamlFile::has(root, key) ? yaml_.number(root[key], key) : 0.;
                if (scale < 0. || scale > 1.)
                {
                    yaml_.fail(root[key], key + " = " + root[key].Scalar() + ": must be from 0 to 1");
                }
                return scale == 0. ? 1. : scale;
            }

            void readStart(const YAML::Node &root)
            {
                if (!YamlFile::has(root, "start_state"))
                {
                    return;
                }
                request_.start = collision::readRobotState(yaml_, root["start_state"]);
                if (yaml_.list(root["start_state"], "attached_collision_objects").size() > 0)
                {
                    yaml_.fail(root["start_state"]["attached_collision_objects"],
                               "start_state.attached_collision_objects: objects are attached in the scene");
                }
            }

            void readGoals(const YAML::Node &root)
            {
                for (const YAML::Node &node : yaml_.list(root, "goal_constraints"))
                {
                    checkConstraints(node, "goal_constraints");
                    RequestedGoal goal;
                    goal.place = yaml_.place(node);
                    if (yaml_.list(node, "visibility_constraints").size() > 0)
                    {
                        yaml_.fail(node, "goal_constraints.visibility_constraints are not supported");
                    }
                    for (const YAML::Node &joint : yaml_.list(node, "joint_constraints"))
                    {
                        goal.joints.push_back(readJoint(joint));
                    }
                    readPose(node, goal);
                    if (goal.joints.empty() == !goal.pose)
                    {
                        yaml_.fail(node, goal.pose ? "goal_constraints: a goal is either of joints or a pose, not both"
                                                   : "goal_constraints: a goal needs joint_constraints or "
                                                     "position_constraints");
                    }
                    request_.goals.push_back(std::move(goal));
                }
            }

            JointTarget readJoint(const YAML::Node &node) const
            {
                yaml_.checkKeys(node, "joint_constraints",
                                {"joint_name", "position", "tolerance_above", "tolerance_below", "weight"});
                JointTarget target;
                target.joint = yaml_.required(node, "joint_name").Scalar();
                target.position = yaml_.number(yaml_.required(node, "position"), "position");
                target.above = readTolerance(node, "tolerance_above");
                target.below = readTolerance(node, "tolerance_below");
                target.place = yaml_.place(node);
                return target;
            }

            double readTolerance(const YAML::Node &node, const std::string &key) const
            {
                const double value = YamlFile::has(node, key) ? yaml_.number(node[key], key) : 0.;
                if (value < 0.)
                {
                    yaml_.fail(node[key], key + " = " + node[key].Scalar() + ": must not be negative");
                }
                return value;
            }

            void readPose(const YAML::Node &node, RequestedGoal &goal) const
            {
                const YAML::Node positions = yaml_.list(node, "position_constraints");
                const YAML::Node orientations = yaml_.list(node, "orientation_constraints");
                if (positions.size() > 1 || orientations.size() > 1)
                {
                    yaml_.fail(node, "goal_constraints: accepted are one position and one orientation a goal");
                }
                if (positions.size() == 0 && orientations.size() > 0)
                {
                    yaml_.fail(orientations[0],
                               "goal_constraints.orientation_constraints: an orientation without a "
                               "position is not supported");
                }
                if (positions.size() == 0)
                {
                    return;
                }
                PoseTarget pose;
                pose.place = yaml_.place(node);
                readPosition(positions[0], pose);
                if (orientations.size() > 0)
                {
                    readOrientation(orientations[0], pose);
                }
                goal.pose = pose;
            }

            std::string frameOf(const YAML::Node &node) const
            {
                const YAML::Node header = YamlFile::optional(node, "header");
                yaml_.checkKeys(header, "header", {"seq", "stamp", "frame_id"});
                const std::string frame = yaml_.text(header, "frame_id");
                return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
            }

            void readPosition(const YAML::Node &node, PoseTarget &pose) const
            {
                yaml_.checkKeys(node, "position_constraints",
                                {"header", "link_name", "target_point_offset", "constraint_region", "weight"});
                pose.link = yaml_.text(node, "link_name");
                pose.frame = frameOf(node);
                if (YamlFile::has(node, "target_point_offset"))
                {
                    pose.offset = yaml_.vector<3>(node["target_point_offset"], "target_point_offset", {"x", "y", "z"});
                }
                const YAML::Node region = yaml_.required(node, "constraint_region");
                yaml_.checkKeys(region, "constraint_region", {"primitives", "primitive_poses", "meshes", "mesh_poses"});
                const YAML::Node shapes = yaml_.list(region, "primitives");
                const YAML::Node poses = yaml_.list(region, "primitive_poses");
                if (shapes.size() != 1 || poses.size() != 1 || yaml_.list(region, "meshes").size() > 0)
                {
                    yaml_.fail(region, "constraint_region: accepted is one primitive with its pose");
                }
                readRegion(shapes[0], pose);
                pose.pose = collision::readTransform(yaml_, poses[0], "pose", "position", "orientation");
                if (!pose.isBall && !pose.pose.linear().isIdentity(1e-9))
                {
                    yaml_.fail(poses[0], "constraint_region: a box must be along the axes of its frame");
                }
            }

            void readRegion(const YAML::Node &shape, PoseTarget &pose) const
            {
                yaml_.checkKeys(shape, "primitive", {"type", "dimensions"});
                const std::string type = lowerCase(yaml_.required(shape, "type").Scalar());
                const YAML::Node dimensions = yaml_.list(shape, "dimensions");
                pose.isBall = type == "sphere" || type == "2";
                const bool isBox = type == "box" || type == "1";
                if ((!pose.isBall && !isBox) || dimensions.size() < (isBox ? 3U : 1U))
                {
                    yaml_.fail(shape, "constraint_region: accepted is a box with 3 or a sphere with 1 dimension");
                }
                for (int i = 0; i < 3; ++i)
                {
                    const double size = yaml_.number(dimensions[pose.isBall ? 0 : i], "dimensions");
                    if (size < 0.)
                    {
                        yaml_.fail(dimensions, "constraint_region: dimensions must not be negative");
                    }
                    pose.positionTolerance[i] = pose.isBall ? size : 0.5 * size;
                }
            }

            void readOrientation(const YAML::Node &node, PoseTarget &pose) const
            {
                yaml_.checkKeys(
                    node, "orientation_constraints",
                    {"header", "link_name", "orientation", "absolute_x_axis_tolerance", "absolute_y_axis_tolerance",
                     "absolute_z_axis_tolerance", "parameterization", "weight"});
                if (yaml_.text(node, "link_name") != pose.link || frameOf(node) != pose.frame)
                {
                    yaml_.fail(node, "orientation_constraints: link and frame must be those of the position, '" +
                                         pose.link + "' in '" + pose.frame + "'");
                }
                YAML::Node rotation(YAML::NodeType::Map);
                rotation["orientation"] = yaml_.required(node, "orientation");
                pose.pose.linear() =
                    collision::readTransform(yaml_, rotation, "orientation", "position", "orientation").linear();
                pose.rotationTolerance = fcl::Vector3d(readTolerance(node, "absolute_x_axis_tolerance"),
                                                       readTolerance(node, "absolute_y_axis_tolerance"),
                                                       readTolerance(node, "absolute_z_axis_tolerance"));
            }

            YamlFile yaml_;
            MotionRequest request_;
        };
    }  // namespace

    MotionRequest loadMotionRequest(const std::filesystem::path &file)
    {
        return RequestReader(file).read();
    }
}  // namespace ompl_mfa::robots
