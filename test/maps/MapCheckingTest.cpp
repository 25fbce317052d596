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

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "benchmark/InputErrorOf.h"
#include "maps/MapFolder.h"
#include "maps/PlaneGeometry.h"
#include "ompl_mfa/maps/MapMotionValidator.h"

namespace ompl_mfa::maps
{
    namespace
    {
        namespace ob = ompl::base;
        using test::Point;
        using test::Polygon;
        using test::uniform;

        constexpr double TURNING_RADIUS = 0.6;
        const Polygon CAR = {{-0.2, -0.3}, {0.9, -0.3}, {0.9, 0.3}, {-0.2, 0.3}};
        const Polygon SHAPE_L = {{-0.3, -0.3}, {0.9, -0.3}, {0.9, 0.0}, {0.0, 0.0}, {0.0, 0.8}, {-0.3, 0.8}};
        /* A turned map of cells of a quarter. */
        const MapFrame FRAME{0.25, {-3.0, 1.0}, 0.3, false};

        enum class Kind
        {
            R2,
            SE2,
            Dubins,
            ReedsShepp
        };

        /* A robot on a random map, and the same in terms of distances from all cells. */
        class Problem
        {
        public:
            Problem(Kind kind, const Footprint &footprint, unsigned int spacing, unsigned int seed)
              : random_(seed)
              , map_(test::randomMap(random_, 36, 28, spacing, FRAME))
            {
                ob::RealVectorBounds bounds(2);
                const Eigen::AlignedBox2d box = map_.bounds();
                for (unsigned int i = 0; i < 2; ++i)
                {
                    bounds.setLow(i, box.min()[i]);
                    bounds.setHigh(i, box.max()[i]);
                }
                const auto bounded = [&bounds](const auto &space)
                {
                    space->setBounds(bounds);
                    return ob::StateSpacePtr(space);
                };
                space_ = kind == Kind::R2       ? bounded(std::make_shared<ob::RealVectorStateSpace>(2))
                         : kind == Kind::SE2    ? bounded(std::make_shared<ob::SE2StateSpace>())
                         : kind == Kind::Dubins ? bounded(std::make_shared<ob::DubinsStateSpace>(TURNING_RADIUS))
                                                : bounded(std::make_shared<ob::ReedsSheppStateSpace>(TURNING_RADIUS));
                si_ = std::make_shared<ob::SpaceInformation>(space_);
                checker_ = setMapChecking(si_, std::make_shared<ObstacleGrid>(map_), footprint);
                si_->setup();
            }

            const ob::SpaceInformation &si() const
            {
                return *si_;
            }

            const MapStateValidityChecker &checker() const
            {
                return *checker_;
            }

            double tolerance() const
            {
                return dynamic_cast<const MapMotionValidator &>(*si_->getMotionValidator()).tolerance();
            }

            ob::ScopedState<> randomState()
            {
                ob::ScopedState<> state(space_);
                const Point position = map_.toWorld({uniform(random_, 0.0, 36.0), uniform(random_, 0.0, 28.0)});
                setPosition(state, position);
                return state;
            }

            /* A state near another one. */
            ob::ScopedState<> randomNeighbour(const ob::ScopedState<> &state, double distance)
            {
                ob::ScopedState<> neighbour(space_);
                Point position(state[0], state[1]);
                do
                {
                    setPosition(neighbour, position + Point(uniform(random_, -distance, distance),
                                                            uniform(random_, -distance, distance)));
                } while (!si_->satisfiesBounds(neighbour.get()));
                return neighbour;
            }

            /* Distance in world units of the robot, without its margin, from the obstacles. */
            double distance(const ob::State *state) const
            {
                const auto *pose = space_->isCompound() ? state->as<ob::SE2StateSpace::StateType>() : nullptr;
                const double *position =
                    pose == nullptr ? state->as<ob::RealVectorStateSpace::StateType>()->values : nullptr;
                const Point at = pose != nullptr ? Point(pose->getX(), pose->getY()) : Point(position[0], position[1]);
                Polygon polygon;
                for (const Point &corner : checker_->footprint().corners())
                {
                    polygon.push_back(
                        map_.toGrid(at + Eigen::Rotation2Dd(pose != nullptr ? pose->getYaw() : 0.0) * corner));
                }
                return map_.frame().resolution * test::distanceFrom(map_, polygon);
            }

