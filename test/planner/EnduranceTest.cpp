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

/* What a planner must survive: cycles of solve and clear, less and less time, problem definitions that are destroyed,
   and a thousand solves in a row without growing. */

#include <malloc.h>

#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Console.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        class Endurance : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Endurance,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Endurance, CyclesOfSolveAndClear)
        {
            const auto planner = problem_->planner(GetParam());
            unsigned int exact = 0;
            for (int i = 0; i < 30; ++i)
            {
                const auto status = planner->solve(test::afterCalls(1 + 300 * static_cast<unsigned int>(i)));
                EXPECT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, planner->bestCost() < NEVER);
                if (status == ob::PlannerStatus::EXACT_SOLUTION)
                {
                    ++exact;
                    EXPECT_TRUE(problem_->pdef->hasExactSolution());
                    EXPECT_TRUE(problem_->pdef->getSolutionPath()->check());
                }
                if (i % 2 == 0)
                {
                    planner->clear();
                }
                if (i % 3 == 0)
                {
                    problem_->pdef->clearSolutionPaths();
                }
                if (i % 5 == 0)
                {
                    planner->clear();
                }
                if (i % 2 == 0 || i % 5 == 0)
                {
                    EXPECT_EQ(planner->bestCost(), NEVER) << "cleared";
                }
            }
            EXPECT_GE(exact, 15U);
        }

        TEST_P(Endurance, LessAndLessTime)
        {
            const auto planner = problem_->planner(GetParam());
            ASSERT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            double best = planner->bestCost();
            for (double seconds = 0.1; seconds > 1e-7; seconds /= 2.0)
            {
                // however little time there is, the known path is reported
                problem_->pdef->clearSolutionPaths();
                ASSERT_EQ(planner->solve(seconds), ob::PlannerStatus::EXACT_SOLUTION) << seconds << " s";
                EXPECT_LE(planner->bestCost(), best);
                best = planner->bestCost();
                EXPECT_EQ(problem_->reportedCost(), best);
            }
            for (double seconds = 0.1; seconds > 1e-7; seconds /= 2.0)
            {
                planner->clear();
                problem_->pdef->clearSolutionPaths();
                const auto status = planner->solve(seconds);
                EXPECT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, problem_->pdef->hasExactSolution());
                EXPECT_EQ(status == ob::PlannerStatus::APPROXIMATE_SOLUTION, problem_->pdef->hasApproximateSolution());
            }
        }

        TEST_P(Endurance, ProblemDefinitionsThatGoAway)
        {
            const auto planner = test::makePlanner(problem_->si, GetParam());
            for (int i = 0; i < 20; ++i)
            {
                auto pdef = std::make_shared<ob::ProblemDefinition>(problem_->si);
                const std::vector<double> start{1.0, 1.0 + 0.1 * i};
                pdef->setStartAndGoalStates(problem_->state(start), problem_->state({9.0, 1.0}));
                planner->setProblemDefinition(pdef);
                if (i % 2 == 0)
                {
                    planner->clear();
                }
                ASSERT_EQ(planner->solve(test::untilExact(pdef)), ob::PlannerStatus::EXACT_SOLUTION);
                const auto &path = *pdef->getSolutionPath()->as<og::PathGeometric>();
                EXPECT_TRUE(problem_->si->equalStates(path.getState(0), problem_->state(start).get()));
                planner->setProblemDefinition(ob::ProblemDefinitionPtr());
                pdef.reset();
                // calls without a problem definition must not access the old one
                ob::PlannerData data(problem_->si);
                planner->getPlannerData(data);
                planner->clear();
            }
        }

        TEST_P(Endurance, APlannerMayGoBeforeItsProblemDefinition)
        {
            auto planner = problem_->planner(GetParam());
            planner->solve(test::untilExact(problem_->pdef));
            planner.reset();
            EXPECT_TRUE(problem_->pdef->getSolutionPath()->check());
            problem_.reset();
        }

        TEST_P(Endurance, TheSameQueryInAnotherProblemDefinitionIsAnswered)
        {
            const auto planner = problem_->planner(GetParam());
            ASSERT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            const auto copy = std::make_shared<ob::ProblemDefinition>(problem_->si);
            copy->addStartState(problem_->state({1.0, 1.0}));
            copy->setGoal(problem_->pdef->getGoal());
            planner->setProblemDefinition(copy);
            EXPECT_EQ(planner->solve(test::untilExact(copy)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(copy->hasExactSolution());
        }

        /* Bytes that are allocated and not freed. Sanitizers replace the allocator, so nothing is counted then, and
           find leaks by themselves. */
        std::size_t bytesInUse()
        {
            const auto info = mallinfo2();
            return info.uordblks + info.hblkhd;
        }

        TEST_P(Endurance, AThousandSolvesDoNotGrow)
        {
            const auto level = ompl::msg::getLogLevel();
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            const auto planner = problem_->planner(GetParam());
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({9.0, 1.0}));
            goals->addState(problem_->state({9.0, 2.0}));
            problem_->pdef->setGoal(goals);
            std::size_t early = 0;
            for (int i = 0; i < 1000; ++i)
            {
                planner->solve(test::afterCalls(200));
                ob::PlannerData data(problem_->si);
                planner->getPlannerData(data);
                planner->clear();
                problem_->pdef->clearSolutionPaths();
                if (i == 200)
                {
                    early = bytesInUse();
                }
            }
            // 800 more solves; a state leaked in each would be 800 times 48 bytes
            EXPECT_LT(bytesInUse(), early + 16 * 1024);
            ompl::msg::setLogLevel(level);
        }

        /* A server that keeps its planner solves the same query in one problem definition after the other. */
        TEST_P(Endurance, TheSameQueryInAThousandProblemDefinitionsDoesNotGrow)
        {
            const auto level = ompl::msg::getLogLevel();
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            problem_ = test::freeProblem();
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({9.0, 1.0}));
            goals->addState(problem_->state({9.0, 2.0}));
            const auto planner = test::makePlanner(problem_->si, GetParam());
            std::size_t early = 0;
            std::size_t motions = 0;
            for (int i = 0; i < 1000; ++i)
            {
                const auto pdef = std::make_shared<ob::ProblemDefinition>(problem_->si);
                pdef->addStartState(problem_->state({1.0, 1.0}));
                pdef->addStartState(problem_->state({1.0, 1.0}));
                pdef->setGoal(goals);
                planner->setProblemDefinition(pdef);
                ASSERT_EQ(planner->solve(test::afterCalls(200)), ob::PlannerStatus::EXACT_SOLUTION);
                ASSERT_TRUE(pdef->hasExactSolution());
                if (i == 200)
                {
                    early = bytesInUse();
                    motions = problem_->counted.motions;
                }
            }
            EXPECT_LT(bytesInUse(), early + 16 * 1024);
            // the path to the nearer goal is optimal: only its own motion is checked again
            EXPECT_LE(problem_->counted.motions, motions + 800);
            ompl::msg::setLogLevel(level);
        }

        TEST_P(Endurance, AThousandPlannersLeaveNothing)
        {
            const auto level = ompl::msg::getLogLevel();
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            std::size_t early = 0;
            for (int i = 0; i < 1000; ++i)
            {
                const auto planner = problem_->planner(GetParam(), static_cast<unsigned int>(i + 1));
                planner->solve(test::afterCalls(200));
                problem_->pdef->clearSolutionPaths();
                if (i == 200)
                {
                    early = bytesInUse();
                }
            }
            EXPECT_LT(bytesInUse(), early + 16 * 1024);
            ompl::msg::setLogLevel(level);
        }

        /* A roadmap keeps its samples; the paper's swarm needs no more memory for a longer search. */
        TEST(LongSearch, OfThePaperDoesNotGrow)
        {
            const auto problem = test::wallProblem();
            const auto planner = problem->planner(test::PlannerVariant::Paper);
            planner->solve(test::afterCalls(30000));
            const std::size_t early = bytesInUse();
            planner->solve(test::afterCalls(30000));
            planner->solve(test::afterCalls(30000));
            EXPECT_LT(bytesInUse(), early + 256 * 1024);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
