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

#include "anytime/PlanarArm.h"

#include <algorithm>
#include <cmath>

namespace ompl_mfa::anytime
{
    namespace
    {
        using Point = Eigen::Vector2d;

        double cross(const Point &a, const Point &b)
        {
            return a.x() * b.y() - a.y() * b.x();
        }

        double squaredDistance(const Point &point, const Point &from, const Point &to)
        {
            const Point along = to - from;
            const double length = along.squaredNorm();
            const double t = length > 0.0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
            return (point - from - t * along).squaredNorm();
        }

        bool crosses(const Point &a, const Point &b, const Point &c, const Point &d)
        {
            return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
        }

        bool collides(const Point &from, const Point &to, const Capsule &obstacle)
        {
            const double limit = obstacle.radius * obstacle.radius;
            if (squaredDistance(obstacle.from, from, to) < limit)
            {
                return true;
            }
            if (obstacle.from == obstacle.to)
            {
                return false;
            }
            return squaredDistance(obstacle.to, from, to) < limit ||
                   squaredDistance(from, obstacle.from, obstacle.to) < limit ||
                   squaredDistance(to, obstacle.from, obstacle.to) < limit ||
                   crosses(from, to, obstacle.from, obstacle.to);
        }
    }  // namespace

    bool armIsFree(const double *angles, int links, const Capsules &obstacles)
    {
        Point joint = Point::Zero();
        double heading = 0.0;
        for (int i = 0; i < links; ++i)
        {
            heading += angles[i];
            const Point next = joint + Point(std::cos(heading), std::sin(heading)) / links;
            for (const Capsule &obstacle : obstacles)
            {
                if (collides(joint, next, obstacle))
                {
                    return false;
                }
            }
            joint = next;
        }
        return true;
    }
}  // namespace ompl_mfa::anytime
