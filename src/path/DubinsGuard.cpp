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

#include "path/DubinsGuard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/constants/constants.hpp>

#include <ompl/base/spaces/DubinsStateSpace.h>

#include "path/Waypoints.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        constexpr double TWO_PI = boost::math::constants::two_pi<double>();
        /* OMPL rounds an angle less than 5e-7 rad short of a full turn to 0; the factor allows for rounding of the
           numbers compared with this. */
        constexpr double ROUNDED = 1.02 * 5e-7;
        /* Largest accepted miss of a curve's end, in turning radii: half of what OMPL's assertions accept. */
        constexpr double LARGEST_MISS = 1e-6;
        /* Distance in turning radii beyond which rounding of doubles alone violates the assertions. */
        constexpr double FARTHEST = 1e8;
        /* Angle (rad) by which a heading is turned, and the number of its multiples tried in either direction. */
        constexpr double TURN = 2e-6;
        constexpr int TURNS = 8;

        using Pose = ob::SE2StateSpace::StateType;

        /* The turning radius has no accessor. */
        struct TurningRadius : ob::DubinsStateSpace
        {
            static double of(const ob::DubinsStateSpace &space)
            {
                return space.*(&TurningRadius::rho_);
            }
        };

        /* The distance by which a line through one pose misses a circle at another, and how far ahead, both in turning
           radii. */
        struct Tangent
        {
            double miss;
            double ahead;
        };

        /* Whether the first turn of a curve may be rounded to 0: the line straight ahead nearly touches a circle at its
           end. */
        bool missesEnd(const Tangent &tangent)
        {
            const double miss = std::abs(tangent.miss);
            return miss > LARGEST_MISS && miss < ROUNDED * tangent.ahead;
        }

        /* The same for a curve that begins on the straight segment of one that ends in a small turn: its end is 1 - cos
           of the turn beside the line ahead, and the other circle there twice as much. The bounds allow for the
           difference between the turn and its sine. */
        bool partsMissEnd(const Tangent &back)
        {
            const double turn = back.miss / back.ahead;
            const double miss = turn * turn;
            return back.ahead > 0.0 && miss > 0.9 * LARGEST_MISS && miss < 2.2 * ROUNDED * (back.ahead + 1.0);
        }

        /* Two poses, in turning radii, in the frame whose x axis leads from the first position to the second. */
        class PosePair
        {
        public:
            PosePair(const Pose &from, const Pose &to, double radius)
            {
                const double dx = to.getX() - from.getX();
                const double dy = to.getY() - from.getY();
                const double length = std::sqrt(dx * dx + dy * dy);
                const double x = length > 0.0 ? dx / length : 1.0;
                const double y = length > 0.0 ? dy / length : 0.0;
                const double fromX = std::cos(from.getYaw());
                const double fromY = std::sin(from.getYaw());
                const double toX = std::cos(to.getYaw());
                const double toY = std::sin(to.getYaw());
                distance_ = length / radius;
                cosFirst_ = x * fromX + y * fromY;
                sinFirst_ = x * fromY - y * fromX;
                cosLast_ = x * toX + y * toY;
                sinLast_ = x * toY - y * toX;
                bend_ = 1.0 - (fromX * toX + fromY * toY);
                shift_ = fromY * toX - fromX * toY;
            }

            /* Whether OMPL can compute the curves from the first to the second. */
            bool curvesExist() const
            {
                // a heading slightly to the right of the direction to the end is rounded to that direction
                const bool rounded = cosFirst_ > 0.0 && sinFirst_ < 0.0 && sinFirst_ > -ROUNDED;
                if (!(distance_ < FARTHEST) || (rounded && -sinFirst_ * distance_ > LARGEST_MISS))
                {
                    return false;
                }
                const double sinFirst = rounded ? 0.0 : sinFirst_;
                const double across = distance_ * sinFirst;
                const double ahead = distance_ * cosFirst_;
                return !losesBothTurns(sinFirst) && !missesEnd({across + bend_, ahead + shift_}) &&
                       !missesEnd({across - bend_, ahead - shift_});
            }

            /* Whether OMPL can compute the curves from states on those curves to their end. */
            bool partsExist() const
            {
                const double across = distance_ * sinLast_;
                const double ahead = distance_ * cosLast_;
                return !partsMissEnd({across - bend_, ahead + shift_}) &&
                       !partsMissEnd({across + bend_, ahead - shift_});
            }

        private:
            /* Whether the first and the last turn of a left-straight-left curve may both be rounded, which changes its
               last heading by more than OMPL accepts. */
            bool losesBothTurns(double sinFirst) const
            {
                return cosFirst_ > 0.0 && cosLast_ > 0.0 && std::abs(sinFirst) < 2.0 * ROUNDED &&
                       std::abs(sinLast_) < 2.0 * ROUNDED && sinFirst - sinLast_ > 0.95 * ROUNDED;
            }

            double distance_;
            double cosFirst_;  ///< angle from the direction of the second position to the heading
            double sinFirst_;
            double cosLast_;
            double sinLast_;
            double bend_;   ///< 1 - cos of the angle between the headings
            double shift_;  ///< sin(first heading - last heading)
        };

        template <typename State>
        State *substate(const std::vector<std::size_t> &chain, State *state)
        {
            for (const std::size_t i : chain)
            {
                state = state->template as<ob::CompoundState>()->components[i];
            }
            return state;
        }

        /* Turns the first pose by the smallest angle that lets OMPL compute the curves from it to the second. */
        bool turn(Pose &from, const Pose &to, double radius)
        {
            const double yaw = from.getYaw();
            for (int k = 0; k <= 2 * TURNS; ++k)
            {
                const int multiple = k % 2 == 0 ? -(k / 2) : (k + 1) / 2;
                from.setYaw(std::remainder(yaw + multiple * TURN, TWO_PI));
                if (PosePair(from, to, radius).curvesExist())
                {
                    return true;
                }
            }
            return false;
        }
    }  // namespace

    /* Copies of the ends of a motion with their headings turned by the smallest angles that let OMPL compute it. */
    class DubinsGuard::TurnedMotion
    {
    public:
        TurnedMotion(const DubinsGuard &guard, const ob::State *from, const ob::State *to)
          : ends_(guard.space_)
        {
            ends_.append(from);
            ends_.append(to);
            for (const Curve &curve : guard.curves_)
            {
                auto &first = *substate(curve.chain, ends_[0])->as<Pose>();
                auto &last = *substate(curve.chain, ends_[1])->as<Pose>();
                exists_ =
                    exists_ && turn(first, last, curve.radius) && (!curve.symmetric || turn(last, first, curve.radius));
            }
            // turning the second end may have invalidated the first
            exists_ = exists_ && guard.allCurvesExist(ends_[0], ends_[1]);
        }

        bool exists() const
        {
            return exists_;
        }

        const ob::State *from() const
        {
            return ends_.front();
        }

        const ob::State *to() const
        {
            return ends_.back();
        }

    private:
        Waypoints ends_;
        bool exists_{true};
    };

    DubinsGuard::DubinsGuard(ob::StateSpacePtr space)
      : space_(std::move(space))
    {
        std::vector<std::size_t> chain;
        addCurves(space_, chain);
    }

    void DubinsGuard::addCurves(const ob::StateSpacePtr &space, std::vector<std::size_t> &chain)
    {
        if (const auto *dubins = dynamic_cast<const ob::DubinsStateSpace *>(space.get()))
        {
            curves_.push_back({chain, TurningRadius::of(*dubins), dubins->hasSymmetricDistance()});
            return;
        }
        const auto *compound = dynamic_cast<const ob::CompoundStateSpace *>(space.get());
        for (unsigned int i = 0; compound != nullptr && i < compound->getSubspaceCount(); ++i)
        {
            chain.push_back(i);
            addCurves(compound->getSubspace(i), chain);
            chain.pop_back();
        }
    }

    /* Whether all curves have \e property, in both directions if OMPL computes both. */
    template <typename Property>
    bool DubinsGuard::allCurves(const ob::State *from, const ob::State *to, Property property) const
    {
        return std::all_of(curves_.begin(), curves_.end(),
                           [&](const Curve &curve)
                           {
                               const Pose &first = *substate(curve.chain, from)->as<Pose>();
                               const Pose &last = *substate(curve.chain, to)->as<Pose>();
                               return property(PosePair(first, last, curve.radius)) &&
                                      (!curve.symmetric || property(PosePair(last, first, curve.radius)));
                           });
    }

    bool DubinsGuard::allCurvesExist(const ob::State *from, const ob::State *to) const
    {
        return allCurves(from, to, [](const PosePair &pair) { return pair.curvesExist(); });
    }

    bool DubinsGuard::allPartsExist(const ob::State *from, const ob::State *to) const
    {
        return allCurves(from, to, [](const PosePair &pair) { return pair.curvesExist() && pair.partsExist(); });
    }

    double DubinsGuard::distance(const ob::State *from, const ob::State *to) const
    {
        if (computes(from, to))
        {
            return space_->distance(from, to);
        }
        const TurnedMotion turned(*this, from, to);
        return turned.exists() ? space_->distance(turned.from(), turned.to()) : std::numeric_limits<double>::infinity();
    }

    unsigned int DubinsGuard::validSegmentCount(const ob::State *from, const ob::State *to) const
    {
        if (computes(from, to))
        {
            return space_->validSegmentCount(from, to);
        }
        const TurnedMotion turned(*this, from, to);
        return turned.exists() ? space_->validSegmentCount(turned.from(), turned.to()) : 1;
    }

    void DubinsGuard::interpolate(const ob::State *from, const ob::State *to, double t, ob::State *state) const
    {
        if (computes(from, to))
        {
            return space_->interpolate(from, to, t, state);
        }
        const TurnedMotion turned(*this, from, to);
        if (turned.exists())
        {
            return space_->interpolate(turned.from(), turned.to(), t, state);
        }
        // there is no curve: the nearer end stands for the states in between
        space_->copyState(state, t < 0.5 ? from : to);
    }
}  // namespace ompl_mfa::path
