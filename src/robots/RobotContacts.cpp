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
#include <functional>
#include <limits>

#include "ompl_mfa/robots/RobotCollision.h"
#include "robots/RobotCollisionData.h"

namespace ompl_mfa::robots
{
    namespace
    {
        using Touches = std::function<bool(const fcl::Vector3d &)>;

        // Shortest translation along a direction after which two shapes are apart, unless it is longer than `limit`.
        double separation(const fcl::Vector3d &direction, double limit, const Touches &touches)
        {
            constexpr double FIRST = 1e-3;
            constexpr int HALVINGS = 20;
            double low = 0.;
            double high = FIRST;
            while (high < limit && touches(high * direction))
            {
                low = high;
                high *= 2.;
            }
            for (int i = 0; i < HALVINGS && low < limit; ++i)
            {
                const double middle = 0.5 * (low + high);
                (touches(middle * direction) ? low : high) = middle;
            }
            return std::min(high, limit);
        }

        // The best of the directions to the 26 neighbours of a cube.
        double depth(const Touches &touches)
        {
            double best = std::numeric_limits<double>::infinity();
            for (const double x : {-1., 0., 1.})
            {
                for (const double y : {-1., 0., 1.})
                {
                    for (const double z : {-1., 0., 1.})
                    {
                        const fcl::Vector3d neighbour(x, y, z);
                        best = neighbour.isZero() ? best : separation(neighbour.normalized(), best, touches);
                    }
                }
            }
            return best;
        }
    }  // namespace

    bool RobotCollision::touchesObstacle(const LinkItem &link, std::size_t obstacle, const fcl::Vector3d &offset,
                                         Scratch &scratch) const
    {
        const Data::Obstacle &other = data_->obstacles[obstacle];
        return std::any_of(
            link.worldParts.begin(), link.worldParts.end(),
            [&](std::size_t index)
            {
                const Part &part = data_->parts[index];
                fcl::Transform3d pose = scratch.pose(part);
                pose.translation() += offset;
                return data_->withObstacle(part, obstacle).collide(*part.geometry, pose, *other.geometry, other.pose);
            });
    }

    bool RobotCollision::touchesLink(const LinkItem &link, const LinkItem &other, const fcl::Vector3d &offset,
                                     Scratch &scratch) const
    {
        for (const std::size_t i : link.selfParts)
        {
            const Part &a = data_->parts[i];
            fcl::Transform3d pose = scratch.pose(a);
            pose.translation() += offset;
            for (const std::size_t j : other.selfParts)
            {
                const Part &b = data_->parts[j];
                if (collision::pairFunctions(*a.geometry, *b.geometry)
                        .collide(*a.geometry, pose, *b.geometry, scratch.pose(b)))
                {
                    return true;
                }
            }
        }
        return false;
    }

    std::vector<RobotContact> RobotCollision::contacts(const double *q) const
    {
        Scratch &scratch = place(q);
        std::vector<RobotContact> contacts;
        const auto add = [&contacts](const std::string &first, const std::string &second, const Touches &touches)
        {
            if (touches(fcl::Vector3d::Zero()))
            {
                contacts.push_back({first, second, depth(touches)});
            }
        };
        for (const Data::Item &item : data_->items)
        {
            const LinkItem &link = data_->links[item.first];
            const LinkItem &other = data_->links[item.second];
            for (std::size_t i = 0; item.isWorld && i < data_->obstacles.size(); ++i)
            {
                if (link.mayTouch[i] == 0)
                {
                    add(link.name, data_->obstacles[i].id,
                        [&, i](const fcl::Vector3d &offset) { return touchesObstacle(link, i, offset, scratch); });
                }
            }
            if (!item.isWorld)
            {
                add(link.name, other.name,
                    [&](const fcl::Vector3d &offset) { return touchesLink(link, other, offset, scratch); });
            }
        }
        return contacts;
    }
}  // namespace ompl_mfa::robots
