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

#include "path/Waypoints.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <ompl/geometric/PathGeometric.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        double &value(ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }

        double value(const ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }

        std::vector<double> values(const Waypoints &path)
        {
            std::vector<double> result;
            for (const ob::State *state : path.pointers())
            {
                result.push_back(value(state));
            }
            return result;
        }

        class WaypointsTest : public ::testing::Test
        {
        protected:
            Waypoints make(std::initializer_list<double> list) const
            {
                Waypoints path(space_);
                ob::ScopedState<ob::RealVectorStateSpace> state(space_);
                for (const double v : list)
                {
                    state[0] = v;
                    path.append(state.get());
                }
                return path;
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(1);
        };

        TEST_F(WaypointsTest, AppendsCopies)
        {
            Waypoints path(space_);
            EXPECT_TRUE(path.empty());
            ob::ScopedState<ob::RealVectorStateSpace> state(space_);
            state[0] = 3.0;
            path.append(state.get());
            state[0] = 4.0;
            EXPECT_EQ(path.size(), 1U);
            EXPECT_EQ(values(path), (std::vector<double>{3.0}));
            EXPECT_NE(path[0], state.get());
        }

        TEST_F(WaypointsTest, AreEqualIfAllStatesAre)
        {
            EXPECT_TRUE(make({1.0, 2.0}).equals(make({1.0, 2.0})));
            EXPECT_TRUE(make({}).equals(make({})));
            EXPECT_FALSE(make({1.0, 2.0}).equals(make({1.0, 2.5})));
            EXPECT_FALSE(make({1.0, 2.0}).equals(make({2.0, 1.0})));
            EXPECT_FALSE(make({1.0, 2.0}).equals(make({1.0})));
            EXPECT_FALSE(make({}).equals(make({1.0})));
        }

        TEST_F(WaypointsTest, FrontAndBackAreTheEnds)
        {
            const Waypoints path = make({1.0, 2.0, 3.0});
            EXPECT_EQ(value(path.front()), 1.0);
            EXPECT_EQ(value(path.back()), 3.0);
        }

        TEST_F(WaypointsTest, CopiesAreDeep)
        {
            Waypoints path = make({1.0, 2.0});
            const Waypoints copy(path);
            value(path[0]) = 9.0;
            EXPECT_EQ(values(copy), (std::vector<double>{1.0, 2.0}));
            Waypoints assigned = make({5.0, 6.0, 7.0});
            assigned = path;
            EXPECT_EQ(values(assigned), (std::vector<double>{9.0, 2.0}));
            const Waypoints &self = assigned;
            assigned = self;
            EXPECT_EQ(values(assigned), (std::vector<double>{9.0, 2.0}));
        }

        TEST_F(WaypointsTest, MovesTakeTheStates)
        {
            Waypoints path = make({1.0, 2.0});
            const ob::State *first = path[0];
            Waypoints moved(std::move(path));
            EXPECT_EQ(moved[0], first);
            Waypoints assigned = make({4.0});
            assigned = std::move(moved);
            EXPECT_EQ(assigned[0], first);
            EXPECT_EQ(values(assigned), (std::vector<double>{1.0, 2.0}));
        }

        TEST_F(WaypointsTest, ReusesMemoryWhenTheLengthChanges)
        {
            Waypoints path = make({1.0, 2.0, 3.0});
            const auto before = path.pointers();
            path.clear();
            EXPECT_TRUE(path.empty());
            path.resize(3);
            EXPECT_EQ(path.pointers(), before);
        }

        TEST_F(WaypointsTest, AreAppendedToAPathAsCopies)
        {
            Waypoints waypoints = make({1.0, 2.0});
            ompl::geometric::PathGeometric path(std::make_shared<ob::SpaceInformation>(space_));
            waypoints.appendTo(path);
            value(waypoints[1]) = 3.0;
            waypoints.appendTo(path);
            ASSERT_EQ(path.getStateCount(), 4U);
            for (unsigned int i = 0; i < 4; ++i)
            {
                EXPECT_EQ(value(path.getState(i)), (std::vector<double>{1.0, 2.0, 1.0, 3.0})[i]);
            }
        }

        TEST_F(WaypointsTest, InsertsAnywhere)
        {
            Waypoints path = make({1.0, 3.0});
            ob::ScopedState<ob::RealVectorStateSpace> state(space_);
            state[0] = 2.0;
            path.insert(1, state.get());
            state[0] = 0.0;
            path.insert(0, state.get());
            state[0] = 4.0;
            path.insert(4, state.get());
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0}));
        }

        TEST_F(WaypointsTest, ErasesARangeAndKeepsTheOrder)
        {
            Waypoints path = make({0.0, 1.0, 2.0, 3.0, 4.0});
            path.erase(1, 3);
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 3.0, 4.0}));
            path.erase(2, 3);
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 3.0}));
            path.erase(1, 1);
            EXPECT_EQ(values(path), (std::vector<double>{0.0, 3.0}));
        }

        TEST_F(WaypointsTest, ReversesOnlyTheStatesInUse)
        {
            Waypoints path = make({0.0, 1.0, 2.0, 3.0});
            path.resize(3);
            path.reverse();
            EXPECT_EQ(values(path), (std::vector<double>{2.0, 1.0, 0.0}));
        }

        TEST_F(WaypointsTest, AnAssignedPathHasTheSpaceOfItsOriginal)
        {
            // states of different sizes: copied in the wrong space, some of their values would be lost
            const auto plane = test::realVectorSpace(2);
            Waypoints planar = test::planarPath(plane, {{1.0, 2.0}, {3.0, 4.0}});
            Waypoints path = make({5.0, 6.0, 7.0});
            path = planar;
            EXPECT_EQ(path.space(), plane);
            ASSERT_EQ(path.size(), 2U);
            for (std::size_t i = 0; i < 2; ++i)
            {
                EXPECT_TRUE(plane->equalStates(path[i], planar[i]));
            }
            Waypoints moved = make({5.0, 6.0, 7.0});
            moved = std::move(planar);
            EXPECT_EQ(moved.space(), plane);
            ASSERT_EQ(moved.size(), 2U);
            EXPECT_TRUE(plane->equalStates(moved[1], path[1]));
            // the old states are freed in their own space, and either can be filled again
            moved.resize(5);
            planar = make({8.0, 9.0});
            EXPECT_EQ(values(planar), (std::vector<double>{8.0, 9.0}));
        }

        /* A path against a std::vector of the same values, under random changes. */
        RC_GTEST_PROP(WaypointsProperty, BehaveLikeAVector, ())
        {
            const auto space = test::realVectorSpace(1, -1e6, 1e6);
            Waypoints path(space);
            Waypoints other(space);
            std::vector<double> model;
            std::vector<double> otherModel;
            ob::ScopedState<ob::RealVectorStateSpace> state(space);
            const auto steps = *rc::gen::inRange(1, 60);
            for (int step = 0; step < steps; ++step)
            {
                const auto size = static_cast<std::ptrdiff_t>(model.size());
                const auto position = *rc::gen::inRange<std::ptrdiff_t>(0, size + 1);
                state[0] = *rc::gen::inRange(-1000, 1000);
                switch (*rc::gen::inRange(0, 10))
                {
                    case 0:
                    case 1:
                        path.append(state.get());
                        model.push_back(state[0]);
                        break;
                    case 2:
                        path.insert(static_cast<std::size_t>(position), state.get());
                        model.insert(model.begin() + position, state[0]);
                        break;
                    case 3:
                    {
                        const auto last = *rc::gen::inRange<std::ptrdiff_t>(position, size + 1);
                        path.erase(static_cast<std::size_t>(position), static_cast<std::size_t>(last));
                        model.erase(model.begin() + position, model.begin() + last);
                        break;
                    }
                    case 4:
                        path.reverse();
                        std::reverse(model.begin(), model.end());
                        break;
                    case 5:
                        path.resize(static_cast<std::size_t>(position));
                        model.resize(static_cast<std::size_t>(position));
                        break;
                    case 6:
                        other = path;
                        otherModel = model;
                        break;
                    case 7:
                        std::swap(path, other);
                        std::swap(model, otherModel);
                        break;
                    case 8:
                        other = Waypoints(path);
                        otherModel = model;
                        break;
                    default:
                        if (size > 0)
                        {
                            // a state of the path itself
                            const std::size_t i = static_cast<std::size_t>(std::min(position, size - 1));
                            path.append(path[i]);
                            model.push_back(model[i]);
                        }
                        break;
                }
                RC_ASSERT(path.size() == model.size());
                RC_ASSERT(path.empty() == model.empty());
                RC_ASSERT(values(path) == model);
                RC_ASSERT(values(other) == otherModel);
                double length = 0.0;
                for (std::size_t i = 1; i < model.size(); ++i)
                {
                    length += std::abs(model[i] - model[i - 1]);
                }
                RC_ASSERT(path.length() == length);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::path
