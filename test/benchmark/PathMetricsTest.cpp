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

#include "benchmark/PathMetrics.h"

#include <cmath>

#include <gtest/gtest.h>

#include "benchmark/PlanarProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::benchmark
{
    namespace
    {
        og::PathGeometric pathThrough(const og::SimpleSetup &setup,
                                      const std::vector<std::pair<double, double>> &points)
        {
            og::PathGeometric path(setup.getSpaceInformation());
            ob::ScopedState<> state(setup.getStateSpace());
            for (const auto &point : points)
            {
                state[0] = point.first;
                state[1] = point.second;
                path.append(state.get());
            }
            return path;
        }

        const double *coordinates(const ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values;
        }
    }  // namespace

    TEST(PathMetrics, ResampledStatesLieAtEqualDistances)
    {
        const auto setup = test::planarProblem();
        setup->getSpaceInformation()->setup();
        auto path = pathThrough(*setup, {{0, 0}, {3, 0}, {3, 0.1}, {3, 4}});
        auto resampled = resamplePath(path, 0.5);
        ASSERT_EQ(resampled.getStateCount(), 15u);  // 7 units in 14 motions
        for (std::size_t i = 0; i < 15; ++i)
        {
            const double along = 0.5 * static_cast<double>(i);
            EXPECT_NEAR(coordinates(resampled.getState(i))[0], std::min(along, 3.0), 1e-12);
            EXPECT_NEAR(coordinates(resampled.getState(i))[1], std::max(along - 3.0, 0.0), 1e-12);
        }
    }

    TEST(PathMetrics, DegeneratePathsAreLeftAlone)
    {
        const auto setup = test::planarProblem();
        setup->getSpaceInformation()->setup();
        EXPECT_EQ(resamplePath(pathThrough(*setup, {{1, 1}}), 0.1).getStateCount(), 1u);
        EXPECT_EQ(resamplePath(pathThrough(*setup, {{1, 1}, {1, 1}}), 0.1).getStateCount(), 2u);
        // Repeated vertices, first, last and within.
        auto path = resamplePath(pathThrough(*setup, {{1, 1}, {1, 1}, {2, 1}, {2, 1}, {3, 1}, {3, 1}}), 1.0);
        ASSERT_EQ(path.getStateCount(), 3u);
        EXPECT_NEAR(coordinates(path.getState(1))[0], 2.0, 1e-12);
    }

    TEST(PathMetrics, MinimumClearanceIsThatBetweenTheVertices)
    {
        const auto setup = test::planarProblem(1.0);
        setup->getSpaceInformation()->setup();
        // Passes the disc at distance 2 from the centre, in the middle of its only motion.
        auto path = pathThrough(*setup, {{0, 7}, {10, 7}});
        const double step = setup->getStateSpace()->getLongestValidSegmentLength();
        EXPECT_NEAR(measurePath(path).minimumClearance, 1.0, step * step);
        EXPECT_GT(path.clearance(), 4.0);  // OMPL's own: the mean over the two ends
    }

    TEST(PathMetrics, DoesNotDependOnTheVertices)
    {
        const auto setup = test::planarProblem();
        setup->getSpaceInformation()->setup();
        auto coarse = pathThrough(*setup, {{0, 1}, {5, 1}, {9, 3}});
        auto fine = pathThrough(*setup, {{0, 1}, {1, 1}, {2.5, 1}, {5, 1}, {7, 2}, {9, 3}});
        const auto a = measurePath(coarse);
        const auto b = measurePath(fine);
        EXPECT_NEAR(a.smoothness, b.smoothness, 1e-6 * a.smoothness);
        EXPECT_GT(a.smoothness, 0.0);
        EXPECT_EQ(a.minimumClearance, b.minimumClearance);
        EXPECT_GT(std::abs(coarse.smoothness() - fine.smoothness()), 0.01);

        EXPECT_NEAR(measurePath(pathThrough(*setup, {{0, 1}, {9, 1}})).smoothness, 0.0, 1e-9);
    }
}  // namespace ompl_mfa::benchmark
