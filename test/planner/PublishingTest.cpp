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

/* What is reported to the problem definition and to the intermediate-solution callback, and how often. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "planner/PlanningProblem.h"
#include "planner/PublishingSchedule.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        TEST(PublishingSchedule, TheFirstPathAndNotableImprovementsAreDueAtOnce)
        {
            PublishingSchedule schedule;
            EXPECT_TRUE(schedule.due(100.0, 5));
            schedule.published(100.0, 1000);
            EXPECT_TRUE(schedule.due(98.9, 1001));
            EXPECT_FALSE(schedule.due(99.1, 1001));
            EXPECT_FALSE(schedule.due(99.999999, 1049));
            EXPECT_TRUE(schedule.due(99.999999, 1050));
            schedule.reset();
            EXPECT_TRUE(schedule.due(99.999999, 1));
        }

        TEST(PublishingSchedule, AFiniteCostAfterAnInfiniteOneIsDue)
        {
            PublishingSchedule schedule;
            schedule.published(std::numeric_limits<double>::infinity(), 1000);
            EXPECT_TRUE(schedule.due(5.0, 1001));
        }

        TEST(PublishingSchedule, TheirNumberIsBoundedByTheLogarithmOfTheWork)
        {
            // a cost that falls for ever, and one that falls to zero
            for (const double factor : {0.999999, 0.99, 0.5})
            {
                PublishingSchedule schedule;
                double cost = 1e300;
                unsigned int published = 0;
                for (std::uint64_t work = 1000; work < 10000000; work += 10)
                {
                    cost *= factor;
                    if (!schedule.due(cost, work))
                    {
                        continue;
                    }
                    schedule.published(cost, work);
                    ++published;
                }
                EXPECT_LE(published, 1001 + std::log(10000.0) / std::log(1.05)) << factor;
            }
        }

        class PublishedPaths : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::shared_ptr<MFA> planner_ = problem_->planner(GetParam());
        };

        INSTANTIATE_TEST_SUITE_P(Planner, PublishedPaths,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST(Publishing, ALongSolveLeavesABoundedNumberOfSolutions)
        {
            // around a ball in six dimensions there is always something left to improve
            const test::PlanningProblem problem(
                test::realVectorSpace(6, 0.0, 10.0),
                [](const ob::State *state)
                {
                    double sum = 0.0;
                    for (unsigned int i = 0; i < 6; ++i)
                    {
                        sum += std::pow(test::coordinate(state, i) - 5.0, 2);
                    }
                    return sum > 16.0;
                },
                std::vector<double>(6, 2.0), std::vector<double>(6, 8.0));
            const auto planner = problem.planner(test::PlannerVariant::Default);
            // without strict checks every improvement is one of the answer
            planner->setStrictness(1);
            std::size_t improvements = 0;
            double best = std::numeric_limits<double>::infinity();
            planner->solve(ob::PlannerTerminationCondition(
                [&, ptc = test::afterCalls(2000000)]
                {
                    improvements += planner->bestCost() < best ? 1 : 0;
                    best = planner->bestCost();
                    return ptc();
                }));
            EXPECT_GT(improvements, 300U);
            EXPECT_LE(problem.pdef->getSolutionCount(), 150U);
        }

        TEST_P(PublishedPaths, TheLastSolutionIsThere)
        {
            for (unsigned int calls = 1000; calls < 60000; calls += 7001)
            {
                planner_->solve(test::afterCalls(calls));
                if (problem_->pdef->hasExactSolution())
                {
                    EXPECT_EQ(problem_->reportedCost(), planner_->bestCost());
                    EXPECT_DOUBLE_EQ(problem_->path().length(), planner_->bestCost());
                }
            }
            EXPECT_TRUE(problem_->pdef->hasExactSolution());
        }

        TEST_P(PublishedPaths, NoImprovementByAHundredthIsWithheld)
        {
            std::vector<double> costs;
            problem_->pdef->setIntermediateSolutionCallback(
                [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
                { costs.push_back(cost.value()); });
            bool withheld = false;
            unsigned int seen = 0;
            planner_->solve(ob::PlannerTerminationCondition(
                [&, ptc = test::afterCalls(30000)]
                {
                    const double best = planner_->bestCost();
                    if (std::isfinite(best))
                    {
                        ++seen;
                        withheld = withheld || costs.empty() || best < 0.99 * costs.back();
                    }
                    return ptc();
                }));
            EXPECT_GT(seen, 100U);
            EXPECT_FALSE(withheld);
            EXPECT_TRUE(std::is_sorted(costs.rbegin(), costs.rend()));
        }

        TEST_P(PublishedPaths, SolvingAgainAddsNothingThatTheDefinitionHas)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            const double best = planner_->bestCost();
            planner_->solve(test::afterCalls(1));
            ASSERT_EQ(planner_->bestCost(), best);
            const std::size_t solutions = problem_->pdef->getSolutionCount();
            for (unsigned int i = 0; i < 20; ++i)
            {
                EXPECT_EQ(planner_->solve(test::afterCalls(1)), ob::PlannerStatus::EXACT_SOLUTION);
            }
            EXPECT_EQ(problem_->pdef->getSolutionCount(), solutions);
            // but it is added again where it was removed
            problem_->pdef->clearSolutionPaths();
            EXPECT_EQ(planner_->solve(test::afterCalls(1)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(problem_->pdef->getSolutionCount(), 1U);
            EXPECT_EQ(problem_->reportedCost(), best);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
