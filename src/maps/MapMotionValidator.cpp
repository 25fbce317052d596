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

#include "ompl_mfa/maps/MapMotionValidator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include "maps/GridRobot.h"
#include "maps/MapMotion.h"

namespace ob = ompl::base;

namespace ompl_mfa::maps
{
    namespace
    {
        constexpr double PI = 3.14159265358979323846;

        // OMPL's counters are plain integers, and planners check motions from several threads.
        void count(unsigned int &counter)
        {
            __atomic_fetch_add(&counter, 1U, __ATOMIC_RELAXED);
        }

        /* The turning radius of a curve has no accessor. */
        template <typename Space>
        struct TurningRadius : Space
        {
            static double of(const Space &space)
            {
                return space.*(&TurningRadius::rho_);
            }
        };

        /* The type of a space's curves, which OMPL's versions name differently. */
        template <typename Space, typename Path>
        Path curveOf(void (Space::*)(const ob::State *, const ob::State *, double, bool &, Path &, ob::State *) const);

        using DubinsCurve = decltype(curveOf<ob::DubinsStateSpace>(&ob::DubinsStateSpace::interpolate));
        using ReedsSheppCurve = decltype(curveOf<ob::ReedsSheppStateSpace>(&ob::ReedsSheppStateSpace::interpolate));

        class StraightMotion : public MapMotion
        {
        public:
            StraightMotion(const GridPose &from, const GridPose &to)
              : from_(from)
              , along_(to.position - from.position)
              , turned_(std::remainder(to.yaw - from.yaw, 2.0 * PI))
            {
                length = along_.norm();
                turn = std::abs(turned_);
            }

            GridPose pose(double share) override
            {
                return {from_.position + share * along_, from_.yaw + share * turned_};
            }

        private:
            GridPose from_;
            Eigen::Vector2d along_;
            double turned_;
        };

        /* A curve of \e Space, computed once for all of its poses. */
        template <typename Space, typename Path>
        class CurvedMotion : public MapMotion
        {
        public:
            CurvedMotion(const ob::StateSpacePtr &space, const GridMap &map, const ob::State *from, const ob::State *to)
              : space_(dynamic_cast<const Space &>(*space))
              , map_(map)
              , from_(from)
              , to_(to)
              , state_(space)
            {
                const double distance = space->distance(from, to);
                length = distance / map.frame().resolution;
                turn = distance / TurningRadius<Space>::of(space_);
                isStraight = false;
            }

            GridPose pose(double share) override
            {
                space_.interpolate(from_, to_, share, isFirst_, path_, state_.get());
                const auto *state = state_->template as<ob::SE2StateSpace::StateType>();
                return {map_.toGrid({state->getX(), state->getY()}), state->getYaw() - map_.frame().yaw};
            }

        private:
            const Space &space_;
            const GridMap &map_;
            const ob::State *from_;
            const ob::State *to_;
            ob::ScopedState<> state_;
            Path path_;
            bool isFirst_{true};
        };

        Eigen::AlignedBox2d positionBounds(const ob::StateSpace &space)
        {
            const auto *plane = dynamic_cast<const ob::SE2StateSpace *>(&space);
            const ob::RealVectorBounds &bounds =
                plane != nullptr ? plane->getBounds() : space.as<ob::RealVectorStateSpace>()->getBounds();
            return {Eigen::Vector2d(bounds.low[0], bounds.low[1]), Eigen::Vector2d(bounds.high[0], bounds.high[1])};
        }
    }  // namespace

    MapMotionValidator::MapMotionValidator(const ob::SpaceInformationPtr &si,
                                           std::shared_ptr<const MapStateValidityChecker> checker)
      : ob::MotionValidator(si)
      , checker_(std::move(checker))
      , curve_(Curve::Straight)
      , exceedsBounds_(!positionBounds(*si->getStateSpace()).contains(checker_->grid().map().bounds()))
    {
        const ob::StateSpace *space = si->getStateSpace().get();
        if (dynamic_cast<const ob::DubinsStateSpace *>(space) != nullptr)
        {
            curve_ = Curve::Dubins;
        }
        else if (dynamic_cast<const ob::ReedsSheppStateSpace *>(space) != nullptr)
        {
            curve_ = Curve::ReedsShepp;
        }
    }

    double MapMotionValidator::tolerance() const
    {
        return MOTION_TOLERANCE * checker_->grid().map().frame().resolution;
    }

    bool MapMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
    {
        const bool valid = si_->isValid(s2) && freeShare(s1, s2, false) >= 1.0;
        count(valid ? valid_ : invalid_);
        return valid;
    }

    bool MapMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                         std::pair<ob::State *, double> &lastValid) const
    {
        const double share = freeShare(s1, s2, true);
        const bool valid = share >= 1.0 && si_->isValid(s2);
        if (!valid)
        {
            lastValid.second = std::min(share, std::nextafter(1.0, 0.0));
            if (lastValid.first != nullptr)
            {
                si_->getStateSpace()->interpolate(s1, s2, lastValid.second, lastValid.first);
            }
        }
        count(valid ? valid_ : invalid_);
        return valid;
    }

    double MapMotionValidator::freeShare(const ob::State *s1, const ob::State *s2, bool locates) const
    {
        const ob::StateSpacePtr &space = si_->getStateSpace();
        const GridMap &map = checker_->grid().map();
        const auto shareOf = [&](auto motion)
        {
            if ((exceedsBounds_ && !motion.isStraight) || (locates && !space->satisfiesBounds(s2)))
            {
                motion.bounds = positionBounds(*space);
            }
            return freeShareOf(*checker_->robot_, motion, locates);
        };
        switch (curve_)
        {
            case Curve::Dubins:
                return shareOf(CurvedMotion<ob::DubinsStateSpace, DubinsCurve>(space, map, s1, s2));
            case Curve::ReedsShepp:
                return shareOf(CurvedMotion<ob::ReedsSheppStateSpace, ReedsSheppCurve>(space, map, s1, s2));
            case Curve::Straight:
                break;
        }
        return shareOf(StraightMotion(checker_->pose(s1), checker_->pose(s2)));
    }

    std::shared_ptr<MapStateValidityChecker> setMapChecking(const ob::SpaceInformationPtr &si,
                                                            std::shared_ptr<const ObstacleGrid> grid,
                                                            const Footprint &footprint)
    {
        auto checker = std::make_shared<MapStateValidityChecker>(si, std::move(grid), footprint);
        si->setStateValidityChecker(checker);
        si->setMotionValidator(std::make_shared<MapMotionValidator>(si, checker));
        return checker;
    }
}  // namespace ompl_mfa::maps
