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

#include "engine/refinement/StrictAnswer.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/SearchProblem.h"
#include "path/FineChecks.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        constexpr unsigned int STRICTNESS = 8;

        using Points = std::vector<std::pair<double, double>>;

        SearchSettings settingsWith(unsigned int strictness)
        {
            SearchSettings settings;
            settings.strictness = strictness;
            return settings;
        }

        /* The square [0, 10]^2, checked every 0.2, with a needle between two of these states. */
        class StrictAnswerTest : public ::testing::Test
        {
        protected:
            explicit StrictAnswerTest(unsigned int strictness = STRICTNESS)
            {
                problem_.si->getStateSpace()->setLongestValidSegmentFraction(
                    0.2 / problem_.si->getStateSpace()->getMaximumExtent());
                problem_.si->setup();
                search_ = std::make_unique<test::SearchProblem>(problem_.pdef, 5, settingsWith(strictness));
                search_->begin();
                strict_ = std::make_unique<StrictAnswer>(search_->context);
            }

            /* Makes a path the incumbent; its cost is its length. */
            void offer(const Points &points)
            {
                const path::Waypoints path = test::planarPath(problem_.si->getStateSpace(), points);
                ASSERT_TRUE(search_->evaluator().checkPath(path));
                ASSERT_TRUE(incumbent().offer(path, path.length()));
            }

            /* As if the search had worked otherwise. */
            void work(std::uint64_t units)
            {
                search_->evaluator().addWork(units);
            }

            std::uint64_t updated(bool demanded = false)
            {
                const std::uint64_t before = search_->evaluator().work();
                strict_->update(demanded);
                return search_->evaluator().work() - before;
            }

            Incumbent &incumbent()
            {
                return search_->context.incumbent;
            }

            const Incumbent &answer() const
            {
                return search_->context.answer;
            }

            bool answerHolds() const
            {
                std::vector<ob::State *> states;
                for (const ob::State *state : answer().path().pointers())
                {
                    states.push_back(const_cast<ob::State *>(state));
                }
                return path::isValidAt(*problem_.si, states, STRICTNESS);
            }

            double needle_{5.1};        ///< its abscissa
            double needleTop_{5.05};    ///< ordinate of its upper end
            double needleBottom_{4.9};  ///< and of its lower one
            test::PlanningProblem problem_{test::realVectorSpace(2, 0.0, 10.0),
                                           [this](const ob::State *state)
                                           {
                                               const double y = test::coordinate(state, 1);
                                               return std::abs(test::coordinate(state, 0) - needle_) > 0.03 ||
                                                      y < needleBottom_ || y > needleTop_;
                                           },
                                           {1.0, 5.0},
                                           {9.0, 5.0}};
            std::unique_ptr<test::SearchProblem> search_;
            std::unique_ptr<StrictAnswer> strict_;
        };

        const Points OVER_THE_NEEDLE{{1, 5}, {3, 5}, {7, 5}, {9, 5}};
        const Points FAR_FROM_IT{{1, 5}, {3, 7}, {7, 7}, {9, 5}};

        TEST_F(StrictAnswerTest, WithoutAPathThereIsNone)
        {
            EXPECT_EQ(updated(true), 0U);
            strict_->giveUp();
            EXPECT_FALSE(answer().hasPath());
        }

        TEST_F(StrictAnswerTest, ADemandedAnswerHoldsAtTheFinerResolution)
        {
            offer(OVER_THE_NEEDLE);
            updated(true);
            ASSERT_TRUE(answer().hasPath());
            EXPECT_TRUE(strict_->isStrict());
            EXPECT_TRUE(answerHolds());
            EXPECT_GT(answer().path().size(), 4U);
            EXPECT_DOUBLE_EQ(answer().cost(), answer().path().length());
            EXPECT_GT(answer().cost(), 8.0);
            EXPECT_LT(answer().cost(), 8.1);
        }

        TEST_F(StrictAnswerTest, WhatIsKnownIsNotCheckedAgain)
        {
            offer(FAR_FROM_IT);
            const std::uint64_t first = updated(true);
            EXPECT_TRUE(strict_->isStrict());
            EXPECT_EQ(updated(true), 0U) << "the same path";
            offer({{1, 5}, {3, 7}, {7, 6.9}, {9, 5}});
            EXPECT_LT(updated(true), first) << "one of its motions is the same";
            EXPECT_TRUE(strict_->isStrict());
        }

        TEST_F(StrictAnswerTest, CornersAreCheckedAtOnceAndTheRestWhenTheWorkAllows)
        {
            offer(OVER_THE_NEEDLE);
            updated();
            ASSERT_TRUE(answer().hasPath());
            EXPECT_FALSE(strict_->isStrict());
            EXPECT_FALSE(answerHolds()) << "the needle is in the middle of a motion";
            EXPECT_EQ(answer().path().size(), 4U);
            EXPECT_EQ(updated(), 0U) << "there is nothing new, and little work was done";
            work(1000000);
            EXPECT_GT(updated(), 20U * (STRICTNESS - 1)) << "all states of the path";
        }

        TEST_F(StrictAnswerTest, ANeedleAtACornerIsFoundAtOnce)
        {
            needle_ = 3.1;
            offer(OVER_THE_NEEDLE);
            updated();
            ASSERT_TRUE(answer().hasPath());
            EXPECT_TRUE(answerHolds());
            EXPECT_GT(answer().path().size(), 4U);
        }

        TEST_F(StrictAnswerTest, ChecksTakeASmallShareOfTheWork)
        {
            offer({{1, 5}, {3, 9}, {7, 9}, {9, 5}});
            std::uint64_t spent = updated();
            std::uint64_t total = search_->evaluator().work();
            double top = 9.0;
            unsigned int strict = 0;
            for (unsigned int k = 0; k < 4000; ++k)
            {
                work(400);
                top -= 0.0005;
                offer({{1, 5}, {3, top}, {7, top}, {9, 5}});
                spent += updated();
                total = search_->evaluator().work();
                strict += strict_->isStrict() ? 1 : 0;
                EXPECT_LE(static_cast<double>(spent), 0.2 * static_cast<double>(total) + 1000.0) << k;
            }
            EXPECT_GT(strict, 2000U);
            EXPECT_LE(static_cast<double>(spent), 0.05 * static_cast<double>(total));
            EXPECT_LT(answer().cost() / incumbent().cost(), 1.01);
        }

        TEST_F(StrictAnswerTest, WithoutAStrictPathTheIncumbentIsReturnedInTheEnd)
        {
            needleTop_ = 20.0;
            needleBottom_ = -1.0;
            offer(OVER_THE_NEEDLE);
            for (unsigned int k = 0; k < 10; ++k)
            {
                updated(true);
                EXPECT_FALSE(strict_->isStrict());
            }
            EXPECT_EQ(updated(true), 0U) << "a few attempts are enough";
            EXPECT_FALSE(answer().hasPath());
            strict_->giveUp();
            ASSERT_TRUE(answer().hasPath());
            EXPECT_EQ(answer().cost(), incumbent().cost());
            EXPECT_FALSE(strict_->isStrict());
        }

        TEST_F(StrictAnswerTest, WithoutAStrictPathTheIncumbentIsReturnedAfterLongWork)
        {
            needle_ = 3.1;
            needleTop_ = 20.0;
            needleBottom_ = -1.0;
            offer(OVER_THE_NEEDLE);
            for (unsigned int k = 0; k < 1000 && !answer().hasPath(); ++k)
            {
                work(400);
                updated();
            }
            ASSERT_TRUE(answer().hasPath());
            EXPECT_FALSE(strict_->isStrict());
        }

        TEST_F(StrictAnswerTest, WhereTheBestPathCannotHoldAStrictOneIsTightened)
        {
            // nothing passes the needle below y = 8 except between the states
            needleTop_ = 8.0;
            needleBottom_ = -1.0;
            offer({{1, 5}, {3, 9.5}, {7, 9.5}, {9, 5}});
            updated(true);
            ASSERT_TRUE(strict_->isStrict());
            const double before = answer().cost();
            offer(OVER_THE_NEEDLE);
            for (unsigned int k = 0; k < 500; ++k)
            {
                work(8000);
                updated();
            }
            EXPECT_TRUE(strict_->isStrict());
            EXPECT_TRUE(answerHolds());
            // over the upper end of the needle
            EXPECT_LT(answer().cost(), 1.01 * 2.0 * std::hypot(4.0, 3.0));
            EXPECT_GT(before, 13.0);
        }

        class WithoutStrictness : public StrictAnswerTest
        {
        protected:
            WithoutStrictness()
              : StrictAnswerTest(1)
            {
            }
        };

        TEST_F(WithoutStrictness, TheAnswerIsTheIncumbent)
        {
            EXPECT_FALSE(strict_->isActive());
            offer(OVER_THE_NEEDLE);
            EXPECT_EQ(updated(), 0U);
            EXPECT_EQ(answer().cost(), incumbent().cost());
            EXPECT_FALSE(strict_->isStrict());
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
