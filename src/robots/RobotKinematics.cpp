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

#include "ompl_mfa/robots/RobotKinematics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ompl_mfa::robots
{
    namespace
    {
        fcl::Matrix3d crossMatrix(const fcl::Vector3d &v)
        {
            fcl::Matrix3d matrix;
            matrix << 0., -v.z(), v.y(), v.z(), 0., -v.x(), -v.y(), v.x(), 0.;
            return matrix;
        }
    }  // namespace

    RobotKinematics::RobotKinematics(const RobotModel &model, const std::vector<std::size_t> &group,
                                     const std::vector<double> &values, const fcl::Transform3d &base)
      : dimension_(group.size())
      , bodyOfLink_(model.links().size(), 0)
      , poseInBody_(model.links().size(), base)
    {
        for (const std::size_t joint : group)
        {
            if (joint >= model.joints().size() || !model.joints()[joint].isMoving() || model.joints()[joint].mimic)
            {
                throw std::invalid_argument("RobotKinematics: a joint of the group does not move by itself");
            }
        }
        for (std::size_t i = 0; i < model.joints().size(); ++i)
        {
            const Joint &joint = model.joints()[i];
            const std::size_t source = joint.mimic ? joint.mimic->joint : i;
            const auto variable = std::find(group.begin(), group.end(), source);
            if (joint.isMoving() && variable != group.end())
            {
                addStep(joint, model.joints()[source], static_cast<std::size_t>(variable - group.begin()));
                continue;
            }
            const double value =
                joint.mimic ? joint.mimic->multiplier * values[source] + joint.mimic->offset : values[i];
            bodyOfLink_[joint.childLink] = bodyOfLink_[joint.parentLink];
            poseInBody_[joint.childLink] = poseInBody_[joint.parentLink] * joint.origin * jointMotion(joint, value);
        }
    }

    void RobotKinematics::addStep(const Joint &joint, const Joint &source, std::size_t variable)
    {
        const fcl::Transform3d origin = poseInBody_[joint.parentLink] * joint.origin;
        Step step;
        step.parent = bodyOfLink_[joint.parentLink];
        step.variable = variable;
        step.multiplier = joint.mimic ? joint.mimic->multiplier : 1.;
        step.offset = joint.mimic ? joint.mimic->offset : 0.;
        step.origin = origin.translation();
        step.isPrismatic = joint.type == JointType::Prismatic;
        if (step.isPrismatic)
        {
            step.constant = origin.linear();
            step.direction = origin.linear() * joint.axis;
            step.longestTravel = std::max(std::abs(step.multiplier * source.lower + step.offset),
                                          std::abs(step.multiplier * source.upper + step.offset));
        }
        else
        {
            // Rodrigues' formula
            const fcl::Matrix3d along = joint.axis * joint.axis.transpose();
            step.constant = origin.linear() * along;
            step.sine = origin.linear() * crossMatrix(joint.axis);
            step.cosine = origin.linear() * (fcl::Matrix3d::Identity() - along);
        }
        steps_.push_back(step);
        bodyOfLink_[joint.childLink] = steps_.size();
        poseInBody_[joint.childLink] = fcl::Transform3d::Identity();
    }

    void RobotKinematics::place(const double *q, fcl::Transform3d *bodies) const
    {
        bodies[0].setIdentity();
        for (std::size_t i = 0; i < steps_.size(); ++i)
        {
            const Step &step = steps_[i];
            const fcl::Transform3d &parent = bodies[step.parent];
            fcl::Transform3d &body = bodies[i + 1];
            const double value = step.multiplier * q[step.variable] + step.offset;
            body.makeAffine();
            if (step.isPrismatic)
            {
                body.linear().noalias() = parent.linear() * step.constant;
                body.translation() = parent.translation() + parent.linear() * (step.origin + value * step.direction);
            }
            else
            {
                const fcl::Matrix3d rotation =
                    step.constant + std::sin(value) * step.sine + std::cos(value) * step.cosine;
                body.linear().noalias() = parent.linear() * rotation;
                body.translation() = parent.translation() + parent.linear() * step.origin;
            }
        }
    }

    std::vector<RobotKinematics::Leverage> RobotKinematics::leverages(std::size_t body, double reach) const
    {
        std::vector<Leverage> leverages;
        // `reach` bounds the distance of the points from the origin of the joint that moves `body`.
        while (body > 0)
        {
            const Step &step = steps_[body - 1];
            reach += step.longestTravel;
            leverages.push_back({body - 1, std::abs(step.multiplier) * (step.isPrismatic ? 1. : reach)});
            reach += step.origin.norm();
            body = step.parent;
        }
        return leverages;
    }
}  // namespace ompl_mfa::robots
