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

#include "benchmark/PositionTaskSpace.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

namespace ompl_mfa::benchmark
{
    namespace
    {
        namespace ob = ompl::base;

        ob::SpaceInformationPtr rigidBody()
        {
            auto space = std::make_shared<ob::SE3StateSpace>();
            ob::RealVectorBounds bounds(3);
            bounds.setLow(-1.0);
            bounds.setHigh(2.0);
            space->setBounds(bounds);
            return std::make_shared<ob::SpaceInformation>(space);
        }

        TEST(PositionTaskSpace, SamplesWithinTheBounds)
        {
            const PositionTaskSpace task(rigidBody());
            ASSERT_EQ(task.getDimension(), 3);
            Eigen::VectorXd position(3);
            Eigen::VectorXd lower = Eigen::VectorXd::Constant(3, 2.0);
            Eigen::VectorXd upper = Eigen::VectorXd::Constant(3, -1.0);
            for (int i = 0; i < 1000; ++i)
            {
                task.sample(position);
                lower = lower.cwiseMin(position);
                upper = upper.cwiseMax(position);
            }
            EXPECT_GE(lower.minCoeff(), -1.0);
            EXPECT_LE(upper.maxCoeff(), 2.0);
            EXPECT_LT(lower.maxCoeff(), -0.9);
            EXPECT_GT(upper.minCoeff(), 1.9);
        }

        TEST(PositionTaskSpace, LiftingAndProjectingIsTheIdentity)
        {
            const auto si = rigidBody();
            const PositionTaskSpace task(si);
            ob::ScopedState<ob::SE3StateSpace> state(si);
            Eigen::VectorXd back(3);
            Eigen::VectorXd position(3);
            position << 0.5, -0.25, 1.75;
            ASSERT_TRUE(task.lift(position, nullptr, state.get()));
            EXPECT_TRUE(si->satisfiesBounds(state.get())) << "the orientation is a unit quaternion";
            task.project(state.get(), back);
            EXPECT_EQ(back, position);
        }

        TEST(PositionTaskSpace, RefusesSpacesWithoutPosition)
        {
            const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SO2StateSpace>());
            EXPECT_THROW(PositionTaskSpace task(si), ompl::Exception);
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
