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

#ifndef OMPL_MFA_COLLISION_BODY_MOTION_
#define OMPL_MFA_COLLISION_BODY_MOTION_

#include <cmath>

#include <fcl/common/types.h>

namespace ompl_mfa::collision
{
    /** \brief Motion of a body over t in [0, 1]: its reference point moves along a segment and it rotates about an axis
        fixed in the body, both at constant speed. Lengths are in world units, angles in radians. */
    struct BodyMotion
    {
        /** \brief Position of the reference point at t = 0. */
        fcl::Vector3d start{fcl::Vector3d::Zero()};

        /** \brief Displacement of the reference point from t = 0 to t = 1. */
        fcl::Vector3d displacement{fcl::Vector3d::Zero()};

        /** \brief Orientation at t = 0. */
        fcl::Matrix3d rotation{fcl::Matrix3d::Identity()};

        /** \brief Unit axis in the frame of the body. */
        fcl::Vector3d axis{fcl::Vector3d::UnitZ()};

        /** \brief Rotation about the axis from t = 0 to t = 1. */
        double angle{0.};

        void place(double t, fcl::Transform3d &pose) const
        {
            pose.setIdentity();
            pose.translation() = start + t * displacement;
            if (angle == 0.)
            {
                pose.linear() = rotation;
            }
            else
            {
                pose.linear() = rotation * Eigen::AngleAxisd(t * angle, axis).toRotationMatrix();
            }
        }
    };
}  // namespace ompl_mfa::collision

#endif
