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

#include "ompl_mfa/collision/StatePlacement.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>

#include "collision/TestFiles.h"

namespace ob = ompl::base;

namespace ompl_mfa::collision
{
    namespace
    {
        ob::StateSpacePtr realVector(unsigned int dimension)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(dimension);
            space->setBounds(-5., 5.);
            return space;
        }

        template <typename Space>
        ob::StateSpacePtr rigid(unsigned int dimension)
        {
            auto space = std::make_shared<Space>();
            ob::RealVectorBounds bounds(dimension);
            bounds.setLow(-5.);
            bounds.setHigh(5.);
            space->setBounds(bounds);
            return space;
        }

        // Unlike the operator + of state spaces this keeps nested compounds.
        ob::StateSpacePtr compound(const std::vector<ob::StateSpacePtr> &parts)
        {
            auto space = std::make_shared<ob::CompoundStateSpace>();
            for (const ob::StateSpacePtr &part : parts)
            {
                space->addSubspace(part, 1.);
            }
            return space;
        }

        TEST(StatePlacement, PutsBodiesWhereTheStateSays)
        {
            const ob::StateSpacePtr space = compound({realVector(2), realVector(3), rigid<ob::SE2StateSpace>(2),
                                                      compound({rigid<ob::SE3StateSpace>(3), realVector(2)})});
            const StatePlacement placement(space);
            ASSERT_EQ(placement.bodyCount(), 5U);
            ob::ScopedState<> state(space);
            auto *parts = state->as<ob::CompoundState>();
            parts->as<ob::RealVectorStateSpace::StateType>(0)->values[0] = 1.;
            parts->as<ob::RealVectorStateSpace::StateType>(0)->values[1] = 2.;
            parts->as<ob::RealVectorStateSpace::StateType>(1)->values[2] = 3.;
            parts->as<ob::SE2StateSpace::StateType>(2)->setXY(4., 5.);
            parts->as<ob::SE2StateSpace::StateType>(2)->setYaw(M_PI / 2.);
            auto *nested = parts->as<ob::CompoundState>(3);
            nested->as<ob::SE3StateSpace::StateType>(0)->setXYZ(-1., -2., -3.);
            nested->as<ob::SE3StateSpace::StateType>(0)->rotation().setAxisAngle(0., 1., 0., M_PI / 2.);
            nested->as<ob::RealVectorStateSpace::StateType>(1)->values[0] = 4.5;

            fcl::Transform3d pose;
            placement.place(state.get(), 0, pose);
            EXPECT_EQ(pose.translation(), fcl::Vector3d(1., 2., 0.));
            EXPECT_TRUE(pose.linear().isIdentity());
            placement.place(state.get(), 1, pose);
            EXPECT_EQ(pose.translation().z(), 3.);
            placement.place(state.get(), 2, pose);
            EXPECT_EQ(pose.translation(), fcl::Vector3d(4., 5., 0.));
            EXPECT_TRUE((pose.linear() * fcl::Vector3d::UnitX()).isApprox(fcl::Vector3d::UnitY()));
            placement.place(state.get(), 3, pose);
            EXPECT_EQ(pose.translation(), fcl::Vector3d(-1., -2., -3.));
            EXPECT_TRUE((pose.linear() * fcl::Vector3d::UnitX()).isApprox(-fcl::Vector3d::UnitZ()));
            placement.place(state.get(), 4, pose);
            EXPECT_EQ(pose.translation().x(), 4.5);
        }

        TEST(StatePlacement, MotionFollowsTheInterpolationOfTheSpace)
        {
            const ob::StateSpacePtr space =
                compound({rigid<ob::SE2StateSpace>(2), rigid<ob::SE3StateSpace>(3), realVector(3)});
            space->setup();
            const StatePlacement placement(space);
            EXPECT_TRUE(placement.interpolatesStraight());
            const ob::StateSamplerPtr sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> from(space);
            ob::ScopedState<> to(space);
            ob::ScopedState<> between(space);
            for (int i = 0; i < 500; ++i)
            {
                sampler->sampleUniform(from.get());
                sampler->sampleUniform(to.get());
                const double share = (i % 21) / 20.;
                space->interpolate(from.get(), to.get(), share, between.get());
                space->enforceBounds(between.get());
                for (std::size_t body = 0; body < 3; ++body)
                {
                    fcl::Transform3d expected;
                    fcl::Transform3d pose;
                    placement.place(between.get(), body, expected);
                    placement.motion(from.get(), to.get(), body).place(share, pose);
                    EXPECT_TRUE(pose.isApprox(expected, 1e-9)) << "body " << body << " at " << share;
                }
            }
        }

        TEST(StatePlacement, KnowsCurvedSpaces)
        {
            const auto space = std::make_shared<ob::DubinsStateSpace>();
            EXPECT_FALSE(StatePlacement(space).interpolatesStraight());
            EXPECT_FALSE(StatePlacement(compound({realVector(2), space})).interpolatesStraight());
        }

        TEST(StatePlacement, RefusesSpacesThatPlaceNoBody)
        {
            for (const unsigned int dimension : {1U, 4U, 7U})
            {
                expectInputError([dimension] { StatePlacement placement(realVector(dimension)); }, "dimension",
                                 std::to_string(dimension), "R^2, R^3, SE(2), SE(3)");
            }
            expectInputError([] { StatePlacement placement(std::make_shared<ob::SO3StateSpace>()); }, "SO3");
            expectInputError(
                []
                {
                    const ob::StateSpacePtr time = std::make_shared<ob::TimeStateSpace>();
                    const StatePlacement placement(compound({realVector(2), time}));
                },
                "does not place a rigid body");
            expectInputError([] { StatePlacement placement(std::make_shared<ob::CompoundStateSpace>()); },
                             "does not place a rigid body");
        }
    }  // namespace
}  // namespace ompl_mfa::collision
