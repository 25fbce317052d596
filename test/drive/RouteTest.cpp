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

#include "drive/Route.h"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ompl_mfa::drive
{
    namespace
    {
        namespace ob = ompl::base;

        /* From (0, 0) by (3, 0), twice, to (3, 4). */
        ompl::geometric::PathGeometric corner()
        {
            const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(2));
            ompl::geometric::PathGeometric path(si);
            for (const auto &[x, y] : {std::pair<double, double>(0, 0), {3, 0}, {3, 0}, {3, 4}})
            {
                ob::ScopedState<ob::RealVectorStateSpace> state(si);
                state->values[0] = x;
                state->values[1] = y;
                path.append(state.get());
            }
            return path;
        }
    }  // namespace

    TEST(Route, StatesAreAtTheirDistancesAlongThePath)
    {
        Route route(corner());
        EXPECT_EQ(route.length(), 7.0);
        ob::ScopedState<ob::RealVectorStateSpace> state(route.path().getSpaceInformation());
        for (const auto &[distance, x, y] :
             {std::tuple<double, double, double>(0, 0, 0), {1, 1, 0}, {3, 3, 0}, {5, 3, 2}, {7, 3, 4}})
        {
            route.stateAt(distance, state.get());
            EXPECT_DOUBLE_EQ(state->values[0], x) << distance;
            EXPECT_DOUBLE_EQ(state->values[1], y) << distance;
        }
    }

    TEST(Route, TheRestBeginsWhereTheRobotIs)
    {
        Route route(corner());
        EXPECT_EQ(route.rest().getStateCount(), 4U);
        EXPECT_EQ(route.endOfMotion(), 3.0);
        route.setDriven(2.0);
        EXPECT_DOUBLE_EQ(route.rest().length(), 5.0);
        EXPECT_EQ(route.endOfMotion(), 3.0);
        route.setDriven(3.0);
        EXPECT_EQ(route.rest().getStateCount(), 2U);
        EXPECT_EQ(route.endOfMotion(), 7.0);
        route.setDriven(7.0);
        EXPECT_EQ(route.rest().length(), 0.0);
        EXPECT_EQ(route.endOfMotion(), 7.0);
    }
}  // namespace ompl_mfa::drive
