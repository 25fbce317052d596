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

#include "ompl_mfa/robots/RobotModel.h"

#include <algorithm>
#include <stdexcept>

namespace ompl_mfa::robots
{
    namespace
    {
        template <typename Named>
        std::optional<std::size_t> indexOf(const std::vector<Named> &all, const std::string &name)
        {
            const auto found =
                std::find_if(all.begin(), all.end(), [&name](const Named &one) { return one.name == name; });
            return found == all.end() ? std::nullopt
                                      : std::make_optional(static_cast<std::size_t>(found - all.begin()));
        }
    }  // namespace

    RobotModel::RobotModel(std::string name, std::vector<Link> links, std::vector<Joint> joints)
      : name_(std::move(name))
      , links_(std::move(links))
      , joints_(std::move(joints))
    {
        bool isTree = !links_.empty() && !links_.front().parentJoint && joints_.size() + 1 == links_.size();
        for (std::size_t i = 0; isTree && i < joints_.size(); ++i)
        {
            isTree = joints_[i].childLink == i + 1 && joints_[i].parentLink <= i && links_[i + 1].parentJoint == i &&
                     (!joints_[i].mimic ||
                      (joints_[i].mimic->joint < joints_.size() && !joints_[joints_[i].mimic->joint].mimic));
        }
        if (!isTree)
        {
            throw std::invalid_argument("RobotModel: links and joints must form a tree, parents first");
        }
    }

    std::optional<std::size_t> RobotModel::findLink(const std::string &name) const
    {
        return indexOf(links_, name);
    }

    std::optional<std::size_t> RobotModel::findJoint(const std::string &name) const
    {
        return indexOf(joints_, name);
    }

    double RobotModel::defaultValue(std::size_t joint) const
    {
        const Joint &one = joints_[joint];
        return one.lower > 0. || one.upper < 0. ? 0.5 * (one.lower + one.upper) : 0.;
    }

    std::vector<fcl::Transform3d> RobotModel::linkPoses(const std::vector<double> &values) const
    {
        std::vector<fcl::Transform3d> poses(links_.size(), fcl::Transform3d::Identity());
        for (std::size_t i = 0; i < joints_.size(); ++i)
        {
            const Joint &joint = joints_[i];
            const double value =
                joint.mimic ? joint.mimic->multiplier * values[joint.mimic->joint] + joint.mimic->offset : values[i];
            poses[joint.childLink] = poses[joint.parentLink] * joint.origin * jointMotion(joint, value);
        }
        return poses;
    }

    fcl::Transform3d jointMotion(const Joint &joint, double value)
    {
        fcl::Transform3d motion = fcl::Transform3d::Identity();
        if (joint.type == JointType::Prismatic)
        {
            motion.translation() = value * joint.axis;
        }
        else if (joint.isMoving())
        {
            motion.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
        }
        return motion;
    }
}  // namespace ompl_mfa::robots
