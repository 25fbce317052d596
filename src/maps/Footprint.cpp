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

#include "ompl_mfa/maps/Footprint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/PlanePolygon.h"
#include "ompl_mfa/InputError.h"
#include "text/NumberText.h"

namespace ompl_mfa::maps
{
    namespace
    {
        constexpr double PI = 3.14159265358979323846;

        /* Around the middle of the bounding box. */
        Footprint::Circle outerCircle(const Footprint::Polygon &corners)
        {
            Eigen::Vector2d lower = corners.front();
            Eigen::Vector2d upper = corners.front();
            for (const Eigen::Vector2d &corner : corners)
            {
                lower = lower.cwiseMin(corner);
                upper = upper.cwiseMax(corner);
            }
            Footprint::Circle circle{0.5 * (lower + upper), 0.0};
            for (const Eigen::Vector2d &corner : corners)
            {
                circle.radius = std::max(circle.radius, (corner - circle.centre).norm());
            }
            return circle;
        }

        /* The best of a grid of points, then of ever finer grids about the best. Any point within is correct. */
        Footprint::Circle innerCircle(const Footprint::Polygon &corners, const Footprint::Circle &outer)
        {
            constexpr int HALF_COUNT = 10;
            constexpr int ROUNDS = 4;
            constexpr double REFINEMENT = 0.25;
            Footprint::Circle best{corners.front(), 0.0};
            Eigen::Vector2d centre = outer.centre;
            double extent = outer.radius;
            for (int round = 0; round < ROUNDS; ++round)
            {
                for (int i = -HALF_COUNT; i <= HALF_COUNT; ++i)
                {
                    for (int j = -HALF_COUNT; j <= HALF_COUNT; ++j)
                    {
                        const Eigen::Vector2d point = centre + extent / HALF_COUNT * Eigen::Vector2d(i, j);
                        const double radius = contains(corners, point) ? distanceToSides(corners, point) : 0.0;
                        if (radius > best.radius)
                        {
                            best = {point, radius};
                        }
                    }
                }
                centre = best.centre;
                extent *= REFINEMENT;
            }
            return best;
        }
    }  // namespace

    Footprint::Footprint(Polygon corners, double margin)
      : corners_(std::move(corners))
      , margin_(margin)
      , parts_{corners_}
      , inner_{Eigen::Vector2d::Zero(), margin}
      , outer_{Eigen::Vector2d::Zero(), margin}
      , reach_(0.0)
      , inscribedRadius_(margin)
    {
        if (isRound())
        {
            return;
        }
        parts_ = maps::convexParts(corners_);
        outer_ = outerCircle(corners_);
        inner_ = innerCircle(corners_, outer_);
        for (const Eigen::Vector2d &corner : corners_)
        {
            reach_ = std::max(reach_, corner.norm());
        }
        const double toSides = distanceToSides(corners_, Eigen::Vector2d::Zero());
        inscribedRadius_ =
            std::max(0.0, contains(corners_, Eigen::Vector2d::Zero()) ? toSides + margin : margin - toSides);
        outer_.radius += margin;
        inner_.radius += margin;
    }

    Footprint Footprint::point()
    {
        return Footprint({Eigen::Vector2d::Zero()}, 0.0);
    }

    Footprint Footprint::disc(double radius)
    {
        if (!(radius > 0.0) || !std::isfinite(radius))
        {
            throw InputError("the radius of a disc is " + text::numberText(radius) + "; expected a number above 0");
        }
        return Footprint({Eigen::Vector2d::Zero()}, radius);
    }

    Footprint Footprint::polygon(const Polygon &corners, double padding)
    {
        const std::string fault = faultOf(corners);
        if (!fault.empty())
        {
            throw InputError("footprint: " + fault + "; expected the corners of a simple polygon in their order");
        }
        if (!(padding >= 0.0) || !std::isfinite(padding))
        {
            throw InputError("the padding of a footprint is " + text::numberText(padding) +
                             "; expected a number of at least 0");
        }
        Polygon ordered = corners;
        if (doubleArea(ordered) < 0.0)
        {
            std::reverse(ordered.begin(), ordered.end());
        }
        return Footprint(std::move(ordered), padding);
    }

    Footprint::Polygon Footprint::outline() const
    {
        constexpr int CIRCLE_CORNERS = 32;
        if (margin_ == 0.0)
        {
            return corners_;
        }
        Polygon outline;
        for (std::size_t i = 0; i < corners_.size(); ++i)
        {
            const Eigen::Vector2d &corner = corners_[i];
            double begin = 0.0;
            double end = 2.0 * PI * (1.0 - 1.0 / CIRCLE_CORNERS);
            if (!isRound())
            {
                const Eigen::Vector2d into = corner - corners_[(i + corners_.size() - 1) % corners_.size()];
                const Eigen::Vector2d from = corners_[(i + 1) % corners_.size()] - corner;
                begin = std::atan2(-into.x(), into.y());
                end = begin + std::remainder(std::atan2(-from.x(), from.y()) - begin, 2.0 * PI);
            }
            // at a corner that turns inwards the padded sides cross, which a filled picture does not show
            const int steps = std::max(1, static_cast<int>(std::ceil((end - begin) / (2.0 * PI) * CIRCLE_CORNERS)));
            for (int step = 0; step <= steps; ++step)
            {
                const double angle = begin + (end - begin) * step / steps;
                outline.push_back(corner + margin_ * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
            }
        }
        return outline;
    }
}  // namespace ompl_mfa::maps