        private:
            void setPosition(ob::ScopedState<> &state, const Point &position)
            {
                state[0] = position.x();
                state[1] = position.y();
                if (space_->isCompound())
                {
                    state[2] = uniform(random_, -M_PI, M_PI);
                }
            }

            std::mt19937 random_;
            GridMap map_;
            ob::StateSpacePtr space_;
            ob::SpaceInformationPtr si_;
            std::shared_ptr<MapStateValidityChecker> checker_;
        };

        struct Case
        {
            Kind kind;
            Footprint footprint;
            unsigned int spacing;
        };

        std::vector<Case> cases()
        {
            std::vector<Case> all;
            for (const Kind kind : {Kind::R2, Kind::SE2, Kind::Dubins, Kind::ReedsShepp})
            {
                all.push_back({kind, Footprint::point(), 12});
                all.push_back({kind, Footprint::disc(0.37), 60});
                all.push_back({kind, Footprint::polygon(CAR), 100});
                all.push_back({kind, Footprint::polygon(SHAPE_L, 0.1), 130});
            }
            return all;
        }
    }  // namespace

    TEST(MapChecking, StatesAgreeWithDistancesFromAllCells)
    {
        for (const Case &each : cases())
        {
            Problem problem(each.kind, each.footprint, each.spacing, 17);
            int valid = 0;
            constexpr int ROUNDS = 1200;
            for (int round = 0; round < ROUNDS; ++round)
            {
                const ob::ScopedState<> state = problem.randomState();
                const double distance = problem.distance(state.get());
                const double margin = each.footprint.margin();
                if (std::abs(distance - margin) < 1e-9 && distance > 0.0)
                {
                    continue;
                }
                const bool expected = distance > margin;
                valid += expected ? 1 : 0;
                ASSERT_EQ(problem.si().isValid(state.get()), expected) << state << distance;
                const double clearance = problem.checker().clearance(state.get());
                ASSERT_TRUE(expected ? clearance >= 0.0 : clearance <= 0.0) << state << clearance;
                if (expected)
                {
                    ASSERT_NEAR(clearance, distance - margin, FRAME.resolution) << state;
                }
            }
            EXPECT_GT(valid, ROUNDS / 10);
            EXPECT_LT(valid, 19 * ROUNDS / 20);
        }
    }

    TEST(MapChecking, DepthOfADiscIsTrueToWithinACell)
    {
        Problem problem(Kind::R2, Footprint::disc(0.6), 40, 23);
        for (int round = 0; round < 500; ++round)
        {
            const ob::ScopedState<> state = problem.randomState();
            const double distance = problem.distance(state.get());
            if (distance > 0.0 && distance < 0.6)
            {
                ASSERT_NEAR(problem.checker().clearance(state.get()), distance - 0.6, FRAME.resolution);
            }
        }
    }

