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

#include "engine/guides/TreePart.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>

#include "engine/SearchProblem.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        constexpr double ANY = std::numeric_limits<double>::infinity();

        ob::ProblemDefinitionPtr problemOf(const ob::SpaceInformationPtr &si, const path::Waypoints &starts,
                                           const path::Waypoints &goals)
        {
            auto pdef = std::make_shared<ob::ProblemDefinition>(si);
            for (const ob::State *start : starts.pointers())
            {
                pdef->addStartState(start);
            }
            const auto goal = std::make_shared<ob::GoalStates>(si);
            for (const ob::State *state : goals.pointers())
            {
                goal->addState(state);
            }
            pdef->setGoal(goal);
            return pdef;
        }

        /* A query in any space, with everything that a part of its search needs. */
        class TreeQuery
        {
        public:
            TreeQuery(const ob::StateSpacePtr &space, const std::function<bool(const ob::State *)> &isValid,
                      const path::Waypoints &starts, const path::Waypoints &goals, std::uint64_t seed = 3)
              : counted(space, isValid)
              , si(counted.si)
              , search(problemOf(si, starts, goals), seed)
              , path(space)
            {
                EXPECT_EQ(search.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            /* Gives the guide turns until it has a path. */
            bool find(GuidePart &guide, double bound, int turns = 2000)
            {
                for (int turn = 0; turn < turns; ++turn)
                {
                    if (guide.search(bound, 1000, path))
                    {
                        return true;
                    }
                }
                return false;
            }

            bool isOneOf(const path::Waypoints &states, const ob::State *state) const
            {
                for (std::size_t i = 0; i < states.size(); ++i)
                {
                    if (si->equalStates(states[i], state))
                    {
                        return true;
                    }
                }
                return false;
            }

            void expectPath()
            {
                ASSERT_GE(path.size(), 2U);
                EXPECT_TRUE(isOneOf(search.starts(), path.front()));
                EXPECT_TRUE(isOneOf(search.goals(), path.back()));
                for (std::size_t i = 0; i < path.size(); ++i)
                {
                    EXPECT_TRUE(si->isValid(path[i]));
                }
                EXPECT_TRUE(search.evaluator().checkPath(path));
            }

            test::CountingProblem counted;
            ob::SpaceInformationPtr si;
            test::SearchProblem search;
            path::Waypoints path;
        };

        path::Waypoints one(const ob::StateSpacePtr &space, ompl::RNG &rng)
        {
            path::Waypoints states(space);
            states.resize(1);
            path::StateChart(space).sampleUniform(rng, states[0]);
            return states;
        }

        class TreePartInSpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, TreePartInSpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        /* A tenth of the states, in stripes along the first coordinate of the space's projection, is invalid. */
        TEST_P(TreePartInSpace, FindsValidPathsFromStartToGoal)
        {
            const auto space = GetParam().make();
            std::vector<double> values;
            const auto valid = [&](const ob::State *state)
            {
                space->copyToReals(values, state);
                return values.size() < 2 || std::abs(values[0] - 1.0) > 0.3 || std::abs(values[1]) > 0.8;
            };
            ompl::RNG rng(11);
            int found = 0;
            for (std::uint_fast32_t seed = 1; seed <= 5; ++seed)
            {
                path::Waypoints start = one(space, rng);
                path::Waypoints goal = one(space, rng);
                while (!valid(start[0]))
                {
                    start = one(space, rng);
                }
                while (!valid(goal[0]))
                {
                    goal = one(space, rng);
                }
                TreeQuery q(space, valid, start, goal, seed);
                TreePart trees(q.search.context);
                // and again: they restart
                for (int i = 0; i < 3; ++i)
                {
                    ASSERT_TRUE(q.find(trees, ANY));
                    q.expectPath();
                    ++found;
                }
            }
            EXPECT_EQ(found, 15);
        }

        /* R^2 where a motion to the right is three times as long as one to the left. */
        class Windy : public ob::RealVectorStateSpace
        {
        public:
            Windy()
              : RealVectorStateSpace(2)
            {
                setBounds(-10.0, 10.0);
                setup();
            }

            double distance(const ob::State *a, const ob::State *b) const override
            {
                const double straight = RealVectorStateSpace::distance(a, b);
                return test::coordinate(b, 0) > test::coordinate(a, 0) ? 3.0 * straight : straight;
            }

            bool hasSymmetricDistance() const override
            {
                return false;
            }
        };

        /* One-way: motions across the middle are valid only to the right. */
        class OneWay : public ob::MotionValidator
        {
        public:
            using MotionValidator::MotionValidator;

            bool checkMotion(const ob::State *from, const ob::State *to) const override
            {
                return test::coordinate(from, 0) <= 0.0 || test::coordinate(to, 0) >= 0.0;
            }

            bool checkMotion(const ob::State *from, const ob::State *to,
                             std::pair<ob::State *, double> &) const override
            {
                return checkMotion(from, to);
            }
        };

        TEST(TreePart, FollowsTheDirectionOfMotions)
        {
            const auto space = std::make_shared<Windy>();
            const auto anywhere = [](const ob::State *) { return true; };
            TreeQuery there(space, anywhere, test::planarPath(space, {{-8.0, 0.0}}),
                            test::planarPath(space, {{8.0, 0.0}}));
            TreeQuery back(space, anywhere, test::planarPath(space, {{8.0, 0.0}}),
                           test::planarPath(space, {{-8.0, 0.0}}));
            for (TreeQuery *q : {&there, &back})
            {
                q->si->setMotionValidator(std::make_shared<OneWay>(q->si));
            }
            TreePart treesThere(there.search.context);
            ASSERT_TRUE(there.find(treesThere, ANY));
            there.expectPath();
            TreePart treesBack(back.search.context);
            EXPECT_FALSE(back.find(treesBack, ANY, 20));
        }

        /* The plane with a wall 4.5 < x < 5.5 that leaves a gap above y = 6. */
        class TreePartTest : public ::testing::Test
        {
        protected:
            static bool isFree(const ob::State *s)
            {
                return test::coordinate(s, 0) <= 4.5 || test::coordinate(s, 0) >= 5.5 || test::coordinate(s, 1) >= 6.0;
            }

            std::unique_ptr<TreeQuery> query(const std::vector<std::pair<double, double>> &starts,
                                             const std::vector<std::pair<double, double>> &goals,
                                             std::uint64_t seed = 3) const
            {
                return std::make_unique<TreeQuery>(space_, isFree, test::planarPath(space_, starts),
                                                   test::planarPath(space_, goals), seed);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2, 0.0, 10.0);
        };

        TEST_F(TreePartTest, JoinsAnyOfTheStartsWithAnyOfTheGoals)
        {
            const auto q = query({{1.0, 6.5}, {1.0, 9.5}}, {{9.0, 6.5}, {9.0, 9.5}});
            TreePart trees(q->search.context);
            std::vector<int> starts(2, 0);
            std::vector<int> goals(2, 0);
            for (int i = 0; i < 100; ++i)
            {
                ASSERT_TRUE(q->find(trees, ANY));
                q->expectPath();
                ++starts[q->si->equalStates(q->path.front(), q->search.starts()[0]) ? 0 : 1];
                ++goals[q->si->equalStates(q->path.back(), q->search.goals()[0]) ? 0 : 1];
            }
            for (const int count : {starts[0], starts[1], goals[0], goals[1]})
            {
                EXPECT_GT(count, 5);
            }
        }

        /* The near goal is visible from the start: trees with a root there would always end there. */
        TEST_F(TreePartTest, GrowsFromNoGoalThatCannotBeOnABetterPath)
        {
            const auto q = query({{1.0, 1.0}}, {{1.0, 9.9}, {9.0, 1.0}});
            TreePart trees(q->search.context);
            // 8.9 to the first goal; to the second at least 8, and 13.2 around the wall
            ASSERT_FALSE(q->find(trees, 8.5, 20));
            SearchGraph graph(space_);
            trees.explain(graph);
            ASSERT_EQ(graph.goals.size(), 1U);
            EXPECT_TRUE(q->si->equalStates(graph.states[graph.goals[0]], q->search.goals()[1]));
            EXPECT_EQ(graph.starts.size(), 1U);
        }

        TEST_F(TreePartTest, KeepsWithinTheInformedSet)
        {
            const auto q = query({{1.0, 1.0}}, {{9.0, 1.0}});
            TreePart trees(q->search.context);
            constexpr double BOUND = 14.0;
            for (int i = 0; i < 10; ++i)
            {
                ASSERT_TRUE(q->find(trees, BOUND));
                SearchGraph graph(space_);
                trees.explain(graph);
                for (std::size_t v = 0; v < graph.states.size(); ++v)
                {
                    EXPECT_LT(space_->distance(q->search.starts()[0], graph.states[v]) +
                                  space_->distance(graph.states[v], q->search.goals()[0]),
                              BOUND);
                }
            }
            // trees do not grow when no better path is possible
            TreePart others(q->search.context);
            q->counted.forget();
            EXPECT_FALSE(q->find(others, 8.0, 3));
            EXPECT_EQ(q->counted.motions, 0U);
        }

        TEST_F(TreePartTest, TheSeedDecidesThePath)
        {
            const auto run = [this](std::uint_fast32_t seed)
            {
                const auto q = query({{1.0, 1.0}}, {{9.0, 1.0}}, seed);
                TreePart trees(q->search.context);
                std::vector<double> costs;
                for (int i = 0; i < 5; ++i)
                {
                    EXPECT_TRUE(q->find(trees, 20.0));
                    costs.push_back(q->path.length());
                }
                return costs;
            };
            EXPECT_EQ(run(5), run(5));
            EXPECT_NE(run(5), run(6));
        }

        TEST_F(TreePartTest, StopsWithTheConditionAndGoesOn)
        {
            const auto q = query({{1.0, 1.0}}, {{9.0, 1.0}});
            TreePart trees(q->search.context);
            int interrupted = 0;
            for (int calls = 0;; ++calls)
            {
                int asked = 0;
                q->search.evaluator().setStopCondition([&asked, calls] { return ++asked > calls; });
                q->counted.forget();
                const bool found = trees.search(ANY, 1000000, q->path);
                EXPECT_LE(q->counted.motions, static_cast<std::uint64_t>(calls) + 1);
                const bool stopped = q->search.evaluator().interrupted();
                q->search.evaluator().setStopCondition({});
                if (found)
                {
                    q->expectPath();
                    break;
                }
                EXPECT_TRUE(stopped);
                ++interrupted;
            }
            EXPECT_GT(interrupted, 0);
        }

        TEST_F(TreePartTest, WorksNoMoreThanItIsAllowed)
        {
            const auto q = query({{1.0, 1.0}}, {{9.0, 1.0}});
            TreePart trees(q->search.context);
            for (int turn = 0; turn < 20; ++turn)
            {
                const std::uint64_t before = q->search.evaluator().work();
                trees.search(ANY, 100, q->path);
                // one iteration may follow the other tree across the plane
                EXPECT_LT(q->search.evaluator().work() - before, 1000U);
            }
        }

        TEST_F(TreePartTest, ExplainsTheTreesThatFoundThePath)
        {
            const auto q = query({{1.0, 1.0}}, {{9.0, 1.0}});
            TreePart trees(q->search.context);
            SearchGraph before(space_);
            trees.explain(before);
            EXPECT_TRUE(before.states.empty());
            ASSERT_TRUE(q->find(trees, ANY));
            // it appends to the states of other parts
            SearchGraph graph(space_);
            graph.states.append(q->search.starts()[0]);
            trees.explain(graph);
            ASSERT_EQ(graph.starts.size(), 1U);
            ASSERT_EQ(graph.goals.size(), 1U);
            EXPECT_TRUE(q->si->equalStates(graph.states[graph.starts[0]], q->search.starts()[0]));
            EXPECT_TRUE(q->si->equalStates(graph.states[graph.goals[0]], q->search.goals()[0]));
            for (const auto &[from, to] : graph.edges)
            {
                EXPECT_TRUE(q->si->isValid(graph.states[to]));
                EXPECT_TRUE(q->si->checkMotion(graph.states[from], graph.states[to]));
            }
            // every motion of the path is one of its edges
            for (std::size_t i = 1; i < q->path.size(); ++i)
            {
                bool known = false;
                for (const auto &[from, to] : graph.edges)
                {
                    known = known || (q->si->equalStates(graph.states[from], q->path[i - 1]) &&
                                      q->si->equalStates(graph.states[to], q->path[i]));
                }
                EXPECT_TRUE(known) << i;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine::guides
