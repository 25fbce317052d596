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

#include "ompl_mfa/robots/JointTrajectory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>

#include "text/NumberText.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using Point = JointTrajectory::Point;

        /* Largest speed and acceleration of a segment's parameter, which goes from 0 to 1; infinite if unlimited. */
        struct Limits
        {
            double speed{std::numeric_limits<double>::infinity()};
            double acceleration{std::numeric_limits<double>::infinity()};
        };

        Limits limitsOf(const RobotProblem &problem, const std::vector<double> &difference)
        {
            Limits limits;
            for (std::size_t i = 0; i < difference.size(); ++i)
            {
                const Joint &joint = problem.robot().model->joints()[problem.robot().group[i]];
                const double distance = std::abs(difference[i]);
                if (distance == 0.)
                {
                    continue;
                }
                const double velocity = joint.velocity > 0. ? joint.velocity : DEFAULT_VELOCITY;
                limits.speed = std::min(limits.speed, problem.velocityScale() * velocity / distance);
                if (joint.acceleration > 0.)
                {
                    limits.acceleration =
                        std::min(limits.acceleration, problem.accelerationScale() * joint.acceleration / distance);
                }
            }
            return limits;
        }

        Point at(const std::vector<double> &from, const std::vector<double> &difference, double share, double speed,
                 double time)
        {
            Point point{time, from, difference};
            for (std::size_t i = 0; i < from.size(); ++i)
            {
                point.positions[i] += share * difference[i];
                point.velocities[i] *= speed;
            }
            return point;
        }

        /* Adds the points of a segment after its first one. */
        void addSegment(const Limits &limits, const std::vector<double> &difference, JointTrajectory &trajectory)
        {
            const std::vector<double> from = trajectory.points.back().positions;
            const double start = trajectory.points.back().time;
            // Without a limit of acceleration the speed jumps at the ends.
            const double speed = std::min(limits.speed, std::sqrt(limits.acceleration));
            const double ramp = std::isfinite(limits.acceleration) ? speed / limits.acceleration : 0.;
            const double covered = 0.5 * speed * ramp;
            const double duration = 2. * ramp + (1. - 2. * covered) / speed;
            if (ramp > 0.)
            {
                trajectory.points.push_back(at(from, difference, covered, speed, start + ramp));
                if (duration > 2. * ramp)
                {
                    trajectory.points.push_back(at(from, difference, 1. - covered, speed, start + duration - ramp));
                }
            }
            trajectory.points.push_back(at(from, difference, 1., 0., start + duration));
        }

        void writeList(const std::vector<double> &values, std::ostream &out)
        {
            out << "[";
            for (std::size_t i = 0; i < values.size(); ++i)
            {
                out << (i == 0 ? "" : ", ") << text::numberText(values[i]);
            }
            out << "]";
        }

        /* A name as YAML reads it back, whatever is in it. */
        std::string quoted(const std::string &name)
        {
            std::string text = "'";
            for (const char letter : name)
            {
                text += letter == '\'' ? "''" : std::string(1, letter);
            }
            return text + "'";
        }
    }  // namespace

    JointTrajectory timedPath(const RobotProblem &problem, const ompl::geometric::PathGeometric &path)
    {
        const JointSpace joints = problem.makeSpace();
        JointTrajectory trajectory;
        trajectory.joints = joints.names();
        std::vector<double> buffer(joints.dimension());
        std::vector<double> difference(joints.dimension());
        for (unsigned int i = 0; i < path.getStateCount(); ++i)
        {
            const ompl::base::State *state = path.getState(i);
            if (i == 0)
            {
                const double *values = joints.values(state, buffer.data());
                trajectory.points.push_back(
                    {0., {values, values + joints.dimension()}, std::vector<double>(joints.dimension(), 0.)});
                continue;
            }
            joints.difference(path.getState(i - 1), state, difference.data());
            if (std::any_of(difference.begin(), difference.end(), [](double value) { return value != 0.; }))
            {
                addSegment(limitsOf(problem, difference), difference, trajectory);
            }
        }
        return trajectory;
    }

    void writeCsv(const JointTrajectory &trajectory, std::ostream &out)
    {
        out << "time";
        for (const char *suffix : {"", ".velocity"})
        {
            for (const std::string &joint : trajectory.joints)
            {
                out << "," << joint << suffix;
            }
        }
        out << "\n";
        for (const Point &point : trajectory.points)
        {
            out << text::numberText(point.time);
            for (const auto *values : {&point.positions, &point.velocities})
            {
                for (const double value : *values)
                {
                    out << "," << text::numberText(value);
                }
            }
            out << "\n";
        }
    }

    void writeYaml(const JointTrajectory &trajectory, std::ostream &out)
    {
        constexpr double BILLION = 1e9;
        out << "joint_trajectory:\n  joint_names: [";
        for (std::size_t i = 0; i < trajectory.joints.size(); ++i)
        {
            out << (i == 0 ? "" : ", ") << quoted(trajectory.joints[i]);
        }
        out << "]\n  points:\n";
        for (const Point &point : trajectory.points)
        {
            const auto time = static_cast<std::int64_t>(std::llround(point.time * BILLION));
            out << "    - positions: ";
            writeList(point.positions, out);
            out << "\n      velocities: ";
            writeList(point.velocities, out);
            out << "\n      time_from_start: {sec: " << time / 1000000000 << ", nanosec: " << time % 1000000000
                << "}\n";
        }
    }
}  // namespace ompl_mfa::robots
