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

#ifndef OMPL_MFA_MAPS_GRID_ROBOT_
#define OMPL_MFA_MAPS_GRID_ROBOT_

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "ompl_mfa/maps/Footprint.h"
#include "ompl_mfa/maps/ObstacleGrid.h"

namespace ompl_mfa::maps
{
    /** \brief Position and orientation on a grid, in cells and radians. */
    struct GridPose
    {
        Eigen::Vector2d position;
        double yaw;
    };

    /** \brief A robot among the obstacles of a grid. All positions and distances are in cells. */
    class GridRobot
    {
    public:
        GridRobot(std::shared_ptr<const ObstacleGrid> grid, const Footprint &footprint);

        const ObstacleGrid &grid() const
        {
            return *grid_;
        }

        /** \brief The robot in world units. */
        const Footprint &footprint() const
        {
            return footprint_;
        }

        /** \brief Distance of the farthest corner from the reference point. */
        double reach() const
        {
            return reach_;
        }

        /** \brief Whether the robot touches no obstacle. Exact. */
        bool isFree(const GridPose &pose) const;

        /** \brief Signed distance from the obstacles, to within a cell: not below 0 for a free pose nor above 0 for
            another one. In collision it is minus the greatest depth of a point of the outline, or of the centre of a
            disc plus its radius. */
        double clearance(const GridPose &pose) const;

        /** \brief Whether discs show that no obstacle is within \e travel, at least 0, of the robot; false if they do
            not tell. */
        bool isClearlyFree(const GridPose &pose, double travel) const;

        /** \brief Whether a disc shows that the robot touches an obstacle; false if it does not tell. */
        bool isClearlyBlocked(const GridPose &pose) const;

        /** \brief Whether no obstacle is within \e margin of what the robot covers while its reference point goes
            straight from \e from to \e to. Exact. */
        bool isSweepFree(const Eigen::Vector2d &from, const Eigen::Vector2d &to, double yaw, double margin) const;

    private:
        double outlineDistance(const GridPose &pose) const;

        std::shared_ptr<const ObstacleGrid> grid_;
        Footprint footprint_;
        /** \brief A convex part of the robot, and a disc around it. */
        struct Part
        {
            Footprint::Polygon corners;
            Footprint::Circle outer;
        };

        std::vector<Part> parts_;
        Footprint::Polygon corners_;
        Footprint::Circle inner_;
        Footprint::Circle outer_;
        double margin_;
        double reach_;
    };
}  // namespace ompl_mfa::maps

#endif
