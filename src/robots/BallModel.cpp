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

#include <algorithm>
#include <optional>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>

#include "ompl_mfa/robots/RobotCollision.h"
#include "robots/RobotCollisionData.h"

namespace ompl_mfa::robots
{
    namespace
    {
        std::optional<BallModel::Obstacle> primitive(const fcl::CollisionGeometryd &geometry,
                                                     const fcl::Transform3d &pose)
        {
            BallModel::Obstacle obstacle;
            obstacle.toShape = pose.linear().transpose();
            obstacle.position = pose.translation();
            switch (geometry.getNodeType())
            {
                case fcl::GEOM_BOX:
                    obstacle.shape = BallModel::Shape::Box;
                    obstacle.size = 0.5 * static_cast<const fcl::Boxd &>(geometry).side;
                    obstacle.reach = obstacle.size.norm();
                    return obstacle;
                case fcl::GEOM_SPHERE:
                    obstacle.shape = BallModel::Shape::Ball;
                    obstacle.size.setConstant(static_cast<const fcl::Sphered &>(geometry).radius);
                    obstacle.reach = obstacle.size.x();
                    return obstacle;
                case fcl::GEOM_CYLINDER:
                {
                    const auto &cylinder = static_cast<const fcl::Cylinderd &>(geometry);
                    obstacle.shape = BallModel::Shape::Cylinder;
                    obstacle.size = {cylinder.radius, 0.5 * cylinder.lz, 0.};
                    obstacle.reach = obstacle.size.norm();
                    return obstacle;
                }
                default:
                    return std::nullopt;
            }
        }
    }  // namespace

    void RobotCollision::addBalls()
    {
        BallModel model;
        const auto isBall = [](const Part &part) { return part.geometry->getNodeType() == fcl::GEOM_SPHERE; };
        if (!std::all_of(data_->parts.begin(), data_->parts.end(), isBall))
        {
            return;
        }
        const auto ballsOf = [this](const std::vector<std::size_t> &parts)
        {
            std::vector<BallModel::Ball> balls;
            balls.reserve(parts.size());
            for (const std::size_t part : parts)
            {
                balls.push_back({data_->parts[part].centre, data_->parts[part].radius});
            }
            return balls;
        };
        for (const LinkItem &link : data_->links)
        {
            model.links.push_back(
                {link.body, {link.centre, link.radius}, ballsOf(link.worldParts), ballsOf(link.selfParts)});
        }
        for (const Data::Obstacle &obstacle : data_->obstacles)
        {
            const auto shape = primitive(*obstacle.geometry, obstacle.pose);
            if (!shape)
            {
                return;
            }
            model.obstacles.push_back(*shape);
        }
        for (const Data::Item &item : data_->items)
        {
            BallModel::Test test{item.first, item.second, item.isWorld, {}};
            for (std::size_t i = 0; item.isWorld && i < data_->obstacles.size(); ++i)
            {
                if (data_->links[item.first].mayTouch[i] == 0)
                {
                    test.obstacles.push_back(i);
                }
            }
            model.tests.push_back(std::move(test));
        }
        data_->balls = std::make_unique<BallChecker>(kinematics_, std::move(model));
    }

    bool RobotCollision::isOfBalls() const
    {
        return data_->balls != nullptr;
    }

    bool RobotCollision::anyCollides(const double *const *states, std::size_t count) const
    {
        if (!data_->balls)
        {
            return std::any_of(states, states + count, [this](const double *state) { return collides(state); });
        }
        for (std::size_t i = 0; i < count; i += BallChecker::LANES)
        {
            std::uint32_t test = 0;
            if (data_->balls->collide(states + i, std::min(count - i, BallChecker::LANES), data_->order->current(),
                                      true, test) != 0)
            {
                data_->order->hit(test);
                return true;
            }
        }
        return false;
    }

    std::size_t RobotCollision::firstColliding(const double *const *states, std::size_t count) const
    {
        if (!data_->balls)
        {
            return static_cast<std::size_t>(
                std::find_if(states, states + count, [this](const double *state) { return collides(state); }) - states);
        }
        for (std::size_t i = 0; i < count; i += BallChecker::LANES)
        {
            std::uint32_t test = 0;
            const unsigned int hits = data_->balls->collide(states + i, std::min(count - i, BallChecker::LANES),
                                                            data_->order->current(), false, test);
            for (std::size_t lane = 0; hits != 0; ++lane)
            {
                if ((hits >> lane & 1U) != 0)
                {
                    data_->order->hit(test);
                    return i + lane;
                }
            }
        }
        return count;
    }
}  // namespace ompl_mfa::robots
