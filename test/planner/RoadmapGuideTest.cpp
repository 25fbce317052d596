#include "ompl_mfa/planner/RoadmapGuide.h"

#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "ompl_mfa/planner/MFA.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* A roadmap for the wall of PlanningProblem.h, with its query. */
        class RoadmapGuideTest : public ::testing::Test
        {
        protected:
            RoadmapGuideTest()
            {
                planner_.setProblemDefinition(problem_->pdef);
                inputs_.use(problem_->pdef);
                query_.reset(*problem_->pdef);
                query_.begin(inputs_, ob::plannerNonTerminatingCondition(), chart_, problem_->si, 1);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            MFA planner_{problem_->si};
            StateChartPtr chart_ = std::make_shared<const StateChart>(problem_->si->getStateSpace());
            PathEvaluator evaluator_{problem_->si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si)};
            ob::PlannerInputStates inputs_;
            Query query_{problem_->si->getStateSpace()};
            Waypoints path_{problem_->si->getStateSpace()};
        };

        TEST_F(RoadmapGuideTest, FindsValidPathsAndBetterOnesAsItGrows)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            double best = std::numeric_limits<double>::infinity();
            int found = 0;
            for (int turn = 0; turn < 400 && found < 4; ++turn)
            {
                if (!roadmap.advance(query_, best, 5000, path_))
                    continue;
                ++found;
                EXPECT_TRUE(evaluator_.checkPath(path_));
                EXPECT_TRUE(problem_->si->equalStates(path_.front(), query_.starts()[0]));
                EXPECT_TRUE(problem_->si->equalStates(path_.back(), query_.goals()[0]));
                best = std::min(best, evaluator_.cost(path_).value());
            }
            EXPECT_EQ(found, 4);
        }

        TEST_F(RoadmapGuideTest, StopsWithTheCondition)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            evaluator_.setStopCondition([] { return true; });
            EXPECT_FALSE(roadmap.advance(query_, std::numeric_limits<double>::infinity(), 1000000, path_));
        }

        TEST_F(RoadmapGuideTest, TheSeedDecidesThePath)
        {
            const auto firstCost = [this](std::uint_fast32_t seed)
            {
                RoadmapGuide roadmap(&planner_, chart_, evaluator_, seed);
                while (!roadmap.advance(query_, std::numeric_limits<double>::infinity(), 5000, path_))
                {
                }
                return evaluator_.cost(path_).value();
            };
            EXPECT_EQ(firstCost(5), firstCost(5));
            EXPECT_NE(firstCost(5), firstCost(6));
        }
    }  // namespace
}  // namespace ompl_mfa
