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
#include <cstdint>

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
        // A number for each state: one, or a vector of the compiler's.
        using Four = double __attribute__((vector_size(4 * sizeof(double))));
        using FourBits = std::int64_t __attribute__((vector_size(4 * sizeof(std::int64_t))));
        static_assert(sizeof(Four) == BallChecker::LANES * sizeof(double), "a lane for each state");

        template <typename Lanes>
        constexpr unsigned int ALL = 15U;
        template <>
        constexpr unsigned int ALL<double> = 1U;

        // Vectors are passed by reference, as the way to pass them by value depends on the instructions.
        OMPL_MFA_INLINE void setLane(double &lanes, std::size_t /*lane*/, double value)
        {
            lanes = value;
        }

        OMPL_MFA_INLINE void setLane(Four &lanes, std::size_t lane, double value)
        {
            lanes[lane] = value;
        }

        template <typename Lanes>
        constexpr std::size_t WIDTH = sizeof(Lanes) / sizeof(double);

        // Amount by which the absolute values exceed a limit; 0 if they do not.
        OMPL_MFA_INLINE void excess(const double &value, double limit, double &result)
        {
            const double above = std::abs(value) - limit;
            result = above > 0. ? above : 0.;
        }

        OMPL_MFA_INLINE void excess(const Four &value, double limit, Four &result)
        {
            constexpr std::int64_t WITHOUT_SIGN = 0x7fffffffffffffff;
            const Four above = (Four)((FourBits)value & WITHOUT_SIGN) - limit;
            const Four zero{};
            result = (Four)((FourBits)above & (FourBits)(above > zero));
        }

        // A mask of the lanes with values of at most the limit.
        OMPL_MFA_INLINE unsigned int atMost(const double &value, double limit)
        {
            return value <= limit ? 1U : 0U;
        }

        OMPL_MFA_INLINE unsigned int atMost(const Four &value, double limit)
        {
            const Four limits{limit, limit, limit, limit};
            const FourBits bits = (FourBits)(value <= limits);
            return static_cast<unsigned int>((bits[0] & 1) | (bits[1] & 2) | (bits[2] & 4) | (bits[3] & 8));
        }

        OMPL_MFA_INLINE void squareRoot(const double &value, double &result)
        {
            result = std::sqrt(value);
        }

        OMPL_MFA_INLINE void squareRoot(const Four &value, Four &result)
        {
            for (std::size_t i = 0; i < WIDTH<Four>; ++i)
            {
                result[i] = std::sqrt(value[i]);
            }
        }

        // Aligned explicitly: without AVX2 the compiler's alignment of a vector is smaller than with it.
        template <typename Lanes>
        struct alignas(sizeof(Lanes)) Point
        {
            Lanes x;
            Lanes y;
            Lanes z;
        };

        template <typename Lanes>
        struct alignas(sizeof(Lanes)) Pose
        {
            Lanes r[9];
            Point<Lanes> t;
        };

        template <typename Lanes>
        OMPL_MFA_INLINE void rotate(const Pose<Lanes> &pose, const fcl::Vector3d &p, Point<Lanes> &result)
        {
            result.x = pose.r[0] * p.x() + pose.r[1] * p.y() + pose.r[2] * p.z();
            result.y = pose.r[3] * p.x() + pose.r[4] * p.y() + pose.r[5] * p.z();
            result.z = pose.r[6] * p.x() + pose.r[7] * p.y() + pose.r[8] * p.z();
        }

        template <typename Lanes>
        OMPL_MFA_INLINE void transform(const Pose<Lanes> &pose, const fcl::Vector3d &p, Point<Lanes> &result)
        {
            rotate(pose, p, result);
            result.x += pose.t.x;
            result.y += pose.t.y;
            result.z += pose.t.z;
        }

        template <typename Lanes>
        OMPL_MFA_INLINE void place(const RobotKinematics::Step &step, const Pose<Lanes> &parent,
                                   const double *const *states, Pose<Lanes> &body)
        {
            Lanes value{};
            Lanes sine{};
            Lanes cosine{};
            for (std::size_t i = 0; i < WIDTH<Lanes>; ++i)
            {
                const double one = step.multiplier * states[i][step.variable] + step.offset;
                setLane(value, i, one);
                setLane(sine, i, step.isPrismatic ? 0. : std::sin(one));
                setLane(cosine, i, step.isPrismatic ? 0. : std::cos(one));
            }
            Lanes own[9];
            for (int row = 0; row < 3; ++row)
            {
                for (int column = 0; column < 3; ++column)
                {
                    own[3 * row + column] =
                        step.constant(row, column) + sine * step.sine(row, column) + cosine * step.cosine(row, column);
                }
            }
            for (int row = 0; row < 3; ++row)
            {
                for (int column = 0; column < 3; ++column)
                {
                    body.r[3 * row + column] = parent.r[3 * row] * own[column] +
                                               parent.r[3 * row + 1] * own[3 + column] +
                                               parent.r[3 * row + 2] * own[6 + column];
                }
            }
            transform(parent, step.origin, body.t);
            if (step.isPrismatic)
            {
                Point<Lanes> along;
                rotate(parent, step.direction, along);
                body.t.x += value * along.x;
                body.t.y += value * along.y;
                body.t.z += value * along.z;
            }
        }

        template <typename Lanes>
        OMPL_MFA_INLINE unsigned int touch(const Point<Lanes> &a, const Point<Lanes> &b, double radii)
        {
            const Lanes x = a.x - b.x;
            const Lanes y = a.y - b.y;
            const Lanes z = a.z - b.z;
            return atMost(x * x + y * y + z * z, radii * radii);
        }

        template <typename Lanes>
        OMPL_MFA_INLINE unsigned int touchBall(const BallModel::Obstacle &obstacle, const Point<Lanes> &centre,
                                               double radii)
        {
            const Lanes x = centre.x - obstacle.position.x();
            const Lanes y = centre.y - obstacle.position.y();
            const Lanes z = centre.z - obstacle.position.z();
            return atMost(x * x + y * y + z * z, radii * radii);
        }

        template <typename Lanes>
        OMPL_MFA_INLINE unsigned int touchObstacle(const BallModel::Obstacle &obstacle, const Point<Lanes> &centre,
                                                   double radius)
        {
            if (obstacle.shape == BallModel::Shape::Ball)
            {
                return touchBall(obstacle, centre, radius + obstacle.size.x());
            }
            // in the frame of the obstacle
            const fcl::Matrix3d &r = obstacle.toShape;
            const Lanes x = centre.x - obstacle.position.x();
            const Lanes y = centre.y - obstacle.position.y();
            const Lanes z = centre.z - obstacle.position.z();
            const Lanes ownX = r(0, 0) * x + r(0, 1) * y + r(0, 2) * z;
            const Lanes ownY = r(1, 0) * x + r(1, 1) * y + r(1, 2) * z;
            const Lanes ownZ = r(2, 0) * x + r(2, 1) * y + r(2, 2) * z;
            if (obstacle.shape == BallModel::Shape::Box)
            {
                Point<Lanes> outside;
                excess(ownX, obstacle.size.x(), outside.x);
                excess(ownY, obstacle.size.y(), outside.y);
                excess(ownZ, obstacle.size.z(), outside.z);
                return atMost(outside.x * outside.x + outside.y * outside.y + outside.z * outside.z, radius * radius);
            }
            Lanes fromAxis{};
            squareRoot(ownX * ownX + ownY * ownY, fromAxis);
            Lanes across;
            Lanes along;
            excess(fromAxis, obstacle.size.x(), across);
            excess(ownZ, obstacle.size.y(), along);
            return atMost(across * across + along * along, radius * radius);
        }

        template <typename Lanes>
        struct Batch
        {
            std::vector<Pose<Lanes>> bodies;
            std::vector<Point<Lanes>> hulls;
            std::vector<Point<Lanes>> centres;
        };

        template <typename Lanes>
        OMPL_MFA_INLINE unsigned int testWorld(const BallModel &model, const BallModel::Test &test,
                                               const Batch<Lanes> &batch, bool stopAtFirst)
        {
            const BallModel::Link &link = model.links[test.first];
            unsigned int hits = 0;
            for (const std::size_t index : test.obstacles)
            {
                const BallModel::Obstacle &obstacle = model.obstacles[index];
                const Point<Lanes> &hull = batch.hulls[test.first];
                if (touchBall(obstacle, hull, link.hull.radius + obstacle.reach) == 0 ||
                    touchObstacle(obstacle, hull, link.hull.radius) == 0)
                {
                    continue;
                }
                for (const BallModel::Ball &ball : link.world)
                {
                    Point<Lanes> centre;
                    transform(batch.bodies[link.body], ball.centre, centre);
                    hits |= touchObstacle(obstacle, centre, ball.radius);
                    if (hits == ALL<Lanes> || (stopAtFirst && hits != 0))
                    {
                        return hits;
                    }
                }
            }
            return hits;
        }

        template <typename Lanes>
        OMPL_MFA_INLINE unsigned int testLinks(const BallModel &model, const BallModel::Test &test, Batch<Lanes> &batch,
                                               bool stopAtFirst)
        {
            const BallModel::Link &first = model.links[test.first];
            const BallModel::Link &second = model.links[test.second];
            const Point<Lanes> &hull = batch.hulls[test.second];
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
                Point<Lanes> centre;
                transform(batch.bodies[first.body], ball.centre, centre);
                if (touch(centre, hull, ball.radius + second.hull.radius) == 0)
                {
                    continue;
                }
                for (std::size_t j = 0; j < second.self.size(); ++j)
                {
                    hits |= touch(centre, batch.centres[j], ball.radius + second.self[j].radius);
                }
                if (hits == ALL<Lanes> || (stopAtFirst && hits != 0))
                {
                    return hits;
                }
            }
            return hits;
        }

        template <typename Lanes>
        OMPL_MFA_INLINE unsigned int check(const RobotKinematics &kinematics, const BallModel &model,
                                           const double *const *states, const std::vector<std::uint32_t> &order,
                                           bool stopAtFirst, std::uint32_t &hitTest, Batch<Lanes> &batch)
        {
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
                if (hits == ALL<Lanes> || (stopAtFirst && hits != 0))
                {
                    break;
                }
            }
            return hits;
        }

        template <typename Lanes>
        Batch<Lanes> &batchFor(const RobotKinematics &kinematics, const BallModel &model)
        {
            thread_local Batch<Lanes> batch;
            if (batch.bodies.size() < kinematics.bodyCount())
            {
                batch.bodies.resize(kinematics.bodyCount());
                // Body 0 stands still.
                const Lanes zero{};
                for (int k = 0; k < 9; ++k)
                {
                    batch.bodies[0].r[k] = zero + (k % 4 == 0 ? 1. : 0.);
                }
                batch.bodies[0].t = {zero, zero, zero};
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
                                                                   Batch<Four> &batch)
        {
            return check<Four>(kinematics, model, states, order, stopAtFirst, hitTest, batch);
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
            Batch<double> &batch = batchFor<double>(kinematics_, model_);
            unsigned int hits = 0;
            for (std::size_t i = 0; i < count && (hits == 0 || !stopAtFirst); ++i)
            {
                hits |= check<double>(kinematics_, model_, states + i, order, stopAtFirst, hitTest, batch) << i;
            }
            return hits;
        }
        const double *all[LANES];
        for (std::size_t i = 0; i < LANES; ++i)
        {
            all[i] = states[i < count ? i : 0];
        }
        Batch<Four> &batch = batchFor<Four>(kinematics_, model_);
        const unsigned int wanted = (1U << count) - 1U;
#if OMPL_MFA_HAS_AVX2
        if (hasAvx2_)
        {
            return checkWithAvx2(kinematics_, model_, all, order, stopAtFirst, hitTest, batch) & wanted;
        }
#endif
        return check<Four>(kinematics_, model_, all, order, stopAtFirst, hitTest, batch) & wanted;
    }
}  // namespace ompl_mfa::robots
