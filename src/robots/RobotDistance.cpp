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
#include <array>
#include <cmath>

#include "ompl_mfa/robots/RobotCollision.h"
#include "robots/RobotCollisionData.h"

namespace ompl_mfa::robots
{
    namespace
    {
        // Bounds the cost of grazing motions; a motion that needs more steps counts as touching.
        constexpr int MAXIMUM_STEPS = 1000;

        // Of a pair that overlaps, only depths known in closed form are of interest once another pair overlaps.
        bool isOfInterest(const collision::PairFunctions &functions, double smallest)
        {
            return smallest > 0. || functions.separate != nullptr;
        }

        double pairDistance(const collision::PairFunctions &functions, const fcl::CollisionGeometryd &a,
                            const fcl::Transform3d &poseA, const fcl::CollisionGeometryd &b,
                            const fcl::Transform3d &poseB, double smallest)
        {
            if (!isOfInterest(functions, smallest))
            {
                return smallest;
            }
            collision::DistanceSearch search{smallest};
            return std::min(smallest, functions.distance(a, poseA, b, poseB, search));
        }
    }  // namespace

    double RobotCollision::distance(const double *q, double limit) const
    {
        Scratch &scratch = place(q);
        double smallest = limit;
        for (std::uint32_t item = 0; item < data_->items.size(); ++item)
        {
            smallest = itemDistance(item, scratch, smallest);
        }
        return smallest;
    }

    double RobotCollision::itemDistance(std::uint32_t item, Scratch &scratch, double limit) const
    {
        const Data::Item &one = data_->items[item];
        return one.isWorld ? worldDistance(data_->links[one.first], scratch, limit)
                           : linkDistance(data_->links[one.first], data_->links[one.second], scratch, limit);
    }

    double RobotCollision::worldDistance(const LinkItem &link, Scratch &scratch, double limit) const
    {
        double smallest = limit;
        const auto near = [&smallest] { return std::max(smallest, 0.); };
        data_->tree.visitNear(
            scratch.linkCentres[static_cast<std::size_t>(&link - data_->links.data())], link.radius, near,
            [&](std::size_t index)
            {
                const Data::Obstacle &obstacle = data_->obstacles[index];
                for (const std::size_t part : link.worldParts)
                {
                    const Part &one = data_->parts[part];
                    if (link.mayTouch[index] == 0 &&
                        ObstacleTree::distance(obstacle.box, scratch.centre(one)) - one.radius <= near())
                    {
                        smallest = pairDistance(data_->withObstacle(one, index), *one.geometry, scratch.pose(one),
                                                *obstacle.geometry, obstacle.pose, smallest);
                    }
                }
                return false;
            });
        return smallest;
    }

    double RobotCollision::linkDistance(const LinkItem &first, const LinkItem &second, Scratch &scratch,
                                        double limit) const
    {
        double smallest = limit;
        const auto isNear = [&smallest](const fcl::Vector3d &a, const fcl::Vector3d &b, double radii)
        { return (a - b).norm() - radii <= std::max(smallest, 0.); };
        if (!isNear(scratch.linkCentres[static_cast<std::size_t>(&first - data_->links.data())],
                    scratch.linkCentres[static_cast<std::size_t>(&second - data_->links.data())],
                    first.radius + second.radius))
        {
            return smallest;
        }
        for (const std::size_t i : first.selfParts)
        {
            const Part &a = data_->parts[i];
            for (const std::size_t j : second.selfParts)
            {
                const Part &b = data_->parts[j];
                if (isNear(scratch.centre(a), scratch.centre(b), a.radius + b.radius))
                {
                    smallest = pairDistance(collision::pairFunctions(*a.geometry, *b.geometry), *a.geometry,
                                            scratch.pose(a), *b.geometry, scratch.pose(b), smallest);
                }
            }
        }
        return smallest;
    }

