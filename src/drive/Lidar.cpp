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

#include "drive/Lidar.h"

#include <cmath>
#include <limits>

namespace ompl_mfa::drive
{
    namespace
    {
        constexpr double PI = 3.14159265358979323846;

        /* How a ray proceeds along one axis. */
        struct Axis
        {
            Axis(double from, double direction)
              : cell(static_cast<std::int64_t>(std::floor(from)))
              , step(direction < 0.0 ? -1 : 1)
            {
                if (direction != 0.0)
                {
                    spacing = 1.0 / std::abs(direction);
                    const double border = static_cast<double>(cell + (direction > 0.0 ? 1 : 0));
                    next = (border - from) / direction;
                }
            }

            void advance()
            {
                cell += step;
                next += spacing;
            }

            std::int64_t cell;
            std::int64_t step;
            /* Distance along the ray between two borders of cells, and of the next one from the beginning. */
            double spacing{std::numeric_limits<double>::infinity()};
            double next{std::numeric_limits<double>::infinity()};
        };
    }  // namespace

    void castRay(const maps::ObstacleGrid &truth, const Eigen::Vector2d &from, const Eigen::Vector2d &direction,
                 double range, const CellVisitor &visit)
    {
        const auto width = static_cast<std::int64_t>(truth.map().width());
        const auto height = static_cast<std::int64_t>(truth.map().height());
        Axis x(from.x(), direction.x());
        Axis y(from.y(), direction.y());
        while (x.cell >= 0 && x.cell < width && y.cell >= 0 && y.cell < height)
        {
            const bool isObstacle = truth.isOccupied(x.cell, y.cell);
            visit(x.cell, y.cell, isObstacle);
            Axis &nearer = x.next < y.next ? x : y;
            if (isObstacle || nearer.next >= range)
            {
                return;
            }
            nearer.advance();
        }
    }

    void scan(const maps::ObstacleGrid &truth, const Eigen::Vector2d &from, double range, unsigned int rays,
              const CellVisitor &visit)
    {
        for (unsigned int i = 0; i < rays; ++i)
        {
            const double angle = 2.0 * PI * i / rays;
            castRay(truth, from, {std::cos(angle), std::sin(angle)}, range, visit);
        }
    }
}  // namespace ompl_mfa::drive
