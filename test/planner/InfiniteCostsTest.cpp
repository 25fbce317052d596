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

/* Costs that are infinite, and costs that are not a number. */

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/util/Exception.h>

#include "path/PathEvaluator.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double INF = std::numeric_limits<double>::infinity();

        /* The square [-5, 5]^2 without obstacles, from (-4, 0) to (4, 0). */
        std::unique_ptr<test::PlanningProblem> openProblem()
        {
            return std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, -5.0, 5.0), [](const ob::State *) { return true; },
                std::vector<double>{-4.0, 0.0}, std::vector<double>{4.0, 0.0});
        }

        double radius(const ob::State *state)
        {
            return std::hypot(test::coordinate(state, 0), test::coordinate(state, 1));
        }

        /* A cost map: states nearer to the origin than \e inner or farther from it than \e outer have infinite cost. */
        class LethalDisc : public ob::StateCostIntegralObjective
        {
        public:
            LethalDisc(const ob::SpaceInformationPtr &si, double inner, double outer = INF)
              : StateCostIntegralObjective(si, true)
              , inner_(inner)
              , outer_(outer)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                const double r = radius(state);
                return ob::Cost(r < inner_ || r > outer_ ? INF : 1.0);
            }

        private:
            double inner_;
            double outer_;
        };

        /* Path length, with infinite cost for motions across the line from (0, -2) to (0, 2). */
        class ForbiddenLine : public ob::OptimizationObjective
        {
        public:
            using OptimizationObjective::OptimizationObjective;

            ob::Cost stateCost(const ob::State *) const override
            {
                return ob::Cost(0.0);
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const double a = test::coordinate(from, 0);
                const double b = test::coordinate(to, 0);
                if ((a < 0.0) != (b < 0.0))
                {
                    const double part = a / (a - b);
                    const double y = (1.0 - part) * test::coordinate(from, 1) + part * test::coordinate(to, 1);
                    if (std::abs(y) < 2.0)
                    {
                        return infiniteCost();
                    }
                }
                return ob::Cost(si_->distance(from, to));
            }
        };

        /* The lowest y of a path, to be maximised; -infinite through the disc. */
        class LowestHeight : public ob::OptimizationObjective
        {
        public:
            using OptimizationObjective::OptimizationObjective;

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(radius(state) < 2.0 ? -INF : test::coordinate(state, 1));
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                double worst = INF;
                ob::State *state = si_->allocState();
                for (unsigned int i = 0; i <= 64; ++i)
                {
                    si_->getStateSpace()->interpolate(from, to, i / 64.0, state);
                    worst = std::min(worst, stateCost(state).value());
                }
                si_->freeState(state);
                return ob::Cost(worst);
            }

            bool isCostBetterThan(ob::Cost a, ob::Cost b) const override
            {
                return a.value() > b.value();
            }

            ob::Cost combineCosts(ob::Cost a, ob::Cost b) const override
            {
                return ob::Cost(std::min(a.value(), b.value()));
            }

            ob::Cost identityCost() const override
            {
                return ob::Cost(INF);
            }

            ob::Cost infiniteCost() const override
            {
                return ob::Cost(-INF);
            }
        };

        /* True once the planner's best cost is at most the limit, or after a minute. */
        ob::PlannerTerminationCondition untilBelow(const std::shared_ptr<MFA> &planner, double limit)
        {
            return ob::plannerOrTerminationCondition(
                ob::PlannerTerminationCondition([planner, limit] { return planner->bestCost() < limit; }),
                ob::timedPlannerTerminationCondition(60.0));
        }

        class InfiniteCosts : public ::testing::TestWithParam<std::uint32_t>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = openProblem();
            std::shared_ptr<MFA> planner_ = problem_->planner(test::PlannerVariant::Default, GetParam());
        };

        // 0: unseeded
        INSTANTIATE_TEST_SUITE_P(Seeds, InfiniteCosts, ::testing::Values(0U, 1U, 2U, 3U, 4U, 5U));

        TEST_P(InfiniteCosts, TheLethalPartOfACostMapIsPassed)
        {
            problem_->pdef->setOptimizationObjective(std::make_shared<LethalDisc>(problem_->si, 2.0));
            EXPECT_EQ(planner_->solve(untilBelow(planner_, 9.3)), ob::PlannerStatus::EXACT_SOLUTION);
            // 2 (sqrt(12) + 2 asin(1/2)) = 9.02
            EXPECT_LT(planner_->bestCost(), 9.3);
            EXPECT_LT(problem_->reportedCost(), 9.3);
            EXPECT_TRUE(problem_->path().check());
        }

        TEST_P(InfiniteCosts, AForbiddenCrossingIsAvoided)
        {
            problem_->pdef->setOptimizationObjective(std::make_shared<ForbiddenLine>(problem_->si));
            EXPECT_EQ(planner_->solve(untilBelow(planner_, 9.0)), ob::PlannerStatus::EXACT_SOLUTION);
            // 2 sqrt(20) = 8.944
            EXPECT_LT(planner_->bestCost(), 9.0);
        }

        TEST_P(InfiniteCosts, MayBeTheWorstOfWhatIsMaximised)
        {
            problem_->pdef->setOptimizationObjective(std::make_shared<LowestHeight>(problem_->si));
            const auto condition = ob::plannerOrTerminationCondition(
                ob::PlannerTerminationCondition(
                    [this] { return std::isfinite(planner_->bestCost()) && planner_->bestCost() > -0.05; }),
                ob::timedPlannerTerminationCondition(60.0));
            planner_->solve(condition);
            EXPECT_TRUE(std::isfinite(planner_->bestCost()));
            EXPECT_GT(planner_->bestCost(), -0.05);
        }

        TEST_P(InfiniteCosts, APathOfInfiniteCostIsKeptWhereNoneIsFinite)
        {
            // every path crosses the strip of infinite cost
            class LethalStrip : public ob::StateCostIntegralObjective
            {
            public:
                explicit LethalStrip(const ob::SpaceInformationPtr &si)
                  : StateCostIntegralObjective(si, true)
                {
                }

                ob::Cost stateCost(const ob::State *state) const override
                {
                    return ob::Cost(std::abs(test::coordinate(state, 0)) < 1.0 ? INF : 1.0);
                }
            };
            problem_->pdef->setOptimizationObjective(std::make_shared<LethalStrip>(problem_->si));
            EXPECT_EQ(planner_->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(planner_->bestCost(), INF);
            EXPECT_TRUE(problem_->path().check());
            ob::PlannerSolution solution(nullptr);
            ASSERT_TRUE(problem_->pdef->getSolution(solution));
            EXPECT_FALSE(solution.optimized_);
            // the search for a first path goes on: trees and roadmap get nearly all of the time
            const auto shares = planner_->shares();
            EXPECT_GT(shares.at("trees") + shares.at("roadmap"), 0.5);
        }

        TEST(MotionsOfNoLength, CostNothingWhereAnIntegralOfThemIsNotANumber)
        {
            const auto problem = openProblem();
            const auto objective = std::make_shared<LethalDisc>(problem->si, 2.0);
            const auto lethal = problem->state({0.5, 0.5});
            ASSERT_TRUE(std::isnan(objective->motionCost(lethal.get(), lethal.get()).value()));
            path::PathEvaluator evaluator(problem->si, objective);
            ob::Cost cost;
            ASSERT_TRUE(evaluator.motionCost(lethal.get(), lethal.get(), cost));
            EXPECT_EQ(cost.value(), 0.0);
        }

        /* Path length, whose \e n-th motion cost is not a number. */
        class Undefined : public ob::OptimizationObjective
        {
        public:
            Undefined(const ob::SpaceInformationPtr &si, std::uint64_t n)
              : OptimizationObjective(si)
              , left_(n)
            {
                description_ = "undefined";
            }

            ob::Cost stateCost(const ob::State *) const override
            {
                return ob::Cost(0.0);
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                if (left_ > 0)
                {
                    --left_;
                }
                return ob::Cost(left_ > 0 ? si_->distance(from, to) : std::numeric_limits<double>::quiet_NaN());
            }

        private:
            mutable std::uint64_t left_;
        };

        TEST_P(InfiniteCosts, ACostThatIsNotANumberIsAnException)
        {
            for (const std::uint64_t n : {1U, 2U, 50U, 3000U})
            {
                const auto problem = test::wallProblem();
                problem->pdef->setOptimizationObjective(std::make_shared<Undefined>(problem->si, n));
                const auto planner = problem->planner(test::PlannerVariant::Default, GetParam());
                try
                {
                    planner->solve(ob::timedPlannerTerminationCondition(60.0));
                    FAIL() << "no exception";
                }
                catch (const ompl::Exception &error)
                {
                    EXPECT_NE(std::string(error.what()).find("'undefined'"), std::string::npos) << error.what();
                    EXPECT_NE(std::string(error.what()).find("not a number"), std::string::npos) << error.what();
                }
                // the planner remains usable
                planner->clear();
                problem->pdef->clearSolutionPaths();
                problem->pdef->setOptimizationObjective(nullptr);
                EXPECT_EQ(planner->solve(test::untilExact(problem->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::planner
