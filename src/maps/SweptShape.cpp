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

#include "maps/SweptShape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ompl_mfa::maps
{
    namespace
    {
        /* In cells; touching counts as a collision, whatever the rounding. */
        constexpr double ROUNDING = 1e-9;

        /* Farther than any cell of a map, and whole as a double. */
        constexpr double FARTHEST = 1e12;

        std::int64_t lowestCell(double coordinate)
        {
            return static_cast<std::int64_t>(std::clamp(std::ceil(coordinate - ROUNDING), -FARTHEST, FARTHEST)) - 1;
        }

        std::int64_t highestCell(double coordinate)
        {
            return static_cast<std::int64_t>(std::clamp(std::floor(coordinate + ROUNDING), -FARTHEST, FARTHEST));
        }
    }  // namespace

    void SweptShape::reset(double radius)
    {
        radius_ = radius;
        segments_.clear();
    }

    void SweptShape::add(const Eigen::Vector2d &from, const Eigen::Vector2d &to)
    {
        Segment segment{from, to, Eigen::Vector2d(1.0, 0.0)};
        if (from.y() > to.y())
        {
            std::swap(segment.low, segment.high);
        }
        const Eigen::Vector2d along = segment.high - segment.low;
        const double length = along.norm();
        if (length > 0.0)
        {
            segment.normal = Eigen::Vector2d(along.y(), -along.x()) / length;
        }
        segments_.push_back(segment);
    }

    /* The largest x of the points between two heights of the segment enlarged by the radius, or the largest -x for the
       side -1. The right boundary is an arc about the lower end, a line and an arc about the upper end; x is a concave
       function of the height on it, so that its maximum is at the height nearest to that of its farthest point. */
    double SweptShape::farthestRight(const Segment &segment, double side, double bottom, double top, double radius)
    {
        const Eigen::Vector2d low(side * segment.low.x(), segment.low.y());
        const Eigen::Vector2d high(side * segment.high.x(), segment.high.y());
        // of the mirrored segment, its x at least 0 again
        const Eigen::Vector2d normal(segment.normal.x(), side * segment.normal.y());
        const double farthest = high.x() > low.x() ? high.y() : low.y();
        const double height = std::clamp(farthest, bottom, top);
        const double lineBegin = low.y() + radius * normal.y();
        const double lineEnd = high.y() + radius * normal.y();
        const auto arc = [height, radius](const Eigen::Vector2d &centre)
        {
            const double offset = height - centre.y();
            return centre.x() + std::sqrt(std::max(0.0, radius * radius - offset * offset));
        };
        if (height >= lineEnd && (height > lineBegin || high.x() > low.x()))
        {
            return arc(high);
        }
        if (height <= lineBegin)
        {
            return arc(low);
        }
        const double share = (height - lineBegin) / (lineEnd - lineBegin);
        return low.x() + radius * normal.x() + share * (high.x() - low.x());
    }

    bool SweptShape::touches(const ObstacleGrid &grid) const
    {
        constexpr double NONE = std::numeric_limits<double>::infinity();
        double bottom = NONE;
        double top = -NONE;
        for (const Segment &segment : segments_)
        {
            bottom = std::min(bottom, segment.low.y() - radius_);
            top = std::max(top, segment.high.y() + radius_);
        }
        for (std::int64_t row = lowestCell(bottom); row <= highestCell(top); ++row)
        {
            const double rowBottom = static_cast<double>(row) - ROUNDING;
            const double rowTop = static_cast<double>(row) + 1.0 + ROUNDING;
            double left = NONE;
            double right = -NONE;
            for (const Segment &segment : segments_)
            {
                const double from = std::max(rowBottom, segment.low.y() - radius_);
                const double to = std::min(rowTop, segment.high.y() + radius_);
                if (from <= to)
                {
                    right = std::max(right, farthestRight(segment, 1.0, from, to, radius_));
                    left = std::min(left, -farthestRight(segment, -1.0, from, to, radius_));
                }
            }
            if (left <= right && grid.isAnyOccupied(row, lowestCell(left), highestCell(right)))
            {
                return true;
            }
        }
        return false;
    }
}  // namespace ompl_mfa::maps
