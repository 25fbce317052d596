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

#include "benchmark/NearbyState.h"

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "benchmark/ProblemSpace.h"
#include "text/NumberText.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;
        using Directions = std::vector<Eigen::Vector3d>;

        Directions circle()
        {
            constexpr int COUNT = 64;
            Directions directions;
            for (int i = 0; i < COUNT; ++i)
            {
                const double angle = 2.0 * M_PI * i / COUNT;
                directions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
            }
            return directions;
        }

        /* The axes, as most obstacles are axis-aligned, and a spiral from pole to pole. */
        Directions ball()
        {
            constexpr int COUNT = 200;
            const double goldenAngle = M_PI * (3.0 - std::sqrt(5.0));
            Directions directions;
            for (int axis = 0; axis < 3; ++axis)
            {
                directions.emplace_back(Eigen::Vector3d::Unit(axis));
                directions.emplace_back(-Eigen::Vector3d::Unit(axis));
            }
            for (int i = 0; i < COUNT; ++i)
            {
                const double z = 1.0 - (2.0 * i + 1.0) / COUNT;
                const double radius = std::sqrt(1.0 - z * z);
                directions.emplace_back(radius * std::cos(goldenAngle * i), radius * std::sin(goldenAngle * i), z);
            }
            return directions;
        }

        /* Searches for valid states of a given orientation around a position. */
        class OutwardSearch
        {
        public:
            OutwardSearch(const ob::SpaceInformation &si, StateSpaceKind kind, const ConfigPose &pose)
              : si_(si)
              , state_(makeState(si.getStateSpace(), kind, pose))
              , dimension_(positionDimension(kind))
              , pose_(pose)
              , centre_(pose.x, pose.y, pose.z)
            {
            }

            std::optional<NearbyState> run(double farthest)
            {
                constexpr double GROWTH = 1.3;
                constexpr int RADII = 32;
                const Directions directions = dimension_ == 3 ? ball() : circle();
                double inner = 0.0;
                for (int i = RADII; i >= 0; --i)
                {
                    const double radius = farthest * std::pow(GROWTH, -i);
                    double least = INFINITY;
                    Eigen::Vector3d towards;
                    for (const Eigen::Vector3d &direction : directions)
                    {
                        if (!isValid(centre_ + radius * direction))
                        {
                            continue;
                        }
                        const double distance = narrowed(direction, inner, radius);
                        if (distance < least)
                        {
                            least = distance;
                            towards = direction;
                        }
                    }
                    if (std::isfinite(least))
                    {
                        return written(towards, least);
                    }
                    inner = radius;
                }
                return std::nullopt;
            }

        private:
            bool isValid(const Eigen::Vector3d &position)
            {
                for (unsigned int i = 0; i < dimension_; ++i)
                {
                    *si_.getStateSpace()->getValueAddressAtIndex(state_.get(), i) = position[i];
                }
                return si_.satisfiesBounds(state_.get()) && si_.isValid(state_.get());
            }

            /* The distance at which the state becomes valid, by bisection between an invalid and a valid one. */
            double narrowed(const Eigen::Vector3d &direction, double invalid, double valid)
            {
                constexpr int HALVINGS = 25;
                for (int i = 0; i < HALVINGS; ++i)
                {
                    const double middle = 0.5 * (invalid + valid);
                    (isValid(centre_ + middle * direction) ? valid : invalid) = middle;
                }
                return valid;
            }

            /* Rounds the coordinates for use in a config, slightly farther away, as touching counts as a collision. */
            NearbyState written(const Eigen::Vector3d &direction, double distance)
            {
                constexpr double MARGIN = 1.02;
                constexpr int ALL_DIGITS = 17;
                Eigen::Vector3d position;
                for (const int digits : {4, 6, 9, ALL_DIGITS})
                {
                    const double reach = digits == ALL_DIGITS ? distance : MARGIN * distance;
                    for (int i = 0; i < 3; ++i)
                    {
                        text::readNumber(text::numberText(centre_[i] + reach * direction[i], digits), position[i]);
                    }
                    if (isValid(position) && (position - centre_).norm() <= MARGIN * distance * (1.0 + ROUNDING))
                    {
                        break;
                    }
                }
                NearbyState nearby{pose_, distance};
                nearby.pose.x = position.x();
                nearby.pose.y = position.y();
                nearby.pose.z = position.z();
                return nearby;
            }

            static constexpr double ROUNDING = 1e-9;

            const ob::SpaceInformation &si_;
            ob::ScopedState<> state_;
            unsigned int dimension_;
            ConfigPose pose_;
            Eigen::Vector3d centre_;
        };
    }  // namespace

    std::optional<NearbyState> findNearbyState(const ob::SpaceInformation &si, StateSpaceKind kind,
                                               const ConfigPose &pose, double farthest)
    {
        return OutwardSearch(si, kind, pose).run(farthest);
    }
}  // namespace ompl_mfa::benchmark
