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

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>

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

        KDL::Frame frameOf(const fcl::Transform3d &pose)
        {
            const fcl::Matrix3d &r = pose.linear();
            const fcl::Vector3d &p = pose.translation();
            return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
                    KDL::Vector(p.x(), p.y(), p.z())};
        }

        fcl::Transform3d poseOf(const KDL::Frame &frame)
        {
            fcl::Transform3d pose = fcl::Transform3d::Identity();
            for (int row = 0; row < 3; ++row)
            {
                pose.translation()[row] = frame.p(row);
                for (int column = 0; column < 3; ++column)
                {
                    pose.linear()(row, column) = frame.M(row, column);
                }
            }
            return pose;
        }

        KDL::Segment segmentOf(const Joint &joint)
        {
            const KDL::Frame origin = frameOf(joint.origin);
            const KDL::Vector axis = origin.M * KDL::Vector(joint.axis.x(), joint.axis.y(), joint.axis.z());
            const auto kind = joint.type == JointType::Prismatic ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
            return KDL::Segment(KDL::Joint(joint.name, origin.p, axis, kind), origin);
        }
    }  // namespace

    // KDL's own solvers by singular values are not used: Debian's libkdl and libompl have the same functions of
    // different versions of Eigen, and the dynamic linker mixes them.
    struct PoseSampler::Chain
    {
        explicit Chain(const KDL::Chain &segments)
          : chain(segments)
          , forward(chain)
          , derivative(chain)
          , joints(chain.getNrOfJoints())
          , jacobian(chain.getNrOfJoints())
        {
        }

        KDL::Chain chain;
        KDL::ChainFkSolverPos_recursive forward;
        KDL::ChainJntToJacSolver derivative;
        KDL::JntArray joints;
        KDL::Jacobian jacobian;

        // Index in the group of each joint of the chain.
        std::vector<std::size_t> variables;
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
        KDL::Chain segments;
        segments.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed), frameOf(robot.base)));
        std::vector<std::size_t> variables;
        for (const std::size_t index : path)
        {
            const Joint &joint = robot.model->joints()[index];
            const std::size_t source = joint.mimic ? joint.mimic->joint : index;
            const auto variable = std::find(robot.group.begin(), robot.group.end(), source);
            if (!joint.isMoving() || variable == robot.group.end())
            {
                const double value = joint.mimic ? joint.mimic->multiplier * robot.values[source] + joint.mimic->offset
                                                 : robot.values[index];
                segments.addSegment(
                    KDL::Segment(KDL::Joint(KDL::Joint::Fixed), frameOf(joint.origin * jointMotion(joint, value))));
                continue;
            }
            if (joint.mimic)
            {
                throw InputError(target_.place + ": goal_constraints: the link '" + target_.link +
                                 "' is moved by the joint '" + joint.name +
                                 "', which follows another one; accepted are "
                                 "other links");
            }
            segments.addSegment(segmentOf(joint));
            variables.push_back(static_cast<std::size_t>(variable - robot.group.begin()));
        }
        segments.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed),
                                         frameOf(fcl::Transform3d(Eigen::Translation3d(target_.offset)))));
        chain_ = std::make_unique<Chain>(segments);
        chain_->variables = variables;
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
            chain_->joints(static_cast<unsigned int>(i)) = values[chain_->variables[i]];
        }
        if (!solve(share))
        {
            return false;
        }
        for (std::size_t i = 0; i < chain_->variables.size(); ++i)
        {
            values[chain_->variables[i]] = chain_->joints(static_cast<unsigned int>(i));
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
            KDL::Frame reached;
            chain_->forward.JntToCart(chain_->joints, reached);
            const KDL::Twist twist = KDL::diff(reached, frameOf(nearestTarget(poseOf(reached), share)));
            if (twist.vel.Norm() <= POSITION_ACCURACY && (rows == 3 || twist.rot.Norm() <= ROTATION_ACCURACY))
            {
                return true;
            }
            Eigen::Matrix<double, 6, 1> error;
            error << twist.vel.x(), twist.vel.y(), twist.vel.z(), twist.rot.x(), twist.rot.y(), twist.rot.z();
            chain_->derivative.JntToJac(chain_->joints, chain_->jacobian);
            Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian = chain_->jacobian.data;
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
                const auto k = static_cast<unsigned int>(i);
                const Joint &joint = joints_[chain_->variables[i]];
                chain_->joints(k) = std::clamp(chain_->joints(k) + step[k], joint.lower, joint.upper);
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
