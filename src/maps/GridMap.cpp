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

#include "ompl_mfa/maps/GridMap.h"

#include <stdexcept>
#include <utility>

namespace ompl_mfa::maps
{
    GridMap::GridMap(std::size_t width, std::size_t height, std::vector<Cell> cells, const MapFrame &frame)
      : width_(width)
      , height_(height)
      , cells_(std::move(cells))
      , frame_(frame)
      , rotation_(Eigen::Rotation2Dd(frame.yaw).toRotationMatrix())
    {
        if (width == 0 || height == 0 || cells_.size() != width * height)
        {
            throw std::invalid_argument("a map has width x height cells, at least one");
        }
        if (!(frame.resolution > 0.0))
        {
            throw std::invalid_argument("the resolution of a map is above 0");
        }
    }

    Eigen::AlignedBox2d GridMap::bounds() const
    {
        const auto width = static_cast<double>(width_);
        const auto height = static_cast<double>(height_);
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d &corner : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(width, 0.0),
                                              Eigen::Vector2d(0.0, height), Eigen::Vector2d(width, height)})
        {
            box.extend(toWorld(corner));
        }
        return box;
    }
}  // namespace ompl_mfa::maps
