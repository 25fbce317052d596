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

#include "collision/ConvexDistance.h"

#include <algorithm>

namespace ompl_mfa::collision
{
    namespace
    {
        double determinant(const fcl::Vector3d &a, const fcl::Vector3d &b, const fcl::Vector3d &c)
        {
            return a.dot(b.cross(c));
        }
    }  // namespace

    ClosestSimplex::Feature ClosestSimplex::onSegment(const fcl::Vector3d &a, const fcl::Vector3d &b)
    {
        const fcl::Vector3d ab = b - a;
        const double along = -a.dot(ab);
        const double length = ab.squaredNorm();
        if (along <= 0.)
        {
            return {{a}, 1, a};
        }
        if (along >= length)
        {
            return {{b}, 1, b};
        }
        return {{a, b}, 2, a + along / length * ab};
    }

    // The regions of a triangle, after C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5.
    ClosestSimplex::Feature ClosestSimplex::onTriangle(const fcl::Vector3d &a, const fcl::Vector3d &b,
                                                       const fcl::Vector3d &c)
    {
        const fcl::Vector3d ab = b - a;
        const fcl::Vector3d ac = c - a;
        const fcl::Vector3d normal = ab.cross(ac);
        const double area = normal.squaredNorm();
        const double u = normal.dot(b.cross(c));
        const double v = normal.dot(c.cross(a));
        const double w = normal.dot(a.cross(b));
        if (u > 0. && v > 0. && w > 0.)
        {
            return {{a, b, c}, 3, normal * (normal.dot(a) / area)};
        }
        Feature best = onSegment(a, b);
        for (const Feature &edge : {onSegment(b, c), onSegment(c, a)})
        {
            if (edge.closest.squaredNorm() < best.closest.squaredNorm())
            {
                best = edge;
            }
        }
        return best;
    }

    bool ClosestSimplex::holds(const fcl::Vector3d &point) const
    {
        return std::find(corners_.begin(), corners_.begin() + size_, point) != corners_.begin() + size_;
    }

    void ClosestSimplex::keep(const Feature &feature)
    {
        std::copy_n(feature.corners.begin(), feature.size, corners_.begin());
        size_ = feature.size;
        closest_ = feature.closest;
    }

    void ClosestSimplex::add(const fcl::Vector3d &point)
    {
        const auto &p = corners_;
        switch (size_)
        {
            case 0:
                keep({{point}, 1, point});
                return;
            case 1:
                keep(onSegment(p[0], point));
                return;
            case 2:
                keep(onTriangle(p[0], p[1], point));
                return;
            default:
                break;
        }
        // The origin is inside if it is on the same side of every face as the opposite corner.
        const double volume = determinant(p[1] - p[0], p[2] - p[0], point - p[0]);
        const std::array<double, 4> parts{determinant(p[1], p[2], point), -determinant(p[0], p[2], point),
                                          determinant(p[0], p[1], point), -determinant(p[0], p[1], p[2])};
        containsOrigin_ = volume != 0. &&
                          std::all_of(parts.begin(), parts.end(), [volume](double part) { return part * volume > 0.; });
        if (containsOrigin_)
        {
            closest_.setZero();
            return;
        }
        Feature best = onTriangle(p[0], p[1], point);
        for (const Feature &face : {onTriangle(p[1], p[2], point), onTriangle(p[2], p[0], point)})
        {
            if (face.closest.squaredNorm() < best.closest.squaredNorm())
            {
                best = face;
            }
        }
        keep(best);
    }
}  // namespace ompl_mfa::collision
