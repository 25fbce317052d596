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

#include <cmath>
#include <cstddef>
#include <cstdint>
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
              : TighteningPartTest(test::wallProblem())
            {
            }

            explicit TighteningPartTest(std::unique_ptr<test::PlanningProblem> problem)
              : problem_(std::move(problem))
            {
                EXPECT_EQ(search_.begin(), ob::PlannerStatus::EXACT_SOLUTION);
            }

            Proposal proposal(const path::Waypoints &path, Proposal::Stage stage) const
            {
                return {path, search_.evaluator().cost(path), stage, PartKind::Trees, false};
            }

            /* As the engine does with a path that is better than the best one. */
            void accept(const Proposal &better)
            {
                EXPECT_TRUE(search_.context.incumbent.offer(better.path, better.cost->value(), better.origin));
                part_.improved(better);
            }

            void offer(const path::Waypoints &path, Proposal::Stage stage)
            {
                accept(proposal(path, stage));
            }

            Proposal refine(const path::Waypoints &path, double rival)
            {
                return part_.refine(proposal(path, Proposal::Stage::Raw), ob::Cost(rival));
            }

            /* A tight path between the ends of \e raw whose cost is its length. */
            void expectTight(const Proposal &refined, const path::Waypoints &raw) const
            {
                EXPECT_EQ(refined.stage, Proposal::Stage::Tight);
                EXPECT_EQ(refined.origin, PartKind::Trees);
                ASSERT_TRUE(refined.cost);
                EXPECT_NEAR(refined.cost->value(), refined.path.length(), 1e-9);
                EXPECT_TRUE(space_->equalStates(refined.path.front(), raw.front()));
                EXPECT_TRUE(space_->equalStates(refined.path.back(), raw.back()));
            }

            std::unique_ptr<test::PlanningProblem> problem_;
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
            unsigned int drafts = 0;
            unsigned int full = 0;
            for (int turn = 0; turn < 50; ++turn)
            {
                findings_.paths.clear();
                part_.advance(2000, findings_);
                for (Proposal &proposed : findings_.paths)
                {
                    const double best = search_.context.incumbent.cost();
                    expectTight(proposed, detour_);
                    EXPECT_LT(proposed.cost->value(), best);
                    ++(proposed.draft ? drafts : full);
                    if (proposed.draft)
                    {
                        proposed = part_.refine(proposed, ob::Cost(best));
                        ASSERT_FALSE(proposed.draft);
                        expectTight(proposed, detour_);
                    }
                    EXPECT_TRUE(search_.evaluator().checkPath(proposed.path));
                    if (proposed.cost->value() < best)
                    {
                        accept(proposed);
                    }
                }
            }
            EXPECT_GT(drafts, 0U);
            EXPECT_GT(full, 0U);
            EXPECT_LT(search_.context.incumbent.cost(), 1.005 * test::wallOptimum());
        }

        TEST_F(TighteningPartTest, RefinesUntilThePathIsBetterThanItsRival)
        {
            const double rival = 0.95 * detour_.length();
            const Proposal refined = refine(detour_, rival);
            EXPECT_FALSE(refined.draft);
            expectTight(refined, detour_);
            EXPECT_LT(refined.cost->value(), rival);
            EXPECT_TRUE(search_.evaluator().checkPath(refined.path));
        }

        TEST_F(TighteningPartTest, GivesUpOnAPathThatCannotBeatItsRival)
        {
            const std::uint64_t before = search_.evaluator().work();
            const Proposal refined = refine(detour_, 0.1);
            const std::uint64_t given = search_.evaluator().work() - before;
            EXPECT_GT(refined.cost->value(), 0.1);
            // at most 8 rounds of 3 checks of the path, some 600 states
            EXPECT_LT(given, 20000U);
        }

        /* The next turns continue with the path that refine() made, or with the raw one that became the best. */
        TEST_F(TighteningPartTest, TurnsGoOnWithWhatBecameTheBestPath)
        {
            const Proposal refined = refine(detour_, ANY);
            accept(refined);
            part_.advance(5000, findings_);
            part_.advance(5000, findings_);
            ASSERT_FALSE(findings_.paths.empty());
            EXPECT_LT(findings_.paths.back().cost->value(), refined.cost->value());
            findings_.paths.clear();
            // a raw path that is shorter than the refined one
            const path::Waypoints other = test::planarPath(space_, {{1.0, 1.0}, {4.0, 6.2}, {6.0, 6.2}, {9.0, 1.0}});
            ASSERT_LT(other.length(), refined.cost->value());
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
            const Proposal raw = proposal(detour_, Proposal::Stage::Raw);
            search_.evaluator().setStopCondition([] { return true; });
            problem_->counted.forget();
            part_.advance(100000, findings_);
            part_.advance(100000, findings_);
            part_.refine(raw, ob::Cost(0.1));
            EXPECT_TRUE(findings_.paths.empty());
            EXPECT_EQ(problem_->counted.states, 0U);
        }

        TEST_F(TighteningPartTest, ADraftThatPromisesNothingStaysADraft)
        {
            offer(detour_, Proposal::Stage::Raw);
            ASSERT_GT(search_.context.draftStride(), 1U);
            problem_->counted.forget();
            const double rival = 0.9 * test::wallOptimum();
            const Proposal refined = refine(detour_, rival);
            EXPECT_TRUE(refined.draft);
            expectTight(refined, detour_);
            EXPECT_GT(refined.cost->value(), rival);
            EXPECT_LT(refined.cost->value(), detour_.length());
            EXPECT_EQ(problem_->counted.motions, 0U) << "checked in full";
            EXPECT_EQ(search_.evaluator().stride(), 1U);
            const path::StrideScope draft(search_.evaluator(), search_.context.draftStride());
            EXPECT_TRUE(search_.evaluator().checkPath(refined.path));
        }

        TEST_F(TighteningPartTest, ADraftThatPromisesToBeTheBestBecomesAValidPath)
        {
            offer(detour_, Proposal::Stage::Raw);
            const path::Waypoints other =
                test::planarPath(space_, {{1.0, 1.0}, {1.0, 9.0}, {5.0, 9.0}, {9.0, 9.0}, {9.0, 1.0}});
            ASSERT_GT(other.length(), detour_.length());
            const Proposal refined = refine(other, detour_.length());
            EXPECT_FALSE(refined.draft);
            expectTight(refined, other);
            EXPECT_LT(refined.cost->value(), detour_.length());
            EXPECT_TRUE(search_.evaluator().checkPath(refined.path));
        }

        /* The plane [0, 10]^2 with obstacles at x = 5.1 that a draft of the straight motion from (1, 1) to (9, 1) does
           not notice: a peg, which leaves room beside it, or a wall up to y = \e height. */
        std::unique_ptr<test::PlanningProblem> thinProblem(double bottom, double height)
        {
            auto problem = std::make_unique<test::PlanningProblem>(
                test::realVectorSpace(2, 0.0, 10.0),
                [=](const ob::State *s)
                {
                    return std::abs(test::coordinate(s, 0) - 5.1) > 0.04 || test::coordinate(s, 1) < bottom ||
                           test::coordinate(s, 1) > height;
                },
                std::vector<double>{1.0, 1.0}, std::vector<double>{9.0, 1.0});
            problem->si->setStateValidityCheckingResolution(0.002);
            problem->si->setup();
            return problem;
        }

        class ThinObstacleTest : public TighteningPartTest
        {
        protected:
            explicit ThinObstacleTest(double bottom, double height)
              : TighteningPartTest(thinProblem(bottom, height))
            {
                offer(over_, Proposal::Stage::Raw);
                const path::Waypoints straight = test::planarPath(space_, {{1.0, 1.0}, {9.0, 1.0}});
                const path::StrideScope draft(search_.evaluator(), search_.context.draftStride());
                EXPECT_TRUE(search_.evaluator().checkPath(straight));
                search_.evaluator().setStride(1);
                EXPECT_FALSE(search_.evaluator().checkPath(straight));
            }

            path::Waypoints over_ = test::planarPath(space_, {{1.0, 1.0}, {3.0, 6.0}, {7.0, 6.0}, {9.0, 1.0}});
        };

        class PegTest : public ThinObstacleTest
        {
        protected:
            PegTest()
              : ThinObstacleTest(0.97, 1.03)
            {
            }
        };

        class ThinWallTest : public ThinObstacleTest
        {
        protected:
            ThinWallTest()
              : ThinObstacleTest(0.0, 4.0)
            {
            }
        };

        TEST_F(PegTest, ADraftThroughAPegIsLedAroundIt)
        {
            Proposal draft = proposal(test::planarPath(space_, {{1.0, 1.0}, {9.0, 1.0}}), Proposal::Stage::Tight);
            draft.draft = true;
            const Proposal repaired = part_.refine(draft, ob::Cost(over_.length()));
            EXPECT_FALSE(repaired.draft);
            expectTight(repaired, over_);
            EXPECT_GT(repaired.cost->value(), 8.0);
            EXPECT_LT(repaired.cost->value(), 8.2);
            EXPECT_TRUE(search_.evaluator().checkPath(repaired.path));
        }

        TEST_F(ThinWallTest, ADraftThatCannotBeRepairedStaysADraft)
        {
            Proposal draft = proposal(test::planarPath(space_, {{1.0, 1.0}, {9.0, 1.0}}), Proposal::Stage::Tight);
            draft.draft = true;
            const Proposal refined = part_.refine(draft, ob::Cost(over_.length()));
            EXPECT_TRUE(refined.draft);
            expectTight(refined, over_);
            EXPECT_DOUBLE_EQ(refined.cost->value(), 8.0);
        }

        TEST_F(ThinWallTest, ARawPathWhoseDraftCannotBeRepairedIsTightenedInFull)
        {
            const path::Waypoints other = test::planarPath(space_, {{1.0, 1.0}, {1.0, 7.0}, {9.0, 7.0}, {9.0, 1.0}});
            const Proposal refined = refine(other, over_.length());
            EXPECT_FALSE(refined.draft);
            expectTight(refined, over_);
            EXPECT_LT(refined.cost->value(), over_.length());
            EXPECT_GT(refined.cost->value(), 2.0 * std::hypot(3.9, 3.0)) << "through the wall";
            EXPECT_TRUE(search_.evaluator().checkPath(refined.path));
        }

        TEST_F(ThinWallTest, ADraftOfTheBestPathMustPromiseMoreAfterItFailed)
        {
            const double best = search_.context.incumbent.cost();
            std::vector<double> promised;
            for (int turn = 0; turn < 300; ++turn)
            {
                findings_.paths.clear();
                part_.advance(2000, findings_);
                for (const Proposal &proposed : findings_.paths)
                {
                    if (proposed.draft)
                    {
                        promised.push_back((best - proposed.cost->value()) / best);
                    }
                }
            }
            ASSERT_FALSE(promised.empty());
            // from 0.4 % on, and 30 % at most
            EXPECT_LE(promised.size(), 7U);
            EXPECT_GT(promised[0], 0.004);
            for (std::size_t i = 1; i < promised.size(); ++i)
            {
                // half as much is enough for a draft that gains no more
                EXPECT_GE(promised[i], (i + 1 < promised.size() ? 2.0 : 1.0) * promised[i - 1]);
            }
        }

        TEST_F(TighteningPartTest, ADraftOfTheBestPathThatBecameTheBestNeedNotPromiseMore)
        {
            offer(detour_, Proposal::Stage::Raw);
            std::vector<double> promised;
            for (int turn = 0; turn < 60; ++turn)
            {
                findings_.paths.clear();
                part_.advance(300, findings_);
                for (const Proposal &proposed : findings_.paths)
                {
                    // nothing else improves it meanwhile
                    const double best = search_.context.incumbent.cost();
                    const Proposal refined = proposed.draft ? part_.refine(proposed, ob::Cost(best)) : proposed;
                    if (proposed.draft && refined.cost->value() < best)
                    {
                        promised.push_back((best - proposed.cost->value()) / best);
                        accept(refined);
                    }
                }
            }
            // the first gains are the greatest
            ASSERT_GT(promised.size(), 3U);
            EXPECT_LT(promised[1], promised[0]);
            EXPECT_LT(promised.back(), promised[0]);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
