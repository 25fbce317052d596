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

#include "maps/MapMotion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ompl_mfa::maps
{
    namespace
    {
        /* Cells of length up to which a part of a motion is compared with the cells of the grid. */
        constexpr double LONGEST_SWEEP = 24.0;
        /* Cells by which turns and curves may enlarge the region of such a part: beyond them it is seldom free. */
        constexpr double LARGEST_SPREAD = 2.0;

        struct Part
        {
            double begin;
            double end;
            GridPose from;
            GridPose to;
        };

        enum class Verdict
        {
            Free,
            Blocked,
            Unknown
        };

        class MotionCheck
        {
        public:
            MotionCheck(const GridRobot &robot, MapMotion &motion, bool locates)
              : robot_(robot)
              , motion_(motion)
              , locates_(locates)
            {
            }

            Verdict check(const Part &part, const GridPose &middle) const
            {
                const Extent extent = extentOf(part);
                const bool isWithin = isWithinBounds(part, extent.bulge);
                if (isWithin && robot_.isClearlyFree(middle, 0.5 * extent.length + extent.swing))
                {
                    return Verdict::Free;
                }
                if (!locates_ && robot_.isClearlyBlocked(middle))
                {
                    return Verdict::Blocked;
                }
                const double spread = extent.bulge + extent.swing;
                const bool isShort = extent.length <= LONGEST_SWEEP && spread <= MOTION_TOLERANCE;
                if (isWithin && extent.length <= LONGEST_SWEEP && spread <= LARGEST_SPREAD &&
                    isSweepFree(part, middle, extent))
                {
                    return Verdict::Free;
                }
                const bool isMiddleBlocked = !isShort && !locates_ && isWithin && !robot_.isFree(middle);
                return isShort || isMiddleBlocked ? Verdict::Blocked : Verdict::Unknown;
            }

            /* The end of the free beginning of a part that is blocked, with the same distance from obstacles. */
            double locate(Part part) const
            {
                const Extent whole = extentOf(part);
                while (extentOf(part).length > MOTION_TOLERANCE)
                {
                    const double half = 0.5 * (part.begin + part.end);
                    const Part first{part.begin, half, part.from, motion_.pose(half)};
                    if (isWithinBounds(first, extentOf(first).bulge) &&
                        isSweepFree(first, motion_.pose(0.5 * (part.begin + half)), whole))
                    {
                        part.begin = half;
                        part.from = first.to;
                    }
                    else
                    {
                        part.end = half;
                        part.to = first.to;
                    }
                }
                return part.begin;
            }

        private:
            /* Bounds of a part, in cells. */
            struct Extent
            {
                double length;
                /* How far the path is from the chord. */
                double bulge;
                /* How far the turning moves a corner. */
                double swing;
            };

            Extent extentOf(const Part &part) const
            {
                const double share = part.end - part.begin;
                const double length = motion_.length * share;
                const double chord = (part.to.position - part.from.position).norm();
                // a path of this length between the ends of the chord does not leave an ellipse about it
                const double bulge =
                    motion_.isStraight ? 0.0 : 0.5 * std::sqrt(std::max(0.0, length * length - chord * chord));
                return {length, bulge, 0.5 * robot_.reach() * motion_.turn * share};
            }

            bool isSweepFree(const Part &part, const GridPose &middle, const Extent &extent) const
            {
                return robot_.isSweepFree(part.from.position, part.to.position, middle.yaw,
                                          extent.bulge + extent.swing);
            }

            /* Whether the part is within the bounds, but for the tolerance. */
            bool isWithinBounds(const Part &part, double bulge) const
            {
                if (!motion_.bounds)
                {
                    return true;
                }
                const GridMap &map = robot_.grid().map();
                const double slack = std::max(0.0, bulge - MOTION_TOLERANCE) * map.frame().resolution;
                const Eigen::AlignedBox2d inside(motion_.bounds->min().array() + slack,
                                                 motion_.bounds->max().array() - slack);
                return inside.contains(map.toWorld(part.from.position)) &&
                       inside.contains(map.toWorld(part.to.position));
            }

            const GridRobot &robot_;
            MapMotion &motion_;
            bool locates_;
        };
    }  // namespace

    double freeShareOf(const GridRobot &robot, MapMotion &motion, bool locates)
    {
        thread_local std::vector<Part> parts;
        const MotionCheck check(robot, motion, locates);
        parts.assign(1, {0.0, 1.0, motion.pose(0.0), motion.pose(1.0)});
        // From the beginning on to locate the first collision. Otherwise all parts of a length are checked before their
        // halves, which finds collisions sooner.
        for (std::size_t next = 0; next < parts.size();)
        {
            const Part part = locates ? parts.back() : parts[next];
            if (locates)
            {
                parts.pop_back();
            }
            else
            {
                ++next;
            }
            const double half = 0.5 * (part.begin + part.end);
            const GridPose middle = motion.pose(half);
            const Verdict verdict = check.check(part, middle);
            if (verdict == Verdict::Blocked)
            {
                return locates ? check.locate(part) : part.begin;
            }
            if (verdict == Verdict::Unknown)
            {
                const Part first{part.begin, half, part.from, middle};
                const Part second{half, part.end, middle, part.to};
                parts.push_back(locates ? second : first);
                parts.push_back(locates ? first : second);
            }
        }
        return 1.0;
    }
}  // namespace ompl_mfa::maps
