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

#include "robots/PoseSampler.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "ompl_mfa/InputError.h"
#include "robots/UnknownName.h"
#include "text/NumberText.h"

namespace ompl_mfa::robots
{
    namespace
    {
        constexpr double PI = 3.141592653589793;
        constexpr double POSITION_ACCURACY = 1e-5;
        constexpr double ROTATION_ACCURACY = 1e-4;
    }  // namespace

    // Orocos KDL is not used: Debian's library and libompl contain the same functions of different versions of Eigen.
    // The dynamic linker mixes them, and OMPL's informed samplers crash.
    struct PoseSampler::Chain
    {
        /* A fixed pose, behind which there may be a joint. */
        struct Segment
        {
            fcl::Transform3d origin{fcl::Transform3d::Identity()};
            const Joint *joint{nullptr};
            std::size_t variable{0};  ///< index in the group
        };

        std::vector<Segment> segments;  ///< all but the last one have a joint

        std::vector<std::size_t> variables;  ///< those of the segments
        Eigen::VectorXd values;
        fcl::Transform3d reached{fcl::Transform3d::Identity()};
        Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian;  ///< rows: position, rotation about the axes of the world

        void finish()
        {
            for (const Segment &segment : segments)
            {
                if (segment.joint != nullptr)
                {
                    variables.push_back(segment.variable);
                }
            }
            const auto count = static_cast<Eigen::Index>(variables.size());
            values.setZero(count);
            jacobian.setZero(6, count);
        }

        /* Sets pose and Jacobian for the present values. */
        void update()
        {
            const auto count = values.size();
            Eigen::Matrix<double, 3, Eigen::Dynamic> axes(3, count);
            Eigen::Matrix<double, 3, Eigen::Dynamic> points(3, count);
            reached = fcl::Transform3d::Identity();
            Eigen::Index column = 0;
            for (const Segment &segment : segments)
            {
                reached = reached * segment.origin;
                if (segment.joint != nullptr)
                {
                    axes.col(column) = reached.linear() * segment.joint->axis;
                    points.col(column) = reached.translation();
                    reached = reached * jointMotion(*segment.joint, values[column]);
                    ++column;
                }
            }
            column = 0;
            for (const Segment &segment : segments)
            {
                if (segment.joint == nullptr)
                {
                    continue;
                }
                const fcl::Vector3d axis = axes.col(column);
                const bool slides = segment.joint->type == JointType::Prismatic;
                const fcl::Vector3d lever = reached.translation() - points.col(column);
                jacobian.block<3, 1>(0, column) = slides ? axis : fcl::Vector3d(axis.cross(lever));
                jacobian.block<3, 1>(3, column) = slides ? fcl::Vector3d(fcl::Vector3d::Zero()) : axis;
                ++column;
            }
        }
    };

    PoseSampler::PoseSampler(const PlacedRobot &robot, const PoseTarget &target)
      : target_(target)
    {
        for (const std::size_t joint : robot.group)
        {
            joints_.push_back(robot.model->joints()[joint]);
        }
        const auto link = robot.model->findLink(target.link);
        if (!link)
        {
            throw InputError(target.place +
                             ": goal_constraints: " + unknownName("link", target.link, namesOf(robot.model->links())));
        }
        findFrame(robot);
        const RobotKinematics kinematics(*robot.model, robot.group, robot.values, robot.base);
        if (kinematics.bodyOf(*link) == 0)
        {
            throw InputError(target.place + ": goal_constraints: the group does not move the link '" + target.link +
                             "'");
        }
        requireReach(robot, kinematics, *link);
        buildChain(robot, *link);
    }

    PoseSampler::~PoseSampler() = default;
    PoseSampler::PoseSampler(PoseSampler &&) noexcept = default;