    /* Dense samples are the reference. What the validator accepts has no invalid sample; what it rejects has one, or
       comes closer than its tolerance. */
    TEST(MapChecking, MotionsAgreeWithDenseSamples)
    {
        for (const Case &each : cases())
        {
            Problem problem(each.kind, each.footprint, each.spacing, 29);
            ob::ScopedState<> sample(problem.si().getStateSpace());
            int accepted = 0;
            int rejected = 0;
            for (int round = 0; round < 250; ++round)
            {
                const ob::ScopedState<> from = problem.randomState();
                const ob::ScopedState<> to = problem.randomNeighbour(from, round % 4 == 0 ? 6.0 : 1.2);
                if (!problem.si().isValid(from.get()))
                {
                    continue;
                }
                const bool isFree = problem.si().checkMotion(from.get(), to.get());
                (isFree ? accepted : rejected) += 1;
                // a sample each hundredth of a cell
                const double length = problem.si().distance(from.get(), to.get()) +
                                      (problem.si().getStateSpace()->isCompound() ? 3.0 : 0.0);
                const int samples = static_cast<int>(length / FRAME.resolution * 100.0);
                int invalid = 0;
                for (int i = 0; i <= samples && invalid == 0; ++i)
                {
                    problem.si().getStateSpace()->interpolate(from.get(), to.get(), static_cast<double>(i) / samples,
                                                              sample.get());
                    invalid += problem.si().isValid(sample.get()) ? 0 : 1;
                }
                ASSERT_FALSE(isFree && invalid > 0) << from << to;
                // a rejection that no sample confirms is examined with exact distances
                if (!isFree && invalid == 0)
                {
                    double least = INFINITY;
                    for (int i = 0; i <= samples; i += 2)
                    {
                        problem.si().getStateSpace()->interpolate(from.get(), to.get(),
                                                                  static_cast<double>(i) / samples, sample.get());
                        if (problem.checker().clearance(sample.get()) < 2.0 * FRAME.resolution)
                        {
                            least = std::min(least, problem.distance(sample.get()) - each.footprint.margin());
                        }
                    }
                    ASSERT_LT(least, problem.tolerance() + 0.03 * FRAME.resolution) << from << to;
                }
            }
            EXPECT_GT(accepted, 10);
            EXPECT_GT(rejected, 20);
        }
    }

    TEST(MapChecking, LastValidStateIsJustBeforeTheCollision)
    {
        for (const Case &each : cases())
        {
            Problem problem(each.kind, each.footprint, each.spacing, 31);
            const auto &space = problem.si().getStateSpace();
            ob::ScopedState<> last(space);
            int rejected = 0;
            for (int round = 0; round < 300; ++round)
            {
                const ob::ScopedState<> from = problem.randomState();
                const ob::ScopedState<> to = problem.randomNeighbour(from, 1.5);
                if (!problem.si().isValid(from.get()))
                {
                    continue;
                }
                std::pair<ob::State *, double> lastValid(last.get(), -1.0);
                const bool isFree = problem.si().checkMotion(from.get(), to.get(), lastValid);
                ASSERT_EQ(isFree, problem.si().checkMotion(from.get(), to.get())) << from << to;
                if (isFree)
                {
                    continue;
                }
                ++rejected;
                ASSERT_GE(lastValid.second, 0.0);
                ASSERT_LT(lastValid.second, 1.0);
                ASSERT_TRUE(problem.si().isValid(last.get()));
                // soon after it the robot is as close to an obstacle as the validator can tell
                const double length = problem.si().distance(from.get(), to.get());
                const double spread = (2.0 * problem.tolerance()) / std::max(1e-9, length);
                double least = INFINITY;
                for (int i = 0; i <= 20; ++i)
                {
                    space->interpolate(from.get(), to.get(), std::min(1.0, lastValid.second + spread * i / 20.0),
                                       last.get());
                    least = std::min(least, problem.distance(last.get()) - each.footprint.margin());
                }
                ASSERT_LT(least, 3.0 * problem.tolerance())
                    << from << to << lastValid.second << ", margin " << each.footprint.margin() << ", corners "
                    << each.footprint.corners().size() << ", " << space->getName();
            }
            EXPECT_GT(rejected, 20);
        }
    }

