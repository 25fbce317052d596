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

#include "engine/fireflies/GoalSearchPart.h"

#include <cstdint>
#include <memory>

#include <gtest/gtest.h>

#include "engine/SearchProblem.h"
#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        class GoalSearchPartTest : public ::testing::Test
        {
        protected:
            GoalSearchPartTest()
            {
                problem_->pdef->setGoal(
                    std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5));
                search_ = std::make_unique<test::SearchProblem>(problem_->pdef);
                part_ = std::make_unique<GoalSearchPart>(search_->context);
            }

            void begin()
            {
                ASSERT_EQ(search_->begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            /* Gives the part turns until there is a goal state. */
            bool find(int turns)
            {
                for (int i = 0; i < turns && findings_.goals.empty(); ++i)
                {
                    part_->advance(1000, findings_);
                }
                return !findings_.goals.empty();
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::unique_ptr<test::SearchProblem> search_;
            std::unique_ptr<GoalSearchPart> part_;
            Findings findings_{problem_->si->getStateSpace()};
        };

        TEST_F(GoalSearchPartTest, FindsValidStatesThatSatisfyTheGoal)
        {
            begin();
            ASSERT_TRUE(find(1000));
            for (std::size_t i = 0; i < findings_.goals.size(); ++i)
            {
                EXPECT_TRUE(problem_->pdef->getGoal()->isSatisfied(findings_.goals[i]));
                EXPECT_TRUE(problem_->si->isValid(findings_.goals[i]));
            }
            EXPECT_TRUE(findings_.paths.empty());
            EXPECT_TRUE(search_->goals().empty()) << "only the engine adds goals";
        }

        TEST_F(GoalSearchPartTest, CountsItsComparisonsAsWork)
        {
            begin();
            const std::uint64_t before = search_->evaluator().checks();
            part_->advance(1000, findings_);
            // a generation
            EXPECT_EQ(search_->evaluator().checks() - before, 30U);
        }

        TEST_F(GoalSearchPartTest, BeginsWithTheFirstStart)
        {
            EXPECT_EQ(part_->readiness(), Readiness::Idle);
            begin();
            EXPECT_EQ(part_->readiness(), Readiness::Ready);
        }

        TEST_F(GoalSearchPartTest, SearchesForAnotherStateEverMoreRarely)
        {
            begin();
            std::uint64_t pause = 0;
            for (int k = 0; k < 3; ++k)
            {
                ASSERT_TRUE(find(1000));
                search_->context.query.addGoal(findings_.goals.front());
                findings_.goals.clear();
                std::uint64_t waited = 0;
                for (; part_->readiness() == Readiness::Idle && waited < 100000; ++waited)
                {
                    search_->evaluator().addWork(1);
                }
                EXPECT_GT(waited, pause);
                EXPECT_LT(waited, 100000U);
                pause = waited;
            }
        }

        TEST_F(GoalSearchPartTest, StopsWithTheCondition)
        {
            begin();
            problem_->counted.forget();
            search_->evaluator().setStopCondition([] { return true; });
            EXPECT_FALSE(find(10));
            EXPECT_EQ(problem_->counted.states, 0U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
