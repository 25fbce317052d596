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

#include "engine/fireflies/GoalSearch.h"

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalRegion.h>

#include "path/StateSpaces.h"
#include "planner/DistanceGoal.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        class GoalSearchOfEverySpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, GoalSearchOfEverySpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(GoalSearchOfEverySpace, FindsStatesThatSatisfyTheGoal)
        {
            const auto space = GetParam().make();
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            const auto sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> origin(space);
            ob::ScopedState<> target(space);
            sampler->sampleUniform(origin.get());
            sampler->sampleUniform(target.get());
            const auto goal = std::make_shared<test::DistanceGoal>(si, target.get(), 0.15 * space->getMaximumExtent());
            GoalSearch search(std::make_shared<const path::StateChart>(space), si, goal, origin.get(), 5);
            path::Waypoints found(space);
            const ob::PlannerTerminationCondition never([] { return false; });
            for (int i = 0; i < 2000 && found.size() < 3; ++i)
            {
                search.advance(never, found);
            }
            ASSERT_EQ(found.size(), 3U);
            for (const ob::State *state : found.pointers())
            {
                EXPECT_TRUE(goal->isSatisfied(state));
                EXPECT_TRUE(space->satisfiesBounds(state));
            }
        }

        TEST(GoalSearch, PassesOverInvalidStates)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            const auto isValid = [](const ob::State *state)
            { return state->as<ob::RealVectorStateSpace::StateType>()->values[0] > 5.5; };
            si->setStateValidityChecker(isValid);
            si->setup();
            ob::ScopedState<> origin(space);
            ob::ScopedState<> target(space);
            origin[0] = origin[1] = -5.0;
            target[0] = target[1] = 5.0;
            const auto goal = std::make_shared<test::DistanceGoal>(si, target.get(), 1.0);
            GoalSearch search(std::make_shared<const path::StateChart>(space), si, goal, origin.get(), 5);
            path::Waypoints found(space);
            const ob::PlannerTerminationCondition never([] { return false; });
            for (int i = 0; i < 2000 && found.empty(); ++i)
            {
                search.advance(never, found);
            }
            ASSERT_FALSE(found.empty());
            EXPECT_TRUE(isValid(found.front()));
        }

        /* Far from the target the distance is unknown: infinite or not a number. */
        class LostGoal : public test::DistanceGoal
        {
        public:
            LostGoal(const ob::SpaceInformationPtr &si, const ob::State *target, double unknown)
              : DistanceGoal(si, target, 0.3)
              , unknown_(unknown)
            {
            }

            double distanceGoal(const ob::State *state) const override
            {
                const double distance = DistanceGoal::distanceGoal(state);
                return distance < 4.0 ? distance : unknown_;
            }

        private:
            double unknown_;
        };

        TEST(GoalSearch, FindsTheGoalWhereNotAllDistancesAreNumbers)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            ob::ScopedState<> origin(space);
            ob::ScopedState<> target(space);
            origin[0] = origin[1] = -5.0;
            target[0] = target[1] = 5.0;
            for (const double unknown :
                 {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
            {
                const auto goal = std::make_shared<LostGoal>(si, target.get(), unknown);
                GoalSearch search(std::make_shared<const path::StateChart>(space), si, goal, origin.get(), 5);
                path::Waypoints found(space);
                const ob::PlannerTerminationCondition never([] { return false; });
                for (int i = 0; i < 500 && found.empty(); ++i)
                {
                    search.advance(never, found);
                }
                ASSERT_FALSE(found.empty()) << unknown;
                EXPECT_TRUE(goal->isSatisfied(found.front()));
            }
        }

        /* Records the states whose distance was computed. */
        class NeverSatisfied : public ob::GoalRegion
        {
        public:
            using GoalRegion::GoalRegion;

            double distanceGoal(const ob::State *state) const override
            {
                const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                asked.emplace_back(values[0], values[1]);
                return 1e9;
            }

            mutable std::vector<std::pair<double, double>> asked;
        };

        TEST(GoalSearch, EverySwarmOfNeighbouringSeedsDrawsStatesOfItsOwn)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            ob::ScopedState<> origin(space);
            origin[0] = origin[1] = -5.0;
            const ob::PlannerTerminationCondition never([] { return false; });
            std::set<std::pair<double, double>> states;
            for (const std::uint64_t seed : {5U, 6U, 12U})
            {
                const auto goal = std::make_shared<NeverSatisfied>(si);
                GoalSearch search(std::make_shared<const path::StateChart>(space), si, goal, origin.get(), seed);
                path::Waypoints found(space);
                for (int swarm = 0; swarm < 3; ++swarm)
                {
                    goal->asked.clear();
                    search.advance(never, found);
                    ASSERT_EQ(goal->asked.size(), 30U);
                    states.insert(goal->asked.begin(), goal->asked.end());
                    for (int generation = 0; generation < 50; ++generation)
                    {
                        search.advance(never, found);
                    }
                }
            }
            EXPECT_EQ(states.size(), 3U * 3U * 30U);
        }

        TEST(GoalSearch, StopsWithTheCondition)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            int asked = 0;
            si->setStateValidityChecker(
                [&asked](const ob::State *)
                {
                    ++asked;
                    return true;
                });
            si->setup();
            ob::ScopedState<> origin(space);
            origin[0] = origin[1] = -5.0;
            const auto goal = std::make_shared<test::DistanceGoal>(si, origin.get(), 100.0);
            GoalSearch search(std::make_shared<const path::StateChart>(space), si, goal, origin.get(), 5);
            path::Waypoints found(space);
            EXPECT_FALSE(search.advance(ob::PlannerTerminationCondition([] { return true; }), found));
            EXPECT_EQ(asked, 0);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
