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

#include "engine/Query.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>

#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        class QueryTest : public ::testing::Test
        {
        protected:
            QueryTest()
            {
                inputs_.use(problem_->pdef);
                ask();
            }

            /* A new query of the problem definition. */
            void ask()
            {
                query_ = Query(problem_->si->getStateSpace());
                query_.ask(*pdef_);
            }

            ob::PlannerStatus::StatusType begin()
            {
                return query_.begin(inputs_, never_, problem_->si);
            }

            /* Another query. */
            void beginAgain()
            {
                ask();
                ASSERT_EQ(begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            ob::ProblemDefinitionPtr pdef_ = problem_->pdef;
            ob::PlannerInputStates inputs_;
            Query query_{problem_->si->getStateSpace()};
            ob::PlannerTerminationCondition never_{[] { return false; }};
        };

        TEST_F(QueryTest, ReadsStartsAndGoal)
        {
            EXPECT_EQ(begin(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(query_.starts().size(), 1U);
            EXPECT_EQ(query_.goals().size(), 1U);
            EXPECT_TRUE(query_.goalsComplete());
            EXPECT_FALSE(query_.poll(inputs_));
        }

        TEST_F(QueryTest, NoticesWhatChanges)
        {
            begin();
            EXPECT_FALSE(query_.differsFrom(*pdef_));
            pdef_->addStartState(problem_->state({2.0, 2.0}));
            EXPECT_FALSE(query_.differsFrom(*pdef_)) << "an added start needs no new search";
            pdef_->clearStartStates();
            pdef_->addStartState(problem_->state({2.0, 2.0}));
            EXPECT_TRUE(query_.differsFrom(*pdef_));
            beginAgain();
            EXPECT_FALSE(query_.differsFrom(*pdef_));
            pdef_->setGoalState(problem_->state({8.0, 2.0}));
            EXPECT_TRUE(query_.differsFrom(*pdef_));
            beginAgain();
            pdef_->getGoal()->as<ob::GoalState>()->setState(problem_->state({8.0, 3.0}));
            EXPECT_TRUE(query_.differsFrom(*pdef_)) << "the state of the same goal object";
            beginAgain();
            pdef_->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si));
            EXPECT_TRUE(query_.differsFrom(*pdef_));
        }

        /* OMPL reads all states again for a new problem definition. */
        TEST_F(QueryTest, TheSameStatesInAnotherProblemDefinitionAreKnown)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            for (const double y : {1.0, 2.0, 1.0})
            {
                goals->addState(problem_->state({9.0, y}));
            }
            pdef_->setGoal(goals);
            ask();
            for (int i = 0; i < 20; ++i)
            {
                const auto next = std::make_shared<ob::ProblemDefinition>(problem_->si);
                for (const double x : {1.0, 2.0, 1.0})
                {
                    next->addStartState(problem_->state({x, 1.0}));
                }
                next->setGoal(goals);
                ASSERT_FALSE(query_.differsFrom(*next));
                inputs_.use(next);
                ASSERT_EQ(begin(), ob::PlannerStatus::EXACT_SOLUTION);
                for (int k = 0; k < 5; ++k)
                {
                    query_.poll(inputs_);
                }
                EXPECT_EQ(query_.starts().size(), 2U);
                EXPECT_EQ(query_.goals().size(), 2U);
                EXPECT_TRUE(query_.goalsComplete());
            }
        }

        TEST_F(QueryTest, TheOrderOfStatesMakesNoDifference)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            for (const double y : {1.0, 2.0, 3.0})
            {
                goals->addState(problem_->state({9.0, y}));
            }
            pdef_->addStartState(problem_->state({2.0, 1.0}));
            pdef_->setGoal(goals);
            beginAgain();
            for (int k = 0; k < 5; ++k)
            {
                query_.poll(inputs_);
            }
            ASSERT_EQ(query_.goals().size(), 3U);
            goals->clear();
            for (const double y : {3.0, 1.0, 2.0})
            {
                goals->addState(problem_->state({9.0, y}));
            }
            pdef_->clearStartStates();
            for (const double x : {2.0, 1.0})
            {
                pdef_->addStartState(problem_->state({x, 1.0}));
            }
            EXPECT_FALSE(query_.differsFrom(*pdef_));
            goals->clear();
            for (const double y : {3.0, 1.0})
            {
                goals->addState(problem_->state({9.0, y}));
            }
            EXPECT_TRUE(query_.differsFrom(*pdef_));
        }

        TEST_F(QueryTest, InvalidListedGoalsAreReadButNotTaken)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            for (const double x : {5.0, 11.0, 9.0})
            {
                goals->addState(problem_->state({x, 1.0}));
            }
            pdef_->setGoal(goals);
            beginAgain();
            query_.poll(inputs_);
            EXPECT_EQ(query_.goals().size(), 1U);
            EXPECT_TRUE(query_.goalsComplete()) << "no more goals can follow";
        }

        TEST_F(QueryTest, AStateThatIsNoNumberIsNoneToPlanFrom)
        {
            const double nan = std::numeric_limits<double>::quiet_NaN();
            pdef_->clearStartStates();
            pdef_->addStartState(problem_->state({1.0, nan}));
            ask();
            EXPECT_EQ(begin(), ob::PlannerStatus::INVALID_START);
            pdef_->addStartState(problem_->state({1.0, 1.0}));
            pdef_->setGoalState(problem_->state({nan, 1.0}));
            ask();
            EXPECT_EQ(begin(), ob::PlannerStatus::INVALID_GOAL);
        }

        /* A region of one point and one of a few: repeated samples are recognised. */
        TEST_F(QueryTest, SampledGoalsAreTakenOnceToo)
        {
            class Points : public ob::GoalSampleableRegion
            {
            public:
                Points(const ob::SpaceInformationPtr &si, unsigned int points)
                  : GoalSampleableRegion(si)
                  , points_(points)
                {
                }

                void sampleGoal(ob::State *state) const override
                {
                    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    values[0] = 9.0;
                    values[1] = 1.0 + samples++ % points_;
                }

                unsigned int maxSampleCount() const override
                {
                    return std::numeric_limits<unsigned int>::max();
                }

                double distanceGoal(const ob::State *state) const override
                {
                    return std::abs(test::coordinate(state, 0) - 9.0);
                }

                mutable unsigned int samples{0};

            private:
                unsigned int points_;
            };
            for (const unsigned int points : {1U, 3U})
            {
                const auto region = std::make_shared<Points>(problem_->si, points);
                pdef_->setGoal(region);
                beginAgain();
                for (int k = 0; k < 1000; ++k)
                {
                    query_.poll(inputs_);
                }
                EXPECT_EQ(query_.goals().size(), points);
                EXPECT_GT(region->samples, points);
                EXPECT_LT(region->samples, 100U) << "sampled ever more rarely";
                EXPECT_FALSE(query_.goalsComplete());
            }
        }

        TEST_F(QueryTest, APathAnswersItFromAStartToTheGoal)
        {
            pdef_->setGoal(std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5));
            beginAgain();
            path::Waypoints path(problem_->si->getStateSpace());
            path.append(problem_->state({1.0, 1.0}).get());
            EXPECT_FALSE(query_.isAnsweredBy(path));
            path.append(problem_->state({9.0, 1.25}).get());
            EXPECT_TRUE(query_.isAnsweredBy(path)) << "the goal is satisfied there";
            path.reverse();
            EXPECT_FALSE(query_.isAnsweredBy(path));
        }

        TEST_F(QueryTest, StartsMayBeAddedLater)
        {
            begin();
            pdef_->addStartState(problem_->state({2.0, 2.0}));
            EXPECT_TRUE(query_.poll(inputs_));
            EXPECT_EQ(query_.starts().size(), 2U);
        }

        TEST_F(QueryTest, ListedGoalsComeOneAfterTheOther)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            for (const double y : {1.0, 2.0, 3.0})
            {
                goals->addState(problem_->state({9.0, y}));
            }
            pdef_->setGoal(goals);
            ask();
            begin();
            EXPECT_FALSE(query_.goalsComplete());
            for (int i = 0; i < 5; ++i)
            {
                query_.poll(inputs_);
            }
            EXPECT_EQ(query_.goals().size(), 3U);
            EXPECT_TRUE(query_.goalsComplete());
            goals->addState(problem_->state({9.0, 4.0}));
            EXPECT_FALSE(query_.goalsComplete());
            EXPECT_TRUE(query_.poll(inputs_));
            EXPECT_EQ(query_.goals().size(), 4U);
        }

        TEST_F(QueryTest, GoalsThatOnlyTellDistancesHaveToBeHandedOver)
        {
            EXPECT_FALSE(query_.needsGoalSearch());
            pdef_->setGoal(std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5));
            ask();
            EXPECT_TRUE(query_.needsGoalSearch());
            EXPECT_EQ(begin(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_FALSE(query_.poll(inputs_));
            EXPECT_TRUE(query_.goals().empty());
            EXPECT_FALSE(query_.goalsComplete());
            EXPECT_TRUE(query_.addGoal(problem_->state({9.0, 1.25}).get()));
            EXPECT_FALSE(query_.addGoal(problem_->state({9.0, 1.25}).get())) << "known";
            EXPECT_FALSE(query_.addGoal(problem_->state({9.0, std::numeric_limits<double>::quiet_NaN()}).get()));
            ASSERT_EQ(query_.goals().size(), 1U);
            EXPECT_TRUE(problem_->si->equalStates(query_.goals()[0], problem_->state({9.0, 1.25}).get()));
            EXPECT_FALSE(query_.goalsComplete()) << "more of them may be found";
        }

        TEST_F(QueryTest, AGoalThatWasHandedOverHasToSatisfyTheGoalStill)
        {
            const auto goal =
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5);
            pdef_->setGoal(goal);
            beginAgain();
            query_.addGoal(problem_->state({9.0, 1.25}).get());
            EXPECT_FALSE(query_.differsFrom(*pdef_));
            goal->setThreshold(0.125);
            EXPECT_TRUE(query_.differsFrom(*pdef_));
        }

        TEST_F(QueryTest, SomeThousandGoalsAreEnough)
        {
            pdef_->setGoal(std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 5.0}).get(), 4.0));
            beginAgain();
            int taken = 0;
            for (; !query_.hasEnoughGoals() && taken < 10000; ++taken)
            {
                ASSERT_TRUE(query_.addGoal(problem_->state({9.0, 2.0 + 0.0005 * taken}).get()));
            }
            EXPECT_GE(taken, 1000);
            EXPECT_LT(taken, 10000);
        }

        TEST_F(QueryTest, SaysWhyItCannotBegin)
        {
            pdef_->clearStartStates();
            pdef_->addStartState(problem_->state({5.0, 1.0}));
            ask();
            EXPECT_EQ(begin(), ob::PlannerStatus::INVALID_START);
            pdef_->addStartState(problem_->state({1.0, 1.0}));
            pdef_->setGoalState(problem_->state({5.0, 1.0}));
            ask();
            EXPECT_EQ(begin(), ob::PlannerStatus::INVALID_GOAL);
        }

        TEST_F(QueryTest, KnowsNothingBeforeItIsAsked)
        {
            const Query query(problem_->si->getStateSpace());
            EXPECT_TRUE(query.starts().empty());
            EXPECT_TRUE(query.goals().empty());
            EXPECT_EQ(query.goal(), nullptr);
            EXPECT_TRUE(query.differsFrom(*pdef_));
        }
    }  // namespace
}  // namespace ompl_mfa::engine
