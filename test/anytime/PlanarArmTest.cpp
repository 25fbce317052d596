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
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa::anytime
{
    using Point = Eigen::Vector2d;

    namespace
    {
        Point along(const Point &from, const Point &to, int i, int count)
        {
            return from + (to - from) * i / count;
        }

        /* Clearance between the arm and the capsule at sampled points of both: exceeds the exact one by the spacing of
           the points at most. */
        double sampledClearance(const std::vector<double> &angles, const Capsule &capsule)
        {
            constexpr int POINTS = 100;
            double nearest = std::numeric_limits<double>::infinity();
            Point joint = Point::Zero();
            double heading = 0.0;
            for (const double angle : angles)
            {
                heading += angle;
                const Point next =
                    joint + Point(std::cos(heading), std::sin(heading)) / static_cast<double>(angles.size());
                for (int i = 0; i <= POINTS; ++i)
                {
                    for (int j = 0; j <= POINTS; ++j)
                    {
                        nearest = std::min(
                            nearest,
                            (along(joint, next, i, POINTS) - along(capsule.from, capsule.to, j, POINTS)).norm());
                    }
                }
                joint = next;
            }
            return nearest - capsule.radius;
        }
    }  // namespace

    TEST(PlanarArm, AgreesWithPointsAlongLinksAndObstacles)
    {
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> angle(-1.5, 1.5);
        std::uniform_real_distribution<double> place(-0.8, 0.8);
        int free = 0;
        int colliding = 0;
        for (int trial = 0; trial < 500; ++trial)
        {
            std::vector<double> angles(7);
            for (double &value : angles)
            {
                value = angle(engine);
            }
            Capsule capsule{{place(engine), place(engine)}, {place(engine), place(engine)}, 0.03};
            if (trial % 2 == 0)
            {
                capsule.to = capsule.from;
            }
            const double clearance = sampledClearance(angles, capsule);
            // the points are at most 0.023 apart, and a pair of points misses at most half of that
            if (clearance > 0.0 && clearance < 0.02)
            {
                continue;
            }
            const bool isFree = armIsFree(angles.data(), 7, {capsule});
            EXPECT_EQ(isFree, clearance > 0.0) << "trial " << trial << ", clearance " << clearance;
            ++(isFree ? free : colliding);
        }
        EXPECT_GT(free, 50);
        EXPECT_GT(colliding, 50);
    }
}  // namespace ompl_mfa::anytime