    // Covers a motion by intervals. The distances at the middle of an interval cover what the joints can move before
    // and after it; the two remainders are covered recursively, the earlier one first.
    struct RobotCollision::Cover
    {
        Cover(const RobotCollision &robot, const double *start, const double *motion, double contactDistance)
          : collision(robot)
          , from(start)
          , difference(motion)
          , tolerance(contactDistance)
        {
            thread_local std::vector<double> values;
            if (values.size() < robot.kinematics_.dimension())
            {
                values.resize(robot.kinematics_.dimension());
            }
            state = values.data();
        }

        Scratch &place(double t)
        {
            for (std::size_t i = 0; i < collision.kinematics_.dimension(); ++i)
            {
                state[i] = from[i] + t * difference[i];
            }
            return collision.place(state);
        }

        // Metres that a pair can approach each other, at most, over the whole motion.
        double speed(const Data::Item &item) const
        {
            double sum = 0.;
            for (const RobotKinematics::Leverage &leverage : item.leverages)
            {
                sum += leverage.bound * std::abs(difference[collision.kinematics_.steps()[leverage.step].variable]);
            }
            return sum;
        }

        // Intervals in which links travel by about their own size.
        int pieceCount() const
        {
            double count = 4.;
            for (const Data::Item &item : collision.data_->items)
            {
                const double radius = collision.data_->links[item.first].radius;
                count = std::max(count, radius > 0. ? speed(item) / radius : 0.);
            }
            return static_cast<int>(std::min(count, 32.));
        }

        void push(double low, double high)
        {
            open[size++] = {low, high};
        }

        // A collision check takes less time than distances, and most colliding motions collide over a long section.
        bool someStateCollides()
        {
            for (const double share : {1., 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875})
            {
                place(share);
                if (collision.collides(state))
                {
                    return true;
                }
            }
            return false;
        }

        // Half the length of the interval about `middle` that is free, at most `half`; not above 0 if a pair touches.
        double freeHalf(double middle, double half)
        {
            Scratch &scratch = place(middle);
            double covered = half;
            for (const std::uint32_t item : collision.data_->order->current())
            {
                const double approach = speed(collision.data_->items[item]);
                // Slightly more than needed because of rounding errors.
                const double limit = approach * covered * 1.000001 + tolerance;
                if (approach <= 0.)
                {
                    continue;
                }
                const double distance = collision.itemDistance(item, scratch, limit) - tolerance;
                if (distance < approach * covered)
                {
                    covered = distance / approach;
                }
                if (covered <= 0.)
                {
                    collision.data_->order->hit(item);
                    return covered;
                }
            }
            return covered;
        }

        double advance(bool untilFirst)
        {
            // Resolution of the first contact, as a fraction of the motion.
            constexpr double CONTACT_RESOLUTION = 1e-4;
            if (untilFirst && someStateCollides())
            {
                return 0.;
            }
            const int pieces = pieceCount();
            for (int piece = pieces; piece > 0; --piece)
            {
                push(static_cast<double>(piece - 1) / pieces, static_cast<double>(piece) / pieces);
            }
            for (int step = 0; size > 0; ++step)
            {
                const auto [low, high] = open[--size];
                const double middle = 0.5 * (low + high);
                const double half = 0.5 * (high - low);
                if (step == MAXIMUM_STEPS || size + 2 > open.size())
                {
                    return low;
                }
                const double covered = freeHalf(middle, half);
                if (covered >= half)
                {
                    continue;
                }
                if (covered <= 0.)
                {
                    if (untilFirst || half < CONTACT_RESOLUTION)
                    {
                        return low;
                    }
                    // Only free states before the contact are still of interest.
                    size = 0;
                    push(middle, middle);
                    push(low, middle);
                    continue;
                }
                push(middle + covered, high);
                push(low, middle - covered);
            }
            return 1.;
        }

        const RobotCollision &collision;
        const double *from;
        const double *difference;
        double tolerance;
        double *state{nullptr};

        // A stack, the earliest interval on top; each is less than half as long as the one below it.
        std::array<std::pair<double, double>, 128> open;
        std::size_t size{0};
    };

    double RobotCollision::advance(const double *from, const double *difference, double tolerance,
                                   bool untilFirst) const
    {
        return Cover(*this, from, difference, tolerance).advance(untilFirst);
    }
}  // namespace ompl_mfa::robots
