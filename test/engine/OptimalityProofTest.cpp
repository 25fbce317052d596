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

#include "engine/OptimalityProof.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>

#include "engine/SearchProblem.h"
#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Twice the path length. No detour is cheaper, but the planner cannot rely on that. */
        class Double : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(2.0 * si_->distance(from, to));
            }

            ob::Cost motionCostHeuristic(const ob::State *from, const ob::State *to) const override
            {
                return motionCost(from, to);
            }
        };

        /* Splitting a motion halves its cost, so the inherited heuristic is no lower bound. */
        class Squared : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const double length = si_->distance(from, to);
                return ob::Cost(length * length);
            }

            ob::Cost motionCostHeuristic(const ob::State *from, const ob::State *to) const override
            {
                return motionCost(from, to);
            }
        };

        class OptimalityProofTest : public ::testing::Test
        {
        protected:
            std::unique_ptr<test::SearchProblem> search(const ob::OptimizationObjectivePtr &objective = nullptr) const
            {
                auto result = std::make_unique<test::SearchProblem>(problem_->pdef, 5, SearchSettings(), objective);
                EXPECT_EQ(result->begin(), ob::PlannerStatus::EXACT_SOLUTION);
                return result;
            }

            void offer(test::SearchProblem &search, const std::vector<std::vector<double>> &states) const
            {
                path::Waypoints path(problem_->si->getStateSpace());
                for (const auto &values : states)
                {
                    path.append(problem_->state(values).get());
                }
                ASSERT_TRUE(search.context.incumbent.offer(path, search.evaluator().cost(path).value()));
            }

            void setGoals(const std::vector<std::vector<double>> &states) const
            {
                const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
                for (const auto &values : states)
                {
                    goals->addState(problem_->state(values));
                }
                problem_->pdef->setGoal(goals);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::freeProblem();
        };

        TEST_F(OptimalityProofTest, TheStraightMotionIsTheShortestWay)
        {
            const auto searched = search();
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {5.0, 1.1}, {9.0, 1.0}});
            EXPECT_FALSE(proof.holds());
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            EXPECT_TRUE(proof.holds());
        }

        TEST_F(OptimalityProofTest, APathToTheFartherGoalIsNotTheBest)
        {
            setGoals({{9.0, 1.0}, {4.0, 1.0}});
            const auto searched = search();
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            EXPECT_FALSE(proof.holds());
            offer(*searched, {{1.0, 1.0}, {4.0, 1.0}});
            EXPECT_TRUE(proof.holds());
        }

        TEST_F(OptimalityProofTest, AGoalThatHasNotComeYetMayBeNearer)
        {
            setGoals({{9.0, 1.0}});
            const auto searched = search();
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            EXPECT_TRUE(proof.holds());
            problem_->pdef->getGoal()->as<ob::GoalStates>()->addState(problem_->state({8.0, 1.0}));
            EXPECT_FALSE(proof.holds()) << "it was not read yet";
            searched->context.query.poll(searched->inputs);
            ASSERT_EQ(searched->goals().size(), 2U);
            EXPECT_FALSE(proof.holds()) << "a path to it is shorter";
        }

        TEST_F(OptimalityProofTest, GoalsThatHaveToBeSearchedForAreNeverComplete)
        {
            problem_->pdef->setGoal(
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5));
            const auto searched = search();
            searched->context.query.addGoal(problem_->state({9.0, 1.0}).get());
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            EXPECT_FALSE(proof.holds());
        }

        TEST_F(OptimalityProofTest, AUsersHeuristicProvesItWhereNoDetourContradicts)
        {
            const auto searched = search(std::make_shared<Double>(problem_->si));
            ASSERT_FALSE(searched->evaluator().bounds().certain());
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            EXPECT_TRUE(proof.holds());
        }

        TEST_F(OptimalityProofTest, AUsersHeuristicProvesNothingWhereDetoursContradict)
        {
            const auto searched = search(std::make_shared<Squared>(problem_->si));
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            ASSERT_TRUE(searched->evaluator().bounds().admissible()) << "a single motion says nothing about detours";
            EXPECT_FALSE(proof.holds());
            EXPECT_FALSE(searched->evaluator().bounds().admissible());
        }

        TEST_F(OptimalityProofTest, TheStopConditionLeavesItOpenUntilTheNextCall)
        {
            const auto searched = search(std::make_shared<Double>(problem_->si));
            OptimalityProof proof(searched->context);
            offer(*searched, {{1.0, 1.0}, {9.0, 1.0}});
            searched->evaluator().setStopCondition([] { return true; });
            EXPECT_FALSE(proof.holds());
            searched->evaluator().setStopCondition({});
            EXPECT_TRUE(proof.holds());
        }
    }  // namespace
}  // namespace ompl_mfa::engine
