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

#include "collision/MoveItWorld.h"

#include <algorithm>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::collision
{
    FixedFrames::FixedFrames(const std::vector<FixedTransform> &transforms)
    {
        const Children children = childrenOf(transforms);
        namePlanningFrame(transforms, children);
        for (const auto &[name, transform] : children)
        {
            fcl::Transform3d pose = transform.pose;
            std::size_t steps = 0;
            for (auto parent = children.find(transform.parent); parent != children.end();
                 parent = children.find(parent->second.parent))
            {
                if (++steps > children.size())
                {
                    throw InputError(transform.place + ": fixed_frame_transforms place the frame '" + name +
                                     "' in a circle");
                }
                pose = parent->second.pose * pose;
            }
            frames_[name] = pose;
        }
    }

    FixedFrames::Children FixedFrames::childrenOf(const std::vector<FixedTransform> &transforms)
    {
        Children children;
        for (const FixedTransform &transform : transforms)
        {
            if (transform.child == transform.parent)
            {
                // MoveIt writes the planning frame as a transform to itself.
                if (!transform.pose.matrix().isIdentity(1e-9))
                {
                    throw InputError(transform.place + ": fixed_frame_transforms displace the frame '" +
                                     transform.child + "' from itself");
                }
            }
            else if (!children.emplace(transform.child, transform).second)
            {
                throw InputError(transform.place + ": fixed_frame_transforms place the frame '" + transform.child +
                                 "' twice");
            }
        }
        return children;
    }

    void FixedFrames::namePlanningFrame(const std::vector<FixedTransform> &transforms, const Children &children)
    {
        std::string named;
        for (const FixedTransform &transform : transforms)
        {
            if (transform.parent.empty() || children.count(transform.parent) > 0)
            {
                continue;
            }
            if (!named.empty() && named != transform.parent)
            {
                throw InputError(transform.place + ": fixed_frame_transforms are given in two frames, '" + named +
                                 "' and '" + transform.parent + "', which nothing connects; accepted is one");
            }
            named = transform.parent;
        }
        if (!named.empty())
        {
            planningFrame_ = named;
        }
    }

    std::optional<fcl::Transform3d> FixedFrames::find(const std::string &name) const
    {
        const auto frame = frames_.find(name);
        if (frame != frames_.end())
        {
            return frame->second;
        }
        return name.empty() || name == planningFrame_ ? std::make_optional(fcl::Transform3d::Identity()) : std::nullopt;
    }

    std::string FixedFrames::names() const
    {
        std::string names = frames_.count(planningFrame_) > 0 ? "" : planningFrame_;
        for (const auto &[name, pose] : frames_)
        {
            names += (names.empty() ? "" : ", ") + name;
        }
        return names;
    }

    bool MoveItWorld::add(Object object)
    {
        if (Object *present = find(object.id))
        {
            *present = std::move(object);
            return true;
        }
        objects_.push_back(std::move(object));
        return false;
    }

    void MoveItWorld::append(const Object &object)
    {
        Object *present = find(object.id);
        if (present == nullptr)
        {
            objects_.push_back(object);
            return;
        }
        const fcl::Transform3d toPresent = present->pose.inverse() * object.pose;
        for (const Shape &shape : object.shapes)
        {
            present->shapes.push_back({shape.geometry, toPresent * shape.pose, shape.skippedFaces});
        }
        for (const auto &[name, pose] : object.subframes)
        {
            present->subframes[name] = toPresent * pose;
        }
    }

    bool MoveItWorld::move(const std::string &id, const fcl::Transform3d &pose)
    {
        Object *present = find(id);
        if (present == nullptr)
        {
            return false;
        }
        present->pose = pose;
        return true;
    }

    bool MoveItWorld::remove(const std::string &id)
    {
        if (id.empty())
        {
            objects_.clear();
            return true;
        }
        const std::size_t before = objects_.size();
        objects_.erase(
            std::remove_if(objects_.begin(), objects_.end(), [&id](const Object &object) { return object.id == id; }),
            objects_.end());
        return objects_.size() < before;
    }

    std::optional<fcl::Transform3d> MoveItWorld::findFrame(const std::string &name) const
    {
        for (const Object &object : objects_)
        {
            if (name.empty() || name.compare(0, object.id.size(), object.id) != 0)
            {
                continue;
            }
            if (name.size() == object.id.size())
            {
                return object.pose;
            }
            const auto subframe = name[object.id.size()] == '/'
                                      ? object.subframes.find(name.substr(object.id.size() + 1))
                                      : object.subframes.end();
            if (subframe != object.subframes.end())
            {
                return object.pose * subframe->second;
            }
        }
        return std::nullopt;
    }

    Scene MoveItWorld::scene() const
    {
        Scene scene;
        for (const Object &object : objects_)
        {
            for (const Shape &shape : object.shapes)
            {
                scene.add({object.id, shape.geometry, object.pose * shape.pose, shape.skippedFaces});
            }
        }
        return scene;
    }

    MoveItWorld::Object *MoveItWorld::find(const std::string &id)
    {
        const auto object =
            std::find_if(objects_.begin(), objects_.end(), [&id](const Object &known) { return known.id == id; });
        return object == objects_.end() ? nullptr : &*object;
    }

    const MoveItWorld::Object *MoveItWorld::object(const std::string &id) const
    {
        return const_cast<MoveItWorld *>(this)->find(id);
    }

    std::string withoutSlash(const std::string &frame)
    {
        return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
    }
}  // namespace ompl_mfa::collision
