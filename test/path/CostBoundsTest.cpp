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

#include "path/CostBounds.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        constexpr double NONE = std::numeric_limits<double>::infinity();

        /* Inherits motionCost() as its heuristic. */
        class Derived : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;
        };

        /* Has OMPL's default heuristic, identityCost. */
        class Own : public ob::OptimizationObjective
        {
        public:
            using OptimizationObjective::OptimizationObjective;

            ob::Cost stateCost(const ob::State *) const override
            {
                return identityCost();
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(si_->distance(from, to));
            }
        };

        ob::SpaceInformationPtr information(const ob::StateSpacePtr &space)
        {
            return std::make_shared<ob::SpaceInformation>(space);
        }

        bool certainOfLength(const ob::StateSpacePtr &space)
        {
            const auto si = information(space);
            return CostBounds(si, std::make_shared<ob::PathLengthOptimizationObjective>(si)).certain();
        }

        class CostBoundsTest : public ::testing::Test
        {
        protected:
            CostBoundsTest()
            {
                // start, a state between, and goal on a line
                for (unsigned int i = 0; i < 3; ++i)
                {
                    (*states_[i])[0] = (*states_[i])[1] = static_cast<double>(i);
                }
            }

            const ob::State *state(unsigned int i) const
            {
                return states_[i]->get();
            }

            bool beatable(const CostBounds &bounds, double bound) const
            {
                return bounds.canBeat(state(0), state(1), state(2), bound);
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            ob::SpaceInformationPtr si_ = information(space_);
            std::vector<std::shared_ptr<ob::ScopedState<>>> states_{std::make_shared<ob::ScopedState<>>(space_),
                                                                    std::make_shared<ob::ScopedState<>>(space_),
                                                                    std::make_shared<ob::ScopedState<>>(space_)};
        };

        TEST_F(CostBoundsTest, OfPathLengthAreCertainWhereTheDistanceObeysTheTriangleInequality)
        {
            for (const auto &named : test::supportedSpaces())
            {
                EXPECT_EQ(certainOfLength(named.make()), named.name != "DubinsSymmetric") << named.name;
            }
        }

        /* Why the last test leaves them out: for a Dubins car that may reverse a path with a cusp is shorter. */
        TEST_F(CostBoundsTest, SymmetricDubinsCurvesAreLongerThanSomeDetour)
        {
            const auto space = test::dubinsSpace(true);
            const auto sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> from(space);
            ob::ScopedState<> via(space);
            ob::ScopedState<> to(space);
            bool shorter = false;
            for (int i = 0; i < 10000 && !shorter; ++i)
            {
                for (auto *state : {&from, &via, &to})
                {
                    sampler->sampleUniform(state->get());
                }
                shorter = space->distance(from.get(), via.get()) + space->distance(via.get(), to.get()) <
                          space->distance(from.get(), to.get()) - 1e-6;
            }
            EXPECT_TRUE(shorter);
        }

        TEST_F(CostBoundsTest, OfAUsersOwnObjectiveAreNotCertain)
        {
            EXPECT_FALSE(CostBounds(si_, std::make_shared<Derived>(si_)).certain());
            EXPECT_FALSE(CostBounds(si_, std::make_shared<Own>(si_)).certain());
        }

        TEST_F(CostBoundsTest, AreThoseOfTheHeuristicWhileNothingContradicts)
        {
            CostBounds bounds(si_, std::make_shared<Derived>(si_));
            bounds.observeMotion(state(0), state(1), ob::Cost(std::sqrt(2.0)));
            EXPECT_TRUE(bounds.admissible());
            EXPECT_TRUE(bounds.monotone());
            EXPECT_FALSE(beatable(bounds, 2.8));
            EXPECT_TRUE(beatable(bounds, 2.9));
            EXPECT_TRUE(beatable(bounds, NONE));
        }

        TEST_F(CostBoundsTest, ADetourThatIsBetterThanTheHeuristicContradicts)
        {
            CostBounds bounds(si_, std::make_shared<Derived>(si_));
            bounds.observePath(state(0), state(2), ob::Cost(2.0));
            EXPECT_FALSE(bounds.admissible());
            EXPECT_TRUE(bounds.monotone());
            EXPECT_TRUE(beatable(bounds, 0.1));
        }

        /* Path length with costs of the first and the last state. */
        class PricedEnds : public Derived
        {
        public:
            PricedEnds(const ob::SpaceInformationPtr &si, double initial, double terminal)
              : Derived(si)
              , initial_(initial)
              , terminal_(terminal)
            {
            }

            ob::Cost initialCost(const ob::State *) const override
            {
                return ob::Cost(initial_);
            }

            ob::Cost terminalCost(const ob::State *) const override
            {
                return ob::Cost(terminal_);
            }

        private:
            double initial_;
            double terminal_;
        };

        TEST_F(CostBoundsTest, HoldInitialAndTerminalCostsAsPathsDo)
        {
            const CostBounds bounds(si_, std::make_shared<PricedEnds>(si_, 20.0, -100.0));
            EXPECT_TRUE(beatable(bounds, 0.0));
            EXPECT_TRUE(beatable(bounds, -77.1));
            EXPECT_FALSE(beatable(bounds, -77.2));
            EXPECT_DOUBLE_EQ(bounds.lowerBound(state(0), state(2)), 20.0 + std::sqrt(8.0) - 100.0);
            EXPECT_FALSE(beatable(CostBounds(si_, std::make_shared<PricedEnds>(si_, 0.0, 100.0)), 50.0));
        }

        TEST_F(CostBoundsTest, OfPathsThatCannotHaveAFiniteCostBeatNoFiniteOne)
        {
            const CostBounds bounds(si_, std::make_shared<PricedEnds>(si_, NONE, 0.0));
            EXPECT_FALSE(beatable(bounds, std::numeric_limits<double>::max()));
            EXPECT_TRUE(beatable(bounds, NONE));
            EXPECT_TRUE(beatable(CostBounds(si_, std::make_shared<PricedEnds>(si_, 1.0, 0.0)),
                                 std::numeric_limits<double>::max()));
        }

        TEST_F(CostBoundsTest, ThatAreNoNumbersPruneNothing)
        {
            EXPECT_TRUE(beatable(CostBounds(si_, std::make_shared<PricedEnds>(si_, NONE, -NONE)), 1.0));
        }

        TEST_F(CostBoundsTest, AMotionThatEarnsSomethingContradicts)
        {
            CostBounds bounds(si_, std::make_shared<Own>(si_));
            EXPECT_FALSE(beatable(bounds, -1.0));
            bounds.observeMotion(state(0), state(1), ob::Cost(-0.5));
            EXPECT_FALSE(bounds.admissible());
            EXPECT_FALSE(bounds.monotone());
            EXPECT_TRUE(beatable(bounds, -1.0));
        }

        TEST_F(CostBoundsTest, RoundingDoesNotContradict)
        {
            CostBounds bounds(si_, std::make_shared<Derived>(si_));
            bounds.observePath(state(0), state(2), ob::Cost(std::sqrt(8.0) * (1.0 - 1e-14)));
            EXPECT_TRUE(bounds.admissible());
        }

        TEST_F(CostBoundsTest, AreTheObjectivesOwnWhereMoreIsBetter)
        {
            si_->setStateValidityChecker([](const ob::State *) { return true; });
            CostBounds bounds(si_, std::make_shared<ob::MaximizeMinClearanceObjective>(si_));
            bounds.observeMotion(state(0), state(1), ob::Cost(3.0));
            EXPECT_TRUE(bounds.admissible());
            EXPECT_TRUE(bounds.monotone());
            EXPECT_TRUE(beatable(bounds, 1e6));
        }
    }  // namespace
}  // namespace ompl_mfa::path
