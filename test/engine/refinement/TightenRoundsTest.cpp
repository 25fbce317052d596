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

#include "engine/refinement/TightenRounds.h"

#include <cstdint>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        class TightenRoundsTest : public ::testing::Test
        {
        protected:
            /* Tightens a path over the wall and returns its cost. */
            double tighten(double rival, bool untilBetter)
            {
                tightening_.begin(detour_);
                const auto before = evaluator_.work();
                const ob::Cost cost =
                    tightenRounds(tightening_, evaluator_, ob::Cost(detour_.length()), ob::Cost(rival), untilBetter);
                work_ = evaluator_.work() - before;
                EXPECT_DOUBLE_EQ(cost.value(), tightening_.cost().value());
                EXPECT_TRUE(evaluator_.interrupted() || evaluator_.checkPath(tightening_.path()));
                return cost.value();
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            path::PathEvaluator evaluator_{problem_->si,
                                           std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si)};
            PathTightening tightening_{std::make_shared<const path::StateChart>(problem_->si->getStateSpace()),
                                       evaluator_, 3};
            path::Waypoints detour_ =
                test::planarPath(problem_->si->getStateSpace(),
                                 {{1.0, 1.0}, {2.0, 5.0}, {3.0, 8.5}, {7.0, 8.5}, {8.0, 4.0}, {9.0, 1.0}});
            std::uint64_t work_{0};
        };

        TEST_F(TightenRoundsTest, GoOnAsLongAsTheyGain)
        {
            EXPECT_LT(tighten(std::numeric_limits<double>::infinity(), false), 0.8 * detour_.length());
            // at least four rounds of three checks
            EXPECT_GT(work_, 10 * evaluator_.checkWork(detour_));
            // at most eight
            EXPECT_LT(work_, 36 * evaluator_.checkWork(detour_));
        }

        TEST_F(TightenRoundsTest, EndOnceThePathIsBetterThanItsRival)
        {
            tighten(std::numeric_limits<double>::infinity(), false);
            const std::uint64_t all = work_;
            const double rival = 0.97 * detour_.length();
            EXPECT_LT(tighten(rival, true), rival);
            EXPECT_LT(2 * work_, all);
            // unless the best is wanted
            EXPECT_LT(tighten(rival, false), 0.8 * detour_.length());
        }

        TEST_F(TightenRoundsTest, EndWhereTheyCannotBeatTheRival)
        {
            tighten(std::numeric_limits<double>::infinity(), false);
            const std::uint64_t all = work_;
            EXPECT_GT(tighten(0.1, false), 0.1);
            EXPECT_LT(work_, all);
        }

        TEST_F(TightenRoundsTest, DoNotBeginIfInterrupted)
        {
            evaluator_.setStopCondition([] { return true; });
            tightening_.begin(detour_);
            problem_->counted.forget();
            const ob::Cost cost =
                tightenRounds(tightening_, evaluator_, ob::Cost(detour_.length()), ob::Cost(0.1), false);
            EXPECT_EQ(cost.value(), detour_.length());
            EXPECT_EQ(problem_->counted.states, 0U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
