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

#include "engine/PathPool.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/PathWalk.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        constexpr std::size_t CAPACITY = 3;

        class PathPoolTest : public ::testing::Test
        {
        protected:
            /* A path of three states and length 10 or slightly more. */
            path::Waypoints tent(double height) const
            {
                return test::planarPath(space_, {{0.0, 0.0}, {5.0, height}, {10.0, 0.0}});
            }

            static void expectCosts(const PathPool &pool, const std::multiset<double> &costs)
            {
                std::multiset<double> kept;
                for (std::size_t i = 0; i < pool.size(); ++i)
                {
                    kept.insert(pool[i].cost);
                }
                EXPECT_EQ(kept, costs);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, [](const ob::State *) { return true; }};
            path::StateChartPtr chart_ = std::make_shared<const path::StateChart>(space_);
            path::PathEvaluator evaluator_{problem_.si,
                                           std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
            PathPool pool_{CAPACITY, chart_, evaluator_};
        };

        TEST_F(PathPoolTest, KeepsPathsWithTheirSlices)
        {
            EXPECT_EQ(pool_.size(), 0U);
            path::Waypoints path = tent(1.0);
            pool_.add(path, 11.0, true, 10.0);
            path.clear();
            pool_.add(tent(-1.0), 10.5, false, 10.0);
            ASSERT_EQ(pool_.size(), 2U);
            EXPECT_EQ(pool_[0].cost, 11.0);
            EXPECT_TRUE(pool_[0].valid);
            EXPECT_FALSE(pool_[1].valid);
            for (std::size_t i = 0; i < pool_.size(); ++i)
            {
                const path::Waypoints expected = tent(i == 0 ? 1.0 : -1.0);
                ASSERT_EQ(pool_[i].path.size(), 3U);
                EXPECT_TRUE(space_->equalStates(pool_[i].path[1], expected[1]));
                const path::Waypoints slices = path::statesAlong(expected, PathPool::SLICES);
                ASSERT_EQ(pool_[i].slices.size(), PathPool::SLICES);
                for (std::size_t k = 0; k < slices.size(); ++k)
                {
                    EXPECT_TRUE(space_->equalStates(pool_[i].slices[k], slices[k]));
                }
            }
            EXPECT_EQ(pool_.brightest(), 1U);
            EXPECT_EQ(pool_.dimmest(), 0U);
        }

        TEST_F(PathPoolTest, TheMostExpensivePathMakesRoom)
        {
            pool_.add(tent(0.0), 10.2, true, 10.0);
            pool_.add(tent(2.0), 10.4, true, 10.0);
            pool_.add(tent(4.0), 10.1, true, 10.0);
            expectCosts(pool_, {10.1, 10.2, 10.4});
            EXPECT_EQ(pool_.brightest(), 2U);
            EXPECT_EQ(pool_.dimmest(), 1U);
            pool_.add(tent(6.0), 10.5, true, 10.0);
            expectCosts(pool_, {10.1, 10.2, 10.4});
            pool_.add(tent(6.0), 10.4, true, 10.0);
            EXPECT_FALSE(space_->equalStates(pool_[1].path[1], tent(6.0)[1])) << "no better than the one it replaces";
            pool_.add(tent(6.0), 10.3, true, 10.0);
            expectCosts(pool_, {10.1, 10.2, 10.3});
        }

        TEST_F(PathPoolTest, OfTwoPathsThatAreNearlyTheSameTheCheaperIsKept)
        {
            // the mean distance of the slices is a bit more than half that of the middles, and the limit is 0.2
            pool_.add(tent(0.0), 10.2, true, 10.0);
            pool_.add(tent(0.2), 10.3, true, 10.0);
            expectCosts(pool_, {10.2});
            pool_.add(tent(0.2), 10.1, false, 10.0);
            expectCosts(pool_, {10.1});
            EXPECT_FALSE(pool_[0].valid);
            pool_.add(tent(0.7), 10.3, true, 10.0);
            expectCosts(pool_, {10.1, 10.3});
        }

        TEST_F(PathPoolTest, ThePathThatIsNearlyTheSameIsReplacedNotTheMostExpensive)
        {
            pool_.add(tent(0.0), 10.9, true, 10.0);
            pool_.add(tent(2.5), 10.3, true, 10.0);
            pool_.add(tent(2.0), 10.2, true, 10.0);
            expectCosts(pool_, {10.2, 10.3, 10.9});
            // near both the second and the third, but nearer to the second
            pool_.add(tent(2.3), 10.1, true, 10.0);
            expectCosts(pool_, {10.1, 10.2, 10.9});
            // nearly the same as cheaper ones
            pool_.add(tent(2.1), 10.5, true, 10.0);
            expectCosts(pool_, {10.1, 10.2, 10.9});
        }

        TEST_F(PathPoolTest, PathsCostAtMostSlightlyMoreThanTheBest)
        {
            pool_.add(tent(0.0), 11.4, true, 10.0);
            pool_.add(tent(2.0), 11.6, true, 10.0);
            pool_.add(tent(4.0), 10.0, true, 10.0);
            expectCosts(pool_, {10.0, 11.4});
            pool_.prune(10.0);
            expectCosts(pool_, {10.0, 11.4});
            pool_.prune(9.9);
            expectCosts(pool_, {10.0});
            pool_.prune(5.0);
            EXPECT_EQ(pool_.size(), 0U);
        }

        TEST_F(PathPoolTest, AnyPathIsWorthKeepingBeforeThereIsABestOne)
        {
            pool_.add(tent(0.0), 1e6, true, std::numeric_limits<double>::infinity());
            EXPECT_EQ(pool_.size(), 1U);
        }

        TEST_F(PathPoolTest, ASingleMotionIsNotKept)
        {
            pool_.add(test::planarPath(space_, {{0.0, 0.0}, {10.0, 0.0}}), 10.0, true, 10.0);
            EXPECT_EQ(pool_.size(), 0U);
        }

        TEST_F(PathPoolTest, AMaximisedObjectiveTurnsTheOrder)
        {
            path::PathEvaluator evaluator(problem_.si,
                                          std::make_shared<ob::MaximizeMinClearanceObjective>(problem_.si));
            PathPool pool(CAPACITY, chart_, evaluator);
            // there is no slack
            pool.add(tent(0.0), 4.9, true, 5.0);
            EXPECT_EQ(pool.size(), 0U);
            pool.add(tent(0.0), 5.0, true, 5.0);
            pool.add(tent(2.0), 7.0, true, 5.0);
            pool.add(tent(4.0), 6.0, true, 5.0);
            expectCosts(pool, {5.0, 6.0, 7.0});
            EXPECT_EQ(pool.brightest(), 1U);
            EXPECT_EQ(pool.dimmest(), 0U);
            pool.add(tent(6.0), 8.0, true, 5.0);
            expectCosts(pool, {6.0, 7.0, 8.0});
            pool.add(tent(2.1), 6.5, true, 5.0);
            expectCosts(pool, {6.0, 7.0, 8.0});
            pool.prune(7.0);
            expectCosts(pool, {7.0, 8.0});
        }
    }  // namespace
}  // namespace ompl_mfa::engine
