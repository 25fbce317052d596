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

#ifndef OMPL_MFA_MAPS_SWEPT_SHAPE_
#define OMPL_MFA_MAPS_SWEPT_SHAPE_

#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/maps/ObstacleGrid.h"

namespace ompl_mfa::maps
{
    /** \brief The convex hull of points, enlarged by a radius: a point, a disc, a convex polygon with a margin, or what
        one of these sweeps along a segment. Positions are in cells.

        It is given by segments between its points that include the sides of the hull. Reusing an object avoids
        allocations. */
    class SweptShape
    {
    public:
        /** \brief An empty shape of this \e radius, at least 0. */
        void reset(double radius);

        /** \brief Adds a segment, or a point if both ends are equal. */
        void add(const Eigen::Vector2d &from, const Eigen::Vector2d &to);

        /** \brief Whether the shape touches an obstacle of \e grid. Exact but for the rounding of doubles. */
        bool touches(const ObstacleGrid &grid) const;

    private:
        struct Segment
        {
            /** \brief The end at the bottom and the one on top. */
            Eigen::Vector2d low;
            Eigen::Vector2d high;
            /** \brief Unit vector normal to the segment, its x at least 0. */
            Eigen::Vector2d normal;
        };

        static double farthestRight(const Segment &segment, double side, double bottom, double top, double radius);

        double radius_{0.0};
        std::vector<Segment> segments_;
    };
}  // namespace ompl_mfa::maps

#endif
