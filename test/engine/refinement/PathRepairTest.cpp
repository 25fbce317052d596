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

#include "engine/refinement/PathRepair.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        using Points = std::vector<std::pair<double, double>>;

        constexpr double RADIUS = 0.1;

        std::pair<double, double> position(const ob::StateSpacePtr &space, const ob::State *state)
        {
            std::vector<double> values;
            space->copyToReals(values, state);
            return {values[0], values[1]};
        }

        /* A space over the plane [-10, 10]^2 with pegs that a draft may not notice. */
        struct Pegs
        {
            Pegs(const ob::StateSpacePtr &stateSpace, Points pegs, std::uint_fast32_t seed = 3)
              : space(stateSpace)
              , problem(space,
                        [this, pegs = std::move(pegs)](const ob::State *state)
                        {
                            const auto [x, y] = position(space, state);
                            return std::all_of(pegs.begin(), pegs.end(),
                                               [x = x, y = y](const auto &peg)
                                               { return std::hypot(x - peg.first, y - peg.second) > RADIUS; }) &&
                                   (!wall || std::abs(x - 7.0) > RADIUS);
                        })
              , evaluator(problem.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem.si))
              , repair(std::make_shared<const path::StateChart>(space), evaluator, seed)
            {
                problem.si->setStateValidityCheckingResolution(0.001);
                problem.si->setup();
            }

            ob::StateSpacePtr space;
            bool wall{false};  ///< whether there is a wall across the plane at x = 7
            test::CountingProblem problem;
            path::PathEvaluator evaluator;
            PathRepair repair;
        };

        /* Whether \e repaired is valid and has the states of \e draft in their order. */
        void expectRepaired(Pegs &pegs, const path::Waypoints &draft, const path::Waypoints &repaired)
        {
            ASSERT_GE(repaired.size(), draft.size());
            std::size_t found = 0;
            for (std::size_t i = 0; i < repaired.size(); ++i)
            {
                EXPECT_TRUE(pegs.evaluator.checkState(repaired[i])) << i;
                if (i > 0)
                {
                    EXPECT_TRUE(pegs.problem.si->checkMotion(repaired[i - 1], repaired[i])) << i;
                    EXPECT_FALSE(pegs.space->equalStates(repaired[i - 1], repaired[i])) << i;
                }
                found += found < draft.size() && pegs.space->equalStates(repaired[i], draft[found]) ? 1 : 0;
            }
            EXPECT_TRUE(pegs.space->equalStates(repaired.front(), draft.front()));
            EXPECT_TRUE(pegs.space->equalStates(repaired.back(), draft.back()));
            EXPECT_EQ(found, draft.size());
        }

        TEST(PathRepair, LeadsADraftAroundAPeg)
        {
            for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
            {
                Pegs pegs(test::realVectorSpace(2), {{2.0, 0.02}}, seed);
                const path::Waypoints draft = test::planarPath(pegs.space, {{-8, 0}, {8, 0}, {8, 5}});
                path::Waypoints path = draft;
                ASSERT_TRUE(pegs.repair.repair(path)) << "seed " << seed;
                expectRepaired(pegs, draft, path);
                EXPECT_LE(path.size(), draft.size() + 3);
                EXPECT_LT(path.length(), draft.length() + 1.0);
            }
        }

        TEST(PathRepair, LeadsADraftAroundSeveralPegs)
        {
            Pegs pegs(test::realVectorSpace(2), {{-5, 0}, {-2, 0.05}, {0, -0.05}, {0.5, 0}, {4, 0.0}, {7, 3}});
            const path::Waypoints draft = test::planarPath(pegs.space, {{-8, 0}, {7, 0}, {7, 8}});
            path::Waypoints path = draft;
            ASSERT_TRUE(pegs.repair.repair(path));
            expectRepaired(pegs, draft, path);
            EXPECT_LT(path.length(), draft.length() + 3.0);
        }

        TEST(PathRepair, APegNextToAnEndLeavesTheEnd)
        {
            // fewer valid states before and after the pegs than in the pegs
            Pegs pegs(test::realVectorSpace(2), {{-7.85, 0}, {7.85, 0}});
            const path::Waypoints draft = test::planarPath(pegs.space, {{-8, 0}, {8, 0}});
            path::Waypoints path = draft;
            ASSERT_TRUE(pegs.repair.repair(path));
            expectRepaired(pegs, draft, path);
        }

        TEST(PathRepair, LeavesAValidPathAsItIs)
        {
            Pegs pegs(test::realVectorSpace(2), {{0, 0}});
            const path::Waypoints draft = test::planarPath(pegs.space, {{-8, 0}, {0, 1}, {8, 0}});
            path::Waypoints path = draft;
            ASSERT_TRUE(pegs.repair.repair(path));
            EXPECT_EQ(path.size(), draft.size());
            expectRepaired(pegs, draft, path);
        }

        TEST(PathRepair, FailsWhereThereIsNoWayAround)
        {
            Pegs pegs(test::realVectorSpace(2), {{0, 0}});
            pegs.wall = true;
            path::Waypoints path = test::planarPath(pegs.space, {{-8, 0}, {8, 0}});
            const auto before = pegs.evaluator.work();
            EXPECT_FALSE(pegs.repair.repair(path));
            EXPECT_FALSE(pegs.evaluator.interrupted());
            // a few checks of a path of 600 states
            EXPECT_LT(pegs.evaluator.work() - before, 5000U);
        }

        TEST(PathRepair, FailsIfTheStatesGiveNoReason)
        {
            /* Rejects all motions to states beyond x = 5. */
            class Refusing : public ob::MotionValidator
            {
            public:
                using MotionValidator::MotionValidator;
                bool checkMotion(const ob::State * /*from*/, const ob::State *to) const override
                {
                    return to->as<ob::RealVectorStateSpace::StateType>()->values[0] < 5.0;
                }
                bool checkMotion(const ob::State *from, const ob::State *to,
                                 std::pair<ob::State *, double> & /*lastValid*/) const override
                {
                    return checkMotion(from, to);
                }
            };
            Pegs pegs(test::realVectorSpace(2), {});
            pegs.problem.si->setMotionValidator(std::make_shared<Refusing>(pegs.problem.si));
            path::Waypoints path = test::planarPath(pegs.space, {{-8, 0}, {0, 0}, {8, 0}});
            EXPECT_FALSE(pegs.repair.repair(path));
        }

        TEST(PathRepair, IsFalseIfInterrupted)
        {
            const Points pegsAt{{-5, 0}, {-2, 0}, {0, 0}, {4, 0}};
            unsigned int asked = 0;
            {
                Pegs pegs(test::realVectorSpace(2), pegsAt);
                pegs.evaluator.setStopCondition(
                    [&]
                    {
                        ++asked;
                        return false;
                    });
                path::Waypoints path = test::planarPath(pegs.space, {{-8, 0}, {7, 0}});
                ASSERT_TRUE(pegs.repair.repair(path));
                ASSERT_GT(asked, 10U);
            }
            for (unsigned int last = 0; last < asked; ++last)
            {
                Pegs pegs(test::realVectorSpace(2), pegsAt);
                unsigned int now = 0;
                pegs.evaluator.setStopCondition([&] { return ++now > last; });
                path::Waypoints path = test::planarPath(pegs.space, {{-8, 0}, {7, 0}});
                EXPECT_FALSE(pegs.repair.repair(path)) << "stopped after " << last;
            }
        }

        class PathRepairInSpaces : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(
            Spaces, PathRepairInSpaces,
            ::testing::Values(test::NamedSpace{"SE2", [] { return test::se2Space(); }},
                              test::NamedSpace{"SE3", [] { return test::se3Space(); }},
                              test::NamedSpace{"Dubins", [] { return test::dubinsSpace(false, 0.3); }},
                              test::NamedSpace{"ReedsShepp", [] { return test::reedsSheppSpace(0.3); }}),
            test::SpaceName());

        /* Pegs, long in the third dimension, in the middle of random motions. */
        TEST_P(PathRepairInSpaces, EveryMotionIsValidInItsDirection)
        {
            const auto space = GetParam().make();
            const auto sampler = space->allocStateSampler();
            unsigned int repaired = 0;
            unsigned int invalid = 0;
            for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
            {
                path::Waypoints draft(space);
                draft.resize(3);
                ob::ScopedState<> middle(space);
                Points pegsAt;
                for (std::size_t k = 0; k < draft.size(); ++k)
                {
                    sampler->sampleUniform(draft[k]);
                    if (k > 0)
                    {
                        space->interpolate(draft[k - 1], draft[k], 0.43, middle.get());
                        pegsAt.push_back(position(space, middle.get()));
                    }
                }
                Pegs pegs(space, pegsAt, seed);
                if (!pegs.evaluator.checkState(draft[0]) || !pegs.evaluator.checkState(draft[1]) ||
                    !pegs.evaluator.checkState(draft[2]))
                {
                    continue;
                }
                ASSERT_FALSE(pegs.evaluator.checkPath(draft));
                ++invalid;
                path::Waypoints path = draft;
                if (pegs.repair.repair(path))
                {
                    ++repaired;
                    expectRepaired(pegs, draft, path);
                }
            }
            EXPECT_GT(invalid, 15U);
            EXPECT_GT(2 * repaired, invalid);
        }

        TEST(PathRepair, MakesATinyDetourAtAFinerResolution)
        {
            for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
            {
                // the path cuts 0.005 off the peg
                Pegs pegs(test::realVectorSpace(2), {{2.0, 0.095}}, seed);
                const path::Waypoints original = test::planarPath(pegs.space, {{-8, 0}, {8, 0}, {8, 5}});
                path::Waypoints path = original;
                const path::FinenessScope fine(pegs.evaluator, 8, false);
                ASSERT_TRUE(pegs.repair.repair(path)) << "seed " << seed;
                expectRepaired(pegs, original, path);
                EXPECT_LT(path.length(), original.length() + 0.01);
            }
        }

        TEST(PathRepair, ShiftsACurveThatCannotBendAroundAPeg)
        {
            const auto space = test::ready(test::bounded(std::make_shared<ob::DubinsStateSpace>(1.0), 2, -10.0, 10.0));
            // on the inner side of a quarter of a circle of the smallest radius, into which the peg reaches by 0.003
            const double inner = (1.0 - RADIUS + 0.003) * std::sqrt(0.5);
            for (std::uint_fast32_t seed = 1; seed <= 10; ++seed)
            {
                Pegs pegs(space, {{inner, 1.0 - inner}}, seed);
                pegs.problem.si->setStateValidityCheckingResolution(0.004);
                pegs.problem.si->setup();
                path::Waypoints original(space);
                const double poses[][3] = {
                    {-4, 0, 0}, {0, 0, 0}, {1, 1, 1.5707963267948966}, {1, 5, 1.5707963267948966}};
                original.resize(4);
                for (std::size_t i = 0; i < 4; ++i)
                {
                    space->copyFromReals(original[i], {poses[i][0], poses[i][1], poses[i][2]});
                }
                path::Waypoints path = original;
                const path::FinenessScope fine(pegs.evaluator, 8, false);
                ASSERT_TRUE(pegs.repair.repair(path)) << "seed " << seed;
                double length = 0.0;
                for (std::size_t i = 1; i < path.size(); ++i)
                {
                    EXPECT_TRUE(pegs.evaluator.checkMotion(path[i - 1], path[i])) << i;
                    length += space->distance(path[i - 1], path[i]);
                }
                // without a loop
                EXPECT_LT(length, 8.0 + 1.5708 + 0.3) << "seed " << seed;
            }
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
