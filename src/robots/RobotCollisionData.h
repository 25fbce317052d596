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

#ifndef OMPL_MFA_ROBOTS_ROBOT_COLLISION_DATA_
#define OMPL_MFA_ROBOTS_ROBOT_COLLISION_DATA_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "collision/NarrowPhase.h"
#include "ompl_mfa/robots/RobotCollision.h"
#include "robots/BallChecker.h"
#include "robots/HitOrder.h"
#include "robots/ObstacleTree.h"

namespace ompl_mfa::robots
{
    // A shape of a link. A ball about its centre contains it.
    struct RobotCollision::Part
    {
        Part(std::shared_ptr<fcl::CollisionGeometryd> shape, const fcl::Transform3d &poseInBody, std::size_t bodyIndex,
             std::size_t partIndex);

        std::shared_ptr<fcl::CollisionGeometryd> geometry;
        fcl::Transform3d pose;
        std::size_t body;
        std::size_t index;
        fcl::Vector3d centre;
        double radius{0.};

        // Farthest point from the origin of the body that a rotation moves.
        double reach{0.};
    };

    // A link or an attached object. A ball about its centre contains all its parts, padded or not.
    struct RobotCollision::LinkItem
    {
        std::string name;
        std::size_t body{0};

        // Parts for collisions with the world, and unpadded for those with other links.
        std::vector<std::size_t> worldParts;
        std::vector<std::size_t> selfParts;

        fcl::Vector3d centre{fcl::Vector3d::Zero()};
        double radius{0.};
        double reach{0.};

        // By obstacle: whether the link may touch it.
        std::vector<char> mayTouch;
    };

    struct RobotCollision::Data
    {
        struct Obstacle
        {
            std::string id;
            std::shared_ptr<fcl::CollisionGeometryd> geometry;
            fcl::Transform3d pose;
            fcl::AABBd box;
        };

        // A test: of a link with the world, or with a second link.
        struct Item
        {
            std::size_t first;
            std::size_t second;
            bool isWorld;
            std::vector<RobotKinematics::Leverage> leverages;
        };

        const collision::PairFunctions &withObstacle(const Part &part, std::size_t obstacle) const
        {
            return *obstacleFunctions[part.index * obstacles.size() + obstacle];
        }

        std::vector<Part> parts;
        std::vector<LinkItem> links;
        std::vector<Obstacle> obstacles;
        ObstacleTree tree;
        std::vector<Item> items;
        std::vector<const collision::PairFunctions *> obstacleFunctions;

        // Null if not everything is of balls and primitives.
        std::unique_ptr<const BallChecker> balls;

        // Counts while queries run, which changes no answer.
        std::unique_ptr<HitOrder> order;
    };

    // Memory of a thread, reused by its next query.
    struct RobotCollision::Scratch
    {
        std::vector<fcl::Transform3d> bodies;
        std::vector<fcl::Vector3d> linkCentres;

        // World poses of the parts as far as they have been needed for this state.
        std::vector<fcl::Transform3d> partPoses;
        std::vector<char> isPlaced;

        const fcl::Transform3d &pose(const Part &part)
        {
            if (isPlaced[part.index] == 0)
            {
                partPoses[part.index] = bodies[part.body] * part.pose;
                isPlaced[part.index] = 1;
            }
            return partPoses[part.index];
        }

        fcl::Vector3d centre(const Part &part) const
        {
            return bodies[part.body] * part.centre;
        }
    };
}  // namespace ompl_mfa::robots

#endif
