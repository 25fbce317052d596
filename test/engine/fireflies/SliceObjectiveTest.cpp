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

#include "engine/fireflies/SliceObjective.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* From (-4, 0) to (4, 0) with one slice at x = 0, where |y| < 1 is forbidden. */
        class SliceObjectiveTest : public ::testing::Test
        {
        protected:
            SliceObjectiveTest()
              : frame_(makeFrame())
            {
            }

            SliceFrame makeFrame() const
            {
                ob::ScopedState<> start(space_);
                ob::ScopedState<> goal(space_);
                start[0] = -4.0;
                goal[0] = 4.0;
                start[1] = goal[1] = 0.0;
                return SliceFrame::straight(std::make_shared<const path::StateChart>(space_), start.get(), goal.get(),
                                            2);
            }

            static bool isValid(const ob::State *state)
            {
                const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return std::hypot(values[0], values[1]) > 1.0;
            }

            static Eigen::VectorXd offset(double y)
            {
                return Eigen::VectorXd::Constant(1, y);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, isValid};
            path::PathEvaluator evaluator_{problem_.si,
                                           std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
            SliceFrame frame_;
            std::vector<double> valid_;
            SliceObjective objective_{frame_, nullptr, evaluator_,
                                      [this](const path::Waypoints &path, const Brightness &brightness)
                                      {
                                          EXPECT_EQ(path.size(), 3U);
                                          valid_.push_back(brightness.cost);
                                      }};
        };

        TEST_F(SliceObjectiveTest, EvaluatesThePathAtItsCoordinates)
        {
            const Brightness brightness = objective_.evaluate(offset(3.0), nullptr);
            EXPECT_TRUE(brightness.isFeasible());
            EXPECT_DOUBLE_EQ(brightness.cost, 10.0);
            const Brightness invalid = objective_.evaluate(offset(0.0), nullptr);
            EXPECT_NEAR(invalid.violation, 2.0, 4.0 * 0.01 * space_->getMaximumExtent());
        }

        TEST_F(SliceObjectiveTest, ReportsValidPathsOnly)
        {
            objective_.evaluate(offset(0.0), nullptr);
            EXPECT_TRUE(valid_.empty());
            const Brightness rival = objective_.evaluate(offset(3.0), nullptr);
            EXPECT_EQ(valid_, (std::vector<double>{10.0}));
            objective_.evaluate(offset(-4.0), &rival);
            EXPECT_EQ(valid_.size(), 1U);
        }

        /* Brightness computed under an earlier bound is compared as if the present bound had always applied. */
        TEST_F(SliceObjectiveTest, ABoundThatMovesIsTheSameYardstickForAll)
        {
            const Brightness before = objective_.evaluate(offset(3.0), nullptr);
            ASSERT_TRUE(before.isFeasible());
            objective_.setBound(9.0);
            // closer to the bound than the one that was valid without it
            const Brightness nearer = objective_.evaluate(offset(2.2), nullptr);
            EXPECT_DOUBLE_EQ(nearer.cost, 2.0 * std::hypot(4.0, 2.2));
            EXPECT_TRUE(objective_.isBrighter(nearer, before));
            EXPECT_FALSE(objective_.isBrighter(before, nearer));
            // colliding, but within the bound
            const Brightness colliding = objective_.evaluate(offset(0.5), &before);
            EXPECT_NEAR(colliding.violation, 2.0, 0.5);
            EXPECT_TRUE(objective_.isBrighter(colliding, nearer));
            EXPECT_TRUE(objective_.isBrighter(colliding, before));
            // valid and within the bound
            const Brightness valid = objective_.evaluate(offset(2.0), &colliding);
            EXPECT_TRUE(valid.isFeasible());
            EXPECT_TRUE(objective_.isBrighter(valid, colliding));
            // without a bound, violations that were checked count again, and unchecked ones are dimmer
            objective_.setBound(std::numeric_limits<double>::infinity());
            EXPECT_TRUE(objective_.isBrighter(before, colliding));
            EXPECT_TRUE(objective_.isBrighter(colliding, nearer));
        }

        TEST_F(SliceObjectiveTest, WhatIsBeyondTheBoundIsNotChecked)
        {
            objective_.setBound(9.0);
            problem_.forget();
            EXPECT_FALSE(objective_.evaluate(offset(3.0), nullptr).isFeasible());
            EXPECT_EQ(problem_.states, 0U);
            EXPECT_TRUE(objective_.evaluate(offset(2.0), nullptr).isFeasible());
            EXPECT_GT(problem_.states, 0U);
        }

        /* Length that counts how often it is computed, and is infinite for motions near x = 0 below y = 2. */
        class Lethal : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                ++computed;
                for (const ob::State *end : {from, to})
                {
                    const double *values = end->as<ob::RealVectorStateSpace::StateType>()->values;
                    if (std::abs(values[0]) < 0.5 && values[1] < 2.0 && lethal)
                    {
                        return infiniteCost();
                    }
                }
                return PathLengthOptimizationObjective::motionCost(from, to);
            }

            /* The inherited heuristic computes the cost of a motion too. */
            ob::Cost motionCostHeuristic(const ob::State * /*from*/, const ob::State * /*to*/) const override
            {
                return identityCost();
            }

            mutable unsigned int computed{0};
            bool lethal{false};
        };

        TEST_F(SliceObjectiveTest, TheCostOfACandidateIsComputedOnce)
        {
            const auto counted = std::make_shared<Lethal>(problem_.si);
            path::PathEvaluator evaluator(problem_.si, counted);
            SliceObjective objective(frame_, nullptr, evaluator, [](const path::Waypoints &, const Brightness &) {});
            for (const double bound : {std::numeric_limits<double>::infinity(), 9.5, 8.5})
            {
                objective.setBound(bound);
                counted->computed = 0;
                objective.evaluate(offset(2.2), nullptr);
                EXPECT_EQ(counted->computed, 2U) << "for two motions, with bound " << bound;
            }
        }

        TEST_F(SliceObjectiveTest, InfiniteCostsAreOrderedAndNeverNan)
        {
            const auto lethal = std::make_shared<Lethal>(problem_.si);
            lethal->lethal = true;
            path::PathEvaluator evaluator(problem_.si, lethal);
            SliceObjective objective(frame_, nullptr, evaluator, [](const path::Waypoints &, const Brightness &) {});
            const double inf = std::numeric_limits<double>::infinity();
            for (const double bound : {inf, std::numeric_limits<double>::max(), 9.5})
            {
                objective.setBound(bound);
                const Brightness infinite = objective.evaluate(offset(-1.5), nullptr);
                const Brightness colliding = objective.evaluate(offset(0.5), nullptr);
                const Brightness valid = objective.evaluate(offset(2.1), nullptr);
                EXPECT_EQ(infinite.cost, inf);
                EXPECT_TRUE(valid.isFeasible());
                for (const Brightness &brightness : {infinite, colliding, valid})
                {
                    EXPECT_FALSE(std::isnan(brightness.violation) || std::isnan(brightness.cost));
                }
                EXPECT_TRUE(objective.isBrighter(valid, infinite));
                EXPECT_FALSE(objective.isBrighter(infinite, valid));
                EXPECT_FALSE(objective.isBrighter(infinite, infinite));
                // a valid one is of use as long as no other is known, and not afterwards
                EXPECT_EQ(infinite.isFeasible(), bound == inf);
            }
        }

        /* Computing the coordinates of many slices from their modes takes as long as many motion checks. */
        TEST_F(SliceObjectiveTest, AsksTheStopConditionWhileItComputesManySlices)
        {
            const SliceFrame many =
                SliceFrame::straight(frame_.chart(), frame_.axis().front(), frame_.axis().back(), 1001);
            const SliceModes modes(many);
            const auto counted = std::make_shared<Lethal>(problem_.si);
            path::PathEvaluator evaluator(problem_.si, counted);
            SliceObjective objective(many, &modes, evaluator, [](const path::Waypoints &, const Brightness &) {});
            const Eigen::VectorXd straight = Eigen::VectorXd::Zero(many.dimension());
            int beforeTheFirstCost = 0;
            evaluator.setStopCondition(
                [&]
                {
                    beforeTheFirstCost += counted->computed == 0 ? 1 : 0;
                    return false;
                });
            objective.evaluate(straight, nullptr);
            // a million multiplications
            EXPECT_GE(beforeTheFirstCost, 4);
            counted->computed = 0;
            evaluator.setStopCondition([] { return true; });
            EXPECT_EQ(objective.evaluate(straight, nullptr).cost, Brightness().cost);
            EXPECT_EQ(counted->computed, 0U);
        }

        TEST_F(SliceObjectiveTest, OrdersBrightnessAsTheObjectiveDoes)
        {
            EXPECT_TRUE(objective_.isBrighter({0.0, 1.0}, {0.0, 2.0}));
            path::PathEvaluator clearance(problem_.si,
                                          std::make_shared<ob::MaximizeMinClearanceObjective>(problem_.si));
            SliceObjective wide(frame_, nullptr, clearance, {});
            EXPECT_TRUE(wide.isBrighter({0.0, 2.0}, {0.0, 1.0}));
            // when maximising, all costs but the worst are better than the lowest number
            wide.setBound(std::numeric_limits<double>::lowest());
            const double worst = -std::numeric_limits<double>::infinity();
            EXPECT_TRUE(wide.isBrighter({3.0, 1.0}, {0.0, worst}));
            EXPECT_FALSE(wide.isBrighter({0.0, worst}, {3.0, 1.0}));
            EXPECT_FALSE(wide.isBrighter({0.0, worst}, {0.0, worst}));
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
