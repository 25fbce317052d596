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

/* Checks of motions at a finer resolution than OMPL's. */

#include "path/FineChecks.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/RandomNumbers.h>

#include "path/CountingProblem.h"
#include "path/PathEvaluator.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::path
{
    namespace
    {
        constexpr unsigned int FACTOR = 8;

        double abscissa(const ob::State *state)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[0];
        }

        /* The plane [-10, 10]^2 with a wall across it. The motion from (0, 0) to (10, 0) has 20 segments of 0.5. */
        class FineChecksTest : public ::testing::Test
        {
        protected:
            FineChecksTest()
            {
                space_->setLongestValidSegmentFraction(0.5 / space_->getMaximumExtent());
                space_->setup();
                problem_.forget();
            }

            PathEvaluator evaluator(unsigned int threads = 1) const
            {
                return PathEvaluator(problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si),
                                     threads);
            }

            bool check(PathEvaluator &evaluator) const
            {
                return evaluator.checkMotion(motion_[0], motion_[1]);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            double wall_{-9.0};  ///< a wall 0.02 wide
            test::CountingProblem problem_{
                space_, [this](const ob::State *state) { return std::abs(abscissa(state) - wall_) > 0.01; }};
            Waypoints motion_ = test::planarPath(space_, {{0, 0}, {10, 0}});
        };

        TEST_F(FineChecksTest, AValidMotionIsCheckedAtAllStatesOnce)
        {
            PathEvaluator fine = evaluator();
            ASSERT_EQ(space_->validSegmentCount(motion_[0], motion_[1]), 20U);
            EXPECT_TRUE(check(fine));
            EXPECT_EQ(problem_.states, 20U);
            fine.setFineness(FACTOR);
            EXPECT_EQ(fine.checkedSegments(motion_[0], motion_[1]), 20 * FACTOR);
            problem_.forget();
            const auto before = fine.work();
            EXPECT_TRUE(check(fine));
            EXPECT_EQ(problem_.states, 20 * FACTOR);
            EXPECT_EQ(fine.work() - before, 20 * FACTOR);
            EXPECT_EQ(fine.failedState(), 0U);
            // what is known at OMPL's resolution is not checked again
            problem_.forget();
            EXPECT_TRUE(fine.checkFinely(motion_[0], motion_[1]));
            EXPECT_EQ(problem_.states, 20 * (FACTOR - 1));
        }

        TEST_F(FineChecksTest, FindsAWallAnywhereBetweenTheStates)
        {
            PathEvaluator fine = evaluator();
            for (unsigned int number = 1; number < 20 * FACTOR; ++number)
            {
                wall_ = 10.0 * number / (20 * FACTOR);
                fine.setFineness(1);
                EXPECT_EQ(check(fine), number % FACTOR != 0) << number;
                fine.setFineness(FACTOR);
                EXPECT_FALSE(check(fine)) << number;
                EXPECT_EQ(fine.failedState(), number % FACTOR != 0 ? number : 0);
            }
            wall_ = 10.0 / (20 * FACTOR) * 77.5;
            EXPECT_TRUE(check(fine)) << "the wall is between the states of the finer resolution";
        }

        TEST_F(FineChecksTest, TheStatesNearTheEndsComeFirstOrAreTheOnlyOnes)
        {
            PathEvaluator fine = evaluator();
            fine.setFineness(FACTOR);
            for (const double wall : {0.3125, 9.6875})
            {
                wall_ = wall;
                problem_.forget();
                EXPECT_FALSE(check(fine)) << wall;
                EXPECT_LE(problem_.states, 20 + 2 * (FACTOR - 1)) << wall;
            }
            fine.setFineness(FACTOR, true);
            EXPECT_FALSE(check(fine));
            wall_ = 5.3125;
            problem_.forget();
            EXPECT_TRUE(check(fine));
            EXPECT_EQ(problem_.states, 20 + 2 * (FACTOR - 1));
            fine.setFineness(FACTOR);
            EXPECT_FALSE(check(fine));
        }

        TEST_F(FineChecksTest, AShortMotionHasOneSegment)
        {
            const Waypoints shortMotion = test::planarPath(space_, {{0, 0}, {0.4, 0}});
            PathEvaluator fine = evaluator();
            for (const bool endsOnly : {false, true})
            {
                fine.setFineness(FACTOR, endsOnly);
                problem_.forget();
                EXPECT_TRUE(fine.checkMotion(shortMotion[0], shortMotion[1]));
                EXPECT_EQ(problem_.states, FACTOR);
            }
        }

        TEST_F(FineChecksTest, AScopeRestoresTheFineness)
        {
            PathEvaluator fine = evaluator();
            fine.setFineness(3, true);
            {
                const FinenessScope scope(fine, FACTOR, false);
                EXPECT_EQ(fine.fineness(), FACTOR);
                EXPECT_FALSE(fine.finenessEndsOnly());
            }
            EXPECT_EQ(fine.fineness(), 3U);
            EXPECT_TRUE(fine.finenessEndsOnly());
        }

        TEST_F(FineChecksTest, StopsWhereTheStopConditionHolds)
        {
            PathEvaluator fine = evaluator();
            fine.setFineness(64);
            unsigned int asked = 0;
            fine.setStopCondition([&asked] { return ++asked > 3; });
            EXPECT_FALSE(check(fine));
            EXPECT_TRUE(fine.interrupted());
            EXPECT_LT(problem_.states, 20U * 64U);
        }

        TEST_F(FineChecksTest, SeveralThreadsFindTheSame)
        {
            PathEvaluator alone = evaluator();
            PathEvaluator together = evaluator(3);
            alone.setFineness(FACTOR);
            together.setFineness(FACTOR);
            for (wall_ = 0.05; wall_ < 11.0; wall_ += 0.111)
            {
                EXPECT_EQ(check(alone), check(together)) << wall_;
                EXPECT_EQ(alone.failedState(), together.failedState()) << wall_;
                EXPECT_EQ(alone.work(), together.work()) << wall_;
            }
        }

        TEST_F(FineChecksTest, PathsAreCheckedAsByOmplWithAGreaterFactor)
        {
            ompl::RNG rng(3);
            unsigned int valid = 0;
            for (int k = 0; k < 200; ++k)
            {
                wall_ = rng.uniformReal(0.0, 10.0);
                og::PathGeometric path(problem_.si);
                const Waypoints points = test::planarPath(
                    space_, {{0, 0}, {rng.uniformReal(4, 6), rng.uniformReal(-9, 9)}, {10, rng.uniformReal(-9, 9)}});
                for (const ob::State *state : points.pointers())
                {
                    path.append(state);
                }
                if (!path.check())
                {
                    continue;
                }
                const bool ours = isValidAt(*problem_.si, path.getStates(), FACTOR);
                space_->setValidSegmentCountFactor(FACTOR);
                EXPECT_EQ(ours, path.check()) << k;
                space_->setValidSegmentCountFactor(1);
                valid += ours ? 1 : 0;
                EXPECT_TRUE(isValidAt(*problem_.si, path.getStates(), 1));
            }
            EXPECT_GT(valid, 10U);
            EXPECT_LT(valid, 190U);
        }

        /* Accepts every motion. */
        class Continuous : public ob::MotionValidator
        {
        public:
            using ob::MotionValidator::MotionValidator;

            bool checkMotion(const ob::State * /*from*/, const ob::State * /*to*/) const override
            {
                return true;
            }

            bool checkMotion(const ob::State *from, const ob::State *to,
                             std::pair<ob::State *, double> & /*lastValid*/) const override
            {
                return checkMotion(from, to);
            }
        };

        TEST_F(FineChecksTest, AContinuousMotionValidatorIsTrusted)
        {
            EXPECT_TRUE(hasDiscreteMotionChecks(*problem_.si));
            problem_.si->setMotionValidator(std::make_shared<Continuous>(problem_.si));
            problem_.si->setup();
            EXPECT_FALSE(hasDiscreteMotionChecks(*problem_.si));
            wall_ = 5.0;
            PathEvaluator fine = evaluator();
            fine.setFineness(FACTOR);
            EXPECT_EQ(fine.fineness(), 1U);
            problem_.forget();
            EXPECT_TRUE(check(fine));
            EXPECT_TRUE(isValidAt(*problem_.si, {motion_[0], motion_[1]}, FACTOR));
            EXPECT_EQ(problem_.states, 0U);
        }
    }  // namespace
}  // namespace ompl_mfa::path
