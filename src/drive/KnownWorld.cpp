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

#include "drive/KnownWorld.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "drive/Lidar.h"

namespace ompl_mfa::drive
{
    namespace
    {
        constexpr double FELT = 2.0;

        /* Distances beyond a few times the robot's size only make motion checks in the open a little faster. */
        double usefulDistance(const maps::Footprint &footprint, double resolution)
        {
            constexpr double LEAST = 24.0;
            constexpr double FACTOR = 3.0;
            return std::max(LEAST, FACTOR * (footprint.reach() + footprint.margin()) / resolution);
        }

        maps::GridMap unknownMap(const maps::GridMap &truth)
        {
            return {truth.width(), truth.height(), std::vector<maps::Cell>(truth.cells().size(), maps::Cell::Unknown),
                    truth.frame()};
        }

        /* Distance of a point from a polygon, counterclockwise or not; 0 within it. */
        double distanceFrom(const maps::Footprint::Polygon &corners, const Eigen::Vector2d &point)
        {
            bool isInside = false;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                const Eigen::Vector2d &a = corners[i];
                const Eigen::Vector2d &b = corners[(i + 1) % corners.size()];
                const Eigen::Vector2d along = b - a;
                const double squared = along.squaredNorm();
                const double share = squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
                least = std::min(least, (a + share * along - point).norm());
                if ((a.y() > point.y()) != (b.y() > point.y()) &&
                    point.x() < a.x() + (point.y() - a.y()) / along.y() * along.x())
                {
                    isInside = !isInside;
                }
            }
            return isInside ? 0.0 : least;
        }
    }  // namespace

    KnownWorld::KnownWorld(std::shared_ptr<const maps::ObstacleGrid> truth, const std::optional<maps::GridMap> &known,
                           const maps::Footprint &footprint, double range, unsigned int rays)
      : truth_(std::move(truth))
      , footprint_(footprint)
      , range_(range)
      , rays_(rays)
      , grid_(std::make_shared<maps::ObstacleGrid>(known ? *known : unknownMap(truth_->map()), maps::UnknownCells::Free,
                                                   usefulDistance(footprint, truth_->map().frame().resolution)))
    {
    }

    maps::Cell KnownWorld::cellOf(bool isObstacle) const
    {
        return isObstacle ? maps::Cell::Occupied : maps::Cell::Free;
    }

    std::vector<maps::CellChange> KnownWorld::scanned(const Eigen::Vector2d &position) const
    {
        const maps::GridMap &known = grid_->map();
        std::vector<maps::CellChange> changes;
        scan(*truth_, known.toGrid(position), range_ / known.frame().resolution, rays_,
             [&](std::int64_t x, std::int64_t y, bool isObstacle)
             {
                 const auto column = static_cast<std::size_t>(x);
                 const auto row = static_cast<std::size_t>(y);
                 const maps::Cell cell = cellOf(isObstacle);
                 if (known.cell(column, row) != cell)
                 {
                     changes.push_back({column, row, cell});
                 }
             });
        const auto place = [](const maps::CellChange &change) { return std::tie(change.y, change.x); };
        std::sort(changes.begin(), changes.end(),
                  [place](const auto &one, const auto &other) { return place(one) < place(other); });
        changes.erase(std::unique(changes.begin(), changes.end(),
                                  [place](const auto &one, const auto &other) { return place(one) == place(other); }),
                      changes.end());
        return changes;
    }

    std::vector<maps::CellChange> KnownWorld::felt(const Pose &pose) const
    {
        const maps::GridMap &known = grid_->map();
        const double resolution = known.frame().resolution;
        const Eigen::Vector2d centre = known.toGrid(pose.position);
        const double reach = (footprint_.reach() + footprint_.margin()) / resolution + FELT + 1.0;
        const auto first = [](double value) { return static_cast<std::int64_t>(std::max(0.0, std::floor(value))); };
        const auto end = [](double value, std::size_t count)
        { return static_cast<std::int64_t>(std::clamp(std::ceil(value), 0.0, static_cast<double>(count))); };
        const Eigen::Matrix2d toRobot = Eigen::Rotation2Dd(-pose.yaw).toRotationMatrix();
        std::vector<maps::CellChange> changes;
        for (std::int64_t y = first(centre.y() - reach); y < end(centre.y() + reach, known.height()); ++y)
        {
            for (std::int64_t x = first(centre.x() - reach); x < end(centre.x() + reach, known.width()); ++x)
            {
                const auto column = static_cast<std::size_t>(x);
                const auto row = static_cast<std::size_t>(y);
                const maps::Cell cell = cellOf(truth_->isOccupied(x, y));
                if (known.cell(column, row) == cell)
                {
                    continue;
                }
                // from the nearest point of the cell, at most half a diagonal from its centre
                const Eigen::Vector2d middle(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
                const double distance =
                    distanceFrom(footprint_.corners(), toRobot * (known.toWorld(middle) - pose.position));
                if (distance - footprint_.margin() <= (FELT + std::sqrt(0.5)) * resolution)
                {
                    changes.push_back({column, row, cell});
                }
            }
        }
        return changes;
    }

    bool KnownWorld::learn(const std::vector<maps::CellChange> &changes)
    {
        news_.insert(news_.end(), changes.begin(), changes.end());
        return grid_->update(changes);
    }

    std::vector<maps::CellChange> KnownWorld::takeNews()
    {
        return std::exchange(news_, {});
    }
}  // namespace ompl_mfa::drive
