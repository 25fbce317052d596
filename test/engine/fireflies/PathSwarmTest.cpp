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

#include "engine/fireflies/PathSwarm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/SearchProblem.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        using Points = std::vector<std::pair<double, double>>;

        /* The square [0, 10]^2 with two blocks, which can both be passed above and below. The shortest way passes below
           the first and above the second one. */
        std::unique_ptr<test::PlanningProblem> blocksProblem()
        {
            auto problem = std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, 0.0, 10.0),
                [](const ob::State *s)
                {
                    const double x = test::coordinate(s, 0);
                    const double y = test::coordinate(s, 1);
                    return !(x > 2.5 && x < 4.0 && y > 4.0 && y < 7.0) && !(x > 6.0 && x < 7.5 && y > 3.0 && y < 6.0);
                },
                std::vector<double>{1.0, 5.0}, std::vector<double>{9.0, 5.0});
            problem->si->setStateValidityCheckingResolution(0.002);
            problem->si->setup();
            return problem;
        }

        const Points ABOVE_BOTH{{1.0, 5.0}, {2.5, 7.05}, {4.0, 7.05}, {6.0, 6.05}, {7.5, 6.05}, {9.0, 5.0}};
        const Points BELOW_BOTH{{1.0, 5.0}, {2.5, 3.95}, {4.0, 3.95}, {6.0, 2.95}, {7.5, 2.95}, {9.0, 5.0}};
        const Points BELOW_AND_ABOVE{{1.0, 5.0}, {2.5, 3.95}, {4.0, 3.95}, {6.0, 6.05}, {7.5, 6.05}, {9.0, 5.0}};
        const Points HIGH_ABOVE_BOTH{{1.0, 5.0}, {2.5, 7.6}, {4.0, 7.6}, {6.0, 6.9}, {7.5, 6.9}, {9.0, 5.0}};
        const Points FAR_BELOW_BOTH{{1.0, 5.0}, {2.5, 3.4}, {4.0, 3.4}, {6.0, 2.2}, {7.5, 2.2}, {9.0, 5.0}};

        double shortest()
        {
            return std::hypot(1.5, 1.0) + 1.5 + std::hypot(2.0, 2.0) + 1.5 + std::hypot(1.5, 1.0);
        }

        class PathSwarmTest : public ::testing::Test
        {
        protected:
            explicit PathSwarmTest(std::uint64_t seed = 5)
              : search_(problem_->pdef, seed)
            {
                EXPECT_EQ(search_.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            path::Waypoints path(const Points &points) const
            {
                return test::planarPath(space_, points);
            }

            /* As the engine does with a path that it got. */
            static void add(test::SearchProblem &search, const path::Waypoints &path)
            {
                const double cost = search.evaluator().cost(path).value();
                ASSERT_TRUE(search.evaluator().checkPath(path));
                if (search.context.incumbent.offer(path, cost, PartKind::Trees))
                {
                    search.context.pool.prune(cost);
                }
                search.context.pool.add(path, cost, true, search.context.incumbent.cost());
            }

            void add(const Points &points)
            {
                add(search_, path(points));
            }

            void advance(PathSwarm &swarm, std::uint64_t work = 8000)
            {
                swarm.advance(work, findings_);
            }

            /* A draft between the ends of the query, whose cost is known. */
            void expectDraft(const test::SearchProblem &search, const Proposal &draft) const
            {
                EXPECT_TRUE(draft.draft);
                EXPECT_EQ(draft.stage, Proposal::Stage::Tight);
                EXPECT_EQ(draft.origin, PartKind::Fireflies);
                ASSERT_TRUE(draft.cost);
                EXPECT_NEAR(draft.cost->value(), search.evaluator().cost(draft.path).value(), 1e-6);
                ASSERT_GE(draft.path.size(), 2U);
                const auto &space = search.si->getStateSpace();
                EXPECT_TRUE(space->equalStates(draft.path.front(), search.starts()[0]));
                EXPECT_TRUE(space->equalStates(draft.path.back(), search.goals()[0]));
                for (std::size_t i = 0; i < draft.path.size(); ++i)
                {
                    EXPECT_TRUE(space->satisfiesBounds(draft.path[i]));
                    EXPECT_TRUE(search.si->isValid(draft.path[i])) << "vertex " << i;
                }
            }

            /* Only what costs at most slightly more than the best path is proposed. */
            void expectPromising(double best) const
            {
                for (const Proposal &proposal : findings_.paths)
                {
                    EXPECT_LT(proposal.cost->value(), 1.003 * best);
                    expectDraft(search_, proposal);
                }
                for (const Proposal &draft : findings_.drafts)
                {
                    EXPECT_GE(draft.cost->value(), 1.003 * best);
                    expectDraft(search_, draft);
                }
            }

            std::unique_ptr<test::PlanningProblem> problem_ = blocksProblem();
            ob::StateSpacePtr space_ = problem_->si->getStateSpace();
            test::SearchProblem search_;
            FireflyOptimizer::Settings settings_;
            Findings findings_{space_};
        };

        TEST_F(PathSwarmTest, HasNothingToDoWithoutAPathThatCanMove)
        {
            PathSwarm swarm(search_.context, settings_);
            EXPECT_FALSE(swarm.ready());
            add(ABOVE_BOTH);
            EXPECT_TRUE(swarm.ready());
            search_.context.pool.prune(1.0);
            EXPECT_FALSE(swarm.ready());
        }

        TEST_F(PathSwarmTest, ProposesDraftsThatPromiseToBeTheBest)
        {
            PathSwarm swarm(search_.context, settings_);
            add(ABOVE_BOTH);
            ASSERT_GT(search_.context.draftStride(), 1U);
            const double best = search_.context.incumbent.cost();
            unsigned int turns = 0;
            for (; turns < 300 && findings_.paths.empty(); ++turns)
            {
                problem_->counted.forget();
                advance(swarm);
                EXPECT_EQ(problem_->counted.motions, 0U) << "checked in full";
            }
            ASSERT_EQ(findings_.paths.size(), 1U);
            EXPECT_EQ(search_.evaluator().stride(), 1U);
            expectPromising(best);
            // what promises nothing in comparison with a better path is only for the pool
            findings_ = Findings(space_);
            search_.context.incumbent.offer(path(BELOW_AND_ABOVE), 0.995 * shortest());
            for (turns = 0; turns < 100; ++turns)
            {
                advance(swarm);
            }
            expectPromising(0.995 * shortest());
            EXPECT_TRUE(std::any_of(findings_.drafts.begin(), findings_.drafts.end(),
                                    [](const Proposal &draft) { return draft.cost->value() < 1.01 * shortest(); }));
        }

        TEST_F(PathSwarmTest, FindsTheBestClassFromOneOrFromManyPaths)
        {
            for (const bool many : {false, true})
            {
                unsigned int found = 0;
                for (std::uint64_t seed = 1; seed <= 10; ++seed)
                {
                    test::SearchProblem search(problem_->pdef, seed);
                    search.begin();
                    for (const Points &points :
                         many ? std::vector<Points>{ABOVE_BOTH, BELOW_BOTH, HIGH_ABOVE_BOTH, FAR_BELOW_BOTH}
                              : std::vector<Points>{ABOVE_BOTH})
                    {
                        add(search, path(points));
                    }
                    ASSERT_EQ(search.context.pool.size(), many ? 4U : 1U);
                    PathSwarm swarm(search.context, settings_);
                    bool better = false;
                    for (int turn = 0; turn < 100 && !better; ++turn)
                    {
                        Findings findings(space_);
                        swarm.advance(8000, findings);
                        for (const Proposal &proposal : findings.paths)
                        {
                            expectDraft(search, proposal);
                            better = better || proposal.cost->value() < 1.003 * shortest();
                        }
                    }
                    found += better ? 1 : 0;
                }
                EXPECT_GE(found, 8U) << "many: " << many;
            }
        }

        /* Also with a pool that changes between the turns, and with fireflies of the same slices. */
        TEST_F(PathSwarmTest, APoolOfManyPathsMovesWithinIt)
        {
            for (const Points &points : {ABOVE_BOTH, BELOW_BOTH, BELOW_AND_ABOVE, HIGH_ABOVE_BOTH, FAR_BELOW_BOTH})
            {
                add(points);
            }
            ASSERT_EQ(search_.context.pool.size(), 5U);
            PathSwarm swarm(search_.context, settings_);
            std::size_t drafts = 0;
            for (int turn = 0; turn < 200; ++turn)
            {
                findings_ = Findings(space_);
                advance(swarm, 2000);
                for (const auto *list : {&findings_.paths, &findings_.drafts})
                {
                    for (const Proposal &draft : *list)
                    {
                        expectDraft(search_, draft);
                        search_.context.pool.add(draft.path, draft.cost->value(), false,
                                                 search_.context.incumbent.cost());
                        ++drafts;
                    }
                }
                EXPECT_GE(search_.context.pool.size(), 4U);
            }
            EXPECT_GT(drafts, 20U);
            EXPECT_EQ(search_.progress.evaluations, drafts);
        }

        TEST_F(PathSwarmTest, TheSameSeedMakesTheSameProposals)
        {
            const auto run = [this](std::uint64_t seed)
            {
                test::SearchProblem search(problem_->pdef, seed);
                search.begin();
                for (const Points &points : {ABOVE_BOTH, BELOW_BOTH, HIGH_ABOVE_BOTH, FAR_BELOW_BOTH})
                {
                    add(search, path(points));
                }
                PathSwarm swarm(search.context, settings_);
                std::vector<double> costs;
                for (int turn = 0; turn < 20; ++turn)
                {
                    Findings findings(space_);
                    swarm.advance(8000, findings);
                    for (const auto *list : {&findings.paths, &findings.drafts})
                    {
                        for (const Proposal &draft : *list)
                        {
                            costs.push_back(draft.cost->value());
                        }
                    }
                    costs.push_back(static_cast<double>(search.evaluator().work()));
                }
                return costs;
            };
            const std::vector<double> once = run(3);
            EXPECT_GT(once.size(), 20U);
            EXPECT_EQ(once, run(3));
            EXPECT_NE(once, run(4));
        }

        TEST_F(PathSwarmTest, KeepsToItsBudgetAndStopsWithTheCondition)
        {
            add(ABOVE_BOTH);
            PathSwarm swarm(search_.context, settings_);
            for (int turn = 0; turn < 50; ++turn)
            {
                const auto before = search_.evaluator().work();
                findings_ = Findings(space_);
                advance(swarm, 1000);
                const auto spent = search_.evaluator().work() - before;
                EXPECT_TRUE(spent >= 1000 || !findings_.paths.empty());
                // one trial more: trees, a segment and a path that are tightened, of some 50 states
                EXPECT_LT(spent, 1000U + 5000U);
            }
            search_.evaluator().setStopCondition([] { return true; });
            problem_->counted.forget();
            findings_ = Findings(space_);
            advance(swarm, 100000);
            EXPECT_EQ(problem_->counted.states, 0U);
            EXPECT_TRUE(findings_.paths.empty());
            EXPECT_TRUE(findings_.drafts.empty());
            // at any moment
            for (int last = 1; last < 2000; last += 37)
            {
                int asked = 0;
                search_.evaluator().setStopCondition([&] { return ++asked > last; });
                advance(swarm, 3000);
                EXPECT_EQ(search_.evaluator().stride(), 1U);
            }
        }

        class PathSwarmInSpaces : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Spaces, PathSwarmInSpaces, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        /* Random paths between columns in the first two coordinates. */
        TEST_P(PathSwarmInSpaces, FirefliesRunFromStartToGoal)
        {
            const auto space = GetParam().make();
            const auto chart = std::make_shared<const path::StateChart>(space);
            ompl::RNG rng(3);
            // those of a quaternion are at most 1, others mostly 10
            const double frequency = chart->positionDimension() > 0 ? 1.2 : 6.0;
            const test::CountingProblem counted(
                space,
                [&](const ob::State *state)
                {
                    std::vector<double> values;
                    space->copyToReals(values, state);
                    return values.size() < 2 || std::sin(frequency * values[0]) * std::sin(frequency * values[1]) < 0.5;
                });
            ob::ScopedState<> start(space);
            ob::ScopedState<> goal(space);
            do
            {
                chart->sampleUniform(rng, start.get());
                chart->sampleUniform(rng, goal.get());
            } while (!counted.si->isValid(start.get()) || !counted.si->isValid(goal.get()));
            const auto pdef = std::make_shared<ob::ProblemDefinition>(counted.si);
            pdef->setStartAndGoalStates(start, goal);
            test::SearchProblem search(pdef);
            ASSERT_EQ(search.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            refinement::LocalTrees trees(chart, search.evaluator(), 9);
            path::Waypoints path(space);
            for (int i = 0; i < 30; ++i)
            {
                if (trees.connect(start.get(), goal.get(), 2.0 * chart->distance(start.get(), goal.get()), 20000, path))
                {
                    const double cost = search.evaluator().cost(path).value();
                    search.context.incumbent.offer(path, cost);
                    search.context.pool.prune(search.context.incumbent.cost());
                    search.context.pool.add(path, cost, true, search.context.incumbent.cost());
                }
            }
            ASSERT_TRUE(search.context.incumbent.hasPath());
            PathSwarm swarm(search.context, FireflyOptimizer::Settings());
            ASSERT_TRUE(swarm.ready());
            unsigned int drafts = 0;
            for (int turn = 0; turn < 100; ++turn)
            {
                Findings findings(space);
                swarm.advance(3000, findings);
                for (const auto *list : {&findings.paths, &findings.drafts})
                {
                    for (const Proposal &draft : *list)
                    {
                        EXPECT_TRUE(space->equalStates(draft.path.front(), start.get()));
                        EXPECT_TRUE(space->equalStates(draft.path.back(), goal.get()));
                        EXPECT_NEAR(draft.cost->value(), search.evaluator().cost(draft.path).value(), 1e-6);
                        for (std::size_t i = 0; i < draft.path.size(); ++i)
                        {
                            EXPECT_TRUE(counted.si->isValid(draft.path[i])) << "vertex " << i;
                            EXPECT_TRUE(space->satisfiesBounds(draft.path[i])) << "vertex " << i;
                        }
                        search.context.pool.add(draft.path, draft.cost->value(), false,
                                                search.context.incumbent.cost());
                        ++drafts;
                    }
                }
            }
            // in a plane the columns separate many ways
            EXPECT_TRUE(drafts > 0 || chart->positionDimension() != 2 || chart->dimension() > 3);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
