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

#include "robots/BallChecker.h"

#include <cmath>

// The functions below are inlined into one that is compiled for other instructions.
#if defined(__x86_64__) && defined(__GNUC__)
#define OMPL_MFA_HAS_AVX2 1
#define OMPL_MFA_INLINE inline __attribute__((always_inline))
#else
#define OMPL_MFA_HAS_AVX2 0
#define OMPL_MFA_INLINE inline
#endif

namespace ompl_mfa::robots
{
    namespace
    {
        // A number for each state. The loops have a fixed length, so compilers turn them into vector instructions.
        template <std::size_t N>
        struct Lanes
        {
            double v[N];
        };

        template <std::size_t N>
        struct Point
        {
            Lanes<N> x;
            Lanes<N> y;
            Lanes<N> z;
        };

        template <std::size_t N>
        struct Pose
        {
            Lanes<N> r[9];
            Point<N> t;
        };

        template <std::size_t N>
        OMPL_MFA_INLINE void rotate(const Pose<N> &pose, const fcl::Vector3d &p, Point<N> &result)
        {
            for (std::size_t i = 0; i < N; ++i)
            {
                result.x.v[i] = pose.r[0].v[i] * p.x() + pose.r[1].v[i] * p.y() + pose.r[2].v[i] * p.z();
                result.y.v[i] = pose.r[3].v[i] * p.x() + pose.r[4].v[i] * p.y() + pose.r[5].v[i] * p.z();
                result.z.v[i] = pose.r[6].v[i] * p.x() + pose.r[7].v[i] * p.y() + pose.r[8].v[i] * p.z();
            }
        }

        template <std::size_t N>
        OMPL_MFA_INLINE void transform(const Pose<N> &pose, const fcl::Vector3d &p, Point<N> &result)
        {
            rotate(pose, p, result);
            for (std::size_t i = 0; i < N; ++i)
            {
                result.x.v[i] += pose.t.x.v[i];
                result.y.v[i] += pose.t.y.v[i];
                result.z.v[i] += pose.t.z.v[i];
            }
        }

        template <std::size_t N>
        OMPL_MFA_INLINE void place(const RobotKinematics::Step &step, const Pose<N> &parent,
                                   const double *const *states, Pose<N> &body)
        {
            Lanes<N> value;
            Lanes<N> sine;
            Lanes<N> cosine;
            for (std::size_t i = 0; i < N; ++i)
            {
                value.v[i] = step.multiplier * states[i][step.variable] + step.offset;
                sine.v[i] = step.isPrismatic ? 0. : std::sin(value.v[i]);
                cosine.v[i] = step.isPrismatic ? 0. : std::cos(value.v[i]);
            }
            Lanes<N> own[9];
            for (int row = 0; row < 3; ++row)
            {
                for (int column = 0; column < 3; ++column)
                {
                    const double constant = step.constant(row, column);
                    const double bySine = step.sine(row, column);
                    const double byCosine = step.cosine(row, column);
                    for (std::size_t i = 0; i < N; ++i)
                    {
                        own[3 * row + column].v[i] = constant + sine.v[i] * bySine + cosine.v[i] * byCosine;
                    }
                }
            }
            for (int row = 0; row < 3; ++row)
            {
                for (int column = 0; column < 3; ++column)
                {
                    for (std::size_t i = 0; i < N; ++i)
                    {
                        body.r[3 * row + column].v[i] = parent.r[3 * row].v[i] * own[column].v[i] +
                                                        parent.r[3 * row + 1].v[i] * own[3 + column].v[i] +
                                                        parent.r[3 * row + 2].v[i] * own[6 + column].v[i];
                    }
                }
            }
            transform(parent, step.origin, body.t);
            if (step.isPrismatic)
            {
                Point<N> along;
                rotate(parent, step.direction, along);
                for (std::size_t i = 0; i < N; ++i)
                {
                    body.t.x.v[i] += value.v[i] * along.x.v[i];
                    body.t.y.v[i] += value.v[i] * along.y.v[i];
                    body.t.z.v[i] += value.v[i] * along.z.v[i];
                }
            }
        }

        // A mask of the lanes in which `squared` <= limit squared.
        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int within(const Lanes<N> &squared, double limit)
        {
            unsigned int mask = 0;
            for (std::size_t i = 0; i < N; ++i)
            {
                mask |= squared.v[i] <= limit * limit ? 1U << i : 0U;
            }
            return mask;
        }

        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int touch(const Point<N> &a, const Point<N> &b, double radii)
        {
            Lanes<N> squared;
            for (std::size_t i = 0; i < N; ++i)
            {
                const double x = a.x.v[i] - b.x.v[i];
                const double y = a.y.v[i] - b.y.v[i];
                const double z = a.z.v[i] - b.z.v[i];
                squared.v[i] = x * x + y * y + z * z;
            }
            return within(squared, radii);
        }

        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int touchBall(const BallModel::Obstacle &obstacle, const Point<N> &centre,
                                               double radii)
        {
            Lanes<N> squared;
            for (std::size_t i = 0; i < N; ++i)
            {
                const double x = centre.x.v[i] - obstacle.position.x();
                const double y = centre.y.v[i] - obstacle.position.y();
                const double z = centre.z.v[i] - obstacle.position.z();
                squared.v[i] = x * x + y * y + z * z;
            }
            return within(squared, radii);
        }

        // Centre in the frame of the obstacle.
        template <std::size_t N>
        OMPL_MFA_INLINE void toShape(const BallModel::Obstacle &obstacle, const Point<N> &centre, Point<N> &local)
        {
            const fcl::Matrix3d &r = obstacle.toShape;
            for (std::size_t i = 0; i < N; ++i)
            {
                const double x = centre.x.v[i] - obstacle.position.x();
                const double y = centre.y.v[i] - obstacle.position.y();
                const double z = centre.z.v[i] - obstacle.position.z();
                local.x.v[i] = r(0, 0) * x + r(0, 1) * y + r(0, 2) * z;
                local.y.v[i] = r(1, 0) * x + r(1, 1) * y + r(1, 2) * z;
                local.z.v[i] = r(2, 0) * x + r(2, 1) * y + r(2, 2) * z;
            }
        }

        OMPL_MFA_INLINE double above(double value, double limit)
        {
            const double excess = (value < 0. ? -value : value) - limit;
            return excess > 0. ? excess : 0.;
        }

        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int touchObstacle(const BallModel::Obstacle &obstacle, const Point<N> &centre,
                                                   double radius)
        {
            if (obstacle.shape == BallModel::Shape::Ball)
            {
                return touchBall(obstacle, centre, radius + obstacle.size.x());
            }
            Point<N> local;
            toShape(obstacle, centre, local);
            Lanes<N> squared;
            if (obstacle.shape == BallModel::Shape::Box)
            {
                for (std::size_t i = 0; i < N; ++i)
                {
                    const double x = above(local.x.v[i], obstacle.size.x());
                    const double y = above(local.y.v[i], obstacle.size.y());
                    const double z = above(local.z.v[i], obstacle.size.z());
                    squared.v[i] = x * x + y * y + z * z;
                }
                return within(squared, radius);
            }
            for (std::size_t i = 0; i < N; ++i)
            {
                const double fromAxis = std::sqrt(local.x.v[i] * local.x.v[i] + local.y.v[i] * local.y.v[i]);
                const double across = above(fromAxis, obstacle.size.x());
                const double along = above(local.z.v[i], obstacle.size.y());
                squared.v[i] = across * across + along * along;
            }
            return within(squared, radius);
        }

        template <std::size_t N>
        struct Batch
        {
            std::vector<Pose<N>> bodies;
            std::vector<Point<N>> hulls;
            std::vector<Point<N>> centres;
        };

        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int testWorld(const BallModel &model, const BallModel::Test &test,
                                               const Batch<N> &batch, bool stopAtFirst)
        {
            constexpr unsigned int ALL = (1U << N) - 1U;
            const BallModel::Link &link = model.links[test.first];
            unsigned int hits = 0;
            for (const std::size_t index : test.obstacles)
            {
                const BallModel::Obstacle &obstacle = model.obstacles[index];
                const Point<N> &hull = batch.hulls[test.first];
                if (touchBall(obstacle, hull, link.hull.radius + obstacle.reach) == 0 ||
                    touchObstacle(obstacle, hull, link.hull.radius) == 0)
                {
                    continue;
                }
                for (const BallModel::Ball &ball : link.world)
                {
                    Point<N> centre;
                    transform(batch.bodies[link.body], ball.centre, centre);
                    hits |= touchObstacle(obstacle, centre, ball.radius);
                    if (hits == ALL || (stopAtFirst && hits != 0))
                    {
                        return hits;
                    }
                }
            }
            return hits;
        }

        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int testLinks(const BallModel &model, const BallModel::Test &test, Batch<N> &batch,
                                               bool stopAtFirst)
        {
            constexpr unsigned int ALL = (1U << N) - 1U;
            const BallModel::Link &first = model.links[test.first];
            const BallModel::Link &second = model.links[test.second];
            const Point<N> &hull = batch.hulls[test.second];
            if (touch(batch.hulls[test.first], hull, first.hull.radius + second.hull.radius) == 0)
            {
                return 0;
            }
            for (std::size_t j = 0; j < second.self.size(); ++j)
            {
                transform(batch.bodies[second.body], second.self[j].centre, batch.centres[j]);
            }
            unsigned int hits = 0;
            for (const BallModel::Ball &ball : first.self)
            {
                Point<N> centre;
                transform(batch.bodies[first.body], ball.centre, centre);
                if (touch(centre, hull, ball.radius + second.hull.radius) == 0)
                {
                    continue;
                }
                for (std::size_t j = 0; j < second.self.size(); ++j)
                {
                    hits |= touch(centre, batch.centres[j], ball.radius + second.self[j].radius);
                }
                if (hits == ALL || (stopAtFirst && hits != 0))
                {
                    return hits;
                }
            }
            return hits;
        }

        template <std::size_t N>
        OMPL_MFA_INLINE unsigned int check(const RobotKinematics &kinematics, const BallModel &model,
                                           const double *const *states, const std::vector<std::uint32_t> &order,
                                           bool stopAtFirst, std::uint32_t &hitTest, Batch<N> &batch)
        {
            constexpr unsigned int ALL = (1U << N) - 1U;
            const auto &steps = kinematics.steps();
            for (std::size_t i = 0; i < steps.size(); ++i)
            {
                place(steps[i], batch.bodies[steps[i].parent], states, batch.bodies[i + 1]);
            }
            for (std::size_t i = 0; i < model.links.size(); ++i)
            {
                transform(batch.bodies[model.links[i].body], model.links[i].hull.centre, batch.hulls[i]);
            }
            unsigned int hits = 0;
            for (const std::uint32_t index : order)
            {
                const BallModel::Test &test = model.tests[index];
                const unsigned int found = test.isWorld ? testWorld(model, test, batch, stopAtFirst)
                                                        : testLinks(model, test, batch, stopAtFirst);
                hitTest = (found & ~hits) != 0 ? index : hitTest;
                hits |= found;
                if (hits == ALL || (stopAtFirst && hits != 0))
                {
                    break;
                }
            }
            return hits;
        }

        template <std::size_t N>
        Batch<N> &batchFor(const RobotKinematics &kinematics, const BallModel &model)
        {
            thread_local Batch<N> batch;
            if (batch.bodies.size() < kinematics.bodyCount())
            {
                batch.bodies.resize(kinematics.bodyCount());
                // Body 0 stands still.
                for (std::size_t i = 0; i < N; ++i)
                {
                    for (int k = 0; k < 9; ++k)
                    {
                        batch.bodies[0].r[k].v[i] = k % 4 == 0 ? 1. : 0.;
                    }
                    batch.bodies[0].t.x.v[i] = batch.bodies[0].t.y.v[i] = batch.bodies[0].t.z.v[i] = 0.;
                }
            }
            if (batch.hulls.size() < model.links.size())
            {
                batch.hulls.resize(model.links.size());
            }
            std::size_t most = batch.centres.size();
            for (const BallModel::Link &link : model.links)
            {
                most = link.self.size() > most ? link.self.size() : most;
            }
            if (batch.centres.size() < most)
            {
                batch.centres.resize(most);
            }
            return batch;
        }

#if OMPL_MFA_HAS_AVX2
        __attribute__((target("avx2"))) unsigned int checkWithAvx2(const RobotKinematics &kinematics,
                                                                   const BallModel &model, const double *const *states,
                                                                   const std::vector<std::uint32_t> &order,
                                                                   bool stopAtFirst, std::uint32_t &hitTest,
                                                                   Batch<BallChecker::LANES> &batch)
        {
            return check<BallChecker::LANES>(kinematics, model, states, order, stopAtFirst, hitTest, batch);
        }
#endif
    }  // namespace

    BallChecker::BallChecker(const RobotKinematics &kinematics, BallModel model, Instructions instructions)
      : kinematics_(kinematics)
      , model_(std::move(model))
      , instructions_(instructions)
    {
#if OMPL_MFA_HAS_AVX2
        hasAvx2_ = __builtin_cpu_supports("avx2") != 0;
#endif
    }

    unsigned int BallChecker::collide(const double *const *states, std::size_t count,
                                      const std::vector<std::uint32_t> &order, bool stopAtFirst,
                                      std::uint32_t &hitTest) const
    {
        if (count == 1 || instructions_ == Instructions::Scalar)
        {
            Batch<1> &batch = batchFor<1>(kinematics_, model_);
            unsigned int hits = 0;
            for (std::size_t i = 0; i < count && (hits == 0 || !stopAtFirst); ++i)
            {
                hits |= check<1>(kinematics_, model_, states + i, order, stopAtFirst, hitTest, batch) << i;
            }
            return hits;
        }
        const double *all[LANES];
        for (std::size_t i = 0; i < LANES; ++i)
        {
            all[i] = states[i < count ? i : 0];
        }
        Batch<LANES> &batch = batchFor<LANES>(kinematics_, model_);
        const unsigned int wanted = (1U << count) - 1U;
#if OMPL_MFA_HAS_AVX2
        if (hasAvx2_)
        {
            return checkWithAvx2(kinematics_, model_, all, order, stopAtFirst, hitTest, batch) & wanted;
        }
#endif
        return check<LANES>(kinematics_, model_, all, order, stopAtFirst, hitTest, batch) & wanted;
    }
}  // namespace ompl_mfa::robots
