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

#ifndef OMPL_MFA_MAPS_MAP_MOTION_
#define OMPL_MFA_MAPS_MAP_MOTION_

#include <optional>

#include "maps/GridRobot.h"

namespace ompl_mfa::maps
{
    /** \brief A motion on a grid, in cells. */
    class MapMotion
    {
    public:
        virtual ~MapMotion() = default;

        /** \brief The pose at this fraction of the motion, from 0 to 1. */
        virtual GridPose pose(double share) = 0;

        /** \brief Length of the path of the reference point; it moves at constant speed. */
        double length{0.0};
        /** \brief Bound of the angle by which the robot turns in the whole motion, radians. */
        double turn{0.0};
        bool isStraight{true};
        /** \brief The bounds of positions in the world, if the motion may leave them. */
        std::optional<Eigen::AlignedBox2d> bounds;
    };

    /** \brief Cells: a rotating or curved motion that comes closer to an obstacle counts as a collision. */
    constexpr double MOTION_TOLERANCE = 0.02;

    /** \brief 1 if the motion of \e robot is free. Otherwise less: if it \e locates the collision, a fraction up to
        which the motion is free, at most MOTION_TOLERANCE of length before the collision. */
    double freeShareOf(const GridRobot &robot, MapMotion &motion, bool locates);
}  // namespace ompl_mfa::maps

#endif