    void PoseSampler::findFrame(const PlacedRobot &robot)
    {
        const std::string &frame = target_.frame;
        if (frame.empty() || frame == robot.semantics->worldFrame() || frame == "world")
        {
            return;
        }
        const RobotKinematics kinematics(*robot.model, robot.group, robot.values, robot.base);
        const auto link = robot.model->findLink(frame);
        if (!link || kinematics.bodyOf(*link) != 0)
        {
            throw InputError(target_.place + ": goal_constraints: the frame '" + frame +
                             "' is not known; accepted are the planning frame and links that stand still");
        }
        const fcl::Transform3d &pose = kinematics.poseInBody(*link);
        if (!target_.isBall && !pose.linear().isIdentity(1e-9))
        {
            throw InputError(target_.place + ": goal_constraints: a box must be along the axes of the planning frame");
        }
        target_.pose = pose * target_.pose;
    }

    void PoseSampler::requireReach(const PlacedRobot &robot, const RobotKinematics &kinematics, std::size_t link) const
    {
        std::size_t body = kinematics.bodyOf(link);
        double reach = (kinematics.poseInBody(link) * target_.offset).norm();
        for (; kinematics.steps()[body - 1].parent != 0; body = kinematics.steps()[body - 1].parent)
        {
            const RobotKinematics::Step &step = kinematics.steps()[body - 1];
            reach += step.longestTravel + step.origin.norm();
        }
        const RobotKinematics::Step &first = kinematics.steps()[body - 1];
        reach += first.longestTravel;
        const double distance = (target_.pose.translation() - first.origin).norm();
        const double region = target_.isBall ? target_.positionTolerance.x() : target_.positionTolerance.norm();
        if (distance - region > reach)
        {
            throw InputError(target_.place + ": goal_constraints: the position of '" + target_.link +
                             "' is out of reach: " + text::numberText(distance, 4) +
                             " m from the joint that carries the "
                             "arm of '" +
                             robot.model->name() + "', which is at most " + text::numberText(reach, 4) + " m long");
        }
    }

    void PoseSampler::buildChain(const PlacedRobot &robot, std::size_t link)
    {
        std::vector<std::size_t> path;
        for (std::size_t at = link; at > 0; at = robot.model->joints()[at - 1].parentLink)
        {
            path.insert(path.begin(), at - 1);
        }
        chain_ = std::make_unique<Chain>();
        fcl::Transform3d origin = robot.base;
        for (const std::size_t index : path)
        {
            const Joint &joint = robot.model->joints()[index];
            const std::size_t source = joint.mimic ? joint.mimic->joint : index;
            const auto variable = std::find(robot.group.begin(), robot.group.end(), source);
            origin = origin * joint.origin;
            if (!joint.isMoving() || variable == robot.group.end())
            {
                const double value = joint.mimic ? joint.mimic->multiplier * robot.values[source] + joint.mimic->offset
                                                 : robot.values[index];
                origin = origin * jointMotion(joint, value);
                continue;
            }
            if (joint.mimic)
            {
                throw InputError(target_.place + ": goal_constraints: the link '" + target_.link +
                                 "' is moved by the joint '" + joint.name +
                                 "', which follows another one; accepted are "
                                 "other links");
            }
            const auto number = static_cast<std::size_t>(variable - robot.group.begin());
            chain_->segments.push_back({origin, &joints_[number], number});
            origin = fcl::Transform3d::Identity();
        }
        chain_->segments.push_back({origin * fcl::Transform3d(Eigen::Translation3d(target_.offset)), nullptr, 0});
        chain_->finish();
    }

    // Projected to the tolerances in every step, so that arms of fewer degrees of freedom than a pose find what they
    // reach.
    fcl::Transform3d PoseSampler::nearestTarget(const fcl::Transform3d &reached, double share) const
    {
        fcl::Transform3d target = target_.pose;
        const fcl::Vector3d offset = reached.translation() - target.translation();
        const fcl::Vector3d tolerance = share * target_.positionTolerance;
        if (target_.isBall)
        {
            const double length = offset.norm();
            target.translation() += offset * (length > tolerance.x() ? tolerance.x() / length : 1.);
        }
        else
        {
            target.translation() += offset.cwiseMax(-tolerance).cwiseMin(tolerance);
        }
        if (target_.rotationTolerance)
        {
            // Angles about x, y and z, in this order, as in MoveIt.
            const fcl::Matrix3d turn = target_.pose.linear().transpose() * reached.linear();
            const fcl::Vector3d angles(std::atan2(-turn(1, 2), turn(2, 2)), std::asin(std::clamp(turn(0, 2), -1., 1.)),
                                       std::atan2(-turn(0, 1), turn(0, 0)));
            const fcl::Vector3d allowed = share * *target_.rotationTolerance;
            for (int i = 0; i < 3; ++i)
            {
                const double angle = std::clamp(angles[i], -allowed[i], allowed[i]);
                target.linear() = target.linear() * Eigen::AngleAxisd(angle, fcl::Vector3d::Unit(i)).toRotationMatrix();
            }
        }
        return target;
    }

