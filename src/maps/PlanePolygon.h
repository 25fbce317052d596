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

#ifndef OMPL_MFA_MAPS_PLANE_POLYGON_
#define OMPL_MFA_MAPS_PLANE_POLYGON_

#include <string>
#include <vector>

#include <Eigen/Core>

namespace ompl_mfa::maps
{
    using PlanePolygon = std::vector<Eigen::Vector2d>;

    /** \brief Twice the area, positive if the corners are counterclockwise. */
    double doubleArea(const PlanePolygon &corners);

    /** \brief Why \e corners are not a simple polygon with an area; empty if they are. */
    std::string faultOf(const PlanePolygon &corners);

    bool contains(const PlanePolygon &corners, const Eigen::Vector2d &point);

    /** \brief Distance of \e point from the nearest side. */
    double distanceToSides(const PlanePolygon &corners, const Eigen::Vector2d &point);

    /** \brief Convex polygons that together are the simple polygon \e corners, which are counterclockwise: few of
        them, and only itself if it is convex.

        Source: S. Hertel and K. Mehlhorn, Fast Triangulation of Simple Polygons, 1983. */
    std::vector<PlanePolygon> convexParts(const PlanePolygon &corners);
}  // namespace ompl_mfa::maps

#endif
