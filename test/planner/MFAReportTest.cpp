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

#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        class Report : public ::testing::TestWithParam<test::PlannerVariant>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            std::shared_ptr<MFA> planner_ = problem_->planner(GetParam());
            ob::PlannerData data_{problem_->si};
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Report,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Report, PlannerDataIsEmptyBeforeTheSearch)
        {
            planner_->getPlannerData(data_);
            EXPECT_EQ(data_.numVertices(), 0U);
        }

        TEST_P(Report, PlannerDataMarksStartAndGoalOnce)
        {
            planner_->solve(test::afterCalls(3000));
            planner_->getPlannerData(data_);
            ASSERT_EQ(data_.numStartVertices(), 1U);
            ASSERT_EQ(data_.numGoalVertices(), 1U);
            const auto &space = problem_->si->getStateSpace();
            EXPECT_TRUE(space->equalStates(data_.getStartVertex(0).getState(), problem_->pdef->getStartState(0)));
            EXPECT_TRUE(problem_->pdef->getGoal()->isSatisfied(data_.getGoalVertex(0).getState()));
            EXPECT_GT(data_.numVertices(), 20U);
        }

        TEST_P(Report, EveryEdgeOfThePlannerDataIsAValidMotion)
        {
            planner_->solve(test::afterCalls(3000));
            planner_->getPlannerData(data_);
            EXPECT_GT(data_.numEdges(), 0U);
            for (unsigned int i = 0; i < data_.numVertices(); ++i)
            {
                std::vector<unsigned int> targets;
                data_.getEdges(i, targets);
                for (const unsigned int j : targets)
                {
                    EXPECT_TRUE(
                        problem_->si->checkMotion(data_.getVertex(i).getState(), data_.getVertex(j).getState()));
                }
            }
        }

        TEST_P(Report, EveryVertexOfThePlannerDataIsValid)
        {
            for (const unsigned int calls : {300U, 3000U, 30000U})
            {
                planner_->solve(test::afterCalls(calls));
                ob::PlannerData data(problem_->si);
                planner_->getPlannerData(data);
                for (unsigned int i = 0; i < data.numVertices(); ++i)
                {
                    EXPECT_TRUE(problem_->si->isValid(data.getVertex(i).getState())) << calls;
                }
            }
        }

        TEST_P(Report, PlannerDataShowTheRoadmapThatFoundThePath)
        {
            if (GetParam() == test::PlannerVariant::Paper)
            {
                GTEST_SKIP() << "the paper's algorithm has no roadmap";
            }
            test::set(*planner_, "guide", "roadmap");
            planner_->solve(test::untilExact(problem_->pdef));
            planner_->solve(test::afterCalls(20000));
            planner_->getPlannerData(data_);
            // fireflies and the best path have a few dozen states each
            EXPECT_GT(data_.numVertices(), 200U);
            EXPECT_GT(data_.numEdges(), 50U);
        }

        TEST_P(Report, TheSolutionIsAWayThroughThePlannerData)
        {
            ASSERT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            planner_->solve(test::afterCalls(2000));
            planner_->getPlannerData(data_);
            // all states reachable from the start
            std::set<unsigned int> seen{data_.getStartIndex(0)};
            std::vector<unsigned int> left{data_.getStartIndex(0)};
            while (!left.empty())
            {
                std::vector<unsigned int> targets;
                data_.getEdges(left.back(), targets);
                left.pop_back();
                for (const unsigned int j : targets)
                {
                    if (seen.insert(j).second)
                    {
                        left.push_back(j);
                    }
                }
            }
            EXPECT_EQ(seen.count(data_.getGoalIndex(0)), 1U);
        }

        TEST_P(Report, PlannerDataOwnsItsStates)
        {
            planner_->solve(test::afterCalls(3000));
            planner_->getPlannerData(data_);
            const unsigned int vertices = data_.numVertices();
            ASSERT_GT(vertices, 2U);
            std::vector<ob::ScopedState<>> states;
            for (unsigned int i = 0; i < vertices; ++i)
            {
                states.emplace_back(problem_->si->getStateSpace(), data_.getVertex(i).getState());
            }
            // neither another reader, nor the search, nor the planner's destruction changes them
            ob::PlannerData other(problem_->si);
            planner_->getPlannerData(other);
            planner_->solve(test::afterCalls(3000));
            planner_->clear();
            planner_.reset();
            EXPECT_EQ(data_.numVertices(), vertices);
            for (unsigned int i = 0; i < vertices; ++i)
            {
                EXPECT_TRUE(problem_->si->equalStates(data_.getVertex(i).getState(), states[i].get()));
            }
        }

        TEST_P(Report, PlannerDataHoldsTheProgressProperties)
        {
            planner_->solve(test::afterCalls(3000));
            planner_->getPlannerData(data_);
            EXPECT_EQ(data_.properties.count("best cost REAL"), 1U);
        }

        TEST_P(Report, PlannerDataMayBeAskedForInACallback)
        {
            unsigned int vertices = 0;
            problem_->pdef->setIntermediateSolutionCallback(
                [&](const ob::Planner *planner, const std::vector<const ob::State *> &, const ob::Cost)
                {
                    ob::PlannerData data(problem_->si);
                    planner->getPlannerData(data);
                    vertices = data.numVertices();
                });
            planner_->solve(test::untilExact(problem_->pdef));
            EXPECT_GE(vertices, 2U);
        }

        TEST_P(Report, TheSwarmsPathsRunFromStartToGoal)
        {
            EXPECT_TRUE(planner_->getSwarmPaths().empty());
            EXPECT_TRUE(planner_->getSlicePaths().empty());
            planner_->solve(test::afterCalls(200000));
            auto paths = planner_->getSwarmPaths();
            ASSERT_FALSE(paths.empty());
            const auto &space = problem_->si->getStateSpace();
            for (auto &path : paths)
            {
                EXPECT_TRUE(space->equalStates(path.getState(0), problem_->pdef->getStartState(0)));
                EXPECT_TRUE(problem_->pdef->getGoal()->isSatisfied(path.getState(path.getStateCount() - 1)));
                for (const ob::State *state : path.getStates())
                {
                    EXPECT_TRUE(space->satisfiesBounds(state));
                }
            }
        }

        /* By default the fireflies are whole paths once there is one. */
        TEST_P(Report, TheSwarmsPathsBeginWithTheBest)
        {
            planner_->solve(test::afterCalls(200000));
            const auto paths = planner_->getSwarmPaths();
            ASSERT_GT(paths.size(), 1U);
            if (GetParam() == test::PlannerVariant::Default)
            {
                // the path to return is made from it and may be slightly longer, see the parameter strictness
                EXPECT_LE(paths[0].length(), planner_->bestCost() * (1.0 + 1e-12));
                EXPECT_NEAR(paths[0].length(), planner_->bestCost(), 0.01 * planner_->bestCost());
                for (std::size_t i = 1; i < paths.size(); ++i)
                {
                    EXPECT_LE(paths[i - 1].length(), paths[i].length());
                }
            }
        }

        /* By default a swarm has slices only as long as there is no path. */
        class SlicesReport : public Report
        {
        protected:
            SlicesReport()
            {
                problem_ = test::closedProblem();
                planner_ = problem_->planner(GetParam());
            }
        };

        INSTANTIATE_TEST_SUITE_P(Planner, SlicesReport,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(SlicesReport, TheSlicesEndWithinTheBounds)
        {
            planner_->solve(test::afterCalls(200000));
            auto slices = planner_->getSlicePaths();
            ASSERT_FALSE(slices.empty());
            for (auto &slice : slices)
            {
                EXPECT_EQ(slice.getStateCount(), 2U);
                for (const ob::State *state : slice.getStates())
                {
                    EXPECT_TRUE(problem_->si->satisfiesBounds(state));
                }
            }
        }

        TEST_P(SlicesReport, SlicesAreShownFromTheFirstSwarmOn)
        {
            bool shown = false;
            unsigned int solves = 0;
            for (unsigned int i = 0; i < 300; ++i)
            {
                planner_->solve(test::afterCalls(700));
                const bool now = !planner_->getSlicePaths().empty();
                EXPECT_TRUE(now || !shown) << "after solve() " << i;
                shown = shown || now;
                solves += shown ? 1 : 0;
            }
            EXPECT_GT(solves, 100U);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
