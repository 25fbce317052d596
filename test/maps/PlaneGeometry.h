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

#ifndef OMPL_MFA_TEST_MAPS_PLANE_GEOMETRY_
#define OMPL_MFA_TEST_MAPS_PLANE_GEOMETRY_

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/maps/GridMap.h"

namespace ompl_mfa::maps::test
{
    using Point = Eigen::Vector2d;
    using Polygon = std::vector<Point>;

    inline double distanceToSegment(const Point &point, const Point &from, const Point &to)
    {
        const Point along = to - from;
        const double squared = along.squaredNorm();
        const double share = squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
        return (point - from - share * along).norm();
    }

    inline bool isInside(const Polygon &polygon, const Point &point)
    {
        bool isIn = false;
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            const Point &from = polygon[i];
            const Point &to = polygon[(i + 1) % polygon.size()];
            if ((from.y() > point.y()) != (to.y() > point.y()) &&
                point.x() < from.x() + (to.x() - from.x()) * (point.y() - from.y()) / (to.y() - from.y()))
            {
                isIn = !isIn;
            }
        }
        return isIn;
    }

    inline bool doCross(const Point &from, const Point &to, const Point &otherFrom, const Point &otherTo)
    {
        const auto side = [](const Point &begin, const Point &end, const Point &point)
        { return (end - begin).x() * (point - begin).y() - (end - begin).y() * (point - begin).x(); };
        return side(from, to, otherFrom) * side(from, to, otherTo) < 0.0 &&
               side(otherFrom, otherTo, from) * side(otherFrom, otherTo, to) < 0.0;
    }

    /** \brief Distance of two polygons, which may be points or segments; 0 if they overlap. */
    inline double distanceOf(const Polygon &first, const Polygon &second)
    {
        if (isInside(first, second.front()) || isInside(second, first.front()))
        {
            return 0.0;
        }
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < first.size(); ++i)
        {
            const Point &from = first[i];
            const Point &to = first[(i + 1) % first.size()];
            for (std::size_t j = 0; j < second.size(); ++j)
            {
                const Point &otherFrom = second[j];
                const Point &otherTo = second[(j + 1) % second.size()];
                if (doCross(from, to, otherFrom, otherTo))
                {
                    return 0.0;
                }
                least = std::min(
                    {least, distanceToSegment(from, otherFrom, otherTo), distanceToSegment(otherFrom, from, to)});
            }
        }
        return least;
    }

    /** \brief Distance in cells of \e polygon from the nearest occupied cell of \e map and from its outside: over all
        cells, without any structure of the library. */
    inline double distanceFrom(const GridMap &map, const Polygon &polygon)
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t y = 0; y < map.height(); ++y)
        {
            for (std::size_t x = 0; x < map.width(); ++x)
            {
                const Point corner(static_cast<double>(x), static_cast<double>(y));
                if (map.cell(x, y) != Cell::Free)
                {
                    least = std::min(least, distanceOf(polygon, {corner, corner + Point(1.0, 0.0),
                                                                 corner + Point(1.0, 1.0), corner + Point(0.0, 1.0)}));
                }
            }
        }
        for (const Point &corner : polygon)
        {
            least = std::min({least, corner.x(), corner.y(), static_cast<double>(map.width()) - corner.x(),
                              static_cast<double>(map.height()) - corner.y()});
        }
        return std::max(0.0, least);
    }

    /** \brief A map in which about one cell in \e spacing is occupied. */
    inline GridMap randomMap(std::mt19937 &random, std::size_t width, std::size_t height, unsigned int spacing,
                             const MapFrame &frame = {})
    {
        std::vector<Cell> cells(width * height, Cell::Free);
        for (Cell &cell : cells)
        {
            cell = random() % spacing == 0 ? Cell::Occupied : Cell::Free;
        }
        return GridMap(width, height, cells, frame);
    }

    inline double uniform(std::mt19937 &random, double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
}  // namespace ompl_mfa::maps::test

#endif
