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

#ifndef OMPL_MFA_ROBOTS_JOINT_TRAJECTORY_
#define OMPL_MFA_ROBOTS_JOINT_TRAJECTORY_

#include <iosfwd>
#include <string>
#include <vector>

#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/robots/RobotProblem.h"

namespace ompl_mfa::robots
{
    /** \brief A path of joints with times. */
    struct JointTrajectory
    {
        struct Point
        {
            /** \brief Seconds from the start. */
            double time{0.};

            /** \brief Radians or metres. Continuous joints go on beyond pi. */
            std::vector<double> positions;

            /** \brief Radians or metres per second. */
            std::vector<double> velocities;
        };

        std::vector<std::string> joints;
        std::vector<Point> points;

        /** \brief Seconds. */
        double duration() const
        {
            return points.empty() ? 0. : points.back().time;
        }
    };

    /** \brief Largest speed of a joint without a limit of its own, radians or metres per second. */
    constexpr double DEFAULT_VELOCITY = 1.;

    /** \brief Give times to a path: every segment is a straight line in joint space that begins and ends at rest, with
       a trapezoidal profile of speed, as fast as the limits of all joints allow. The points are the states of the path
       and, between them, the ends of the acceleration and of the constant speed. If no joint that moves on a segment
       has a limit of acceleration, its speed is constant. \param problem whose robot moves; the limits are those of its
       URDF file times the request's factors. \param path of a space of the problem. */
    OMPL_MFA_EXPORT JointTrajectory timedPath(const RobotProblem &problem, const ompl::geometric::PathGeometric &path);

    /** \brief Write one line a point, after a line of names: time, positions, and velocities as `NAME.velocity`. */
    OMPL_MFA_EXPORT void writeCsv(const JointTrajectory &trajectory, std::ostream &out);

    /** \brief Write a `moveit_msgs/RobotTrajectory` as YAML. */
    OMPL_MFA_EXPORT void writeYaml(const JointTrajectory &trajectory, std::ostream &out);
}  // namespace ompl_mfa::robots

#endif