    bool PoseSampler::sample(std::vector<double> &values)
    {
        if (!random_)
        {
            random_ = std::make_unique<ompl::RNG>();
        }
        values.resize(joints_.size());
        for (std::size_t i = 0; i < joints_.size(); ++i)
        {
            values[i] = random_->uniformReal(std::max(joints_[i].lower, -PI), std::min(joints_[i].upper, PI));
        }
        // A random part of the tolerances, so that not all solutions are at their ends.
        const double share = 0.99 * random_->uniform01();
        for (std::size_t i = 0; i < chain_->variables.size(); ++i)
        {
            chain_->values[static_cast<Eigen::Index>(i)] = values[chain_->variables[i]];
        }
        if (!solve(share))
        {
            return false;
        }
        for (std::size_t i = 0; i < chain_->variables.size(); ++i)
        {
            values[chain_->variables[i]] = chain_->values[static_cast<Eigen::Index>(i)];
        }
        return bringWithinLimits(values);
    }

    // Damped least squares, with less damping the nearer the target is.
    bool PoseSampler::solve(double share)
    {
        constexpr int ITERATIONS = 100;
        constexpr double DAMPING = 0.01;
        constexpr double SMALLEST_DAMPING = 1e-9;
        constexpr double LARGEST_STEP = 0.5;
        const int rows = target_.rotationTolerance ? 6 : 3;
        for (int iteration = 0; iteration < ITERATIONS; ++iteration)
        {
            chain_->update();
            const fcl::Transform3d goal = nearestTarget(chain_->reached, share);
            const Eigen::AngleAxisd turn(fcl::Matrix3d(goal.linear() * chain_->reached.linear().transpose()));
            Eigen::Matrix<double, 6, 1> error;
            error << goal.translation() - chain_->reached.translation(), turn.angle() * turn.axis();
            if (error.head<3>().norm() <= POSITION_ACCURACY &&
                (rows == 3 || error.tail<3>().norm() <= ROTATION_ACCURACY))
            {
                return true;
            }
            Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian = chain_->jacobian;
            if (rows == 3)
            {
                error.tail<3>().setZero();
                jacobian.bottomRows<3>().setZero();
            }
            Eigen::Matrix<double, 6, 6> square = jacobian * jacobian.transpose();
            square.diagonal().array() += DAMPING * error.squaredNorm() + SMALLEST_DAMPING;
            Eigen::VectorXd step = jacobian.transpose() * square.ldlt().solve(error);
            const double largest = step.cwiseAbs().maxCoeff();
            step *= largest > LARGEST_STEP ? LARGEST_STEP / largest : 1.;
            for (std::size_t i = 0; i < chain_->variables.size(); ++i)
            {
                const auto k = static_cast<Eigen::Index>(i);
                const Joint &joint = joints_[chain_->variables[i]];
                chain_->values[k] = std::clamp(chain_->values[k] + step[k], joint.lower, joint.upper);
            }
        }
        return false;
    }

    bool PoseSampler::bringWithinLimits(std::vector<double> &values) const
    {
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            const Joint &joint = joints_[i];
            if (!std::isfinite(values[i]))
            {
                return false;
            }
            if (joint.type != JointType::Prismatic)
            {
                const double middle = std::isfinite(joint.lower) ? 0.5 * (joint.lower + joint.upper) : 0.;
                values[i] = middle + std::remainder(values[i] - middle, 2. * PI);
            }
            if (values[i] < joint.lower || values[i] > joint.upper)
            {
                return false;
            }
        }
        return true;
    }
}  // namespace ompl_mfa::robots
