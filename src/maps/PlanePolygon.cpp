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

#include "maps/PlanePolygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ompl_mfa::maps
{
    namespace
    {
        using Point = Eigen::Vector2d;

        double cross(const Point &first, const Point &second)
        {
            return first.x() * second.y() - first.y() * second.x();
        }

        /* Positive if the third point is left of the line from the first to the second. */
        double side(const Point &from, const Point &to, const Point &point)
        {
            return cross(to - from, point - from);
        }

        bool isBetween(const Point &from, const Point &to, const Point &point)
        {
            return side(from, to, point) == 0.0 && (point - from).dot(point - to) <= 0.0;
        }

        bool meet(const Point &from, const Point &to, const Point &otherFrom, const Point &otherTo)
        {
            const double first = side(from, to, otherFrom);
            const double second = side(from, to, otherTo);
            const double third = side(otherFrom, otherTo, from);
            const double fourth = side(otherFrom, otherTo, to);
            const bool cross = ((first > 0.0) != (second > 0.0)) && ((third > 0.0) != (fourth > 0.0)) && first != 0.0 &&
                               second != 0.0 && third != 0.0 && fourth != 0.0;
            return cross || isBetween(from, to, otherFrom) || isBetween(from, to, otherTo) ||
                   isBetween(otherFrom, otherTo, from) || isBetween(otherFrom, otherTo, to);
        }

        std::string nameOf(std::size_t corner)
        {
            return std::to_string(corner + 1);
        }

        bool isConvex(const PlanePolygon &corners)
        {
            const std::size_t count = corners.size();
            for (std::size_t i = 0; i < count; ++i)
            {
                if (side(corners[i], corners[(i + 1) % count], corners[(i + 2) % count]) < 0.0)
                {
                    return false;
                }
            }
            return true;
        }

        /* Whether the triangle at corner i can be cut off: it turns left, and no other corner is in it. */
        bool isEar(const PlanePolygon &corners, std::size_t i)
        {
            const std::size_t count = corners.size();
            const Point &before = corners[(i + count - 1) % count];
            const Point &corner = corners[i];
            const Point &after = corners[(i + 1) % count];
            if (side(before, corner, after) <= 0.0)
            {
                return false;
            }
            return std::none_of(corners.begin(), corners.end(),
                                [&](const Point &other)
                                {
                                    return other != before && other != corner && other != after &&
                                           side(before, corner, other) >= 0.0 && side(corner, after, other) >= 0.0 &&
                                           side(after, before, other) >= 0.0;
                                });
        }

        std::size_t findEar(const PlanePolygon &corners)
        {
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                if (isEar(corners, i))
                {
                    return i;
                }
            }
            // by rounding only: the corner that is nearly on a line with its neighbours
            const auto turn = [&corners](std::size_t i)
            {
                const std::size_t count = corners.size();
                return std::abs(side(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]));
            };
            std::size_t flattest = 0;
            for (std::size_t i = 1; i < corners.size(); ++i)
            {
                flattest = turn(i) < turn(flattest) ? i : flattest;
            }
            return flattest;
        }
        /* The union of two polygons with a common side; empty if they have none. */
        PlanePolygon joined(const PlanePolygon &first, const PlanePolygon &second)
        {
            for (std::size_t i = 0; i < first.size(); ++i)
            {
                for (std::size_t j = 0; j < second.size(); ++j)
                {
                    if (first[i] != second[(j + 1) % second.size()] || first[(i + 1) % first.size()] != second[j])
                    {
                        continue;
                    }
                    PlanePolygon corners;
                    for (std::size_t k = 1; k <= first.size(); ++k)
                    {
                        corners.push_back(first[(i + k) % first.size()]);
                    }
                    for (std::size_t k = 2; k < second.size(); ++k)
                    {
                        corners.push_back(second[(j + k) % second.size()]);
                    }
                    return corners;
                }
            }
            return {};
        }

        /* Replaces two parts by their union if it is convex; false if there are none. */
        bool joinTwo(std::vector<PlanePolygon> &parts)
        {
            for (std::size_t i = 0; i < parts.size(); ++i)
            {
                for (std::size_t j = i + 1; j < parts.size(); ++j)
                {
                    const PlanePolygon both = joined(parts[i], parts[j]);
                    if (!both.empty() && isConvex(both))
                    {
                        parts[i] = both;
                        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
                        return true;
                    }
                }
            }
            return false;
        }
    }  // namespace

    double doubleArea(const PlanePolygon &corners)
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            sum += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
        }
        return sum;
    }

    std::string faultOf(const PlanePolygon &corners)
    {
        const std::size_t count = corners.size();
        if (count < 3)
        {
            return "a polygon has at least three corners; there are " + std::to_string(count);
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            if (!corners[i].allFinite())
            {
                return "corner " + nameOf(i) + " is not finite";
            }
            if (corners[i] == corners[(i + 1) % count])
            {
                return "the corners " + nameOf(i) + " and " + nameOf((i + 1) % count) + " are the same";
            }
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            const std::size_t next = (i + 1) % count;
            // consecutive sides share a corner, and fold back if they are on one line in opposite directions
            const Point &after = corners[(i + 2) % count];
            if (side(corners[i], corners[next], after) == 0.0 &&
                (corners[next] - corners[i]).dot(after - corners[next]) < 0.0)
            {
                return "the polygon folds back at corner " + nameOf(next);
            }
            for (std::size_t j = i + 2; j < count; ++j)
            {
                const std::size_t afterJ = (j + 1) % count;
                if (afterJ != i && meet(corners[i], corners[next], corners[j], corners[afterJ]))
                {
                    return "the polygon crosses or touches itself: side " + nameOf(i) + "-" + nameOf(next) +
                           " meets side " + nameOf(j) + "-" + nameOf(afterJ);
                }
            }
        }
        return doubleArea(corners) == 0.0 ? "the polygon has no area" : "";
    }

    bool contains(const PlanePolygon &corners, const Point &point)
    {
        bool isInside = false;
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            const Point &from = corners[i];
            const Point &to = corners[(i + 1) % corners.size()];
            if ((from.y() > point.y()) != (to.y() > point.y()))
            {
                const double x = from.x() + (to.x() - from.x()) * (point.y() - from.y()) / (to.y() - from.y());
                isInside = isInside != (point.x() < x);
            }
        }
        return isInside;
    }

    double distanceToSides(const PlanePolygon &corners, const Point &point)
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            const Point along = corners[(i + 1) % corners.size()] - corners[i];
            const double squared = along.squaredNorm();
            const double share = squared > 0.0 ? std::clamp((point - corners[i]).dot(along) / squared, 0.0, 1.0) : 0.0;
            least = std::min(least, (point - corners[i] - share * along).norm());
        }
        return least;
    }

    std::vector<PlanePolygon> convexParts(const PlanePolygon &corners)
    {
        if (isConvex(corners))
        {
            return {corners};
        }
        std::vector<PlanePolygon> parts;
        PlanePolygon left = corners;
        while (left.size() > 3)
        {
            const std::size_t ear = findEar(left);
            parts.push_back({left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        parts.push_back(left);
        while (joinTwo(parts))
        {
        }
        return parts;
    }
}  // namespace ompl_mfa::maps
