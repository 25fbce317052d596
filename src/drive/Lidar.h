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

#ifndef OMPL_MFA_DRIVE_LIDAR_
#define OMPL_MFA_DRIVE_LIDAR_

#include <cstdint>
#include <functional>

#include <Eigen/Core>

#include "ompl_mfa/maps/ObstacleGrid.h"

namespace ompl_mfa::drive
{
    /** \brief Called with the column and row of a cell, and whether it is an obstacle. */
    using CellVisitor = std::function<void(std::int64_t, std::int64_t, bool)>;

    /** \brief Visits the cells of the map that a ray crosses from \e from on, in their order, up to \e range cells away
        or up to the first obstacle, which is visited too. Cells of which it only touches an edge or a corner may be
        left out.

        Source: J. Amanatides and A. Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987.
        \param truth the obstacles; the ray ends where the map ends
        \param from position in cells
        \param direction of length 1
        \param range in cells
        \param visit called for each cell */
    void castRay(const maps::ObstacleGrid &truth, const Eigen::Vector2d &from, const Eigen::Vector2d &direction,
                 double range, const CellVisitor &visit);

    /** \brief castRay() for \e rays directions, evenly all around. Cells that several rays cross are visited several
        times. */
    void scan(const maps::ObstacleGrid &truth, const Eigen::Vector2d &from, double range, unsigned int rays,
              const CellVisitor &visit);
}  // namespace ompl_mfa::drive

#endif
