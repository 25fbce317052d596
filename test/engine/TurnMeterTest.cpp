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

#include "engine/TurnMeter.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        using namespace std::chrono_literals;

        class TurnMeterTest : public ::testing::Test
        {
        protected:
            test::CountingProblem problem_{test::realVectorSpace(2), [](const ob::State *)
                                           {
                                               std::this_thread::sleep_for(1ms);
                                               return true;
                                           }};
            path::PathEvaluator evaluator_{problem_.si,
                                           std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
        };

        TEST_F(TurnMeterTest, AClockSeesACheckerThatWaits)
        {
            const TurnMeter meter(evaluator_, 0.0);
            ob::ScopedState<> state(problem_.si);
            state = std::vector<double>{1.0, 2.0};
            for (unsigned int i = 0; i < 20; ++i)
            {
                evaluator_.checkState(state.get());
            }
            EXPECT_GE(meter.spent(), 0.02);
        }

        TEST_F(TurnMeterTest, CountedWorkHasTheDeclaredPrice)
        {
            const TurnMeter meter(evaluator_, 3.0);
            ob::ScopedState<> state(problem_.si);
            state = std::vector<double>{1.0, 2.0};
            EXPECT_GT(meter.spent(), 0.0);
            EXPECT_LT(meter.spent(), 1e-5);
            for (unsigned int i = 0; i < 4; ++i)
            {
                evaluator_.checkState(state.get());
            }
            EXPECT_NEAR(meter.spent(), 12.0, 1e-5);
            evaluator_.addWork(1000000);
            EXPECT_NEAR(meter.spent(), 12.1, 1e-5);
            evaluator_.addChecks(2);
            EXPECT_NEAR(meter.spent(), 18.1, 1e-5);
            evaluator_.addDistances(1000000);
            EXPECT_NEAR(meter.spent(), 18.1 + 1e6 * distanceTime(*problem_.si->getStateSpace()), 1e-5);
        }

        TEST_F(TurnMeterTest, NeighboursTakeMoreDistancesTheMoreStatesAndDimensionsThereAre)
        {
            EXPECT_EQ(neighbourDistances(*test::realVectorSpace(2), 0), 0U);
            EXPECT_LE(neighbourDistances(*test::realVectorSpace(16), 1000), 1000U);
            EXPECT_LT(neighbourDistances(*test::realVectorSpace(2), 1000),
                      neighbourDistances(*test::realVectorSpace(4), 1000));
            EXPECT_LT(neighbourDistances(*test::realVectorSpace(2), 1000),
                      neighbourDistances(*test::realVectorSpace(2), 2000));
            EXPECT_GE(neighbourDistances(ob::DubinsStateSpace(), 1000), 1000U);
        }

        TEST_F(TurnMeterTest, DistancesOfCarsTakeLongest)
        {
            const double plane = distanceTime(*test::realVectorSpace(2));
            EXPECT_GT(plane, 0.0);
            EXPECT_GT(distanceTime(*test::realVectorSpace(16)), plane);
            const double pose = distanceTime(ob::SE2StateSpace());
            EXPECT_GT(pose, plane);
            EXPECT_GT(distanceTime(ob::SE3StateSpace()), pose);
            EXPECT_GT(distanceTime(ob::DubinsStateSpace()), 5.0 * pose);
            EXPECT_GT(distanceTime(ob::ReedsSheppStateSpace()), 5.0 * distanceTime(ob::DubinsStateSpace()));
        }
    }  // namespace
}  // namespace ompl_mfa::engine
