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

#ifndef OMPL_MFA_COLLISION_SCENE_READER_
#define OMPL_MFA_COLLISION_SCENE_READER_

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "collision/MeshResource.h"
#include "collision/MoveItWorld.h"
#include "collision/SceneWarnings.h"
#include "collision/YamlFile.h"

namespace ompl_mfa::collision
{
    /** \brief Reads the world of a planning scene in YAML. Errors are InputErrors that name the file and the line. */
    class SceneReader
    {
    public:
        /** \brief Pose of a frame in the planning frame; empty if it is not known. */
        using OtherFrames = std::function<std::optional<fcl::Transform3d>(const std::string &)>;

        /** \param otherFrames asked for frames that the scene does not define. */
        SceneReader(const std::filesystem::path &file, const Folders &packageFolders, OtherFrames otherFrames = {});

        const YamlFile &yaml() const
        {
            return yaml_;
        }

        /** \brief The message, whose keys are checked. */
        YAML::Node message() const;

        /** \brief Read the fixed transforms and apply the objects and the map of the message to world(). */
        void readWorld(const YAML::Node &root);

        MoveItWorld &world()
        {
            return world_;
        }

        /** \brief A `moveit_msgs/CollisionObject` with its pose in the planning frame.
            \param mayBeEmpty whether it needs no shapes. */
        MoveItWorld::Object readShapesOf(const YAML::Node &node, const std::string &id, bool mayBeEmpty = false);

        /** \brief A transform with a translation and a rotation, both of which may be missing. */
        fcl::Transform3d readTransform(const YAML::Node &node, const std::string &what, const std::string &translation,
                                       const std::string &rotation);

        /** \brief Write one warning for the unset fields that were read since the last one.
            \param owner what has them, with its file and line. */
        void warnOfUnset(const std::string &owner)
        {
            unset_.warn(owner);
        }

    private:
        enum class Operation
        {
            Add,
            Remove,
            Append,
            Move
        };

        void readFixedFrames(const YAML::Node &root);
        std::string frameName(const YAML::Node &message) const;
        fcl::Transform3d findFrame(const YAML::Node &message, const std::string &owner) const;
        void readOctomap(const YAML::Node &octomap);
        void readObject(const YAML::Node &node);
        Operation readOperation(const YAML::Node &node) const;
        void put(const YAML::Node &node, const MoveItWorld::Object &object, Operation operation);
        void change(const YAML::Node &node, const std::string &id, Operation operation);
        template <typename ReadShape>
        void readShapes(const YAML::Node &node, const std::string &shapesKey, const std::string &posesKey,
                        MoveItWorld::Object &object, const ReadShape &readShape);
        void readSubframes(const YAML::Node &node, MoveItWorld::Object &object);
        fcl::Transform3d readPoseOf(const YAML::Node &node);
        fcl::Transform3d readPose(const YAML::Node &node);

        YamlFile yaml_;
        Folders folders_;
        OtherFrames otherFrames_;
        FixedFrames frames_;
        MoveItWorld world_;
        UnsetFields unset_;
    };
}  // namespace ompl_mfa::collision

#endif
