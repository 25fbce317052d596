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

#include "ompl_mfa/robots/RobotCollision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "collision/ShapeReach.h"
#include "ompl_mfa/InputError.h"
#include "robots/RobotCollisionData.h"
#include "robots/ShapePadding.h"

namespace ompl_mfa::robots
{
    namespace
    {
        RobotKinematics kinematicsOf(const PlacedRobot &robot)
        {
            if (!robot.model || !robot.semantics || !robot.scene || robot.values.size() != robot.model->joints().size())
            {
                throw std::invalid_argument(
                    "RobotCollision: a model, semantics, a scene and a value for each joint are "
                    "needed");
            }
            return {*robot.model, robot.group, robot.values, robot.base};
        }

        double valueOf(const std::map<std::string, double> &values, const std::string &link, double fallback)
        {
            const auto value = values.find(link);
            return value == values.end() ? fallback : value->second;
        }

        // Steps that move one of two bodies and not the other.
        std::vector<RobotKinematics::Leverage> relative(const std::vector<RobotKinematics::Leverage> &first,
                                                        const std::vector<RobotKinematics::Leverage> &second)
        {
            std::vector<RobotKinematics::Leverage> result;
            const auto addOthers = [&result](const auto &from, const auto &other)
            {
                std::copy_if(from.begin(), from.end(), std::back_inserter(result),
                             [&other](const auto &leverage)
                             {
                                 return std::none_of(other.begin(), other.end(),
                                                     [&leverage](const auto &one)
                                                     { return one.step == leverage.step; });
                             });
            };
            addOthers(first, second);
            addOthers(second, first);
            return result;
        }
    }  // namespace

    RobotCollision::Part::Part(std::shared_ptr<fcl::CollisionGeometryd> shape, const fcl::Transform3d &poseInBody,
                               std::size_t bodyIndex, std::size_t partIndex)
      : geometry(std::move(shape))
      , pose(poseInBody)
      , body(bodyIndex)
      , index(partIndex)
    {
        // FCL's own box of a shape may not have been computed.
        const fcl::Vector3d middle = collision::boundingBox(*geometry, fcl::Transform3d::Identity()).center();
        const collision::ShapeReach aboutCentre =
            collision::shapeReach(*geometry, fcl::Transform3d(Eigen::Translation3d(-middle)));
        centre = poseInBody * middle;
        radius = aboutCentre.core + aboutCentre.margin;
        reach = collision::shapeReach(*geometry, pose).core;
    }

    RobotCollision::RobotCollision(const PlacedRobot &robot)
      : kinematics_(kinematicsOf(robot))
      , data_(std::make_unique<Data>())
    {
        addLinks(robot);
        addAttached(robot);
        for (LinkItem &link : data_->links)
        {
            // The parts' smallest common ball would be little smaller.
            fcl::AABBd box;
            for (const auto *parts : {&link.worldParts, &link.selfParts})
            {
                for (const std::size_t part : *parts)
                {
                    box += data_->parts[part].centre;
                    link.reach = std::max(link.reach, data_->parts[part].reach);
                }
            }
            link.centre = box.center();
            for (const auto *parts : {&link.worldParts, &link.selfParts})
            {
                for (const std::size_t part : *parts)
                {
                    const Part &one = data_->parts[part];
                    link.radius = std::max(link.radius, (one.centre - link.centre).norm() + one.radius);
                }
            }
        }
        addObstacles(robot);
        addPairs(robot);
        data_->order = std::make_unique<HitOrder>(data_->items.size());
        addBalls();
    }

    RobotCollision::~RobotCollision() = default;

    void RobotCollision::addLinks(const PlacedRobot &robot)
    {
        for (std::size_t i = 0; i < robot.model->links().size(); ++i)
        {
            const Link &link = robot.model->links()[i];
            if (link.shapes.empty())
            {
                continue;
            }
            const double padding = robot.padding + valueOf(robot.scene->padding, link.name, 0.);
            const double scale = valueOf(robot.scene->scale, link.name, 1.);
            LinkItem item;
            item.name = link.name;
            item.body = kinematics_.bodyOf(i);
            for (const collision::RigidBody::Shape &shape : link.shapes)
            {
                const fcl::Transform3d pose = kinematics_.poseInBody(i) * shape.pose;
                item.selfParts.push_back(data_->parts.size());
                data_->parts.emplace_back(shape.geometry, pose, item.body, data_->parts.size());
                std::shared_ptr<fcl::CollisionGeometryd> padded;
                try
                {
                    padded = paddedShape(shape.geometry, scale, padding);
                }
                catch (const InputError &error)
                {
                    throw InputError("link '" + link.name + "': " + error.what());
                }
                item.worldParts.push_back(item.selfParts.back());
                if (padded != shape.geometry)
                {
                    item.worldParts.back() = data_->parts.size();
                    data_->parts.emplace_back(padded, pose, item.body, data_->parts.size());
                }
            }
            data_->links.push_back(std::move(item));
        }
    }

