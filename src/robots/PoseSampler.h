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

#ifndef OMPL_MFA_ROBOTS_POSE_SAMPLER_
#define OMPL_MFA_ROBOTS_POSE_SAMPLER_

#include <memory>
#include <vector>

#include <ompl/util/RandomNumbers.h>

#include "ompl_mfa/robots/MotionRequest.h"
#include "ompl_mfa/robots/RobotCollision.h"

namespace ompl_mfa::robots
{
    /** \brief Samples values of a group's joints at which a link has a pose, by inverse kinematics from random values.
       Not thread-safe. */
    class PoseSampler
    {
    public:
        /** \throw InputError if the robot has no such link or frame, the group does not move the link, a joint that
            follows another one does, or the pose is farther away than the arm is long. */
        PoseSampler(const PlacedRobot &robot, const PoseTarget &target);
        ~PoseSampler();
        PoseSampler(PoseSampler &&) noexcept;

        /** \brief One attempt from random values.
            \param values set to values within the limits at which the link has the pose, within the tolerances and
            1e-5 m and 1e-4 rad.
            \return whether it succeeded. */
        bool sample(std::vector<double> &values);

    private:
        struct Chain;

        void findFrame(const PlacedRobot &robot);
        void requireReach(const PlacedRobot &robot, const RobotKinematics &kinematics, std::size_t link) const;
        void buildChain(const PlacedRobot &robot, std::size_t link);
        fcl::Transform3d nearestTarget(const fcl::Transform3d &reached, double share) const;
        bool solve(double share);
        bool bringWithinLimits(std::vector<double> &values) const;

        PoseTarget target_;
        std::vector<Joint> joints_;
        std::unique_ptr<Chain> chain_;

        // Made when it is first needed, as OMPL cannot be seeded once there is one.
        std::unique_ptr<ompl::RNG> random_;
    };
}  // namespace ompl_mfa::robots

#endif
