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

#ifndef OMPL_MFA_COLLISION_MOVE_IT_WORLD_
#define OMPL_MFA_COLLISION_MOVE_IT_WORLD_

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fcl/geometry/collision_geometry.h>

#include "ompl_mfa/collision/Scene.h"

namespace ompl_mfa::collision
{
    /** \brief An entry of `fixed_frame_transforms`. */
    struct FixedTransform
    {
        /** \brief Name of the parent frame; empty means the planning frame. */
        std::string parent;

        /** \brief Name of the child frame. */
        std::string child;

        fcl::Transform3d pose{fcl::Transform3d::Identity()};

        /** \brief File and line, for error messages. */
        std::string place;
    };

    /** \brief Names and poses of the frames of a planning scene's fixed transforms. */
    class FixedFrames
    {
    public:
        FixedFrames() = default;

        /** \brief The planning frame is the only parent frame that is not a child; "world" if there is none.
            \throw InputError if there are two such frames, a frame has two transforms, or transforms form a cycle. */
        explicit FixedFrames(const std::vector<FixedTransform> &transforms);

        /** \brief Pose of the frame in the planning frame (also named by the empty name); empty if it is unknown. */
        std::optional<fcl::Transform3d> find(const std::string &name) const;

        /** \brief The known names, for error messages. */
        std::string names() const;

    private:
        using Children = std::map<std::string, FixedTransform>;

        static Children childrenOf(const std::vector<FixedTransform> &transforms);
        void namePlanningFrame(const std::vector<FixedTransform> &transforms, const Children &children);

        std::string planningFrame_{"world"};
        std::map<std::string, fcl::Transform3d> frames_;
    };

    /** \brief The objects of a planning scene by name, after the operations applied so far. */
    class MoveItWorld
    {
    public:
        struct Shape
        {
            std::shared_ptr<fcl::CollisionGeometryd> geometry;

            /** \brief Pose of the shape in its object. */
            fcl::Transform3d pose{fcl::Transform3d::Identity()};

            /** \brief As in CollisionObject. */
            std::size_t skippedFaces{0};
        };

        struct Object
        {
            std::string id;

            /** \brief Pose of the object in the planning frame. */
            fcl::Transform3d pose{fcl::Transform3d::Identity()};

            std::vector<Shape> shapes;

            /** \brief Poses of the subframes in the object, by name. */
            std::map<std::string, fcl::Transform3d> subframes;
        };

        /** \brief Add an object, replacing one of the same name.
            \return whether there was one. */
        bool add(Object object);

        /** \brief Append the shapes and subframes to the object of this name, which is created if there is none. */
        void append(const Object &object);

        /** \brief Move an object. \return whether there is one of this name. */
        bool move(const std::string &id, const fcl::Transform3d &pose);

        /** \brief Remove an object, or all if the name is empty.
            \return whether there is one of this name. */
        bool remove(const std::string &id);

        /** \brief The object of this name; null if there is none. */
        const Object *object(const std::string &id) const;

        /** \brief Pose of an object (by its name) or of a subframe (`object/subframe`) in the planning frame. */
        std::optional<fcl::Transform3d> findFrame(const std::string &name) const;

        /** \brief All shapes as obstacles. */
        Scene scene() const;

    private:
        Object *find(const std::string &id);

        std::vector<Object> objects_;
    };

    /** \brief A leading slash in a frame's name is ignored. */
    std::string withoutSlash(const std::string &frame);
}  // namespace ompl_mfa::collision

#endif
