#include "ompl_mfa/planner/Query.h"

#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>

#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        class QueryTest : public ::testing::Test
        {
        protected:
            QueryTest()
            {
                inputs_.use(problem_->pdef);
                query_.reset(*problem_->pdef);
            }

            ob::PlannerStatus::StatusType begin()
            {
                return query_.begin(inputs_, never_, chart_, problem_->si, 1);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            ob::ProblemDefinitionPtr pdef_ = problem_->pdef;
            StateChartPtr chart_ = std::make_shared<const StateChart>(problem_->si->getStateSpace());
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
            EXPECT_FALSE(query_.poll(inputs_, never_));
        }

        TEST_F(QueryTest, NoticesWhatChanges)
        {
            EXPECT_FALSE(query_.differsFrom(*pdef_));
            pdef_->addStartState(problem_->state({2.0, 2.0}));
            EXPECT_FALSE(query_.differsFrom(*pdef_)) << "an added start needs no new search";
            pdef_->clearStartStates();
            pdef_->addStartState(problem_->state({2.0, 2.0}));
            EXPECT_TRUE(query_.differsFrom(*pdef_));
            query_.reset(*pdef_);
            EXPECT_FALSE(query_.differsFrom(*pdef_));
            pdef_->setGoalState(problem_->state({8.0, 2.0}));
            EXPECT_TRUE(query_.differsFrom(*pdef_));
            query_.reset(*pdef_);
            pdef_->getGoal()->as<ob::GoalState>()->setState(problem_->state({8.0, 3.0}));
            EXPECT_TRUE(query_.differsFrom(*pdef_)) << "the state of the same goal object";
            query_.reset(*pdef_);
            pdef_->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si));
            EXPECT_TRUE(query_.differsFrom(*pdef_));
        }

        TEST_F(QueryTest, StartsMayBeAddedLater)
        {
            begin();
            pdef_->addStartState(problem_->state({2.0, 2.0}));
            EXPECT_TRUE(query_.poll(inputs_, never_));
            EXPECT_EQ(query_.starts().size(), 2U);
        }

        TEST_F(QueryTest, ListedGoalsComeOneAfterTheOther)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            for (const double y : {1.0, 2.0, 3.0})
                goals->addState(problem_->state({9.0, y}));
            pdef_->setGoal(goals);
            query_.reset(*pdef_);
            begin();
            EXPECT_FALSE(query_.goalsComplete());
            for (int i = 0; i < 5; ++i)
                query_.poll(inputs_, never_);
            EXPECT_EQ(query_.goals().size(), 3U);
            EXPECT_TRUE(query_.goalsComplete());
            goals->addState(problem_->state({9.0, 4.0}));
            EXPECT_FALSE(query_.goalsComplete());
            EXPECT_TRUE(query_.poll(inputs_, never_));
            EXPECT_EQ(query_.goals().size(), 4U);
        }

        TEST_F(QueryTest, AGoalThatOnlyKnowsADistanceIsSearchedFor)
        {
            pdef_->setGoal(std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 1.0}).get(), 0.5));
            query_.reset(*pdef_);
            EXPECT_EQ(begin(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(query_.goals().empty());
            EXPECT_FALSE(query_.goalsComplete());
            for (int i = 0; i < 1000 && query_.goals().empty(); ++i)
                query_.poll(inputs_, never_);
            ASSERT_FALSE(query_.goals().empty());
            EXPECT_TRUE(pdef_->getGoal()->isSatisfied(query_.goals().front()));
        }

        TEST_F(QueryTest, SaysWhyItCannotBegin)
        {
            pdef_->clearStartStates();
            pdef_->addStartState(problem_->state({5.0, 1.0}));
            query_.reset(*pdef_);
            EXPECT_EQ(begin(), ob::PlannerStatus::INVALID_START);
            pdef_->addStartState(problem_->state({1.0, 1.0}));
            pdef_->setGoalState(problem_->state({5.0, 1.0}));
            query_.reset(*pdef_);
            EXPECT_EQ(begin(), ob::PlannerStatus::INVALID_GOAL);
        }

        TEST_F(QueryTest, ResetForgetsAll)
        {
            begin();
            query_.reset();
            EXPECT_TRUE(query_.starts().empty());
            EXPECT_TRUE(query_.goals().empty());
            EXPECT_EQ(query_.goal(), nullptr);
            EXPECT_TRUE(query_.differsFrom(*pdef_));
        }
    }  // namespace
}  // namespace ompl_mfa
