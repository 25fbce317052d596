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

#include "engine/guides/GuestPlannerPart.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Exception.h>

#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        template <typename Planner>
        ob::PlannerPtr make(const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<Planner>(si);
        }

        /* The square [0, 10]^2 with a room around (3, 5) that is open to the left, away from the goal: a path has to
           leave it backwards, which slices across the line from start to goal cannot express. */
        std::unique_ptr<test::PlanningProblem> roomProblem()
        {
            return std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, 0.0, 10.0),
                [](const ob::State *s)
                {
                    const double x = test::coordinate(s, 0);
                    const double y = test::coordinate(s, 1);
                    const bool inside = x < 4.0 && y > 3.0 && y < 7.0;
                    const bool block = x > 2.0 && x < 5.0 && y > 2.0 && y < 8.0;
                    return inside || !block;
                },
                std::vector<double>{3.5, 5.0}, std::vector<double>{9.0, 5.0});
        }

        /* The length of the shortest path of roomProblem(). */
        const double ROOM_OPTIMUM = std::hypot(1.5, 2.0) + 1.0 + 3.0 + std::hypot(4.0, 3.0);

        /* A planner whose solve() is given by a test. */
        class ScriptedPlanner : public ob::Planner
        {
        public:
            using Script = std::function<ob::PlannerStatus(const ob::ProblemDefinitionPtr &,
                                                           const ob::PlannerTerminationCondition &)>;

            ScriptedPlanner(const ob::SpaceInformationPtr &si, Script script)
              : Planner(si, "Scripted")
              , script_(std::move(script))
            {
            }

            ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override
            {
                return script_(pdef_, ptc);
            }

        private:
            Script script_;
        };

        class GuidePlanner : public ::testing::Test
        {
        protected:
            /* The paper's algorithm, which has no other guide. */
            std::shared_ptr<MFA> planner(const test::PlanningProblem &problem, const ob::PlannerAllocator &guide) const
            {
                auto result = problem.planner(test::PlannerVariant::Paper);
                result->setGuidePlanner(guide);
                return result;
            }

            std::shared_ptr<MFA> scripted(const test::PlanningProblem &problem,
                                          const ScriptedPlanner::Script &script) const
            {
                return planner(problem, [script](const ob::SpaceInformationPtr &si)
                               { return std::make_shared<ScriptedPlanner>(si, script); });
            }

            std::unique_ptr<test::PlanningProblem> problem_ = roomProblem();
        };

        TEST_F(GuidePlanner, WithoutOneThePaperCannotLeaveTheRoom)
        {
            const auto mfa = problem_->planner(test::PlannerVariant::Paper);
            EXPECT_NE(mfa->solve(test::afterCalls(50000)), ob::PlannerStatus::EXACT_SOLUTION);
        }

        TEST_F(GuidePlanner, WithOneTheSwarmIsNotThePapers)
        {
            // a hundred fireflies of offsets alone; twenty in smooth modes beside a guide, also in windows
            problem_ = test::wallProblem();
            const auto alone = problem_->planner(test::PlannerVariant::Paper);
            const auto guided = planner(*problem_, make<og::RRTConnect>);
            for (const auto &mfa : {alone, guided})
            {
                test::set(*mfa, "population_size", "0");
                // between two windows there is no swarm
                for (unsigned int i = 0; i < 50 && (i < 2 || mfa->getSwarmPaths().empty()); ++i)
                {
                    mfa->solve(test::afterCalls(60000));
                }
                problem_->pdef->clearSolutionPaths();
            }
            EXPECT_EQ(alone->getSwarmPaths().size(), 100U);
            EXPECT_EQ(guided->getSwarmPaths().size(), 20U);
        }

        TEST_F(GuidePlanner, WhatItSolvesIsSolved)
        {
            // one that ends, two that continue, one that restarts in each turn, one that must be cleared for that
            for (auto *const guide :
                 {make<og::RRTConnect>, make<og::BITstar>, make<og::RRTstar>, make<og::FMT>, make<og::BFMT>})
            {
                problem_->pdef->clearSolutionPaths();
                const auto mfa = planner(*problem_, guide);
                ASSERT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_TRUE(problem_->path().check());
                EXPECT_DOUBLE_EQ(problem_->path().length(), mfa->bestCost());
                EXPECT_GT(mfa->shares().at("guide planner"), 0.0);
            }
        }

        TEST_F(GuidePlanner, AnotherOneTakesPartFromTheNextQueryOn)
        {
            const auto mfa = planner(*problem_, nullptr);
            mfa->solve(test::afterCalls(2000));
            mfa->setGuidePlanner(make<og::RRTConnect>);
            mfa->solve(test::afterCalls(2000));
            EXPECT_EQ(mfa->shares().at("guide planner"), 0.0);
            problem_->pdef->setGoalState(problem_->state({9.0, 6.0}));
            mfa->solve(test::afterCalls(2000));
            EXPECT_GT(mfa->shares().at("guide planner"), 0.0);
            mfa->setGuidePlanner(nullptr);
            mfa->solve(test::afterCalls(2000));
            EXPECT_GT(mfa->shares().at("guide planner"), 0.0);
            mfa->clear();
            mfa->solve(test::afterCalls(2000));
            EXPECT_EQ(mfa->shares().at("guide planner"), 0.0);
        }

        TEST_F(GuidePlanner, AQueryThatCouldNotBeginBeginsLater)
        {
            const auto mfa = planner(*problem_, [](const ob::SpaceInformationPtr &) { return ob::PlannerPtr(); });
            EXPECT_THROW(mfa->solve(test::afterCalls(2000)), ompl::Exception);
            EXPECT_THROW(mfa->solve(test::afterCalls(2000)), ompl::Exception);
            mfa->setGuidePlanner(make<og::RRTConnect>);
            EXPECT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
        }

        TEST_F(GuidePlanner, ItsBetterPathsAreTaken)
        {
            for (auto *const guide : {make<og::RRTConnect>, make<og::BITstar>})
            {
                problem_->pdef->clearSolutionPaths();
                const auto mfa = planner(*problem_, guide);
                std::vector<double> costs;
                problem_->pdef->setIntermediateSolutionCallback(
                    [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
                    { costs.push_back(cost.value()); });
                mfa->solve(ob::plannerOrTerminationCondition(
                    ob::PlannerTerminationCondition([&] { return costs.size() >= 3; }),
                    ob::timedPlannerTerminationCondition(60.0)));
                EXPECT_GE(costs.size(), 3U);
                EXPECT_TRUE(problem_->path().check());
                EXPECT_GT(mfa->bestCost(), ROOM_OPTIMUM - 0.1);
            }
        }

        TEST_F(GuidePlanner, ItsPathsAreTightened)
        {
            const auto mfa = planner(*problem_, make<og::RRTConnect>);
            test::set(*mfa, "tightening", "1");
            mfa->solve(ob::plannerOrTerminationCondition(
                ob::PlannerTerminationCondition([&] { return mfa->bestCost() < 1.01 * ROOM_OPTIMUM; }),
                ob::timedPlannerTerminationCondition(60.0)));
            EXPECT_LT(mfa->bestCost(), 1.01 * ROOM_OPTIMUM);
            EXPECT_TRUE(problem_->path().check());
        }

        TEST_F(GuidePlanner, EachQueryHasItsOwn)
        {
            unsigned int made = 0;
            const auto mfa = planner(*problem_,
                                     [&made](const ob::SpaceInformationPtr &si)
                                     {
                                         ++made;
                                         return std::make_shared<og::RRTConnect>(si);
                                     });
            mfa->solve(test::untilExact(problem_->pdef));
            mfa->clear();
            problem_->pdef->clearSolutionPaths();
            EXPECT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(made, 2U);
            problem_->pdef->clearSolutionPaths();
            problem_->pdef->clearGoal();
            problem_->pdef->setGoalState(problem_->state({6.0, 1.0}));
            EXPECT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(made, 3U);
            EXPECT_TRUE(problem_->pdef->getGoal()->isSatisfied(problem_->path().getStates().back()));
            mfa->clear();
            mfa->setGuidePlanner({});
            problem_->pdef->clearSolutionPaths();
            problem_->pdef->clearGoal();
            problem_->pdef->setGoalState(problem_->state({9.0, 5.0}));
            EXPECT_NE(mfa->solve(test::afterCalls(5000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(made, 3U);
        }

        TEST_F(GuidePlanner, GoalsThatItCouldNotSampleItselfAreHandedOn)
        {
            problem_->pdef->setGoal(
                std::make_shared<test::DistanceGoal>(problem_->si, problem_->state({9.0, 5.0}).get(), 0.5));
            const auto mfa = planner(*problem_, make<og::RRTConnect>);
            EXPECT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(problem_->pdef->getGoal()->isSatisfied(problem_->path().getStates().back()));
        }

        TEST_F(GuidePlanner, AnyStateThatSatisfiesTheGoalIsAnEnd)
        {
            problem_->pdef->setGoalState(problem_->state({9.0, 5.0}), 3.0);
            const auto end = problem_->state({7.0, 7.0});
            const auto mfa =
                scripted(*problem_,
                         [&](const ob::ProblemDefinitionPtr &pdef, const ob::PlannerTerminationCondition &)
                         {
                             auto path = std::make_shared<og::PathGeometric>(problem_->si);
                             path->append(pdef->getStartState(0));
                             for (const auto &point : {std::vector<double>{1.5, 5.0}, {1.5, 8.5}, {5.5, 8.5}})
                             {
                                 path->append(problem_->state(point).get());
                             }
                             path->append(end.get());
                             EXPECT_TRUE(pdef->getGoal()->isSatisfied(end.get()));
                             pdef->addSolutionPath(path);
                             return ob::PlannerStatus::EXACT_SOLUTION;
                         });
            EXPECT_EQ(mfa->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(problem_->si->equalStates(problem_->path().getStates().back(), end.get()));
        }

        TEST_F(GuidePlanner, GoalsThatComeLaterReachIt)
        {
            // the first goal state is in a closed cell
            test::PlanningProblem problem(test::realVectorSpace(2, 0.0, 10.0),
                                          [](const ob::State *s)
                                          {
                                              const double x = test::coordinate(s, 0);
                                              const double y = test::coordinate(s, 1);
                                              const double fromCell = std::max(std::abs(x - 8.0), std::abs(y - 8.0));
                                              const bool wall = x > 4.5 && x < 5.5 && y < 9.0;
                                              return !wall && (fromCell < 0.5 || fromCell > 1.0);
                                          },
                                          {1.0, 1.0}, {8.0, 8.0});
            const auto goals = std::make_shared<ob::GoalStates>(problem.si);
            goals->addState(problem.state({8.0, 8.0}));
            problem.pdef->setGoal(goals);
            for (auto *const guide : {make<og::RRTConnect>, make<og::BITstar>})
            {
                const auto mfa = planner(problem, guide);
                test::set(*mfa, "slices", "1");
                EXPECT_NE(mfa->solve(test::afterCalls(2000)), ob::PlannerStatus::EXACT_SOLUTION);
                goals->addState(problem.state({9.0, 1.0}));
                EXPECT_EQ(mfa->solve(test::untilExact(problem.pdef)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_TRUE(problem.path().check());
                problem.pdef->clearSolutionPaths();
                goals->clear();
                goals->addState(problem.state({8.0, 8.0}));
            }
        }

        TEST_F(GuidePlanner, IsStoppedWithTheSearch)
        {
            std::uint64_t asked = 0;
            std::uint64_t turns = 0;
            const auto mfa = scripted(*problem_,
                                      [&](const ob::ProblemDefinitionPtr &, const ob::PlannerTerminationCondition &ptc)
                                      {
                                          ++turns;
                                          while (!ptc())
                                          {
                                              ++asked;
                                          }
                                          return ob::PlannerStatus::TIMEOUT;
                                      });
            std::uint64_t calls = 0;
            std::uint64_t askedThen = 0;
            mfa->solve(ob::PlannerTerminationCondition(
                [&]
                {
                    if (++calls == 1000)
                    {
                        askedThen = asked;
                    }
                    return calls >= 1000;
                }));
            EXPECT_GT(turns, 1U);
            EXPECT_EQ(asked, askedThen);
        }

        TEST_F(GuidePlanner, PathsOfItsThatDoNotHoldAreNotTaken)
        {
            // straight through the wall; from elsewhere; to elsewhere
            const auto closed = test::closedProblem();
            for (const auto &ends : {std::pair{closed->state({1.0, 1.0}), closed->state({9.0, 1.0})},
                                     std::pair{closed->state({8.0, 1.0}), closed->state({9.0, 1.0})},
                                     std::pair{closed->state({1.0, 1.0}), closed->state({2.0, 1.0})}})
            {
                unsigned int turns = 0;
                const auto mfa =
                    scripted(*closed,
                             [&](const ob::ProblemDefinitionPtr &pdef, const ob::PlannerTerminationCondition &)
                             {
                                 ++turns;
                                 auto path = std::make_shared<og::PathGeometric>(closed->si);
                                 path->append(ends.first.get());
                                 path->append(ends.second.get());
                                 pdef->addSolutionPath(path);
                                 return ob::PlannerStatus::EXACT_SOLUTION;
                             });
                EXPECT_NE(mfa->solve(test::afterCalls(3000)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_GT(turns, 0U);
            }
        }

        TEST_F(GuidePlanner, OneThatRefusesTheQueryIsNotAskedAgain)
        {
            unsigned int turns = 0;
            const auto problem = test::wallProblem();
            const auto mfa = scripted(*problem,
                                      [&](const ob::ProblemDefinitionPtr &, const ob::PlannerTerminationCondition &)
                                      {
                                          ++turns;
                                          return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
                                      });
            EXPECT_EQ(mfa->solve(test::untilExact(problem->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(turns, 1U);
        }

        TEST_F(GuidePlanner, AnAllocatorThatMakesNoneIsAnError)
        {
            const auto mfa = planner(*problem_, [](const ob::SpaceInformationPtr &) { return ob::PlannerPtr(); });
            EXPECT_THROW(mfa->solve(test::afterCalls(10)), ompl::Exception);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::guides
