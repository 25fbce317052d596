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

#ifndef OMPL_MFA_ROBOTS_ROBOT_KINEMATICS_
#define OMPL_MFA_ROBOTS_ROBOT_KINEMATICS_

#include <cstddef>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/robots/RobotModel.h"

namespace ompl_mfa::robots
{
    /** \brief Forward kinematics of the links that a group of joints moves; all other joints keep their values.

        Links that do not move relative to each other form one body. Body 0 is all that stands still, in the world. */
    class OMPL_MFA_EXPORT RobotKinematics
    {
    public:
        /** \param model the robot; not needed after the construction.
            \param group joints that vary, by their indices: neither fixed nor followers of others.
            \param values of all joints, radians or metres; those of the group are not used.
            \param base pose of the root of the robot in the world.
            \throw std::invalid_argument if a joint of the group does not move by itself. */
        RobotKinematics(const RobotModel &model, const std::vector<std::size_t> &group,
                        const std::vector<double> &values, const fcl::Transform3d &base = fcl::Transform3d::Identity());

        /** \brief Number of bodies, with body 0. */
        std::size_t bodyCount() const
        {
            return steps_.size() + 1;
        }

        /** \brief Number of joints in the group. */
        std::size_t dimension() const
        {
            return dimension_;
        }

        /** \brief Body of a link. */
        std::size_t bodyOf(std::size_t link) const
        {
            return bodyOfLink_[link];
        }

        /** \brief Pose of a link in the frame of its body. */
        const fcl::Transform3d &poseInBody(std::size_t link) const
        {
            return poseInBody_[link];
        }

        /** \brief Poses of all bodies in the world.
            \param q one value for each joint of the group.
            \param bodies bodyCount() poses, which are set. */
        void place(const double *q, fcl::Transform3d *bodies) const;

        /** \brief Movement of a body relative to the body that carries it. */
        struct Step
        {
            /** \brief Body that carries it. */
            std::size_t parent{0};

            /** \brief Index in the group of the joint that moves it, and how its value follows from that joint's. */
            std::size_t variable{0};
            double multiplier{1.};
            double offset{0.};

            bool isPrismatic{false};

            /** \brief Of a rotation: R(q) = constant + sin(q) sine + cos(q) cosine; of a translation: constant. */
            fcl::Matrix3d constant{fcl::Matrix3d::Identity()};
            fcl::Matrix3d sine{fcl::Matrix3d::Zero()};
            fcl::Matrix3d cosine{fcl::Matrix3d::Zero()};

            /** \brief Origin of the joint in the frame of the parent. */
            fcl::Vector3d origin{fcl::Vector3d::Zero()};

            /** \brief Direction of a translation in the frame of the parent. */
            fcl::Vector3d direction{fcl::Vector3d::Zero()};

            /** \brief Upper bound on the distance of the body's origin from that of the joint, metres. */
            double longestTravel{0.};
        };

        /** \brief Step i moves body i + 1; parents come before their children. */
        const std::vector<Step> &steps() const
        {
            return steps_;
        }

        /** \brief How far points of a body move, at most, when each joint moves by one radian or metre. */
        struct Leverage
        {
            std::size_t step{0};

            /** \brief Metres per unit of the joint of the group. */
            double bound{0.};
        };

        /** \brief Leverages on points within `reach` of the origin of a body, of all steps that move the body. */
        std::vector<Leverage> leverages(std::size_t body, double reach) const;

    private:
        void addStep(const Joint &joint, const Joint &source, std::size_t variable);

        std::size_t dimension_;
        std::vector<Step> steps_;
        std::vector<std::size_t> bodyOfLink_;
        std::vector<fcl::Transform3d> poseInBody_;
    };
}  // namespace ompl_mfa::robots

#endif
