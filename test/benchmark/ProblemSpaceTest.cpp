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

#include "benchmark/ProblemSpace.h"

#include <cmath>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include <gtest/gtest.h>

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        const double PI = std::acos(-1.0);

        ob::StateSpacePtr spaceOf(StateSpaceKind kind, double turningRadius = 1.0)
        {
            ProblemConfig problem;
            problem.space = kind;
            problem.turningRadius = turningRadius;
            ob::RealVectorBounds bounds(positionDimension(kind));
            bounds.setLow(-10.0);
            bounds.setHigh(10.0);
            return makeStateSpace(problem, bounds);
        }

        TEST(ProblemSpace, EachKindIsItsOwnSpace)
        {
            EXPECT_EQ(spaceOf(StateSpaceKind::R2)->getDimension(), 2u);
            EXPECT_EQ(spaceOf(StateSpaceKind::R3)->getDimension(), 3u);
            EXPECT_EQ(spaceOf(StateSpaceKind::SE2)->getDimension(), 3u);
            EXPECT_EQ(spaceOf(StateSpaceKind::SE3)->getDimension(), 6u);
            EXPECT_TRUE(std::dynamic_pointer_cast<ob::DubinsStateSpace>(spaceOf(StateSpaceKind::Dubins)));
            EXPECT_FALSE(spaceOf(StateSpaceKind::Dubins)->hasSymmetricDistance());
            EXPECT_TRUE(spaceOf(StateSpaceKind::DubinsSymmetric)->hasSymmetricDistance());
            EXPECT_TRUE(std::dynamic_pointer_cast<ob::ReedsSheppStateSpace>(spaceOf(StateSpaceKind::ReedsShepp)));
        }

        TEST(ProblemSpace, CarsTurnOnTheGivenRadius)
        {
            ConfigPose from;
            ConfigPose to;
            to.y = 5.0;
            to.theta = PI;
            for (const auto kind : {StateSpaceKind::Dubins, StateSpaceKind::DubinsSymmetric})
            {
                const auto space = spaceOf(kind, 2.5);
                const auto a = makeState(space, kind, from);
                const auto b = makeState(space, kind, to);
                EXPECT_NEAR(space->distance(a.get(), b.get()), 2.5 * PI, 1e-9) << "half a circle";
            }
        }

        TEST(ProblemSpace, AnglesOfAnySizeAreNormalised)
        {
            for (const auto kind : {StateSpaceKind::SE2, StateSpaceKind::ReedsShepp})
            {
                const auto space = spaceOf(kind);
                for (const double theta : {PI, -PI, 3.5 * PI, -1e6, 0.25})
                {
                    ConfigPose pose;
                    pose.theta = theta;
                    const auto state = makeState(space, kind, pose);
                    EXPECT_TRUE(space->satisfiesBounds(state.get())) << theta;
                    const double yaw = state->as<ob::SE2StateSpace::StateType>()->getYaw();
                    EXPECT_NEAR(std::cos(yaw), std::cos(theta), 1e-9);
                    EXPECT_NEAR(std::sin(yaw), std::sin(theta), 1e-9);
                }
            }
        }

        TEST(ProblemSpace, AxesOfAnyLengthGiveUnitQuaternions)
        {
            const auto space = spaceOf(StateSpaceKind::SE3);
            ConfigPose pose;
            pose.axis[0] = 0.0;
            pose.axis[1] = 20.0;
            pose.axis[2] = 0.0;
            pose.theta = PI / 2 + 4 * PI;
            const auto state = makeState(space, StateSpaceKind::SE3, pose);
            EXPECT_TRUE(space->satisfiesBounds(state.get()));
            const auto &rotation = state->as<ob::SE3StateSpace::StateType>()->rotation();
            EXPECT_NEAR(std::abs(rotation.y), std::sqrt(0.5), 1e-12);
            EXPECT_NEAR(std::abs(rotation.w), std::sqrt(0.5), 1e-12);
        }

        TEST(ProblemSpace, PositionsAreKeptEvenOutsideTheBounds)
        {
            const auto space = spaceOf(StateSpaceKind::SE2);
            ConfigPose pose;
            pose.x = 11.0;
            EXPECT_FALSE(space->satisfiesBounds(makeState(space, StateSpaceKind::SE2, pose).get()));
        }

        TEST(ProblemSpace, RotationWeightScalesTheRotationInTheDistance)
        {
            ProblemConfig problem;
            problem.space = StateSpaceKind::SE2;
            problem.rotationWeight = 3.0;
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0.0);
            bounds.setHigh(1.0);
            const auto space = makeStateSpace(problem, bounds);
            ConfigPose turned;
            turned.theta = 0.5;
            EXPECT_NEAR(space->distance(makeState(space, problem.space, {}).get(),
                                        makeState(space, problem.space, turned).get()),
                        1.5, 1e-12);
        }

        TEST(ProblemSpace, EverySpaceProjectsToItsPosition)
        {
            for (const auto kind : {StateSpaceKind::R2, StateSpaceKind::R3, StateSpaceKind::SE2, StateSpaceKind::SE3,
                                    StateSpaceKind::Dubins, StateSpaceKind::ReedsShepp})
            {
                const auto space = spaceOf(kind);
                auto si = std::make_shared<ob::SpaceInformation>(space);
                si->setStateValidityChecker([](const ob::State *) { return true; });
                si->setup();
                ConfigPose pose;
                pose.x = 1.0;
                pose.y = -2.0;
                pose.z = 3.0;
                const auto projection = space->getDefaultProjection();
                ASSERT_EQ(projection->getDimension(), positionDimension(kind));
                Eigen::VectorXd position(projection->getDimension());
                projection->project(makeState(space, kind, pose).get(), position);
                EXPECT_EQ(position[0], 1.0);
                EXPECT_EQ(position[1], -2.0);
            }
        }

        TEST(ProblemSpace, PosesAreDescribedByTheCoordinatesOfTheirSpace)
        {
            ConfigPose pose;
            pose.x = 1.5;
            pose.z = 3.0;
            pose.theta = 0.5;
            EXPECT_EQ(describePose(StateSpaceKind::R2, pose), "(1.5, 0)");
            EXPECT_EQ(describePose(StateSpaceKind::R3, pose), "(1.5, 0, 3)");
            EXPECT_EQ(describePose(StateSpaceKind::Dubins, pose), "(1.5, 0, theta 0.5)");
            EXPECT_EQ(describePose(StateSpaceKind::SE3, pose), "(1.5, 0, 3, theta 0.5)");
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
