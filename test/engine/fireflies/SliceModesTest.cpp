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

#include "engine/fireflies/SliceModes.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Across the cube [-10, 10]^3 from (-8, 0, 0) to (8, 0, 0). */
        SliceFrame cubeFrame(unsigned int segments)
        {
            const ob::StateSpacePtr space = test::realVectorSpace(3);
            ob::ScopedState<> start(space);
            ob::ScopedState<> goal(space);
            start = std::vector<double>{-8.0, 0.0, 0.0};
            goal = std::vector<double>{8.0, 0.0, 0.0};
            return SliceFrame::straight(std::make_shared<const path::StateChart>(space), start.get(), goal.get(),
                                        segments);
        }

        TEST(SliceModesTest, TheFirstModeIsHalfASineWave)
        {
            const SliceFrame frame = cubeFrame(8);
            const SliceModes modes(frame);
            Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(frame.dimension());
            Eigen::VectorXd x(frame.dimension());
            amplitudes[0] = modes.upper()[0];
            modes.toCoordinates(amplitudes, x);
            for (std::size_t k = 0; k < frame.slices(); ++k)
            {
                const Eigen::Index first = frame.sliceRange(k).first;
                EXPECT_NEAR(x[first], 10.0 * std::sin(std::acos(-1.0) * static_cast<double>(k + 1) / 8.0), 1e-9);
                EXPECT_NEAR(x[first + 1], 0.0, 1e-9);
            }
        }

        TEST(SliceModesTest, HigherModesAreLower)
        {
            const SliceFrame frame = cubeFrame(8);
            const SliceModes modes(frame);
            for (Eigen::Index k = 0; k < 7; ++k)
            {
                EXPECT_NEAR(modes.upper()[2 * k], modes.upper()[0] / static_cast<double>(k + 1), 1e-12);
                EXPECT_EQ(modes.lower()[2 * k], -modes.upper()[2 * k]);
            }
        }

        TEST(SliceModesTest, AmplitudesAndCoordinatesAreInverse)
        {
            const SliceFrame frame = cubeFrame(12);
            const SliceModes modes(frame);
            const Eigen::VectorXd x = 0.5 * Eigen::VectorXd::Random(frame.dimension()).cwiseProduct(frame.upper());
            Eigen::VectorXd amplitudes(frame.dimension());
            Eigen::VectorXd again(frame.dimension());
            modes.toAmplitudes(x, amplitudes);
            EXPECT_NEAR(amplitudes.norm(), x.norm(), 1e-9);
            modes.toCoordinates(amplitudes, again);
            EXPECT_TRUE(again.isApprox(x, 1e-9));
        }

        TEST(SliceModesTest, CoordinatesOfAFewSlicesAreThoseOfAll)
        {
            for (const unsigned int segments : {12U, 801U})
            {
                const SliceFrame frame = cubeFrame(segments);
                const SliceModes modes(frame);
                const std::size_t atOnce = modes.slicesAtOnce();
                EXPECT_EQ(atOnce >= frame.slices(), segments == 12);
                EXPECT_GE(atOnce, 1U);
                const Eigen::VectorXd amplitudes =
                    Eigen::VectorXd::Random(frame.dimension()).cwiseProduct(modes.upper());
                Eigen::VectorXd whole(frame.dimension());
                Eigen::VectorXd parts = Eigen::VectorXd::Constant(frame.dimension(), std::nan(""));
                modes.toCoordinates(amplitudes, whole);
                const std::size_t few = std::max<std::size_t>(1, frame.slices() / 5);
                for (std::size_t k = 0; k < frame.slices(); k += few)
                {
                    modes.toCoordinates(amplitudes, k, std::min(few, frame.slices() - k), parts);
                }
                EXPECT_TRUE(parts.isApprox(whole, 1e-12));
            }
        }

        TEST(SliceModesTest, CoordinatesKeepToTheFrame)
        {
            const SliceFrame frame = cubeFrame(6);
            const SliceModes modes(frame);
            Eigen::VectorXd x(frame.dimension());
            modes.toCoordinates(modes.upper(), x);
            EXPECT_TRUE((x.array() <= frame.upper().array()).all());
            EXPECT_TRUE((x.array() >= frame.lower().array()).all());
        }

        TEST(SliceModesTest, ExistWhereAllSlicesHaveTheSameCoordinates)
        {
            EXPECT_TRUE(SliceModes::exist(cubeFrame(4)));
            EXPECT_FALSE(SliceModes::exist(cubeFrame(1)));
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
