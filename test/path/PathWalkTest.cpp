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

#include "path/PathWalk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        class PathWalkTest : public ::testing::Test
        {
        protected:
            Waypoints path(const std::vector<std::pair<double, double>> &points) const
            {
                return test::planarPath(space_, points);
            }

            void expectPoint(const ob::State *state, double x, double y) const
            {
                std::vector<double> values;
                space_->copyToReals(values, state);
                EXPECT_NEAR(values[0], x, 1e-12);
                EXPECT_NEAR(values[1], y, 1e-12);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
        };

        TEST_F(PathWalkTest, MeasuresAlongThePath)
        {
            // motions of lengths 5, 2 and 4
            const Waypoints angled = path({{0, 0}, {3, 4}, {3, 6}, {7, 6}});
            PathWalk walk(angled);
            ob::ScopedState<> state(space_);
            walk.stateAt(0.0, state.get());
            expectPoint(state.get(), 0.0, 0.0);
            EXPECT_EQ(walk.next(), 1U);
            walk.stateAt(2.5, state.get());
            expectPoint(state.get(), 1.5, 2.0);
            EXPECT_EQ(walk.next(), 1U);
            // the same distance again
            walk.stateAt(2.5, state.get());
            expectPoint(state.get(), 1.5, 2.0);
            walk.stateAt(6.0, state.get());
            expectPoint(state.get(), 3.0, 5.0);
            EXPECT_EQ(walk.next(), 2U);
            walk.stateAt(10.0, state.get());
            expectPoint(state.get(), 6.0, 6.0);
            EXPECT_EQ(walk.next(), 3U);
        }

        TEST_F(PathWalkTest, SkipsWholeMotions)
        {
            const Waypoints angled = path({{0, 0}, {3, 4}, {3, 6}, {7, 6}});
            PathWalk walk(angled);
            ob::ScopedState<> state(space_);
            walk.stateAt(9.0, state.get());
            expectPoint(state.get(), 5.0, 6.0);
            EXPECT_EQ(walk.next(), 3U);
        }

        TEST_F(PathWalkTest, EndsAtTheEnd)
        {
            const Waypoints angled = path({{0, 0}, {3, 4}, {3, 6}});
            PathWalk walk(angled);
            ob::ScopedState<> state(space_);
            for (const double distance : {7.0, 7.1, 100.0})
            {
                walk.stateAt(distance, state.get());
                expectPoint(state.get(), 3.0, 6.0);
                EXPECT_EQ(walk.next(), 2U);
            }
        }

        TEST_F(PathWalkTest, PassesMotionsOfNoLength)
        {
            const Waypoints repeated = path({{0, 0}, {0, 0}, {2, 0}, {2, 0}, {2, 0}});
            PathWalk walk(repeated);
            ob::ScopedState<> state(space_);
            walk.stateAt(0.0, state.get());
            expectPoint(state.get(), 0.0, 0.0);
            walk.stateAt(0.5, state.get());
            expectPoint(state.get(), 0.5, 0.0);
            EXPECT_EQ(walk.next(), 2U);
            walk.stateAt(3.0, state.get());
            expectPoint(state.get(), 2.0, 0.0);
        }

        TEST_F(PathWalkTest, StatesAlongThePathAreEquallySpaced)
        {
            const Waypoints angled = path({{0, 0}, {3, 0}, {3, 3}});
            const Waypoints states = statesAlong(angled, 5);
            ASSERT_EQ(states.size(), 5U);
            expectPoint(states[0], 1.0, 0.0);
            expectPoint(states[1], 2.0, 0.0);
            expectPoint(states[2], 3.0, 0.0);
            expectPoint(states[3], 3.0, 1.0);
            expectPoint(states[4], 3.0, 2.0);
            EXPECT_TRUE(statesAlong(angled, 0).empty());
        }

        TEST_F(PathWalkTest, StatesOfAPathOfNoLengthAreItsState)
        {
            const Waypoints still = path({{2, 1}, {2, 1}, {2, 1}});
            const Waypoints states = statesAlong(still, 3);
            ASSERT_EQ(states.size(), 3U);
            for (std::size_t k = 0; k < states.size(); ++k)
            {
                expectPoint(states[k], 2.0, 1.0);
            }
        }

        class PathWalkInSpaces : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Spaces, PathWalkInSpaces, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        /* Of every motion; a part of a curve has a share of its length only in a space where it is geodesic. */
        TEST_P(PathWalkInSpaces, StatesLieWithinTheBoundsOnTheMotionOfTheirIndex)
        {
            const auto space = GetParam().make();
            const auto sampler = space->allocStateSampler();
            ob::ScopedState<> state(space);
            ob::ScopedState<> expected(space);
            for (int i = 0; i < 20; ++i)
            {
                Waypoints path(space);
                path.resize(5);
                for (std::size_t k = 0; k < path.size(); ++k)
                {
                    sampler->sampleUniform(path[k]);
                }
                PathWalk walk(path);
                double behind = 0.0;
                for (std::size_t k = 1; k < path.size(); ++k)
                {
                    const double length = space->distance(path[k - 1], path[k]);
                    for (const double part : {0.25, 0.75})
                    {
                        walk.stateAt(behind + part * length, state.get());
                        EXPECT_EQ(walk.next(), k);
                        EXPECT_TRUE(space->satisfiesBounds(state.get()));
                        space->interpolate(path[k - 1], path[k], part, expected.get());
                        space->enforceBounds(expected.get());
                        std::vector<double> values;
                        std::vector<double> expectedValues;
                        space->copyToReals(values, state.get());
                        space->copyToReals(expectedValues, expected.get());
                        for (std::size_t j = 0; j < values.size(); ++j)
                        {
                            // an angle of -pi is one of pi
                            const double off = std::abs(values[j] - expectedValues[j]);
                            EXPECT_LT(std::min(off, std::abs(off - boost::math::constants::two_pi<double>())), 1e-6);
                        }
                    }
                    behind += length;
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa::path
