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

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "collision/MeshResource.h"
#include "collision/ResourceFolders.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/collision/Primitive.h"
#include "ompl_mfa/collision/TriangleMesh.h"
#include "ompl_mfa/robots/RobotModel.h"
#include "robots/XmlFile.h"
#include "text/CLocaleScope.h"
#include "text/NumberText.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using collision::RigidBody;

        // urdfdom reports faults to console_bridge only.
        class Faults : public console_bridge::OutputHandler
        {
        public:
            Faults()
            {
                console_bridge::useOutputHandler(this);
            }

            ~Faults() override
            {
                console_bridge::restorePreviousOutputHandler();
            }

            void log(const std::string &text, console_bridge::LogLevel level, const char * /*file*/,
                     int /*line*/) override
            {
                if (level == console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first.empty())
                {
                    first = text;
                }
            }

            std::string first;
        };

        fcl::Transform3d poseOf(const urdf::Pose &pose)
        {
            fcl::Transform3d result = fcl::Transform3d::Identity();
            result.translation() = fcl::Vector3d(pose.position.x, pose.position.y, pose.position.z);
            const urdf::Rotation &q = pose.rotation;
            result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
            return result;
        }

        class UrdfReader
        {
        public:
            UrdfReader(const std::filesystem::path &file, const std::vector<std::filesystem::path> &packageFolders)
              : xml_(file, "URDF file")
              , folders_{file.parent_path()}
            {
                folders_.insert(folders_.end(), packageFolders.begin(), packageFolders.end());
                const collision::Folders named = collision::resourceFolders();
                folders_.insert(folders_.end(), named.begin(), named.end());
            }

            RobotModel read()
            {
                checkTree();
                XmlFile::forEach(xml_.root(), "joint", [this](const tinyxml2::XMLElement &joint) { checkType(joint); });
                urdf_ = parse();
                addLink(*urdf_->getRoot());
                for (Joint &joint : joints_)
                {
                    readMimic(joint);
                }
                for (const Joint &joint : joints_)
                {
                    resolveMimic(joint);
                }
                return {urdf_->getName(), std::move(links_), std::move(joints_)};
            }

        private:
            // urdfdom overwrites the first parent of a link that has two, and ignores circles beside the tree.
            void checkTree() const
            {
                std::map<std::string, std::string> parents;
                std::map<std::string, const tinyxml2::XMLElement *> carriers;
                XmlFile::forEach(xml_.root(), "joint",
                                 [&](const tinyxml2::XMLElement &joint)
                                 {
                                     const std::string child = linkOf(joint, "child");
                                     if (!carriers.emplace(child, &joint).second)
                                     {
                                         xml_.fail(joint, "joint '" + XmlFile::attribute(joint, "name") +
                                                              "' carries the link '" + child + "', which the joint '" +
                                                              XmlFile::attribute(*carriers[child], "name") +
                                                              "' carries too: loops of joints are not supported");
                                     }
                                     parents[child] = linkOf(joint, "parent");
                                 });
                for (const auto &[child, joint] : carriers)
                {
                    std::string link = child;
                    for (std::size_t steps = 0; parents.count(link) > 0; ++steps)
                    {
                        if (steps > parents.size())
                        {
                            xml_.fail(*joint, "joint '" + XmlFile::attribute(*joint, "name") +
                                                  "' is part of a loop of joints, which is not supported");
                        }
                        link = parents[link];
                    }
                }
            }

            static std::string linkOf(const tinyxml2::XMLElement &joint, const char *end)
            {
                const tinyxml2::XMLElement *link = joint.FirstChildElement(end);
                return link == nullptr ? "" : XmlFile::attribute(*link, "link");
            }

            void checkType(const tinyxml2::XMLElement &joint) const
            {
                const std::string type = XmlFile::attribute(joint, "type");
                if (type == "planar" || type == "floating")
                {
                    xml_.fail(joint, "joint '" + XmlFile::attribute(joint, "name") + "' is " + type +
                                         "; accepted are revolute, continuous, prismatic and fixed");
                }
            }

            urdf::ModelInterfaceSharedPtr parse() const
            {
                static std::mutex mutex;
                const std::lock_guard<std::mutex> lock(mutex);
                const text::CLocaleScope plainNumbers;
                Faults faults;
                urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDF(xml_.text());
                if (!urdf || !urdf->getRoot())
                {
                    xml_.fail(xml_.root(), "not a valid URDF file: " +
                                               (faults.first.empty() ? std::string("unknown fault") : faults.first));
                }
                return urdf;
            }

            void addLink(const urdf::Link &source)
            {
                const std::size_t index = links_.size();
                Link link;
                link.name = source.name;
                for (const urdf::CollisionSharedPtr &shape : source.collision_array)
                {
                    link.shapes.push_back(readShape(source.name, *shape));
                }
                if (source.parent_joint)
                {
                    link.parentJoint = index - 1;
                    addJoint(*source.parent_joint, index);
                }
                links_.push_back(std::move(link));
                for (const urdf::LinkSharedPtr &child : source.child_links)
                {
                    addLink(*child);
                }
            }

            void addJoint(const urdf::Joint &source, std::size_t child)
            {
                static const std::map<int, JointType> TYPES = {{urdf::Joint::FIXED, JointType::Fixed},
                                                               {urdf::Joint::REVOLUTE, JointType::Revolute},
                                                               {urdf::Joint::CONTINUOUS, JointType::Continuous},
                                                               {urdf::Joint::PRISMATIC, JointType::Prismatic}};
                const tinyxml2::XMLElement &element = *XmlFile::findNamed(xml_.root(), "joint", source.name);
                Joint joint;
                joint.name = source.name;
                joint.type = TYPES.at(source.type);
                joint.childLink = child;
                while (links_[joint.parentLink].name != source.parent_link_name)
                {
                    ++joint.parentLink;
                }
                joint.origin = poseOf(source.parent_to_joint_origin_transform);
                if (joint.isMoving())
                {
                    joint.axis = {source.axis.x, source.axis.y, source.axis.z};
                    const double length = joint.axis.norm();
                    if (!(length > 0.) || !std::isfinite(length))
                    {
                        xml_.fail(element, "joint '" + joint.name + "' has the axis 0 0 0, which is no direction");
                    }
                    joint.axis /= length;
                    readLimits(source, element, joint);
                }
                joints_.push_back(std::move(joint));
            }

            void readLimits(const urdf::Joint &source, const tinyxml2::XMLElement &element, Joint &joint) const
            {
                if (source.limits)
                {
                    joint.velocity = source.limits->velocity;
                    const tinyxml2::XMLElement *limit = element.FirstChildElement("limit");
                    const std::string acceleration = XmlFile::attribute(*limit, "acceleration");
                    if (!acceleration.empty() && !text::readNumber(acceleration, joint.acceleration))
                    {
                        xml_.fail(*limit,
                                  "joint '" + joint.name + "': acceleration = " + acceleration + ": must be a number");
                    }
                }
                if (!(joint.velocity >= 0.) || !(joint.acceleration >= 0.))
                {
                    xml_.fail(element, "joint '" + joint.name + "': velocity and acceleration must not be negative");
                }
                if (joint.type == JointType::Continuous)
                {
                    return;
                }
                joint.lower = source.limits->lower;
                joint.upper = source.limits->upper;
                checkOrder(element, joint);
            }

            void checkOrder(const tinyxml2::XMLElement &element, const Joint &joint) const
            {
                if (!(joint.lower <= joint.upper) || !std::isfinite(joint.lower) || !std::isfinite(joint.upper))
                {
                    xml_.fail(element, "joint '" + joint.name + "': the limits contradict each other: lower " +
                                           text::numberText(joint.lower) + ", upper " + text::numberText(joint.upper));
                }
            }

            void readMimic(Joint &joint) const
            {
                const urdf::JointConstSharedPtr source = urdf_->getJoint(joint.name);
                if (!source->mimic || !joint.isMoving())
                {
                    return;
                }
                const auto other =
                    std::find_if(joints_.begin(), joints_.end(),
                                 [&source](const Joint &one) { return one.name == source->mimic->joint_name; });
                if (other == joints_.end() || !other->isMoving())
                {
                    xml_.fail(elementOf(joint), "joint '" + joint.name + "' mimics '" + source->mimic->joint_name +
                                                    "', which is no moving joint of the robot");
                }
                joint.mimic = Mimic{static_cast<std::size_t>(other - joints_.begin()), source->mimic->multiplier,
                                    source->mimic->offset};
            }

            // A joint may follow one that follows another.
            void resolveMimic(const Joint &joint)
            {
                if (!joint.mimic)
                {
                    return;
                }
                Mimic mimic = *joint.mimic;
                for (std::size_t steps = 0; joints_[mimic.joint].mimic; ++steps)
                {
                    if (steps > joints_.size())
                    {
                        xml_.fail(elementOf(joint), "joint '" + joint.name + "' mimics itself");
                    }
                    const Mimic next = *joints_[mimic.joint].mimic;
                    mimic = {next.joint, mimic.multiplier * next.multiplier,
                             mimic.multiplier * next.offset + mimic.offset};
                }
                joints_[static_cast<std::size_t>(&joint - joints_.data())].mimic = mimic;
            }

            const tinyxml2::XMLElement &elementOf(const Joint &joint) const
            {
                return *XmlFile::findNamed(xml_.root(), "joint", joint.name);
            }

            RigidBody::Shape readShape(const std::string &link, const urdf::Collision &source) const
            {
                try
                {
                    RigidBody::Shape shape;
                    shape.pose = poseOf(source.origin);
                    readGeometry(*source.geometry, shape);
                    return shape;
                }
                catch (const std::exception &error)
                {
                    xml_.fail(*XmlFile::findNamed(xml_.root(), "link", link),
                              "collision geometry of the link '" + link + "': " + error.what());
                }
            }

            void readGeometry(const urdf::Geometry &source, RigidBody::Shape &shape) const
            {
                const auto make = [](const char *kind, const std::vector<double> &dimensions)
                { return collision::makePrimitive(*collision::findPrimitiveKind(kind), dimensions); };
                if (const auto *box = dynamic_cast<const urdf::Box *>(&source))
                {
                    shape.geometry = make("box", {box->dim.x, box->dim.y, box->dim.z});
                }
                else if (const auto *sphere = dynamic_cast<const urdf::Sphere *>(&source))
                {
                    shape.geometry = make("sphere", {sphere->radius});
                }
                else if (const auto *cylinder = dynamic_cast<const urdf::Cylinder *>(&source))
                {
                    shape.geometry = make("cylinder", {cylinder->length, cylinder->radius});
                }
                else if (const auto *mesh = dynamic_cast<const urdf::Mesh *>(&source))
                {
                    readMesh(*mesh, shape);
                }
                else
                {
                    throw InputError("unknown shape; accepted are box, cylinder, sphere and mesh");
                }
            }

            void readMesh(const urdf::Mesh &source, RigidBody::Shape &shape) const
            {
                const std::filesystem::path file = collision::findMeshResource(source.filename, folders_);
                collision::TriangleMesh mesh = collision::loadMesh(file, collision::RootTransform::Reset);
                const fcl::Vector3d scale(source.scale.x, source.scale.y, source.scale.z);
                if (!scale.allFinite() || (scale.array() == 0.).any())
                {
                    throw InputError("the scale of a mesh must be finite and not 0");
                }
                for (fcl::Vector3d &vertex : mesh.vertices)
                {
                    vertex = vertex.cwiseProduct(scale);
                }
                shape.geometry = collision::makeMeshGeometry(mesh);
                shape.skippedFaces = mesh.skippedFaces;
            }

            XmlFile xml_;
            collision::Folders folders_;
            urdf::ModelInterfaceSharedPtr urdf_;
            std::vector<Link> links_;
            std::vector<Joint> joints_;
        };
    }  // namespace

    RobotModel loadRobotModel(const std::filesystem::path &file,
                              const std::vector<std::filesystem::path> &packageFolders)
    {
        return UrdfReader(file, packageFolders).read();
    }
}  // namespace ompl_mfa::robots