    void RobotCollision::addAttached(const PlacedRobot &robot)
    {
        for (const collision::AttachedObject &attached : robot.scene->attached)
        {
            const auto link = robot.model->findLink(attached.link);
            if (!link)
            {
                throw InputError(attached.place + ": '" + attached.id + "' is attached to the link '" + attached.link +
                                 "', which the robot does not have");
            }
            for (const std::string &touched : attached.touchLinks)
            {
                if (!robot.model->findLink(touched))
                {
                    throw InputError(attached.place + ": touch_links of '" + attached.id + "' has the link '" +
                                     touched + "', which the robot does not have");
                }
            }
            LinkItem item;
            item.name = attached.id;
            item.body = kinematics_.bodyOf(*link);
            for (const collision::RigidBody::Shape &shape : attached.shapes)
            {
                item.selfParts.push_back(data_->parts.size());
                data_->parts.emplace_back(shape.geometry, kinematics_.poseInBody(*link) * shape.pose, item.body,
                                          data_->parts.size());
            }
            item.worldParts = item.selfParts;
            data_->links.push_back(std::move(item));
        }
    }

    void RobotCollision::addObstacles(const PlacedRobot &robot)
    {
        std::vector<fcl::AABBd> boxes;
        for (const collision::CollisionObject &object : robot.scene->world.objects())
        {
            boxes.push_back(collision::boundingBox(*object.geometry, object.pose));
            data_->obstacles.push_back({object.id, object.geometry, object.pose, boxes.back()});
        }
        data_->tree = ObstacleTree(boxes);
        for (const Part &part : data_->parts)
        {
            for (const Data::Obstacle &obstacle : data_->obstacles)
            {
                data_->obstacleFunctions.push_back(&collision::pairFunctions(*part.geometry, *obstacle.geometry));
            }
        }
        for (std::size_t i = 0; i < data_->links.size(); ++i)
        {
            LinkItem &link = data_->links[i];
            bool isChecked = false;
            for (const Data::Obstacle &obstacle : data_->obstacles)
            {
                link.mayTouch.push_back(robot.scene->allowed.find(link.name, obstacle.id).value_or(false) ? 1 : 0);
                isChecked = isChecked || link.mayTouch.back() == 0;
            }
            if (isChecked && link.body != 0)
            {
                data_->items.push_back({i, i, true, kinematics_.leverages(link.body, link.reach)});
            }
        }
    }

    void RobotCollision::addPairs(const PlacedRobot &robot)
    {
        const auto touches = [&robot](const std::string &object, const std::string &link)
        {
            const auto &attached = robot.scene->attached;
            return std::any_of(
                attached.begin(), attached.end(),
                [&](const collision::AttachedObject &one)
                {
                    return one.id == object &&
                           (one.link == link || std::count(one.touchLinks.begin(), one.touchLinks.end(), link) > 0);
                });
        };
        for (std::size_t i = 0; i < data_->links.size(); ++i)
        {
            for (std::size_t j = i + 1; j < data_->links.size(); ++j)
            {
                const LinkItem &first = data_->links[i];
                const LinkItem &second = data_->links[j];
                const auto inScene = robot.scene->allowed.find(first.name, second.name);
                const bool mayTouch =
                    inScene ? *inScene
                            : touches(first.name, second.name) || touches(second.name, first.name) ||
                                  robot.semantics->allowed().find(first.name, second.name).value_or(false);
                if (!mayTouch && first.body != second.body)
                {
                    data_->items.push_back({i, j, false,
                                            relative(kinematics_.leverages(first.body, first.reach),
                                                     kinematics_.leverages(second.body, second.reach))});
                }
            }
        }
    }

    RobotCollision::Scratch &RobotCollision::place(const double *q) const
    {
        thread_local Scratch scratch;
        if (scratch.bodies.size() < kinematics_.bodyCount())
        {
            scratch.bodies.resize(kinematics_.bodyCount());
        }
        if (scratch.linkCentres.size() < data_->links.size())
        {
            scratch.linkCentres.resize(data_->links.size());
        }
        if (scratch.partPoses.size() < data_->parts.size())
        {
            scratch.partPoses.resize(data_->parts.size());
            scratch.isPlaced.resize(data_->parts.size());
        }
        std::fill(scratch.isPlaced.begin(), scratch.isPlaced.end(), 0);
        kinematics_.place(q, scratch.bodies.data());
        for (std::size_t i = 0; i < data_->links.size(); ++i)
        {
            scratch.linkCentres[i] = scratch.bodies[data_->links[i].body] * data_->links[i].centre;
        }
        return scratch;
    }

