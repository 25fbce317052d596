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

#include "benchmark/RestartSimplify.h"

#include <chrono>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

#include "benchmark/PlanarProblem.h"
#include "ompl_mfa/benchmark/PlannerFactory.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::benchmark
{
    namespace
    {
        using test::planarOptimum;
        using test::planarProblem;

        class RestartSimplifyTest : public testing::Test
        {
        protected:
            void use(const ob::ProblemDefinitionPtr &pdef)
            {
                planner_->setProblemDefinition(pdef);
            }

            ob::PlannerStatus solve(unsigned int evaluations = 3000)
            {
                return planner_->solve(ob::IterationTerminationCondition(evaluations));
            }

            ob::ScopedState<> state(double x, double y) const
            {
                ob::ScopedState<> made(si_);
                made[0] = x;
                made[1] = y;
                return made;
            }

            std::string progress(const std::string &property) const
            {
                return planner_->getPlannerProgressProperties().at(property)();
            }

            og::PathGeometric solution() const
            {
                return *pdef_->getSolutionPath()->as<og::PathGeometric>();
            }

            og::SimpleSetupPtr setup_{planarProblem()};
            ob::SpaceInformationPtr si_{setup_->getSpaceInformation()};
            ob::ProblemDefinitionPtr pdef_{setup_->getProblemDefinition()};
            std::shared_ptr<RestartSimplify> planner_{std::make_shared<RestartSimplify>(si_)};
        };

        TEST_F(RestartSimplifyTest, FindsBetterPathsThanOneRRTConnect)
        {
            const auto single = std::make_shared<og::RRTConnect>(si_);
            const auto problem = pdef_->clone();
            single->setProblemDefinition(problem);
            ASSERT_EQ(single->solve(ob::timedPlannerTerminationCondition(10.0)), ob::PlannerStatus::EXACT_SOLUTION);
            use(pdef_);
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(planner_->pathsFound(), 20U);
            EXPECT_LT(planner_->bestCost(), problem->getSolutionPath()->length());
            EXPECT_LT(planner_->bestCost(), 1.01 * planarOptimum());
            EXPECT_NEAR(solution().length(), planner_->bestCost(), 1e-12);
        }

        TEST_F(RestartSimplifyTest, TellsEveryBetterPathAtOnce)
        {
            std::vector<double> costs;
            bool endsRight = true;
            bool known = true;
            pdef_->setIntermediateSolutionCallback(
                [&](const ob::Planner *planner, const std::vector<const ob::State *> &states, ob::Cost cost)
                {
                    og::PathGeometric path(si_);
                    for (const ob::State *state : states)
                    {
                        path.append(state);
                    }
                    EXPECT_EQ(planner, planner_.get());
                    EXPECT_TRUE(path.check());
                    EXPECT_NEAR(path.length(), cost.value(), 1e-12);
                    endsRight = endsRight && si_->equalStates(states.front(), pdef_->getStartState(0)) &&
                                pdef_->getGoal()->isSatisfied(states.back());
                    known = known && std::abs(solution().length() - cost.value()) < 1e-12;
                    EXPECT_EQ(std::stod(progress("best cost REAL")), cost.value());
                    costs.push_back(cost.value());
                });
            use(pdef_);
            EXPECT_EQ(progress("best cost REAL"), "inf");
            solve();
            EXPECT_TRUE(endsRight);
            EXPECT_TRUE(known) << "a cost was reported before its path was a solution of the problem";
            ASSERT_GT(costs.size(), 1U);
            for (std::size_t i = 1; i < costs.size(); ++i)
            {
                EXPECT_LT(costs[i], costs[i - 1]);
            }
            EXPECT_EQ(costs.back(), planner_->bestCost());
            EXPECT_EQ(pdef_->getSolutionCount(), costs.size());
            EXPECT_EQ(progress("iterations INTEGER"), std::to_string(planner_->pathsFound()));
        }

        /* Motions pass between small discs at this resolution, and halves of motions do not: the simplification, which
           halves them, has invalid paths where it is interrupted before it repairs them. */
        TEST_F(RestartSimplifyTest, EverySolutionPassesItsCheck)
        {
            si_->setStateValidityChecker(
                [](const ob::State *state)
                {
                    const auto &x = *state->as<ob::RealVectorStateSpace::StateType>();
                    return std::hypot(std::fmod(x[0], 0.5) - 0.25, std::fmod(x[1], 0.5) - 0.25) > 0.15;
                });
            si_->setStateValidityCheckingResolution(0.1);
            si_->setup();
            std::size_t solutions = 0;
            for (unsigned int evaluations = 5; evaluations < 500; ++evaluations)
            {
                const auto problem = pdef_->clone();
                use(problem);
                solve(evaluations);
                for (const auto &solution : problem->getSolutions())
                {
                    EXPECT_TRUE(solution.approximate_ || solution.path_->check());
                    ++solutions;
                }
            }
            EXPECT_GT(solutions, 500U);
        }

        /* A start has one goal of its own. */
        class OwnGoals : public ob::GoalStates
        {
        public:
            OwnGoals(const ob::SpaceInformationPtr &si, const ob::ScopedState<> &own, const ob::ScopedState<> &other)
              : GoalStates(si)
            {
                addState(own);
                addState(other);
            }

            bool isStartGoalPairValid(const ob::State * /*start*/, const ob::State *goal) const override
            {
                return si_->equalStates(goal, getState(0));
            }
        };

        TEST_F(RestartSimplifyTest, KeepsToTheGoalThatAStartHas)
        {
            pdef_->setGoal(std::make_shared<OwnGoals>(si_, state(9.0, 5.0), state(8.0, 5.0)));
            use(pdef_);
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            for (const auto &solution : pdef_->getSolutions())
            {
                const auto &states = solution.path_->as<og::PathGeometric>()->getStates();
                EXPECT_TRUE(si_->equalStates(states.back(), state(9.0, 5.0).get()));
            }
        }

        TEST_F(RestartSimplifyTest, TakesTheBestOfSeveralStartsAndGoals)
        {
            pdef_->clearStartStates();
            pdef_->addStartState(state(0.5, 0.5));
            pdef_->addStartState(state(5.0, 5.0));  // in collision
            pdef_->addStartState(state(4.0, 9.0));
            const auto goals = std::make_shared<ob::GoalStates>(si_);
            goals->addState(state(9.5, 0.5));
            goals->addState(state(6.0, 9.0));
            pdef_->setGoal(goals);
            use(pdef_);
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_NEAR(planner_->bestCost(), 2.0, 1e-3);
            const auto path = solution();
            EXPECT_TRUE(si_->equalStates(path.getState(0), state(4.0, 9.0).get()));
            EXPECT_TRUE(si_->equalStates(path.getState(path.getStateCount() - 1), state(6.0, 9.0).get()));
        }

        TEST_F(RestartSimplifyTest, HonoursAnObjectiveThatIsNotALength)
        {
            pdef_->setStartAndGoalStates(state(0.5, 0.5), state(9.5, 9.5));
            const auto clearance = std::make_shared<ob::MaximizeMinClearanceObjective>(si_);
            clearance->setCostThreshold(ob::Cost(10.0));
            pdef_->setOptimizationObjective(clearance);
            std::vector<double> costs;
            pdef_->setIntermediateSolutionCallback([&costs](const ob::Planner *, const std::vector<const ob::State *> &,
                                                            ob::Cost cost) { costs.push_back(cost.value()); });
            use(pdef_);
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            for (std::size_t i = 1; i < costs.size(); ++i)
            {
                EXPECT_GT(costs[i], costs[i - 1]);
            }
            EXPECT_EQ(solution().cost(clearance).value(), planner_->bestCost());
            EXPECT_GT(planner_->bestCost(), 0.5);
        }

        TEST_F(RestartSimplifyTest, ShortensPathsWithoutAnObjective)
        {
            pdef_->setOptimizationObjective(nullptr);
            use(pdef_);
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LT(solution().length(), 1.01 * planarOptimum());
            EXPECT_FALSE(pdef_->getOptimizationObjective());
        }

        TEST_F(RestartSimplifyTest, ReturnsWhenTheObjectiveIsSatisfied)
        {
            pdef_->getOptimizationObjective()->setCostThreshold(ob::Cost(1.02 * planarOptimum()));
            use(pdef_);
            EXPECT_EQ(planner_->solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LT(planner_->bestCost(), 1.02 * planarOptimum());
            EXPECT_TRUE(pdef_->hasOptimizedSolution());
            const auto found = planner_->pathsFound();
            EXPECT_EQ(planner_->solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(planner_->pathsFound(), found) << "there was nothing left to do";
        }

        TEST_F(RestartSimplifyTest, ClearForgetsEverything)
        {
            use(pdef_);
            solve();
            planner_->clear();
            EXPECT_EQ(planner_->bestCost(), std::numeric_limits<double>::infinity());
            EXPECT_EQ(planner_->pathsFound(), 0U);
            ob::PlannerData data(si_);
            planner_->getPlannerData(data);
            EXPECT_EQ(data.numVertices(), 0U);
            pdef_->clearSolutionPaths();
            EXPECT_EQ(planner_->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
            EXPECT_FALSE(pdef_->hasSolution());
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(pdef_->hasExactSolution());
        }

        TEST_F(RestartSimplifyTest, AnotherProblemIsSolvedAnew)
        {
            use(pdef_);
            solve();
            const auto other = pdef_->clone();
            other->setGoalState(state(1.0, 6.0));
            use(other);
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_NEAR(other->getSolutionPath()->length(), 1.0, 1e-3);
            EXPECT_NEAR(planner_->bestCost(), 1.0, 1e-3);
        }

        TEST_F(RestartSimplifyTest, AFurtherSolveKeepsTheBestPath)
        {
            use(pdef_);
            solve();
            const double cost = planner_->bestCost();
            // as SimpleSetup does when it simplifies
            const auto &states = pdef_->getSolutionPath()->as<og::PathGeometric>()->getStates();
            si_->copyState(states.back(), state(5.0, 5.0).get());
            pdef_->clearSolutionPaths();
            EXPECT_EQ(planner_->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
            ASSERT_EQ(pdef_->getSolutionCount(), 1U);
            EXPECT_EQ(solution().length(), cost);
            EXPECT_TRUE(solution().check());
            EXPECT_EQ(planner_->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(pdef_->getSolutionCount(), 1U) << "the same path twice";
            EXPECT_EQ(solve(), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LE(planner_->bestCost(), cost);
        }

        TEST_F(RestartSimplifyTest, GoesOnWithTreesThatWereInterrupted)
        {
            planner_->setRange(0.05);
            use(pdef_);
            EXPECT_EQ(solve(20), ob::PlannerStatus::APPROXIMATE_SOLUTION);
            EXPECT_FALSE(pdef_->hasExactSolution());
            EXPECT_TRUE(pdef_->hasApproximateSolution());
            EXPECT_GT(pdef_->getSolutionDifference(), 0.0);
            EXPECT_EQ(pdef_->getSolutions().front().plannerName_, "RestartSimplify");
            std::size_t states = 0;
            for (int i = 0; i < 200 && !pdef_->hasExactSolution(); ++i)
            {
                ob::PlannerData data(si_);
                planner_->getPlannerData(data);
                EXPECT_GE(data.numVertices(), states);
                states = data.numVertices();
                solve(20);
            }
            EXPECT_TRUE(pdef_->hasExactSolution());
            EXPECT_GT(states, 20U);
        }

        TEST_F(RestartSimplifyTest, StopsSoonAfterItIsTold)
        {
            use(pdef_);
            const auto start = std::chrono::steady_clock::now();
            EXPECT_EQ(planner_->solve(ob::timedPlannerTerminationCondition(0.2)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
        }

        TEST_F(RestartSimplifyTest, ShowsItsLastTrees)
        {
            pdef_->getOptimizationObjective()->setCostThreshold(ob::Cost(1000.0));  // the first path will do
            use(pdef_);
            planner_->solve(ob::plannerNonTerminatingCondition());
            EXPECT_EQ(planner_->pathsFound(), 1U);
            ob::PlannerData data(si_);
            planner_->getPlannerData(data);
            EXPECT_GE(data.numVertices(), 3U);
            EXPECT_EQ(data.numStartVertices(), 1U);
            EXPECT_EQ(data.numGoalVertices(), 1U);
            EXPECT_TRUE(si_->equalStates(data.getStartVertex(0).getState(), pdef_->getStartState(0)));
            EXPECT_TRUE(data.properties.count("best cost REAL") > 0);
        }

        TEST_F(RestartSimplifyTest, SaysWhatIsWrongWithAProblem)
        {
            pdef_->clearStartStates();
            pdef_->addStartState(state(5.0, 5.0));
            use(pdef_);
            EXPECT_EQ(solve(), ob::PlannerStatus::INVALID_START);
            EXPECT_FALSE(pdef_->hasSolution());
        }

        TEST_F(RestartSimplifyTest, IsMadeFromAConfig)
        {
            std::istringstream text(
                "[problem]\nrobot = point\nstart.x = 1\nstart.y = 1\ngoal.x = 9\ngoal.y = 9\n"
                "volume.min.x = 0\nvolume.min.y = 0\nvolume.max.x = 10\nvolume.max.y = 10\n"
                "[planner]\nrestart_simplify =\nrestart_simplify.range = 0.5\n");
            const BenchmarkConfig config = parseBenchmarkConfig(text, "folder/a.cfg");
            const auto setup = ProblemFactory(config).create();
            const auto planner = createPlanner(setup->getSpaceInformation(), config.planners.at(0));
            ASSERT_TRUE(std::dynamic_pointer_cast<RestartSimplify>(planner));
            setup->setPlanner(planner);
            setup->setup();
            EXPECT_EQ(planner->as<RestartSimplify>()->getRange(), 0.5);
            EXPECT_EQ(setup->solve(ob::IterationTerminationCondition(500)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_NEAR(setup->getSolutionPath().length(), std::hypot(8.0, 8.0), 1e-2);
        }

        TEST_F(RestartSimplifyTest, TheRangeIsThatOfRRTConnect)
        {
            const og::RRTConnect trees(si_);
            EXPECT_EQ(planner_->getRange(), trees.getRange());
            use(pdef_);
            planner_->setup();
            EXPECT_GT(planner_->getRange(), 0.0) << "setup() chooses";
            planner_->params().setParam("range", "0.25");
            EXPECT_EQ(planner_->getRange(), 0.25);
            solve(300);
            ob::PlannerData data(si_);
            planner_->getPlannerData(data);
            for (unsigned int i = 0; i < data.numVertices(); ++i)
            {
                std::map<unsigned int, const ob::PlannerDataEdge *> edges;
                data.getEdges(i, edges);
                for (const auto &[to, edge] : edges)
                {
                    EXPECT_LE(si_->distance(data.getVertex(i).getState(), data.getVertex(to).getState()), 0.25 + 1e-9);
                }
            }
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
