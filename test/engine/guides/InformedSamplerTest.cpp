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

#include "engine/guides/InformedSampler.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/StateSpaces.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::guides
{
    namespace
    {
        /* Path length in a derived class: its lower bounds are not certain. */
        class Derived : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;
        };

        class InformedSamplerTest : public ::testing::TestWithParam<test::NamedSpace>
        {
        protected:
            InformedSamplerTest()
              : space_(GetParam().make())
              , si_(std::make_shared<ob::SpaceInformation>(space_))
              , chart_(std::make_shared<const path::StateChart>(space_))
              , start_(space_)
              , goal_(space_)
              , state_(space_)
            {
                ompl::RNG rng(7);
                chart_->sampleUniform(rng, start_.get());
                chart_->sampleUniform(rng, goal_.get());
                starts_.append(start_.get());
                goals_.append(goal_.get());
                bound_ = 1.3 * space_->distance(start_.get(), goal_.get());
            }

            double lengthThroughState() const
            {
                return space_->distance(start_.get(), state_.get()) + space_->distance(state_.get(), goal_.get());
            }

            /* How many of 300 samples may lie on a path shorter than the bound, and how many were drawn. */
            std::pair<int, int> informed(const path::CostBounds &bounds)
            {
                InformedSampler sampler(chart_, bounds, 3);
                int within = 0;
                int drawn = 0;
                for (int i = 0; i < 300; ++i)
                {
                    if (!sampler.sample(starts_, goals_, bound_, state_.get()))
                    {
                        continue;
                    }
                    EXPECT_TRUE(space_->satisfiesBounds(state_.get()));
                    ++drawn;
                    within += lengthThroughState() < bound_ ? 1 : 0;
                }
                return {within, drawn};
            }

            ob::StateSpacePtr space_;
            ob::SpaceInformationPtr si_;
            path::StateChartPtr chart_;
            ob::ScopedState<> start_;
            ob::ScopedState<> goal_;
            ob::ScopedState<> state_;
            path::Waypoints starts_{space_};
            path::Waypoints goals_{space_};
            double bound_{0.0};
        };

        INSTANTIATE_TEST_SUITE_P(Planner, InformedSamplerTest, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(InformedSamplerTest, DrawsWithinTheInformedSet)
        {
            const auto [within, drawn] =
                informed(path::CostBounds(si_, std::make_shared<ob::PathLengthOptimizationObjective>(si_)));
            EXPECT_GT(drawn, 0);
            EXPECT_EQ(within, drawn);
        }

        TEST_P(InformedSamplerTest, DrawsAnywhereOnceTheBoundsDoNotHold)
        {
            path::CostBounds bounds(si_, std::make_shared<Derived>(si_));
            bounds.observePath(start_.get(), goal_.get(), ob::Cost(0.1 * bound_));
            ASSERT_FALSE(bounds.admissible());
            const auto [within, drawn] = informed(bounds);
            EXPECT_EQ(drawn, 300);
            EXPECT_LT(within, 300);
        }

        /* Three goals around a start; the bound leaves two. */
        TEST(InformedSampler, DrawsFromTheInformedSetsOfAllPairsThatCanBeBetter)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            const path::Waypoints starts = test::planarPath(space, {{0.0, 0.0}});
            const path::Waypoints goals = test::planarPath(space, {{4.0, 0.0}, {0.0, 4.0}, {-6.0, 0.0}});
            for (const bool direct : {true, false})
            {
                const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(si);
                const path::CostBounds bounds(si, direct ? length : std::make_shared<Derived>(si));
                InformedSampler sampler(std::make_shared<const path::StateChart>(space), bounds, 3);
                ob::ScopedState<> state(space);
                std::vector<int> within(3, 0);
                for (int i = 0; i < 1000; ++i)
                {
                    if (!sampler.sample(starts, goals, 5.0, state.get()))
                    {
                        continue;
                    }
                    bool useful = false;
                    for (std::size_t j = 0; j < goals.size(); ++j)
                    {
                        const double through =
                            space->distance(starts[0], state.get()) + space->distance(state.get(), goals[j]);
                        within[j] += through < 5.0 ? 1 : 0;
                        useful = useful || through < 5.0;
                    }
                    EXPECT_TRUE(useful);
                    EXPECT_LT(sampler.lowerBound(), 5.0);
                }
                EXPECT_GT(within[0], 100);
                EXPECT_GT(within[1], 100);
                EXPECT_EQ(within[2], 0);
                // no pair is left, and all return with a worse bound
                EXPECT_FALSE(sampler.sample(starts, goals, 3.0, state.get()));
                EXPECT_TRUE(sampler.sample(starts, goals, 7.0, state.get()));
            }
        }

        /* A reward at the farther goal: without it the state between them is beyond the bound. */
        TEST(InformedSampler, KnowsOfRewardsAtTheEnds)
        {
            class Rewarded : public Derived
            {
            public:
                using Derived::Derived;

                ob::Cost terminalCost(const ob::State *state) const override
                {
                    return ob::Cost(state->as<ob::RealVectorStateSpace::StateType>()->values[0] > 0.0 ? -100.0 : 0.0);
                }
            };
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            const path::CostBounds bounds(si, std::make_shared<Rewarded>(si));
            InformedSampler sampler(std::make_shared<const path::StateChart>(space), bounds, 3);
            const path::Waypoints starts = test::planarPath(space, {{0.0, 0.0}});
            const path::Waypoints goals = test::planarPath(space, {{8.0, 0.0}, {-1.0, 0.0}});
            ob::ScopedState<> state(space);
            int drawn = 0;
            for (int i = 0; i < 100; ++i)
            {
                drawn += sampler.sample(starts, goals, 1.0, state.get()) ? 1 : 0;
            }
            EXPECT_EQ(drawn, 100);
        }

        /* Draws states in a corner, some of them out of bounds, and counts them. */
        class CornerSampler : public ob::RealVectorStateSampler
        {
        public:
            CornerSampler(const ob::StateSpace *space, int &count)
              : RealVectorStateSampler(space)
              , count_(count)
            {
            }

            void sampleUniform(ob::State *state) override
            {
                ++count_;
                double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                for (unsigned int i = 0; i < space_->getDimension(); ++i)
                {
                    values[i] = 10.0 + rng_.uniformReal(-1.0, 1.0);
                }
            }

        private:
            int &count_;
        };

        ob::StateSamplerAllocator corner(int &count)
        {
            return [&count](const ob::StateSpace *space) { return std::make_shared<CornerSampler>(space, count); };
        }

        bool isInCorner(const ob::State *state)
        {
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return values[0] >= 9.0 && values[1] >= 9.0;
        }

        TEST(InformedSampler, DrawsEveryOtherStateByTheUsersSampler)
        {
            const auto space = test::realVectorSpace(2);
            int count = 0;
            space->setStateSamplerAllocator(corner(count));
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            const path::CostBounds bounds(si, std::make_shared<ob::PathLengthOptimizationObjective>(si));
            InformedSampler sampler(std::make_shared<const path::StateChart>(space), bounds, 3);
            const path::Waypoints starts = test::planarPath(space, {{0.0, 0.0}});
            const path::Waypoints goals = test::planarPath(space, {{4.0, 0.0}});
            ob::ScopedState<> state(space);
            int inCorner = 0;
            for (int i = 0; i < 1000; ++i)
            {
                ASSERT_TRUE(sampler.sample(starts, goals, std::numeric_limits<double>::infinity(), state.get()));
                EXPECT_TRUE(space->satisfiesBounds(state.get()));
                inCorner += isInCorner(state.get()) ? 1 : 0;
            }
            EXPECT_EQ(count, 500);
            EXPECT_GE(inCorner, 500);
            EXPECT_LT(inCorner, 520);
            // no path as short as that leads through the corner
            int drawn = 0;
            for (int i = 0; i < 1000; ++i)
            {
                if (!sampler.sample(starts, goals, 5.0, state.get()))
                {
                    continue;
                }
                ++drawn;
                EXPECT_FALSE(isInCorner(state.get()));
            }
            EXPECT_EQ(drawn, 500);
            EXPECT_GT(count, 1000);
        }

        TEST(InformedSampler, FindsTheUsersSamplerOfASubspace)
        {
            const auto plane = test::realVectorSpace(2);
            int count = 0;
            plane->setStateSamplerAllocator(corner(count));
            const auto inner = test::compoundSpace({test::so2Space(), plane}, {1.0, 1.0});
            const auto space = test::compoundSpace({inner, test::realVectorSpace(1)}, {1.0, 1.0});
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            const path::CostBounds bounds(si, std::make_shared<ob::PathLengthOptimizationObjective>(si));
            InformedSampler sampler(std::make_shared<const path::StateChart>(space), bounds, 3);
            ob::ScopedState<> state(space);
            for (int i = 0; i < 100; ++i)
            {
                sampler.sample(path::Waypoints(space), path::Waypoints(space), std::numeric_limits<double>::infinity(),
                               state.get());
            }
            EXPECT_EQ(count, 50);
        }

        TEST(InformedSampler, TheWholePlannerDrawsByTheUsersSampler)
        {
            const auto problem = test::wallProblem();
            int count = 0;
            problem->si->getStateSpace()->setStateSamplerAllocator(corner(count));
            const auto planner = problem->planner(test::PlannerVariant::Default);
            ASSERT_EQ(planner->solve(test::afterCalls(30000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(count, 100);
            EXPECT_TRUE(problem->path().check());
        }
    }  // namespace
}  // namespace ompl_mfa::engine::guides
