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

#include "path/TreeStep.h"

#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        class TreeSteps : public ::testing::TestWithParam<bool>
        {
        protected:
            /* An invalid strip, 4 < x < 6, crosses the space. */
            TreeSteps()
              : problem_(test::dubinsSpace(false),
                         [](const ob::State *state)
                         {
                             const double x = state->as<ob::SE2StateSpace::StateType>()->getX();
                             return x <= 4.0 || x >= 6.0;
                         })
              , chart_(problem_.si->getStateSpace())
              , evaluator_(problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si))
              , step_{chart_, GetParam()}
              , near_(problem_.si->getStateSpace())
              , target_(problem_.si->getStateSpace())
              , state_(problem_.si->getStateSpace())
            {
            }

            static void place(ob::ScopedState<> &state, double x, double y, double yaw)
            {
                state[0] = x;
                state[1] = y;
                state[2] = yaw;
            }

            test::CountingProblem problem_;
            StateChart chart_;
            PathEvaluator evaluator_;
            TreeStep step_;
            ob::ScopedState<> near_;
            ob::ScopedState<> target_;
            ob::ScopedState<> state_;
        };

        TEST_P(TreeSteps, LieAtTheRangeOnTheMotionInTheDirectionOfTheTree)
        {
            place(near_, -6.0, 0.0, 0.4);
            place(target_, 1.0, 3.0, 2.0);
            const double distance = step_.distance(near_.get(), target_.get());
            EXPECT_NE(distance, TreeStep({chart_, !GetParam()}).distance(near_.get(), target_.get()));
            EXPECT_FALSE(step_.toward(near_.get(), target_.get(), distance, 2.0, state_.get()));
            EXPECT_NEAR(step_.distance(near_.get(), state_.get()), 2.0, 1e-6);
            EXPECT_NEAR(step_.distance(state_.get(), target_.get()), distance - 2.0, 1e-6);
        }

        TEST_P(TreeSteps, EndAtATargetWithinTheRange)
        {
            place(near_, -6.0, 0.0, 0.4);
            place(target_, -5.0, 0.3, 0.2);
            const double distance = step_.distance(near_.get(), target_.get());
            EXPECT_TRUE(step_.toward(near_.get(), target_.get(), distance, distance, state_.get()));
            EXPECT_EQ(state_, target_);
        }

        TEST_P(TreeSteps, AreClippedToTheBounds)
        {
            // the car begins at the right edge, facing it, and has to turn beyond it
            place(GetParam() ? near_ : target_, 9.9, 0.0, 0.0);
            place(GetParam() ? target_ : near_, 9.9, 0.5, 3.0);
            const double distance = step_.distance(near_.get(), target_.get());
            bool left = false;
            for (double range = 0.2; range < distance; range += 0.2)
            {
                EXPECT_FALSE(step_.toward(near_.get(), target_.get(), distance, range, state_.get()));
                EXPECT_TRUE(problem_.si->satisfiesBounds(state_.get()));
                left = left || state_[0] == 10.0;
            }
            EXPECT_TRUE(left);
        }

        TEST_P(TreeSteps, AreValidIfTheNewStateAndItsMotionAre)
        {
            place(near_, 0.0, 0.0, 0.0);
            place(state_, 3.0, 0.0, 0.0);
            if (!GetParam())
            {
                // motions lead toward the root
                near_[0] = 3.0;
                state_[0] = 0.0;
            }
            EXPECT_TRUE(step_.check(evaluator_, near_.get(), state_.get()));
            place(target_, 5.0, 0.0, 0.0);
            EXPECT_FALSE(step_.check(evaluator_, near_.get(), target_.get()));
            place(target_, 9.0, 0.0, 0.0);
            EXPECT_FALSE(step_.check(evaluator_, near_.get(), target_.get()));
        }

        INSTANTIATE_TEST_SUITE_P(Directions, TreeSteps, ::testing::Bool(),
                                 [](const auto &tested) { return tested.param ? "Forward" : "Backward"; });
    }  // namespace
}  // namespace ompl_mfa::path