    TEST(MapChecking, LongMotionsInOpenSpaceMissNoCell)
    {
        // one occupied cell in the middle of a large empty map
        constexpr std::size_t SIZE = 501;
        std::vector<Cell> cells(SIZE * SIZE, Cell::Free);
        cells[250 * SIZE + 250] = Cell::Occupied;
        const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(0.0, 501.0);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        setMapChecking(si, std::make_shared<ObstacleGrid>(GridMap(SIZE, SIZE, cells, {})), Footprint::disc(2.0));
        si->setup();
        std::mt19937 random(13);
        ob::ScopedState<> from(space);
        ob::ScopedState<> to(space);
        const Polygon cell = {{250, 250}, {251, 250}, {251, 251}, {250, 251}};
        for (int round = 0; round < 3000; ++round)
        {
            const double angle = uniform(random, 0.0, M_PI);
            const Point along(std::cos(angle), std::sin(angle));
            const Point across(-along.y(), along.x());
            const Point middle = Point(250.5, 250.5) + uniform(random, -4.0, 4.0) * across;
            const Point begin = middle - 240.0 * along;
            const Point end = middle + 240.0 * along;
            from[0] = begin.x();
            from[1] = begin.y();
            to[0] = end.x();
            to[1] = end.y();
            const double distance = test::distanceOf({begin, end}, cell);
            if (std::abs(distance - 2.0) > 1e-9)
            {
                ASSERT_EQ(si->checkMotion(from.get(), to.get()), distance > 2.0) << distance;
            }
        }
    }

    TEST(MapChecking, CurvesStayWithinBounds)
    {
        // bounds within an empty map: a car near the edge that looks along it and has to turn back
        std::vector<Cell> cells(400, Cell::Free);
        const auto space = std::make_shared<ob::DubinsStateSpace>(1.0);
        ob::RealVectorBounds bounds(2);
        bounds.setLow(5.0);
        bounds.setHigh(15.0);
        space->setBounds(bounds);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        setMapChecking(si, std::make_shared<ObstacleGrid>(GridMap(20, 20, cells, {})), Footprint::point());
        si->setup();
        const auto state = [&](double x, double y, double yaw)
        {
            ob::ScopedState<> made(space);
            made[0] = x;
            made[1] = y;
            made[2] = yaw;
            return made;
        };
        const auto from = state(14.5, 10.0, 0.0);
        EXPECT_FALSE(si->checkMotion(from.get(), state(14.5, 12.5, -M_PI).get()));
        EXPECT_TRUE(si->checkMotion(state(12.0, 10.0, 0.0).get(), state(12.0, 12.5, -M_PI).get()));
        ob::ScopedState<> last(space);
        std::pair<ob::State *, double> lastValid(last.get(), 0.0);
        EXPECT_FALSE(si->checkMotion(from.get(), state(14.5, 12.5, -M_PI).get(), lastValid));
        EXPECT_GT(last[0], 14.9);
        EXPECT_LE(last[0], 15.0);
        // a motion that leaves the bounds is valid up to them
        EXPECT_FALSE(si->checkMotion(from.get(), state(17.0, 10.0, 0.0).get(), lastValid));
        EXPECT_NEAR(last[0], 15.0, 0.05);
    }

    TEST(MapChecking, StatesBeyondAllMapsAndNumbersAreInvalid)
    {
        const auto space = std::make_shared<ob::RealVectorStateSpace>(2);
        space->setBounds(-1e30, 1e30);
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        const auto checker =
            setMapChecking(si, std::make_shared<ObstacleGrid>(test::mapOf({"...."})), Footprint::polygon(CAR));
        si->setup();
        ob::ScopedState<> state(space);
        for (const double x : {1e30, -1e30, 1e9, static_cast<double>(NAN)})
        {
            state[0] = x;
            state[1] = 0.5;
            EXPECT_FALSE(si->isValid(state.get())) << x;
        }
        state[0] = -1e9;
        EXPECT_NEAR(checker->clearance(state.get()), -1e9, 10.0);
    }

    TEST(MapChecking, OtherSpacesAreRefused)
    {
        const auto space = std::make_shared<ob::SE3StateSpace>();
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        const auto grid = std::make_shared<ObstacleGrid>(test::mapOf({".."}));
        EXPECT_NE(ompl_mfa::test::inputErrorOf([&] { setMapChecking(si, grid, Footprint::point()); })
                      .find("R^2, SE(2), a Dubins or a Reeds-Shepp space"),
                  std::string::npos);
    }
}  // namespace ompl_mfa::maps
