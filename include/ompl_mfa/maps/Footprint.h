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

#ifndef OMPL_MFA_MAPS_FOOTPRINT_
#define OMPL_MFA_MAPS_FOOTPRINT_

#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::maps
{
    /** \brief The outline of a robot on a map, in world units, in the robot's own frame: its reference point, whose
        position is planned, is (0, 0), and it looks along x. */
    class OMPL_MFA_EXPORT Footprint
    {
    public:
        using Polygon = std::vector<Eigen::Vector2d>;

        /** \brief A disc inside the outline, or around it. */
        struct Circle
        {
            Eigen::Vector2d centre;
            double radius;
        };

        static Footprint point();

        /** \brief A disc about the reference point. Throws InputError unless \e radius is above 0. */
        static Footprint disc(double radius);

        /** \brief The \e corners of a simple polygon in either direction, not necessarily convex, and all points within
            \e padding of it. Throws InputError for fewer than three corners, a polygon that crosses or touches itself
            or has no area, a corner that is not finite, or a padding below 0. */
        static Footprint polygon(const Polygon &corners, double padding = 0.0);

        /** \brief Corners counterclockwise, without padding; a single one, (0, 0), for points and discs. */
        const Polygon &corners() const
        {
            return corners_;
        }

        /** \brief Radius of a disc, or the padding. */
        double margin() const
        {
            return margin_;
        }

        /** \brief Whether the robot covers the same points in every orientation. */
        bool isRound() const
        {
            return corners_.size() == 1;
        }

        /** \brief Convex polygons, without padding, that together are the polygon. */
        const std::vector<Polygon> &convexParts() const
        {
            return parts_;
        }

        /** \brief A disc that the robot covers, as large as a search finds. */
        const Circle &inner() const
        {
            return inner_;
        }

        /** \brief A disc that covers the robot. */
        const Circle &outer() const
        {
            return outer_;
        }

        /** \brief Distance of the farthest corner from the reference point: a bound of how far it moves per radian. */
        double reach() const
        {
            return reach_;
        }

        /** \brief The radius of the largest disc about the reference point within the robot, as in Nav2's inflation; 0
            if it is outside of the robot. */
        double inscribedRadius() const
        {
            return inscribedRadius_;
        }

        /** \brief The outline with its padding, in world units, as a polygon. */
        Polygon outline() const;

    private:
        Footprint(Polygon corners, double margin);

        Polygon corners_;
        double margin_;
        std::vector<Polygon> parts_;
        Circle inner_;
        Circle outer_;
        double reach_;
        double inscribedRadius_;
    };
}  // namespace ompl_mfa::maps

#endif
