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

#include "benchmark/NearbyState.h"

#include <cmath>

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <rapidcheck/gtest.h>

#include "benchmark/ProblemSpace.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        /* States are valid outside of a ball about the origin. */
        ob::SpaceInformationPtr ballProblem(StateSpaceKind kind, double radius, double high = 10.0)
        {
            const unsigned int dimension = positionDimension(kind);
            ob::RealVectorBounds bounds(dimension);
            bounds.setLow(-10.0);
            bounds.setHigh(high);
            ProblemConfig problem;
            problem.space = kind;
            const auto space = makeStateSpace(problem, bounds);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker(
                [space = space.get(), dimension, radius](const ob::State *state)
                {
                    double squared = 0.0;
                    for (unsigned int i = 0; i < dimension; ++i)
                    {
                        squared += std::pow(*space->getValueAddressAtIndex(state, i), 2);
                    }
                    return squared >= radius * radius;
                });
            si->setup();
            return si;
        }
    }  // namespace

    RC_GTEST_PROP(NearbyState, IsValidAndHardlyFartherThanTheNearest, ())
    {
        const auto kind =
            *rc::gen::element(StateSpaceKind::R2, StateSpaceKind::R3, StateSpaceKind::SE2, StateSpaceKind::SE3);
        const double depth = std::pow(10.0, -*rc::gen::inRange(1, 8)) * *rc::gen::inRange(1, 10);
        const double angle = *rc::gen::inRange(0, 628) / 100.0;
        const auto si = ballProblem(kind, 3.0);
        ConfigPose pose;
        pose.x = (3.0 - depth) * std::cos(angle);
        pose.y = (3.0 - depth) * std::sin(angle);
        pose.theta = 0.5;
        const auto nearby = findNearbyState(*si, kind, pose, 1.5);
        RC_ASSERT(nearby.has_value());
        RC_ASSERT(si->isValid(makeState(si->getStateSpace(), kind, nearby->pose).get()));
        const double distance = std::hypot(nearby->pose.x - pose.x, nearby->pose.y - pose.y, nearby->pose.z - pose.z);
        RC_ASSERT(distance <= 1.0201 * nearby->distance);
        // directions are up to 0.15 off, and the surface curves away
        RC_ASSERT(nearby->distance > depth - 1e-9);
        RC_ASSERT(nearby->distance < 1.03 * depth + 1e-9);
        RC_ASSERT(nearby->pose.theta == 0.5);
    }

    TEST(NearbyState, IsNotSoughtFartherThanAskedFor)
    {
        const auto si = ballProblem(StateSpaceKind::SE2, 3.0);
        ConfigPose pose;
        pose.x = 2.0;
        EXPECT_FALSE(findNearbyState(*si, StateSpaceKind::SE2, pose, 0.95));
        EXPECT_TRUE(findNearbyState(*si, StateSpaceKind::SE2, pose, 1.05));
    }

    TEST(NearbyState, IsWithinTheBounds)
    {
        // the nearest valid position, (3, 0), is beyond the bounds
        const auto si = ballProblem(StateSpaceKind::R2, 3.0, 2.95);
        ConfigPose pose;
        pose.x = 2.9;
        const auto nearby = findNearbyState(*si, StateSpaceKind::R2, pose, 2.0);
        ASSERT_TRUE(nearby);
        EXPECT_LE(nearby->pose.x, 2.95);
        EXPECT_TRUE(si->isValid(makeState(si->getStateSpace(), StateSpaceKind::R2, nearby->pose).get()));
        // (2.95, 0.5454) is the nearest, at the tip of a wedge that search directions may miss
        EXPECT_GE(nearby->distance, std::hypot(2.9 - 2.95, std::sqrt(9.0 - 2.95 * 2.95)) - 1e-9);
        EXPECT_LT(nearby->distance, 0.9);
    }
}  // namespace ompl_mfa::benchmark
