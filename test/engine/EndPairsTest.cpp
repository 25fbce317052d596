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

#include "engine/EndPairs.h"

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/SearchProblem.h"
#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        using Pair = std::pair<std::size_t, std::size_t>;

        /* A query with one start; further starts and goals are added one by one. */
        class GrowingQuery
        {
        public:
            GrowingQuery()
            {
                problem_->pdef->setGoal(
                    std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 5.0}).get(), 4.0));
                search_ = std::make_unique<test::SearchProblem>(problem_->pdef);
                search_->begin();
            }

            void addStart()
            {
                const double y = 1.0 + 0.01 * static_cast<double>(query().starts().size());
                problem_->pdef->addStartState(problem_->state({1.0, y}));
                search_->context.query.poll(search_->inputs);
            }

            void addGoal()
            {
                const double y = 2.0 + 0.01 * static_cast<double>(query().goals().size());
                search_->context.query.addGoal(problem_->state({9.0, y}).get());
            }

            const Query &query() const
            {
                return search_->context.query;
            }

        private:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::unique_ptr<test::SearchProblem> search_;
        };

        TEST(EndPairs, ThereAreNoneWithoutAGoal)
        {
            const GrowingQuery growing;
            EndPairs pairs;
            EXPECT_EQ(pairs.next(growing.query()), std::nullopt);
        }

        TEST(EndPairs, EachIsReturnedOnceAsItBecomesKnown)
        {
            GrowingQuery growing;
            EndPairs pairs;
            growing.addGoal();
            EXPECT_EQ(pairs.next(growing.query()), Pair(0, 0));
            EXPECT_EQ(pairs.next(growing.query()), std::nullopt);
            growing.addGoal();
            growing.addStart();
            ASSERT_EQ(growing.query().starts().size(), 2U);
            std::set<Pair> further;
            while (const auto pair = pairs.next(growing.query()))
            {
                EXPECT_TRUE(further.insert(*pair).second);
            }
            EXPECT_EQ(further, (std::set<Pair>{{0, 1}, {1, 0}, {1, 1}}));
        }

        TEST(EndPairs, OneThatWasPutBackIsReturnedAgain)
        {
            GrowingQuery growing;
            EndPairs pairs;
            growing.addGoal();
            growing.addStart();
            pairs.next(growing.query());
            const auto second = pairs.next(growing.query());
            pairs.putBack();
            EXPECT_EQ(pairs.next(growing.query()), second);
            EXPECT_EQ(pairs.next(growing.query()), std::nullopt);
            pairs.putBack();
            EXPECT_EQ(pairs.next(growing.query()), second);
        }

        RC_GTEST_PROP(EndPairs, HoldsHoweverStartsAndGoalsArrive, ())
        {
            GrowingQuery growing;
            EndPairs pairs;
            std::multiset<Pair> returned;
            for (const int step : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6)))
            {
                if (step == 0)
                {
                    growing.addStart();
                }
                else if (step == 1)
                {
                    growing.addGoal();
                }
                else if (const auto pair = pairs.next(growing.query()))
                {
                    if (step == 2)
                    {
                        pairs.putBack();
                    }
                    else
                    {
                        returned.insert(*pair);
                    }
                }
            }
            while (const auto pair = pairs.next(growing.query()))
            {
                returned.insert(*pair);
            }
            std::multiset<Pair> all;
            for (std::size_t i = 0; i < growing.query().starts().size(); ++i)
            {
                for (std::size_t j = 0; j < growing.query().goals().size(); ++j)
                {
                    all.emplace(i, j);
                }
            }
            RC_ASSERT(returned == all);
        }
    }  // namespace
}  // namespace ompl_mfa::engine
