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

#ifndef OMPL_MFA_DRIVE_KNOWN_WORLD_
#define OMPL_MFA_DRIVE_KNOWN_WORLD_

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/maps/Footprint.h"
#include "ompl_mfa/maps/ObstacleGrid.h"

namespace ompl_mfa::drive
{
    /** \brief Where the robot is in the world; the yaw is 0 in R^2. */
    struct Pose
    {
        Eigen::Vector2d position;
        double yaw;
    };

    /** \brief What a robot knows of a map, and how it learns more. Unknown cells are free in grid().

        It has a lidar at its reference point, and it perceives the cells within two cells of its outline whatever is
        between: a lidar alone, with gaps between its rays, may miss a cell at its side. */
    class KnownWorld
    {
    public:
        /** \param truth the map as it is, not null
            \param known what the robot knows of it at first, a map of the same size; nothing if not set
            \param footprint the robot
            \param range of the lidar, world units
            \param rays of the lidar */
        KnownWorld(std::shared_ptr<const maps::ObstacleGrid> truth, const std::optional<maps::GridMap> &known,
                   const maps::Footprint &footprint, double range, unsigned int rays);

        /** \brief The obstacles that are known; its distances are limited, see ObstacleGrid::farthest(). */
        std::shared_ptr<const maps::ObstacleGrid> grid() const
        {
            return grid_;
        }

        const maps::ObstacleGrid &truth() const
        {
            return *truth_;
        }

        std::shared_ptr<const maps::ObstacleGrid> trueGrid() const
        {
            return truth_;
        }

        /** \brief The cells that a scan at \e position would change in grid(), each once. */
        std::vector<maps::CellChange> scanned(const Eigen::Vector2d &position) const;

        /** \brief The cells within two cells of the robot's outline that are known otherwise than they are. */
        std::vector<maps::CellChange> felt(const Pose &pose) const;

        /** \brief Adds this to what is known. Returns whether an obstacle appeared or disappeared. */
        bool learn(const std::vector<maps::CellChange> &changes);

        /** \brief All cells passed to learn() since the last call. */
        std::vector<maps::CellChange> takeNews();

    private:
        maps::Cell cellOf(bool isObstacle) const;

        std::shared_ptr<const maps::ObstacleGrid> truth_;
        maps::Footprint footprint_;
        double range_;
        unsigned int rays_;
        std::shared_ptr<maps::ObstacleGrid> grid_;
        std::vector<maps::CellChange> news_;
    };
}  // namespace ompl_mfa::drive

#endif
