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

#include "collision/ConservativeAdvancement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ompl_mfa::collision
{
    namespace
    {
        // Bounds the cost of grazing motions; a motion that needs more steps counts as touching.
        constexpr int MAXIMUM_STEPS = 1000;

        fcl::Vector3d velocity(const MovingShape &shape)
        {
            return shape.motion != nullptr ? shape.motion->displacement : fcl::Vector3d::Zero();
        }

        double rotationSpeed(const MovingShape &shape)
        {
            return shape.motion != nullptr ? std::abs(shape.motion->angle) * shape.reach : 0.;
        }

        // Two convex shapes cannot meet before they have closed the gap between two parallel separating planes, so only
        // the speed normal to these counts. The next planes are computed at the earliest time at which the last ones
        // could meet.
        double advanceConvex(const PairFunctions &functions, const MovingShape &a, const MovingShape &b,
                             double tolerance, double end)
        {
            const fcl::Vector3d approach = velocity(a) - velocity(b);
            const double rotation = rotationSpeed(a) + rotationSpeed(b);
            fcl::Transform3d poseA;
            fcl::Transform3d poseB;
            double reached = 0.;
            double next = 0.;
            for (int step = 0; step < MAXIMUM_STEPS; ++step)
            {
                a.place(next, poseA);
                b.place(next, poseB);
                const ConvexSeparation gap = functions.separate(*a.geometry, poseA, *b.geometry, poseB);
                if (gap.lower <= tolerance)
                {
                    break;
                }
                const double speed = rotation - approach.dot(gap.normal);
                if (gap.lower >= speed * (end - next))
                {
                    return end;
                }
                // The planes are still the tolerance apart there, with the same margin again for rounding errors.
                reached = next + std::max(0., gap.lower - 2. * tolerance) / speed;
                next += gap.lower / speed;
            }
            return reached;
        }

        // Without separating planes only the distance is known. A distance at the middle of an interval covers the same
        // duration before and after it; the two remainders of the interval are covered recursively, the earlier one
        // first.
        class IntervalCover
        {
        public:
            IntervalCover(const PairFunctions &functions, const MovingShape &a, const MovingShape &b,
                          const AdvancementGoal &goal)
              : functions_(functions)
              , a_(a)
              , b_(b)
              , goal_(goal)
              , speed_((velocity(a) - velocity(b)).norm() + rotationSpeed(a) + rotationSpeed(b))
            {
            }

            double advance(double end)
            {
                if (goal_.untilFirst && someStateCollides(end))
                {
                    return 0.;
                }
                const int pieces = pieceCount(end);
                for (int piece = pieces; piece > 0; --piece)
                {
                    push(end * (piece - 1) / pieces, end * piece / pieces);
                }
                for (int step = 0; size_ > 0; ++step)
                {
                    const auto [low, high] = open_[--size_];
                    if (step == MAXIMUM_STEPS || size_ + 2 > open_.size() || !cover(low, high))
                    {
                        return low;
                    }
                }
                return end;
            }

        private:
            // Distance queries are cheaper with a smaller limit: intervals in which shapes travel by about their own
            // size were fastest in the worlds of the micro-benchmark.
            int pieceCount(double end) const
            {
                const double size = (a_.motion != nullptr ? a_ : b_).geometry->aabb_radius;
                return size > 0. ? static_cast<int>(std::clamp(speed_ * end / size, 4., 32.)) : 32;
            }

            // A collision check takes at most a tenth of the time of a distance query, and most colliding motions
            // collide over a long section.
            bool someStateCollides(double end)
            {
                for (const double share : {1., 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875})
                {
                    place(share * end);
                    if (functions_.collide(*a_.geometry, poseA_, *b_.geometry, poseB_))
                    {
                        return true;
                    }
                }
                return false;
            }

            void place(double t)
            {
                a_.place(t, poseA_);
                b_.place(t, poseB_);
            }

            void push(double low, double high)
            {
                open_[size_++] = {low, high};
            }

            // False if the shapes touch so early that nothing after the beginning of the interval is known to be free.
            bool cover(double low, double high)
            {
                const double middle = 0.5 * (low + high);
                const double half = 0.5 * (high - low);
                place(middle);
                // Slightly more than needed because of rounding errors, and never 0.
                search_.limit = speed_ * half * 1.000001 + goal_.tolerance;
                const double distance =
                    functions_.distance(*a_.geometry, poseA_, *b_.geometry, poseB_, search_) - goal_.tolerance;
                if (distance >= speed_ * half)
                {
                    return true;
                }
                if (distance <= 0.)
                {
                    if (goal_.untilFirst || half < CONTACT_RESOLUTION)
                    {
                        return false;
                    }
                    // Only free states before the contact are still of interest.
                    size_ = 0;
                    push(middle, middle);
                    push(low, middle);
                    return true;
                }
                const double covered = distance / speed_;
                push(middle + covered, high);
                push(low, middle - covered);
                return true;
            }

            // Resolution of the first contact, as a fraction of the motion.
            static constexpr double CONTACT_RESOLUTION = 1e-4;

            const PairFunctions &functions_;
            const MovingShape &a_;
            const MovingShape &b_;
            AdvancementGoal goal_;
            double speed_;
            DistanceSearch search_{0.};
            fcl::Transform3d poseA_;
            fcl::Transform3d poseB_;

            // A stack, the earliest interval on top. Each is less than half as long as the one below it, so this
            // capacity suffices for any motion.
            std::array<std::pair<double, double>, 128> open_;
            std::size_t size_{0};
        };
    }  // namespace

    void MovingShape::place(double t, fcl::Transform3d &world) const
    {
        if (motion == nullptr)
        {
            world = *pose;
            return;
        }
        motion->place(t, world);
        world = world * *pose;
    }

    double advancePair(const PairFunctions &functions, const MovingShape &a, const MovingShape &b,
                       const AdvancementGoal &goal, double end)
    {
        if (functions.separate != nullptr)
        {
            return advanceConvex(functions, a, b, goal.tolerance, end);
        }
        return IntervalCover(functions, a, b, goal).advance(end);
    }
}  // namespace ompl_mfa::collision
