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

#include "engine/refinement/PathMending.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        struct Disc
        {
            double x, y, radius;
        };

        /* A space over the plane [-10, 10]^2 with discs. */
        struct Discs
        {
            Discs(const ob::StateSpacePtr &stateSpace, std::vector<Disc> theDiscs, std::uint_fast32_t seed = 3)
              : space(stateSpace)
              , discs(std::move(theDiscs))
              , problem(space,
                        [this](const ob::State *state)
                        {
                            std::vector<double> values;
                            space->copyToReals(values, state);
                            return std::all_of(
                                discs.begin(), discs.end(),
                                [&](const Disc &disc)
                                { return std::hypot(values[0] - disc.x, values[1] - disc.y) > disc.radius; });
                        })
              , evaluator(problem.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem.si))
              , mending(std::make_shared<const path::StateChart>(space), evaluator, seed)
            {
                problem.si->setStateValidityCheckingResolution(0.002);
                problem.si->setup();
            }

            bool has(const path::Waypoints &path, const ob::State *state) const
            {
                for (std::size_t i = 0; i < path.size(); ++i)
                {
                    if (space->equalStates(path[i], state))
                    {
                        return true;
                    }
                }
                return false;
            }

            /* Whether \e mended is valid and joins the ends of \e path. */
            void expectValid(const path::Waypoints &path, const path::Waypoints &mended)
            {
                ASSERT_GE(mended.size(), 2U);
                EXPECT_TRUE(space->equalStates(mended.front(), path.front()));
                EXPECT_TRUE(space->equalStates(mended.back(), path.back()));
                for (std::size_t i = 1; i < mended.size(); ++i)
                {
                    EXPECT_TRUE(evaluator.checkState(mended[i])) << i;
                    EXPECT_TRUE(problem.si->checkMotion(mended[i - 1], mended[i])) << i;
                    EXPECT_FALSE(space->equalStates(mended[i - 1], mended[i])) << i;
                }
            }

            ob::StateSpacePtr space;
            std::vector<Disc> discs;
            test::CountingProblem problem;
            path::PathEvaluator evaluator;
            PathMending mending;
        };

        TEST(PathMending, LeavesAValidPathAsItIs)
        {
            Discs world(test::realVectorSpace(2), {{0, 0, 2}});
            const path::Waypoints before = test::planarPath(world.space, {{-8, 0}, {0, 3}, {8, 0}});
            path::Waypoints path = before;
            ASSERT_TRUE(world.mending.mend(path, 0));
            EXPECT_EQ(path.size(), before.size());
            world.expectValid(before, path);
        }

        TEST(PathMending, ReplacesWhatCollidesOnly)
        {
            for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
            {
                Discs world(test::realVectorSpace(2), {{-5, 0, 1}, {3, 0, 1.5}}, seed);
                const path::Waypoints before =
                    test::planarPath(world.space, {{-8, 0}, {-5, 0.2}, {-1, 0}, {-1, 1}, {3, 0.5}, {8, 0}, {8, 8}});
                path::Waypoints path = before;
                ASSERT_TRUE(world.mending.mend(path, 0)) << seed;
                world.expectValid(before, path);
                for (const std::size_t kept : {2, 3, 5})
                {
                    EXPECT_TRUE(world.has(path, before[kept])) << seed << ", vertex " << kept;
                }
                for (const std::size_t collided : {1, 4})
                {
                    EXPECT_FALSE(world.has(path, before[collided])) << seed << ", vertex " << collided;
                }
            }
        }

        TEST(PathMending, BridgesSectionsOfSeveralVerticesAndBesideTheEnds)
        {
            Discs world(test::realVectorSpace(2), {{0, 0, 7.9}});
            const path::Waypoints before =
                test::planarPath(world.space, {{-8, 0}, {-4, 2}, {0, 0}, {0, 1}, {0, 0}, {4, 1}, {8, 0}});
            bool mended = false;
            for (unsigned int effort = 0; effort < 6 && !mended; ++effort)
            {
                path::Waypoints path = before;
                mended = world.mending.mend(path, effort);
                if (mended)
                {
                    world.expectValid(before, path);
                }
                else
                {
                    EXPECT_EQ(path.size(), before.size()) << "unchanged";
                }
            }
            EXPECT_TRUE(mended);
        }

        TEST(PathMending, WorksInSpacesWithHeadings)
        {
            for (const auto &space : {test::se2Space(), test::dubinsSpace(false), test::reedsSheppSpace()})
            {
                Discs world(space, {{0, 0, 1.5}});
                path::Waypoints before(space);
                for (const double x : {-8.0, -4.0, 0.5, 4.0, 8.0})
                {
                    ob::ScopedState<> state(space);
                    state = std::vector<double>{x, 0.0, 0.0};
                    before.append(state.get());
                }
                bool mended = false;
                for (unsigned int effort = 0; effort < 4 && !mended; ++effort)
                {
                    path::Waypoints path = before;
                    mended = world.mending.mend(path, effort);
                    if (mended)
                    {
                        world.expectValid(before, path);
                    }
                }
                EXPECT_TRUE(mended) << space->getName();
            }
        }

        TEST(PathMending, ADraftIsValidAtItsStride)
        {
            Discs world(test::realVectorSpace(2), {{0, 0, 2}});
            const path::Waypoints before = test::planarPath(world.space, {{-8, 0}, {8, 0}});
            path::Waypoints path = before;
            const path::StrideScope draft(world.evaluator, 8);
            ASSERT_TRUE(world.mending.mend(path, 0));
            EXPECT_TRUE(world.evaluator.checkPath(path));
            EXPECT_GT(path.size(), 2U);
        }

        TEST(PathMending, GivesUpWithinItsBudgetWhereThereIsNoWay)
        {
            Discs world(test::realVectorSpace(2), {{8, 0, 1.5}});
            const path::Waypoints before = test::planarPath(world.space, {{-8, 0}, {8, 5}, {9.9, 0}});
            // the last state is enclosed
            for (double angle = 0.0; angle < 6.28; angle += 0.1)
            {
                world.discs.push_back({9.9 + 0.35 * std::cos(angle), 0.35 * std::sin(angle), 0.1});
            }
            for (unsigned int effort = 0; effort < 3; ++effort)
            {
                path::Waypoints path = before;
                const auto work = world.evaluator.work();
                EXPECT_FALSE(world.mending.mend(path, effort));
                EXPECT_EQ(path.size(), before.size());
                EXPECT_FALSE(world.evaluator.interrupted());
                EXPECT_LT(world.evaluator.work() - work, 3000U << effort);
            }
        }

        TEST(PathMending, StopsWhenInterrupted)
        {
            Discs world(test::realVectorSpace(2), {{0, 0, 2}});
            const path::Waypoints before = test::planarPath(world.space, {{-8, 0}, {0, 0}, {8, 0}});
            for (const unsigned int limit : {1U, 2U, 3U, 5U, 10U, 20U})
            {
                unsigned int asked = 0;
                world.evaluator.setStopCondition([&] { return ++asked >= limit; });
                path::Waypoints path = before;
                world.problem.forget();
                EXPECT_FALSE(world.mending.mend(path, 0));
                EXPECT_TRUE(world.evaluator.interrupted());
                EXPECT_EQ(path.size(), before.size());
                EXPECT_LE(world.problem.motions, limit);
            }
        }

        TEST(PathMending, AMotionMayBeInvalidThoughItsStatesAreNot)
        {
            /* Rejects long motions. */
            class Short : public ob::MotionValidator
            {
            public:
                using MotionValidator::MotionValidator;
                bool checkMotion(const ob::State *from, const ob::State *to) const override
                {
                    return si_->distance(from, to) < 3.0;
                }
                bool checkMotion(const ob::State *from, const ob::State *to,
                                 std::pair<ob::State *, double> & /*lastValid*/) const override
                {
                    return checkMotion(from, to);
                }
            };
            Discs world(test::realVectorSpace(2), {});
            world.problem.si->setMotionValidator(std::make_shared<Short>(world.problem.si));
            const path::Waypoints before = test::planarPath(world.space, {{0, 0}, {2, 0}, {6, 0}, {8, 0}});
            path::Waypoints path = before;
            ASSERT_TRUE(world.mending.mend(path, 0));
            world.expectValid(before, path);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
