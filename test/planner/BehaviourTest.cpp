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

/* MFA over time: solved again, cleared, given other queries, and what it publishes meanwhile. */

#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr double NEVER = std::numeric_limits<double>::infinity();

        class Behaviour : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            og::PathGeometric &path() const
            {
                return problem_->path();
            }

            void expectPath(const std::vector<double> &start, const std::vector<double> &goal) const
            {
                const auto &space = problem_->si->getStateSpace();
                EXPECT_TRUE(space->equalStates(path().getState(0), problem_->state(start).get()));
                EXPECT_TRUE(
                    space->equalStates(path().getState(path().getStateCount() - 1), problem_->state(goal).get()));
                EXPECT_TRUE(path().check());
            }

            std::string progress(const std::string &name) const
            {
                return planner_->getPlannerProgressProperties().at(name)();
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            ob::ProblemDefinition &pdef_ = *problem_->pdef;
            std::shared_ptr<MFA> planner_ = problem_->planner(GetParam());
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Behaviour,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Behaviour, AStraightMotionThatWasCutShortIsTriedAgain)
        {
            for (unsigned int calls = 1; calls <= 12; ++calls)
            {
                const auto problem = test::freeProblem();
                const auto planner = problem->planner(GetParam());
                planner->solve(test::afterCalls(calls));
                planner->solve(test::afterCalls(2000));
                EXPECT_NEAR(planner->bestCost(), 8.0, 1e-9) << calls;
            }
        }

        TEST_P(Behaviour, SolvingAgainContinuesAndIsNeverWorse)
        {
            ASSERT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            const double first = planner_->bestCost();
            const std::uint64_t firstEvaluations = planner_->evaluations();
            double best = first;
            std::uint64_t evaluations = firstEvaluations;
            std::uint64_t iterations = planner_->iterations();
            for (int i = 0; i < 8; ++i)
            {
                // a planner that restarts from the same seed has nothing to report after so few calls
                pdef_.clearSolutionPaths();
                ASSERT_EQ(planner_->solve(test::afterCalls(2)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_LE(planner_->bestCost(), best);
                ASSERT_EQ(planner_->solve(test::afterCalls(3000)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_LE(planner_->bestCost(), best);
                EXPECT_GE(planner_->evaluations(), evaluations);
                EXPECT_GE(planner_->iterations(), iterations);
                best = planner_->bestCost();
                evaluations = planner_->evaluations();
                iterations = planner_->iterations();
                EXPECT_EQ(problem_->reportedCost(), best);
                EXPECT_NEAR(path().length(), best, 1e-9);
            }
            EXPECT_LT(best, first) << "24000 calls later";
            EXPECT_GT(evaluations, firstEvaluations);
        }

        TEST_P(Behaviour, ASolutionIsReportedAgainWhenTheProblemDefinitionForgotIt)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            pdef_.clearSolutionPaths();
            EXPECT_EQ(planner_->solve(test::afterCalls(2)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(pdef_.hasExactSolution());
            expectPath({1.0, 1.0}, {9.0, 1.0});
        }

        TEST_P(Behaviour, ClearForgetsAll)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            planner_->solve(test::afterCalls(3000));
            planner_->clear();
            EXPECT_EQ(planner_->bestCost(), NEVER);
            EXPECT_EQ(planner_->iterations(), 0U);
            EXPECT_EQ(planner_->evaluations(), 0U);
            EXPECT_EQ(progress("best cost REAL"), "inf");
            EXPECT_EQ(progress("iterations INTEGER"), "0");
            EXPECT_TRUE(planner_->getSwarmPaths().empty());
            ob::PlannerData data(problem_->si);
            planner_->getPlannerData(data);
            EXPECT_EQ(data.numVertices(), 0U);
            pdef_.clearSolutionPaths();
            EXPECT_EQ(planner_->solve(0.0), ob::PlannerStatus::TIMEOUT) << "nothing may be left to report";
            EXPECT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
        }

        TEST_P(Behaviour, ClearQueryForgetsTheQuery)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            planner_->clearQuery();
            pdef_.clearSolutionPaths();
            pdef_.clearStartStates();
            pdef_.addStartState(problem_->state({1.0, 3.0}));
            EXPECT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            expectPath({1.0, 3.0}, {9.0, 1.0});
        }

        TEST_P(Behaviour, AChangedStartIsHonoured)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            pdef_.clearSolutionPaths();
            pdef_.clearStartStates();
            pdef_.addStartState(problem_->state({2.0, 3.0}));
            EXPECT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            expectPath({2.0, 3.0}, {9.0, 1.0});
            EXPECT_NEAR(planner_->bestCost(), path().length(), 1e-9);
        }

        TEST_P(Behaviour, AChangedGoalIsHonoured)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            pdef_.clearSolutionPaths();
            pdef_.setGoalState(problem_->state({8.0, 3.0}));
            EXPECT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            expectPath({1.0, 1.0}, {8.0, 3.0});
            pdef_.clearSolutionPaths();
            pdef_.getGoal()->as<ob::GoalState>()->setState(problem_->state({7.0, 2.0}));
            EXPECT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            expectPath({1.0, 1.0}, {7.0, 2.0});
        }

        TEST_P(Behaviour, AChangedObjectiveIsHonoured)
        {
            class ThreeTimesTheLength : public ob::PathLengthOptimizationObjective
            {
            public:
                using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

                ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
                {
                    return ob::Cost(3.0 * si_->distance(from, to));
                }
            };
            planner_->solve(test::untilExact(problem_->pdef));
            pdef_.clearSolutionPaths();
            pdef_.setOptimizationObjective(std::make_shared<ThreeTimesTheLength>(problem_->si));
            EXPECT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_NEAR(planner_->bestCost(), 3.0 * path().length(), 1e-9);
        }

        TEST_P(Behaviour, AnAddedStartIsTakenUpWithoutStartingAnew)
        {
            planner_->solve(test::afterCalls(2000));
            const auto evaluations = planner_->evaluations();
            pdef_.addStartState(problem_->state({8.0, 1.0}));
            EXPECT_EQ(planner_->solve(test::afterCalls(1000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(planner_->evaluations(), evaluations);
            EXPECT_NEAR(planner_->bestCost(), 1.0, 1e-9);
            expectPath({8.0, 1.0}, {9.0, 1.0});
        }

        TEST_P(Behaviour, SetupBeforeAProblemDefinitionExistsIsFine)
        {
            const auto planner = test::makePlanner(problem_->si, GetParam());
            planner->setup();
            EXPECT_TRUE(planner->isSetup());
            planner->clear();
            ob::PlannerData data(problem_->si);
            planner->getPlannerData(data);
            EXPECT_EQ(data.numVertices(), 0U);
            planner->setProblemDefinition(problem_->pdef);
            EXPECT_EQ(planner->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
        }

        TEST_P(Behaviour, EveryImprovementIsPublishedFromStartToGoal)
        {
            std::vector<double> costs;
            pdef_.setIntermediateSolutionCallback(
                [&](const ob::Planner *from, const std::vector<const ob::State *> &states, const ob::Cost cost)
                {
                    EXPECT_EQ(from, planner_.get());
                    ASSERT_GE(states.size(), 2U);
                    const auto &space = problem_->si->getStateSpace();
                    EXPECT_TRUE(space->equalStates(states.front(), pdef_.getStartState(0)));
                    EXPECT_TRUE(pdef_.getGoal()->isSatisfied(states.back()));
                    og::PathGeometric published(problem_->si);
                    for (const ob::State *state : states)
                    {
                        published.append(state);
                    }
                    EXPECT_TRUE(published.check());
                    EXPECT_NEAR(published.length(), cost.value(), 1e-9);
                    if (!costs.empty())
                    {
                        EXPECT_LT(cost.value(), costs.back());
                    }
                    costs.push_back(cost.value());
                    EXPECT_EQ(planner_->bestCost(), cost.value());
                    EXPECT_EQ(problem_->reportedCost(), cost.value()) << "the problem definition has it as well";
                });
            ASSERT_EQ(planner_->solve(test::afterCalls(5000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GE(costs.size(), 2U);
            EXPECT_GE(pdef_.getSolutionCount(), 1U);
            EXPECT_EQ(costs.back(), planner_->bestCost());
            EXPECT_EQ(costs.back(), problem_->reportedCost());
        }

        TEST_P(Behaviour, PublishedPathsAreThePlannersNoMore)
        {
            planner_->solve(test::untilExact(problem_->pdef));
            const auto kept = pdef_.getSolutionPath();
            planner_->solve(test::afterCalls(2000));
            planner_->clear();
            planner_.reset();
            EXPECT_TRUE(kept->check());
        }

        TEST_P(Behaviour, ProgressIsPublishedUnderTheNamesThatOmplsToolsKnow)
        {
            EXPECT_EQ(progress("best cost REAL"), "inf");
            EXPECT_EQ(progress("iterations INTEGER"), "0");
            planner_->solve(test::untilExact(problem_->pdef));
            planner_->solve(test::afterCalls(200000));
            // printed with six digits, as OMPL's own planners do
            EXPECT_NEAR(std::stod(progress("best cost REAL")), planner_->bestCost(), 1e-5 * planner_->bestCost());
            EXPECT_EQ(progress("iterations INTEGER"), std::to_string(planner_->iterations()));
            // with guides, the fireflies usually have a path before their first generation, and none after that
            if (GetParam() == test::PlannerVariant::Paper)
            {
                EXPECT_GT(planner_->iterations(), 0U);
            }
        }

        TEST_P(Behaviour, ASeedMakesARunReproducible)
        {
            const auto run = [this](std::uint32_t seed, unsigned int iterations)
            {
                const auto planner = problem_->planner(GetParam(), seed);
                pdef_.clearSolutionPaths();
                ob::IterationTerminationCondition limit(iterations);
                planner->solve(ob::PlannerTerminationCondition(limit));
                std::vector<double> values{planner->bestCost(), static_cast<double>(planner->evaluations())};
                for (auto &swarmPath : planner->getSwarmPaths())
                {
                    for (ob::State *state : swarmPath.getStates())
                    {
                        values.insert(values.end(), {test::coordinate(state, 0), test::coordinate(state, 1)});
                    }
                }
                if (pdef_.hasExactSolution())
                {
                    for (ob::State *state : path().getStates())
                    {
                        values.insert(values.end(), {test::coordinate(state, 0), test::coordinate(state, 1)});
                    }
                }
                return values;
            };
            for (const unsigned int iterations : {100U, 1000U, 6000U})
            {
                EXPECT_EQ(run(11, iterations), run(11, iterations)) << iterations << " iterations";
                EXPECT_NE(run(11, iterations), run(12, iterations));
            }
        }

        TEST_P(Behaviour, TheSeedHoldsAfterClearToo)
        {
            const auto run = [this]
            {
                planner_->clear();
                pdef_.clearSolutionPaths();
                planner_->solve(test::afterCalls(3000));
                return planner_->bestCost();
            };
            EXPECT_EQ(run(), run());
        }

        TEST_P(Behaviour, SeedZeroIsADifferentRunEveryTime)
        {
            std::set<double> costs;
            for (int i = 0; i < 4; ++i)
            {
                const auto planner = problem_->planner(GetParam(), 0);
                pdef_.clearSolutionPaths();
                planner->solve(test::untilExact(problem_->pdef));
                costs.insert(planner->bestCost());
            }
            EXPECT_GT(costs.size(), 1U);
        }

        TEST_P(Behaviour, SpecsAreTrue)
        {
            const auto &specs = planner_->getSpecs();
            EXPECT_EQ(specs.recognizedGoal, ob::GOAL_REGION);
            EXPECT_TRUE(specs.optimizingPaths);
            EXPECT_TRUE(specs.approximateSolutions);
            EXPECT_TRUE(specs.directed);
            EXPECT_TRUE(specs.canReportIntermediateSolutions);
            EXPECT_FALSE(specs.multithreaded);
            EXPECT_FALSE(specs.provingSolutionNonExistence);
            EXPECT_EQ(planner_->getName(), "MFA");
        }
    }  // namespace
}  // namespace ompl_mfa::planner
