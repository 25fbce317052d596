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

#include "engine/refinement/TighteningPart.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/SearchProblem.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        constexpr double ANY = std::numeric_limits<double>::infinity();

        class TighteningPartTest : public ::testing::Test
        {
        protected:
            TighteningPartTest()
            {
                EXPECT_EQ(search_.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            /* As the engine does with a path that another part found. */
            Proposal offer(const path::Waypoints &path, Proposal::Stage stage)
            {
                Proposal proposal{path, search_.evaluator().cost(path), stage, PartKind::Trees};
                EXPECT_TRUE(search_.context.incumbent.offer(path, proposal.cost->value(), proposal.origin));
                part_.improved(proposal);
                return proposal;
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            test::SearchProblem search_{problem_->pdef};
            TighteningPart part_{search_.context};
            ob::StateSpacePtr space_ = problem_->si->getStateSpace();
            path::Waypoints detour_ =
                test::planarPath(space_, {{1.0, 1.0}, {2.0, 5.0}, {3.0, 8.5}, {7.0, 8.5}, {8.0, 4.0}, {9.0, 1.0}});
            Findings findings_{space_};
        };

        TEST_F(TighteningPartTest, HasNothingToDoWithoutAPathThatCanBeBetter)
        {
            EXPECT_EQ(part_.readiness(), Readiness::Idle);
            offer(detour_, Proposal::Stage::Raw);
            EXPECT_EQ(part_.readiness(), Readiness::Ready);
            offer(test::planarPath(space_, {{1.0, 1.0}, {9.0, 1.0}}), Proposal::Stage::Straight);
            EXPECT_EQ(part_.readiness(), Readiness::Idle) << "one motion";
        }

        TEST_F(TighteningPartTest, ProposesTheBestPathTightenedAsThatOfWhoFoundIt)
        {
            offer(detour_, Proposal::Stage::Raw);
            double best = search_.context.incumbent.cost();
            for (int turn = 0; turn < 50; ++turn)
            {
                findings_.paths.clear();
                part_.advance(2000, findings_);
                for (Proposal &proposal : findings_.paths)
                {
                    EXPECT_EQ(proposal.stage, Proposal::Stage::Tight);
                    EXPECT_EQ(proposal.origin, PartKind::Trees);
                    ASSERT_TRUE(proposal.cost);
                    EXPECT_NEAR(proposal.cost->value(), proposal.path.length(), 1e-9);
                    EXPECT_LT(proposal.cost->value(), best);
                    EXPECT_TRUE(search_.evaluator().checkPath(proposal.path));
                    best = proposal.cost->value();
                    search_.context.incumbent.offer(proposal.path, best, proposal.origin);
                    part_.improved(proposal);
                }
            }
            EXPECT_LT(best, 1.005 * test::wallOptimum());
        }

        TEST_F(TighteningPartTest, RefinesUntilThePathIsBetterThanItsRival)
        {
            const double before = detour_.length();
            ob::Cost cost(before);
            const double rival = 0.95 * before;
            const path::Waypoints refined = part_.refine(detour_, cost, ob::Cost(rival));
            EXPECT_LT(cost.value(), rival);
            EXPECT_NEAR(cost.value(), refined.length(), 1e-9);
            EXPECT_TRUE(search_.evaluator().checkPath(refined));
            EXPECT_TRUE(space_->equalStates(refined.front(), detour_.front()));
            EXPECT_TRUE(space_->equalStates(refined.back(), detour_.back()));
        }

        TEST_F(TighteningPartTest, GivesUpOnAPathThatCannotBeatItsRival)
        {
            ob::Cost cost(detour_.length());
            const std::uint64_t before = search_.evaluator().work();
            part_.refine(detour_, cost, ob::Cost(0.1));
            const std::uint64_t given = search_.evaluator().work() - before;
            EXPECT_GT(cost.value(), 0.1);
            // at most 8 rounds of 3 checks of the path, some 600 states
            EXPECT_LT(given, 20000U);
        }

        /* The next turn continues with the path that refine() made, or with the raw one that became the best. */
        TEST_F(TighteningPartTest, TurnsGoOnWithWhatBecameTheBestPath)
        {
            ob::Cost cost(detour_.length());
            const path::Waypoints refined = part_.refine(detour_, cost, ob::Cost(ANY));
            offer(refined, Proposal::Stage::Tight);
            part_.advance(5000, findings_);
            ASSERT_FALSE(findings_.paths.empty());
            EXPECT_LT(findings_.paths.back().cost->value(), cost.value());
            findings_.paths.clear();
            // a raw path that is shorter than the refined one
            const path::Waypoints other = test::planarPath(space_, {{1.0, 1.0}, {4.0, 6.2}, {6.0, 6.2}, {9.0, 1.0}});
            ASSERT_LT(other.length(), cost.value());
            offer(other, Proposal::Stage::Raw);
            const double best = search_.context.incumbent.cost();
            for (int turn = 0; turn < 20 && findings_.paths.empty(); ++turn)
            {
                part_.advance(2000, findings_);
            }
            ASSERT_FALSE(findings_.paths.empty());
            EXPECT_LT(findings_.paths.back().cost->value(), best);
        }

        TEST_F(TighteningPartTest, StopsWithTheCondition)
        {
            offer(detour_, Proposal::Stage::Raw);
            search_.evaluator().setStopCondition([] { return true; });
            problem_->counted.forget();
            part_.advance(100000, findings_);
            ob::Cost cost(detour_.length());
            part_.refine(detour_, cost, ob::Cost(0.1));
            EXPECT_TRUE(findings_.paths.empty());
            EXPECT_EQ(problem_->counted.states, 0U);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
