/* The time is shared in one way while a first path is sought, and in another once there is one, wherever it came
   from. */

#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* What a state costs does not let the straight motion be proven optimal. */
        class Slope : public ob::StateCostIntegralObjective
        {
        public:
            explicit Slope(const ob::SpaceInformationPtr &si)
              : StateCostIntegralObjective(si, true)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(1.0 + test::coordinate(state, 1));
            }
        };

        TEST(Phases, AStraightMotionIsAFirstPath)
        {
            const auto problem = test::freeProblem();
            problem->pdef->setOptimizationObjective(std::make_shared<Slope>(problem->si));
            const auto planner = problem->planner(test::Engine::Default);
            ASSERT_EQ(planner->solve(test::afterCalls(60000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(planner->shares().at("tightening"), 0.1);
            // while there is no path the trees have three tenths of the time, afterwards less
            EXPECT_LT(planner->shares().at("trees"), 0.15);
        }

        TEST(Phases, TheStraightMotionToALaterGoalIsAFirstPath)
        {
            // the first goal is behind the wall, the second one in front of it
            const auto problem = test::closedProblem();
            const auto goals = std::make_shared<ob::GoalStates>(problem->si);
            goals->addState(problem->state({9.0, 1.0}));
            problem->pdef->setGoal(goals);
            problem->pdef->setOptimizationObjective(std::make_shared<Slope>(problem->si));
            const auto planner = problem->planner(test::Engine::Default);
            EXPECT_NE(planner->solve(test::afterCalls(2000)), ob::PlannerStatus::EXACT_SOLUTION);
            goals->addState(problem->state({4.0, 4.0}));
            ASSERT_EQ(planner->solve(test::afterCalls(100000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(planner->shares().at("tightening"), 0.1);
        }
    }  // namespace
}  // namespace ompl_mfa
