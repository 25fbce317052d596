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

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include "benchmark/InputErrorOf.h"
#include "maps/MapFolder.h"
#include "ompl_mfa/maps/ClearanceCostObjective.h"
#include "ompl_mfa/maps/MapMotionValidator.h"
#include "ompl_mfa/maps/SmoothnessObjective.h"

namespace ompl_mfa::maps
{
    namespace
    {
        namespace ob = ompl::base;

        template <typename Space>
        ob::SpaceInformationPtr boundedSpace(const std::shared_ptr<Space> &space)
        {
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(40.0);
            space->setBounds(bounds);
            return std::make_shared<ob::SpaceInformation>(space);
        }

        /* An empty map of 40 x 40 metres in cells of 0.1: the distance from its left edge is x near it. */
        std::shared_ptr<MapStateValidityChecker> emptyMap(const ob::SpaceInformationPtr &si)
        {
            MapFrame frame;
            frame.resolution = 0.1;
            const GridMap map(400, 400, std::vector<Cell>(400 * 400, Cell::Free), frame);
            auto checker = setMapChecking(si, std::make_shared<ObstacleGrid>(map), Footprint::disc(0.3));
            si->setup();
            return checker;
        }

        ob::ScopedState<> state(const ob::SpaceInformationPtr &si, const std::vector<double> &values)
        {
            ob::ScopedState<> made(si);
            made = values;
            return made;
        }
    }  // namespace

    TEST(ClearanceCostObjective, IsTheIntegralOfNav2sInflation)
    {
        const auto si = boundedSpace(std::make_shared<ob::RealVectorStateSpace>(2));
        const auto checker = emptyMap(si);
        const ClearanceCostObjective objective(si, checker, {2.0, 0.3, 5.0});
        EXPECT_NEAR(objective.inflation(0.3), 252.0, 1e-9);
        EXPECT_NEAR(objective.inflation(1.3), 252.0 * std::exp(-2.0), 1e-9);
        EXPECT_EQ(objective.inflation(0.0), 253.0);
        const auto cost = [&](double x0, double y0, double x1, double y1) {
            return objective.motionCost(state(si, {x0, y0}).get(), state(si, {x1, y1}).get()).value();
        };
        // along the edge, and away from it: 5 times the integral of exp(-2 (x - 0.3)) from 0.5 to 8.5
        EXPECT_NEAR(cost(1.0, 10.0, 1.0, 16.0), 6.0 * (1.0 + 5.0 * std::exp(-1.4)), 0.01);
        EXPECT_NEAR(cost(0.5, 20.0, 8.5, 20.0), 8.0 + 2.5 * (std::exp(-0.4) - std::exp(-16.4)), 0.02);
        // a path in the open costs its length, and none costs less
        EXPECT_NEAR(cost(18.0, 20.0, 22.0, 20.0), 4.0, 1e-9);
        EXPECT_EQ(objective.motionCostHeuristic(state(si, {1.0, 1.0}).get(), state(si, {4.0, 5.0}).get()).value(), 5.0);
        EXPECT_EQ(cost(3.0, 3.0, 3.0, 3.0), 0.0);
        // the sum over a divided motion is that of the whole
        EXPECT_NEAR(cost(0.5, 20.0, 3.0, 20.0) + cost(3.0, 20.0, 8.5, 20.0), cost(0.5, 20.0, 8.5, 20.0), 0.005);
        EXPECT_THROW(ClearanceCostObjective(si, checker, {-1.0, 0.3, 5.0}), std::invalid_argument);
        EXPECT_THROW(ClearanceCostObjective(si, checker, {1.0, NAN, 5.0}), std::invalid_argument);
    }

    TEST(SmoothnessObjective, IsTheSquaredTurningBetweenYawAndDirection)
    {
        const auto si = boundedSpace(std::make_shared<ob::SE2StateSpace>());
        emptyMap(si);
        const auto objective = std::make_shared<SmoothnessObjective>(si);
        const auto cost = [&](const std::vector<std::vector<double>> &states)
        {
            ompl::geometric::PathGeometric path(si);
            for (const auto &values : states)
            {
                path.append(state(si, values).get());
            }
            return path.cost(objective).value();
        };
        // straight ahead, and in pieces
        EXPECT_NEAR(cost({{1, 1, 0}, {5, 1, 0}}), 0.0, 1e-12);
        EXPECT_NEAR(cost({{1, 1, 0}, {3, 1, 0}, {5, 1, 0}}), 0.0, 1e-12);
        // a corner of a right angle with the yaw halfway: twice the square of an eighth turn
        const double eighth = M_PI / 4.0;
        EXPECT_NEAR(cost({{1, 1, 0}, {5, 1, eighth}, {5, 5, 2.0 * eighth}}), 2.0 * eighth * eighth, 1e-12);
        EXPECT_NEAR(cost({{1, 1, 0}, {5, 1, 0}, {5, 5, 2.0 * eighth}}), 4.0 * eighth * eighth, 1e-12);
        // rotation on the spot, across pi, and driving sideways
        EXPECT_NEAR(cost({{1, 1, 3.0}, {1, 1, -3.0}}), std::pow(2.0 * M_PI - 6.0, 2), 1e-12);
        EXPECT_NEAR(cost({{1, 1, 0}, {1, 4, 0}}), 8.0 * eighth * eighth, 1e-12);
    }

    TEST(SmoothnessObjective, IsForSE2Only)
    {
        const auto positions = boundedSpace(std::make_shared<ob::RealVectorStateSpace>(2));
        EXPECT_NE(ompl_mfa::test::inputErrorOf([&] { SmoothnessObjective objective(positions); }), "");
        const auto cars = boundedSpace(std::make_shared<ob::ReedsSheppStateSpace>(1.0));
        EXPECT_NE(ompl_mfa::test::inputErrorOf([&] { SmoothnessObjective objective(cars); }), "");
    }
}  // namespace ompl_mfa::maps
