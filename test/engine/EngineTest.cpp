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

#include "engine/Engine.h"

#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Exception.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        SearchSettings settingsOf(bool fireflies, const std::string &guide, bool tightening)
        {
            SearchSettings settings;
            settings.fireflies = fireflies;
            settings.recombination = false;
            settings.tightening = tightening;
            settings.guide = guide;
            settings.slices = 5;
            settings.generations = 20;
            settings.seed = 7;
            return settings;
        }

        /* An engine for a problem, with everything it needs. */
        class Search
        {
        public:
            Search(const test::PlanningProblem &problem, const SearchSettings &settings,
                   const ob::PlannerAllocator &guest = nullptr)
              : owner_(problem.si)
            {
                owner_.setProblemDefinition(problem.pdef);
                inputs_.use(problem.pdef);
                chart = std::make_shared<const path::StateChart>(problem.si->getStateSpace());
                engine = std::make_unique<Engine>(owner_, chart, settings, 7, guest, progress);
            }

            ob::PlannerStatus::StatusType run(const std::function<bool()> &stop)
            {
                const ob::PlannerTerminationCondition ptc = ob::plannerOrTerminationCondition(
                    ob::PlannerTerminationCondition(stop), ob::timedPlannerTerminationCondition(60.0));
                return engine->search(inputs_, ptc, [this] { ++published; });
            }

            ob::PlannerStatus::StatusType runToPath()
            {
                return run([this] { return incumbent().hasPath(); });
            }

            ob::PlannerStatus::StatusType runFor(unsigned int calls)
            {
                unsigned int asked = 0;
                return run([&asked, calls] { return ++asked >= calls; });
            }

            const Incumbent &incumbent() const
            {
                return engine->context().incumbent;
            }

            std::vector<double> shares() const
            {
                std::vector<double> result;
                for (std::size_t i = 0; i < PART_NAMES.size(); ++i)
                {
                    result.push_back(progress.share(PartKind(i)));
                }
                return result;
            }

            SearchProgress progress;
            path::StateChartPtr chart;
            std::unique_ptr<Engine> engine;
            unsigned int published{0};

        private:
            MFA owner_;
            ob::PlannerInputStates inputs_;
        };

        ob::PlannerPtr guest(const ob::SpaceInformationPtr &si)
        {
            return std::make_shared<ompl::geometric::RRTConnect>(si);
        }

        struct Alone
        {
            std::string name;
            PartKind part;
            SearchSettings settings;
            ob::PlannerAllocator guest;
        };

        std::vector<Alone> partsAlone()
        {
            return {{"Fireflies", PartKind::Fireflies, settingsOf(true, "none", false), nullptr},
                    {"Trees", PartKind::Trees, settingsOf(false, "trees", false), nullptr},
                    {"Roadmap", PartKind::Roadmap, settingsOf(false, "roadmap", false), nullptr},
                    {"GuestPlanner", PartKind::GuestPlanner, settingsOf(false, "none", false), guest}};
        }

        class EngineOfOnePart : public ::testing::TestWithParam<Alone>
        {
        protected:
            bool isValid(const path::Waypoints &path) const
            {
                for (std::size_t i = 1; i < path.size(); ++i)
                {
                    if (!problem_->si->checkMotion(path[i - 1], path[i]))
                    {
                        return false;
                    }
                }
                return problem_->si->equalStates(path.front(), problem_->pdef->getStartState(0)) &&
                       problem_->pdef->getGoal()->isSatisfied(path.back());
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        };

        INSTANTIATE_TEST_SUITE_P(Engine, EngineOfOnePart, ::testing::ValuesIn(partsAlone()),
                                 [](const auto &tested) { return tested.param.name; });

        TEST_P(EngineOfOnePart, FindsAPathAndNobodyElseWorks)
        {
            Search search(*problem_, GetParam().settings, GetParam().guest);
            EXPECT_EQ(search.runToPath(), ob::PlannerStatus::EXACT_SOLUTION);
            ASSERT_TRUE(search.incumbent().hasPath());
            EXPECT_TRUE(isValid(search.incumbent().path()));
            EXPECT_NEAR(search.incumbent().cost(), search.incumbent().path().length(), 1e-9);
            EXPECT_EQ(search.incumbent().origin(), GetParam().part);
            EXPECT_DOUBLE_EQ(search.progress.share(GetParam().part), 1.0);
            EXPECT_EQ(search.engine->swarms() != nullptr, GetParam().part == PartKind::Fireflies);
        }

        /* Tightening improves the path of a part, which stays the path's origin. */
        TEST_P(EngineOfOnePart, ItsPathBecomesTheShortestWithTightening)
        {
            SearchSettings settings = GetParam().settings;
            settings.tightening = true;
            Search search(*problem_, settings, GetParam().guest);
            const double enough = 1.005 * test::wallOptimum();
            search.run([&] { return search.incumbent().cost() < enough; });
            EXPECT_LT(search.incumbent().cost(), enough);
            EXPECT_GT(search.incumbent().cost(), test::wallOptimum() - 0.1);
            EXPECT_TRUE(isValid(search.incumbent().path()));
            EXPECT_EQ(search.incumbent().origin(), GetParam().part);
            EXPECT_NEAR(search.progress.share(GetParam().part) + search.progress.share(PartKind::Tightening), 1.0,
                        1e-9);
        }

        class EngineTest : public ::testing::Test
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            SearchSettings settings_ = settingsOf(true, "both", true);
        };

        TEST_F(EngineTest, ASearchWithoutPartsThatFindPathsIsNone)
        {
            EXPECT_THROW(Search(*problem_, settingsOf(false, "none", true)), ompl::Exception);
        }

        TEST_F(EngineTest, SharesAreThoseOfTheWholeWork)
        {
            settings_.recombination = true;
            for (const bool closed : {false, true})
            {
                problem_ = closed ? test::closedProblem() : test::wallProblem();
                Search search(*problem_, settings_, guest);
                EXPECT_EQ(search.shares(), std::vector<double>(PART_NAMES.size(), 0.0));
                search.runFor(60000);
                const std::vector<double> shares = search.shares();
                EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-9);
                for (std::size_t i = 0; i < shares.size(); ++i)
                {
                    // fireflies are recombined before there is a path, and paths are tightened after that
                    const bool works = PartKind(i) != PartKind::GoalSearch &&
                                       PartKind(i) != (closed ? PartKind::Tightening : PartKind::Recombination);
                    EXPECT_EQ(shares[i] > 0.0, works) << PART_NAMES[i] << ", closed: " << closed;
                }
            }
        }

        TEST_F(EngineTest, AStraightMotionThatIsTheBestEndsTheSearch)
        {
            problem_ = test::freeProblem();
            Search search(*problem_, settings_);
            EXPECT_EQ(search.run([] { return false; }), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_EQ(search.incumbent().path().size(), 2U);
            EXPECT_EQ(search.incumbent().origin(), std::nullopt);
            EXPECT_EQ(search.progress.time(), 0.0) << "no part had a turn";
            EXPECT_GE(search.published, 2U) << "at the beginning and with the path";
        }

        /* Length, and 20 times that in the band 4 < x < 6 below y = 4. */
        class Mud : public ob::StateCostIntegralObjective
        {
        public:
            explicit Mud(const ob::SpaceInformationPtr &si)
              : StateCostIntegralObjective(si, true)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                const bool inside =
                    std::abs(test::coordinate(state, 0) - 5.0) < 1.0 && test::coordinate(state, 1) < 4.0;
                return ob::Cost(inside ? 20.0 : 1.0);
            }
        };

        TEST_F(EngineTest, AStraightMotionThatIsNotTheBestDoesNotEndIt)
        {
            problem_ = test::freeProblem();
            problem_->pdef->setOptimizationObjective(std::make_shared<Mud>(problem_->si));
            for (const char *guide : {"none", "both"})
            {
                Search search(*problem_, settingsOf(true, guide, true));
                bool straight = false;
                search.run(
                    [&]
                    {
                        straight = straight || search.incumbent().path().size() == 2;
                        return search.progress.evaluations > 5000 || search.incumbent().cost() < 12.0;
                    });
                EXPECT_TRUE(straight);
                EXPECT_LT(search.incumbent().cost(), 12.0) << "guide = " << guide;
            }
        }

        TEST_F(EngineTest, APathThatSatisfiesTheObjectiveEndsTheSearch)
        {
            const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si);
            objective->setCostThreshold(ob::Cost(1.02 * test::wallOptimum()));
            problem_->pdef->setOptimizationObjective(objective);
            Search search(*problem_, settings_);
            EXPECT_EQ(search.run([] { return false; }), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_LE(search.incumbent().cost(), 1.02 * test::wallOptimum());
        }

        TEST_F(EngineTest, EveryBetterPathMayBePublished)
        {
            Search search(*problem_, settings_);
            search.runFor(20000);
            EXPECT_GT(search.incumbent().improvements(), 2U);
            EXPECT_GT(search.published, search.incumbent().improvements());
        }

        TEST_F(EngineTest, SaysWhyItCannotBegin)
        {
            problem_->pdef->clearStartStates();
            problem_->pdef->addStartState(problem_->state({5.0, 1.0}));
            Search search(*problem_, settings_);
            EXPECT_EQ(search.runFor(100), ob::PlannerStatus::INVALID_START);
            EXPECT_EQ(search.published, 0U);
        }

        TEST_F(EngineTest, TheSameSeedIsTheSameSearch)
        {
            const auto run = [this]
            {
                Search search(*problem_, settings_);
                search.runFor(20000);
                std::vector<double> result = search.shares();
                result.push_back(search.incumbent().cost());
                result.push_back(static_cast<double>(search.progress.evaluations));
                result.push_back(static_cast<double>(search.progress.iterations));
                return result;
            };
            EXPECT_EQ(run(), run());
        }

        TEST_F(EngineTest, FirefliesFlyWhereverAnEarlierSolveWasStopped)
        {
            SearchSettings settings = settingsOf(true, "none", false);
            settings.populationSize = 10;
            for (unsigned int calls = 1; calls <= 60; ++calls)
            {
                Search search(*problem_, settings);
                search.runFor(calls);
                search.runFor(3000);
                EXPECT_GT(search.progress.iterations, 0U) << "stopped by call " << calls;
            }
        }

        TEST_F(EngineTest, GoesOnWithTheSameQueryOnly)
        {
            Search search(*problem_, settings_);
            search.runFor(20000);
            ASSERT_TRUE(search.incumbent().hasPath());
            const ob::PlannerTerminationCondition never([] { return false; });
            EXPECT_TRUE(search.engine->canContinue(*problem_->pdef, never));
            const double cost = search.incumbent().cost();
            search.runFor(20000);
            EXPECT_LE(search.incumbent().cost(), cost);
            ob::ProblemDefinition another(problem_->si);
            another.setStartAndGoalStates(problem_->state({1.0, 2.0}), problem_->state({9.0, 1.0}));
            EXPECT_FALSE(search.engine->canContinue(another, never));
        }

        TEST_F(EngineTest, DoesNotGoOnWhereThePathDoesNotHoldAnyMore)
        {
            double top = 6.0;
            test::PlanningProblem problem(test::realVectorSpace(2, 0.0, 10.0),
                                          [&top](const ob::State *s) {
                                              return test::coordinate(s, 0) <= 4.5 || test::coordinate(s, 0) >= 5.5 ||
                                                     test::coordinate(s, 1) >= top;
                                          },
                                          {1.0, 1.0}, {9.0, 1.0});
            Search search(problem, settings_);
            search.runFor(20000);
            ASSERT_TRUE(search.incumbent().hasPath());
            const ob::PlannerTerminationCondition never([] { return false; });
            EXPECT_TRUE(search.engine->canContinue(*problem.pdef, never));
            top = 9.0;
            EXPECT_FALSE(search.engine->canContinue(*problem.pdef, never));
            EXPECT_TRUE(search.engine->canContinue(*problem.pdef, ob::plannerAlwaysTerminatingCondition()))
                << "there is no time to check";
        }

        TEST_F(EngineTest, DoesNotGoOnWithinOtherBounds)
        {
            Search search(*problem_, settings_);
            search.runFor(2000);
            const ob::PlannerTerminationCondition never([] { return false; });
            EXPECT_TRUE(search.engine->canContinue(*problem_->pdef, never));
            problem_->si->getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(0.0, 11.0);
            EXPECT_FALSE(search.engine->canContinue(*problem_->pdef, never));
        }

        TEST_F(EngineTest, ExplainsTheBestPath)
        {
            Search search(*problem_, settingsOf(true, "none", true));
            search.runToPath();
            ASSERT_TRUE(search.incumbent().hasPath());
            SearchGraph graph(problem_->si->getStateSpace());
            search.engine->explain(graph);
            const path::Waypoints &path = search.incumbent().path();
            for (std::size_t i = 1; i < path.size(); ++i)
            {
                bool known = false;
                for (const auto &[from, to] : graph.edges)
                {
                    known = known || (problem_->si->equalStates(graph.states[from], path[i - 1]) &&
                                      problem_->si->equalStates(graph.states[to], path[i]));
                }
                EXPECT_TRUE(known) << i;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine
