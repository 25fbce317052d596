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

#include "engine/PathHints.h"

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>

#include "engine/SearchProblem.h"
#include "path/StateSpaces.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine
{
    namespace
    {
        /* Keeps the paths, with the effort for each, and finds them valid or not. */
        class Recorder : public PathMender
        {
        public:
            bool mend(path::Waypoints &path, unsigned int effort) override
            {
                paths.push_back(path);
                efforts.push_back(effort);
                return valid;
            }

            std::vector<path::Waypoints> paths;
            std::vector<unsigned int> efforts;
            bool valid{true};
        };

        using Points = std::vector<std::pair<double, double>>;

        /* Hints for the way from (1, 1) to (9, 1) in the square [0, 10]^2 without obstacles. */
        class PathHintsTest : public ::testing::Test
        {
        protected:
            PathHintsTest()
            {
                EXPECT_EQ(search_.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            void add(const Points &points, PathHints::Source source = PathHints::Source::User)
            {
                hints_.add(test::planarPath(problem_->si->getStateSpace(), points), source);
            }

            Points pointsOf(const path::Waypoints &path) const
            {
                Points points;
                for (std::size_t i = 0; i < path.size(); ++i)
                {
                    points.emplace_back(test::coordinate(path[i], 0), test::coordinate(path[i], 1));
                }
                return points;
            }

            /* What the hint becomes before it is made valid. */
            Points joined(const Points &points)
            {
                add(points);
                hints_.advance(findings_);
                return pointsOf(mender_.paths.back());
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::freeProblem();
            test::SearchProblem search_{problem_->pdef};
            Recorder mender_;
            PathHints hints_{search_.context, &mender_, true};
            Findings findings_{problem_->si->getStateSpace()};
        };

        TEST_F(PathHintsTest, APathFromStartToGoalIsTakenAsItIs)
        {
            EXPECT_EQ(joined({{1, 1}, {5, 5}, {9, 1}}), (Points{{1, 1}, {5, 5}, {9, 1}}));
            ASSERT_EQ(findings_.paths.size(), 1U);
            EXPECT_FALSE(findings_.paths[0].draft);
            EXPECT_EQ(hints_.size(), 0U);
        }

        TEST_F(PathHintsTest, AStartOnThePathCutsOffWhatIsBehindIt)
        {
            EXPECT_EQ(joined({{0, 0}, {0.5, 0.5}, {2, 2}, {5, 5}, {9, 1}}), (Points{{1, 1}, {2, 2}, {5, 5}, {9, 1}}));
        }

        TEST_F(PathHintsTest, AGoalOnThePathCutsOffWhatIsBehindIt)
        {
            EXPECT_EQ(joined({{1, 1}, {5, 5}, {8, 2}, {10, 0}}), (Points{{1, 1}, {5, 5}, {8, 2}, {9, 1}}));
        }

        TEST_F(PathHintsTest, OtherEndsAreJoinedAtTheNearestPoint)
        {
            const Points points = joined({{0, 3}, {10, 3}});
            ASSERT_EQ(points.size(), 2U) << "both ends see the start and the goal";
            EXPECT_EQ(points.front(), Points::value_type(1, 1));
            EXPECT_EQ(points.back(), Points::value_type(9, 1));
            EXPECT_EQ(joined({{4, 4}}), (Points{{1, 1}, {4, 4}, {9, 1}}));
        }

        TEST_F(PathHintsTest, StatesAreBroughtWithinTheBounds)
        {
            EXPECT_EQ(joined({{1, 1}, {-5, 20}, {9, 1}}), (Points{{1, 1}, {0, 10}, {9, 1}}));
        }

        TEST_F(PathHintsTest, OfSeveralGoalsTheNearestIsTaken)
        {
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            for (const std::vector<double> &goal : {std::vector<double>{9, 9}, {9, 1}, {1, 9}})
            {
                goals->addState(problem_->state(goal).get());
            }
            problem_->pdef->setGoal(goals);
            test::SearchProblem search(problem_->pdef);
            search.begin();
            PathHints hints(search.context, &mender_, true);
            hints.add(test::planarPath(problem_->si->getStateSpace(), {{1, 1}, {2, 7}, {2, 8}}),
                      PathHints::Source::User);
            hints.advance(findings_);
            EXPECT_EQ(pointsOf(mender_.paths.back()), (Points{{1, 1}, {2, 7}, {2, 8}, {1, 9}}));
        }

        TEST_F(PathHintsTest, AreTriedInTheOrderOfTheirSource)
        {
            add({{1, 1}, {5, 2}, {9, 1}}, PathHints::Source::Population);
            add({{1, 1}, {5, 3}, {9, 1}}, PathHints::Source::User);
            add({{1, 1}, {5, 4}, {9, 1}}, PathHints::Source::BestPath);
            add({{1, 1}, {5, 5}, {9, 1}}, PathHints::Source::User);
            for (int i = 0; i < 4; ++i)
            {
                hints_.advance(findings_);
            }
            std::vector<double> order;
            for (const path::Waypoints &path : mender_.paths)
            {
                order.push_back(test::coordinate(path[1], 1));
            }
            EXPECT_EQ(order, (std::vector<double>{4, 3, 5, 2}));
        }

        TEST_F(PathHintsTest, OneThatFailsIsTriedAgainWithMoreEffortAfterAPause)
        {
            mender_.valid = false;
            add({{1, 1}, {5, 5}, {9, 1}});
            for (unsigned int k = 1; hints_.size() > 0; ++k)
            {
                hints_.advance(findings_);
                ASSERT_EQ(mender_.efforts.size(), k);
                EXPECT_EQ(mender_.efforts.back(), k - 1);
                hints_.advance(findings_);
                ASSERT_EQ(mender_.efforts.size(), k) << "the parts of the search come first";
                search_.evaluator().addWork(10000);
                ASSERT_LT(k, 20U);
            }
            EXPECT_GT(mender_.efforts.size(), 1U);
            EXPECT_TRUE(findings_.paths.empty());
        }

        TEST_F(PathHintsTest, OnceThereIsAPathTheyAreDraftsAndExpensiveOnesAreDropped)
        {
            problem_->si->setStateValidityCheckingResolution(0.001);
            problem_->si->setup();
            search_.context.incumbent.offer(test::planarPath(problem_->si->getStateSpace(), {{1, 1}, {5, 5}, {9, 1}}),
                                            2.0 * std::hypot(4.0, 4.0));
            ASSERT_GT(search_.context.draftStride(), 1U);
            add({{1, 1}, {5, 9}, {9, 1}});
            hints_.advance(findings_);
            EXPECT_TRUE(mender_.paths.empty());
            EXPECT_EQ(hints_.size(), 0U);
            search_.evaluator().addWork(10000);
            add({{1, 1}, {5, 4}, {9, 1}});
            hints_.advance(findings_);
            ASSERT_EQ(findings_.paths.size(), 1U);
            EXPECT_TRUE(findings_.paths[0].draft);
            // nobody would repair it
            PathHints full(search_.context, &mender_, false);
            full.add(test::planarPath(problem_->si->getStateSpace(), {{1, 1}, {5, 4}, {9, 1}}),
                     PathHints::Source::User);
            full.advance(findings_);
            ASSERT_EQ(findings_.paths.size(), 2U);
            EXPECT_FALSE(findings_.paths[1].draft);
        }

        TEST_F(PathHintsTest, AnInterruptedOneIsKept)
        {
            add({{1, 1}, {5, 5}, {9, 1}});
            search_.evaluator().setStopCondition([] { return true; });
            hints_.advance(findings_);
            EXPECT_EQ(hints_.size(), 1U);
            search_.evaluator().setStopCondition({});
            hints_.advance(findings_);
            EXPECT_EQ(findings_.paths.size(), 1U);
        }

        TEST_F(PathHintsTest, TheirNumberIsLimited)
        {
            for (std::size_t i = 0; i < 2 * PathHints::CAPACITY; ++i)
            {
                add({{1, 1}, {5, 5}, {9, 1}}, PathHints::Source::Population);
            }
            add({{1, 1}, {5, 4}, {9, 1}}, PathHints::Source::BestPath);
            EXPECT_EQ(hints_.size(), PathHints::CAPACITY);
            EXPECT_EQ(hints_.source(0), PathHints::Source::BestPath);
        }

        TEST_F(PathHintsTest, WithoutAMenderTheyAreCheckedOnly)
        {
            const auto wall = test::wallProblem();
            test::SearchProblem search(wall->pdef);
            search.begin();
            PathHints hints(search.context, nullptr, false);
            const auto &space = wall->si->getStateSpace();
            for (const Points &points : {Points{{1, 1}, {9, 1}}, Points{{1, 2}, {4, 7}, {6, 7}, {9, 1}},
                                         Points{{1, 1}, {4, 7}, {6, 7}, {9, 2}}, Points{{1, 1}}})
            {
                hints.add(test::planarPath(space, points), PathHints::Source::User);
                hints.advance(findings_);
                search.evaluator().addWork(10000);
                EXPECT_TRUE(findings_.paths.empty());
                EXPECT_EQ(hints.size(), 0U);
            }
            hints.add(test::planarPath(space, {{1, 1}, {4, 7}, {6, 7}, {9, 1}}), PathHints::Source::User);
            hints.advance(findings_);
            EXPECT_EQ(findings_.paths.size(), 1U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine
