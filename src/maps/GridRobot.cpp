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

#include "maps/GridRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "maps/SweptShape.h"

namespace ompl_mfa::maps
{
    namespace
    {
        Footprint::Polygon scaled(Footprint::Polygon polygon, double factor)
        {
            for (Eigen::Vector2d &corner : polygon)
            {
                corner *= factor;
            }
            return polygon;
        }
        Footprint::Circle circleAround(const Footprint::Polygon &corners)
        {
            Eigen::AlignedBox2d box;
            for (const Eigen::Vector2d &corner : corners)
            {
                box.extend(corner);
            }
            return {box.center(), 0.5 * box.diagonal().norm()};
        }
    }  // namespace

    GridRobot::GridRobot(std::shared_ptr<const ObstacleGrid> grid, const Footprint &footprint)
      : grid_(std::move(grid))
      , footprint_(footprint)
    {
        const double cells = 1.0 / grid_->map().frame().resolution;
        for (const Footprint::Polygon &part : footprint.convexParts())
        {
            const Footprint::Polygon corners = scaled(part, cells);
            parts_.push_back({corners, circleAround(corners)});
        }
        corners_ = scaled(footprint.corners(), cells);
        inner_ = {footprint.inner().centre * cells, footprint.inner().radius * cells};
        outer_ = {footprint.outer().centre * cells, footprint.outer().radius * cells};
        margin_ = footprint.margin() * cells;
        reach_ = footprint.reach() * cells;
    }

    bool GridRobot::isFree(const GridPose &pose) const
    {
        return pose.position.allFinite() &&
               (isClearlyFree(pose, 0.0) ||
                (!isClearlyBlocked(pose) && isSweepFree(pose.position, pose.position, pose.yaw, 0.0)));
    }

    bool GridRobot::isClearlyFree(const GridPose &pose, double travel) const
    {
        const Eigen::Vector2d centre =
            footprint_.isRound() ? pose.position : pose.position + Eigen::Rotation2Dd(pose.yaw) * outer_.centre;
        return grid_->leastDistance(centre) > outer_.radius + travel;
    }

    bool GridRobot::isClearlyBlocked(const GridPose &pose) const
    {
        const Eigen::Vector2d centre =
            footprint_.isRound() ? pose.position : pose.position + Eigen::Rotation2Dd(pose.yaw) * inner_.centre;
        return grid_->largestDistance(centre) < inner_.radius;
    }

    bool GridRobot::isSweepFree(const Eigen::Vector2d &from, const Eigen::Vector2d &to, double yaw, double margin) const
    {
        thread_local SweptShape shape;
        const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(yaw).toRotationMatrix();
        const bool moves = from != to;
        const Eigen::Vector2d middle = 0.5 * (from + to);
        const double spread = margin_ + margin + 0.5 * (to - from).norm();
        for (const Part &each : parts_)
        {
            if (grid_->leastDistance(middle + rotation * each.outer.centre) > each.outer.radius + spread)
            {
                continue;
            }
            const Footprint::Polygon &part = each.corners;
            shape.reset(margin_ + margin);
            Eigen::Vector2d corner = rotation * part.back();
            for (const Eigen::Vector2d &next : part)
            {
                const Eigen::Vector2d turned = rotation * next;
                if (part.size() > 1 || !moves)
                {
                    shape.add(from + corner, from + turned);
                }
                if (moves)
                {
                    shape.add(from + turned, to + turned);
                }
                if (moves && part.size() > 1)
                {
                    shape.add(to + corner, to + turned);
                }
                corner = turned;
            }
            if (shape.touches(*grid_))
            {
                return false;
            }
        }
        return true;
    }

    double GridRobot::outlineDistance(const GridPose &pose) const
    {
        struct Piece
        {
            Eigen::Vector2d from;
            Eigen::Vector2d to;
        };
        // distances change by at most the diagonal of a cell per cell; pieces are halved until this tells the least one
        constexpr double LIPSCHITZ = 1.4143;
        constexpr double TOLERANCE = 0.1;
        thread_local std::vector<Piece> pieces;
        const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(pose.yaw).toRotationMatrix();
        double least = std::numeric_limits<double>::infinity();
        pieces.clear();
        for (std::size_t i = 0; i < corners_.size(); ++i)
        {
            pieces.push_back({pose.position + rotation * corners_[i],
                              pose.position + rotation * corners_[(i + 1) % corners_.size()]});
            least = std::min(least, grid_->distance(pieces.back().from));
        }
        while (!pieces.empty())
        {
            const Piece piece = pieces.back();
            pieces.pop_back();
            const Eigen::Vector2d middle = 0.5 * (piece.from + piece.to);
            const double distance = grid_->distance(middle);
            least = std::min(least, distance);
            if (distance - 0.5 * LIPSCHITZ * (piece.to - piece.from).norm() < least - TOLERANCE)
            {
                pieces.push_back({piece.from, middle});
                pieces.push_back({middle, piece.to});
            }
        }
        return least;
    }

    double GridRobot::clearance(const GridPose &pose) const
    {
        // a free robot is not nearer to an obstacle than this, so that its sign is known
        constexpr double CERTAIN = 2.0;
        const double clearance =
            (footprint_.isRound() ? grid_->distance(pose.position) : outlineDistance(pose)) - margin_;
        if (footprint_.isRound() && std::abs(clearance) > CERTAIN)
        {
            return clearance;
        }
        return isFree(pose) ? std::max(clearance, 0.0) : std::min(clearance, 0.0);
    }
}  // namespace ompl_mfa::maps