    bool RobotCollision::collides(const double *q) const
    {
        if (data_->balls)
        {
            return anyCollides(&q, 1);
        }
        Scratch &scratch = place(q);
        for (const std::uint32_t item : data_->order->current())
        {
            if (test(item, scratch))
            {
                data_->order->hit(item);
                return true;
            }
        }
        return false;
    }

    bool RobotCollision::test(std::uint32_t item, Scratch &scratch) const
    {
        const Data::Item &one = data_->items[item];
        return one.isWorld ? hitsWorld(data_->links[one.first], scratch)
                           : hitsLink(data_->links[one.first], data_->links[one.second], scratch);
    }

    bool RobotCollision::hitsWorld(const LinkItem &link, Scratch &scratch) const
    {
        bool hit = false;
        const auto touching = [] { return 0.; };
        data_->tree.visitNear(
            scratch.linkCentres[static_cast<std::size_t>(&link - data_->links.data())], link.radius, touching,
            [&](std::size_t index)
            {
                if (link.mayTouch[index] != 0)
                {
                    return false;
                }
                const Data::Obstacle &obstacle = data_->obstacles[index];
                hit = std::any_of(link.worldParts.begin(), link.worldParts.end(),
                                  [&](std::size_t part)
                                  {
                                      const Part &one = data_->parts[part];
                                      return ObstacleTree::distance(obstacle.box, scratch.centre(one)) <= one.radius &&
                                             data_->withObstacle(one, index)
                                                 .collide(*one.geometry, scratch.pose(one), *obstacle.geometry,
                                                          obstacle.pose);
                                  });
                return hit;
            });
        return hit;
    }

    bool RobotCollision::hitsLink(const LinkItem &first, const LinkItem &second, Scratch &scratch) const
    {
        const fcl::Vector3d &centre = scratch.linkCentres[static_cast<std::size_t>(&first - data_->links.data())];
        const fcl::Vector3d &other = scratch.linkCentres[static_cast<std::size_t>(&second - data_->links.data())];
        const auto apart = [](const fcl::Vector3d &a, double radiusA, const fcl::Vector3d &b, double radiusB)
        { return (a - b).squaredNorm() > (radiusA + radiusB) * (radiusA + radiusB); };
        if (apart(centre, first.radius, other, second.radius))
        {
            return false;
        }
        for (const std::size_t i : first.selfParts)
        {
            const Part &a = data_->parts[i];
            const fcl::Vector3d centreA = scratch.centre(a);
            if (apart(centreA, a.radius, other, second.radius))
            {
                continue;
            }
            for (const std::size_t j : second.selfParts)
            {
                const Part &b = data_->parts[j];
                if (!apart(centreA, a.radius, scratch.centre(b), b.radius) &&
                    collision::pairFunctions(*a.geometry, *b.geometry)
                        .collide(*a.geometry, scratch.pose(a), *b.geometry, scratch.pose(b)))
                {
                    return true;
                }
            }
        }
        return false;
    }

    std::vector<std::pair<std::string, std::string>> RobotCollision::checkedPairs() const
    {
        std::vector<std::pair<std::string, std::string>> pairs;
        for (const Data::Item &item : data_->items)
        {
            if (!item.isWorld)
            {
                pairs.emplace_back(data_->links[item.first].name, data_->links[item.second].name);
            }
        }
        return pairs;
    }

    std::vector<std::pair<std::string, std::string>> RobotCollision::checkedObstacles() const
    {
        std::vector<std::pair<std::string, std::string>> pairs;
        for (const Data::Item &item : data_->items)
        {
            for (std::size_t i = 0; item.isWorld && i < data_->obstacles.size(); ++i)
            {
                if (data_->links[item.first].mayTouch[i] == 0)
                {
                    pairs.emplace_back(data_->links[item.first].name, data_->obstacles[i].id);
                }
            }
        }
        return pairs;
    }

    double RobotCollision::extent() const
    {
        fcl::AABBd box;
        for (const Data::Obstacle &obstacle : data_->obstacles)
        {
            box += obstacle.box;
        }
        double radius = 0.;
        for (const LinkItem &link : data_->links)
        {
            radius += 2. * link.radius;
        }
        return radius + (data_->obstacles.empty() ? 0. : (box.max_ - box.min_).norm());
    }
}  // namespace ompl_mfa::robots
