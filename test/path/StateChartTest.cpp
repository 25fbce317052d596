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

#include "path/StateChart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rapidcheck.h>

#include <boost/math/constants/constants.hpp>

#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/util/Exception.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        constexpr double PI = boost::math::constants::pi<double>();

        class StateChartOfEverySpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        protected:
            ob::StateSpacePtr space_ = GetParam().make();
            StateChart chart_{space_};
        };

        INSTANTIATE_TEST_SUITE_P(Path, StateChartOfEverySpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(StateChartOfEverySpace, HasTheDimensionOfTheSpace)
        {
            EXPECT_EQ(chart_.dimension(), static_cast<Eigen::Index>(space_->getDimension()));
            Eigen::Index next = 0;
            for (std::size_t i = 0; i < chart_.leaves(); ++i)
            {
                EXPECT_EQ(chart_.leafRange(i).first, next);
                next += chart_.leafRange(i).second;
            }
            EXPECT_EQ(next, chart_.dimension());
            EXPECT_EQ(chart_.rotationReach().size(), chart_.rotationDimension());
        }

        TEST_P(StateChartOfEverySpace, DisplacementUndoesDifference)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> base(space_);
            ob::ScopedState<> state(space_);
            ob::ScopedState<> back(space_);
            Eigen::VectorXd delta(chart_.dimension());
            for (int i = 0; i < 200; ++i)
            {
                sampler->sampleUniform(base.get());
                sampler->sampleUniform(state.get());
                chart_.difference(base.get(), state.get(), delta);
                chart_.displace(base.get(), delta, back.get());
                Eigen::VectorXd error(chart_.dimension());
                chart_.difference(state.get(), back.get(), error);
                EXPECT_LT(error.norm(), 1e-7);
                EXPECT_TRUE(space_->satisfiesBounds(back.get()));
            }
        }

        TEST_P(StateChartOfEverySpace, RotationsStayWithinTheirReach)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> base(space_);
            ob::ScopedState<> state(space_);
            Eigen::VectorXd delta(chart_.dimension());
            for (int i = 0; i < 200; ++i)
            {
                sampler->sampleUniform(base.get());
                sampler->sampleUniform(state.get());
                chart_.difference(base.get(), state.get(), delta);
                const Eigen::VectorXd rotations = delta.tail(chart_.rotationDimension()).cwiseAbs();
                EXPECT_TRUE((rotations.array() <= chart_.rotationReach().array() + 1e-9).all());
            }
        }

        TEST_P(StateChartOfEverySpace, AnyDisplacementEndsWithinTheBounds)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> base(space_);
            ob::ScopedState<> state(space_);
            for (const double size : {0.1, 1.0, 30.0, 1e6})
            {
                for (int i = 0; i < 100; ++i)
                {
                    sampler->sampleUniform(base.get());
                    chart_.displace(base.get(), size * Eigen::VectorXd::Random(chart_.dimension()), state.get());
                    ASSERT_TRUE(space_->satisfiesBounds(state.get()));
                    // in place
                    chart_.displace(base.get(), size * Eigen::VectorXd::Random(chart_.dimension()), base.get());
                    ASSERT_TRUE(space_->satisfiesBounds(base.get()));
                }
            }
        }

        TEST_P(StateChartOfEverySpace, SamplesAreWithinTheBounds)
        {
            ompl::RNG rng(5);
            ob::ScopedState<> state(space_);
            for (int i = 0; i < 100; ++i)
            {
                chart_.sampleUniform(rng, state.get());
                ASSERT_TRUE(space_->satisfiesBounds(state.get()));
                Eigen::VectorXd before(chart_.positionDimension());
                Eigen::VectorXd after(chart_.positionDimension());
                chart_.positions(state.get(), before);
                chart_.sampleRotations(rng, state.get());
                chart_.positions(state.get(), after);
                EXPECT_EQ(before, after);
                ASSERT_TRUE(space_->satisfiesBounds(state.get()));
            }
        }

        TEST_P(StateChartOfEverySpace, PositionsCanBeReadAndSet)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> from(space_);
            ob::ScopedState<> to(space_);
            Eigen::VectorXd values(chart_.positionDimension());
            Eigen::VectorXd delta(chart_.dimension());
            sampler->sampleUniform(from.get());
            sampler->sampleUniform(to.get());
            chart_.positions(from.get(), values);
            EXPECT_TRUE(chart_.setPositions(values, to.get()));
            chart_.difference(from.get(), to.get(), delta);
            EXPECT_LT(delta.head(chart_.positionDimension()).norm(), 1e-12);
            if (chart_.positionDimension() > 0)
            {
                EXPECT_FALSE(chart_.setPositions(Eigen::VectorXd::Constant(values.size(), 1e9), to.get()));
            }
        }

        /* The norm of coordinates against OMPL's own distance: equal for one leaf, and for a compound the sum over its
           leaves, as OMPL adds up weighted distances. */
        class StateChartDistance : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Path, StateChartDistance,
                                 ::testing::Values(test::NamedSpace{"R1", [] { return test::realVectorSpace(1); }},
                                                   test::NamedSpace{"R3", [] { return test::realVectorSpace(3); }},
                                                   test::NamedSpace{"SO2", test::so2Space},
                                                   test::NamedSpace{"SO3", test::so3Space},
                                                   test::NamedSpace{"SE2", [] { return test::se2Space(); }},
                                                   test::NamedSpace{"SE3", [] { return test::se3Space(); }},
                                                   test::NamedSpace{"TwoSE2", test::twoSe2Space},
                                                   test::NamedSpace{"Nested", test::nestedSpace}),
                                 test::SpaceName());

        TEST_P(StateChartDistance, IsThatOfTheSpace)
        {
            const auto space = GetParam().make();
            const StateChart chart(space);
            const auto sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> a(space);
            ob::ScopedState<> b(space);
            Eigen::VectorXd delta(chart.dimension());
            for (int i = 0; i < 200; ++i)
            {
                sampler->sampleUniform(a.get());
                sampler->sampleUniform(b.get());
                chart.difference(a.get(), b.get(), delta);
                double sum = 0.0;
                for (std::size_t leaf = 0; leaf < chart.leaves(); ++leaf)
                {
                    sum += delta.segment(chart.leafRange(leaf).first, chart.leafRange(leaf).second).norm();
                }
                EXPECT_NEAR(sum, space->distance(a.get(), b.get()), 1e-6);
            }
        }

        TEST_P(StateChartDistance, PartOfADifferenceIsTheSpacesInterpolation)
        {
            const auto space = GetParam().make();
            const StateChart chart(space);
            const auto sampler = space->allocDefaultStateSampler();
            ob::ScopedState<> a(space);
            ob::ScopedState<> b(space);
            ob::ScopedState<> ours(space);
            ob::ScopedState<> theirs(space);
            Eigen::VectorXd delta(chart.dimension());
            for (int i = 0; i < 100; ++i)
            {
                sampler->sampleUniform(a.get());
                sampler->sampleUniform(b.get());
                chart.difference(a.get(), b.get(), delta);
                const double t = 0.01 * i;
                chart.displace(a.get(), t * delta, ours.get());
                space->interpolate(a.get(), b.get(), t, theirs.get());
                space->enforceBounds(theirs.get());
                EXPECT_LT(space->distance(ours.get(), theirs.get()), 1e-6);
            }
        }

        TEST(StateChart, TakesTheShortWayAcrossPi)
        {
            const auto space = test::so2Space();
            const StateChart chart(space);
            ob::ScopedState<ob::SO2StateSpace> a(space);
            ob::ScopedState<ob::SO2StateSpace> b(space);
            a->value = 3.0;
            b->value = -3.0;
            Eigen::VectorXd delta(1);
            chart.difference(a.get(), b.get(), delta);
            EXPECT_NEAR(delta[0], 2.0 * PI - 6.0, 1e-12);
            chart.displace(a.get(), delta, a.get());
            EXPECT_NEAR(a->value, -3.0, 1e-12);
        }

        TEST(StateChart, PutsAllPositionsBeforeAllRotations)
        {
            const auto space = test::twoSe2Space();
            const StateChart chart(space);
            EXPECT_EQ(chart.positionDimension(), 4);
            EXPECT_EQ(chart.rotationDimension(), 2);
            ob::ScopedState<> a(space);
            ob::ScopedState<> b(space);
            for (unsigned int i = 0; i < 6; ++i)
            {
                a[i] = 0.0;
                b[i] = 0.1 * (i + 1);
            }
            Eigen::VectorXd delta(6);
            chart.difference(a.get(), b.get(), delta);
            // the values of a state come in the order x1 y1 angle1 x2 y2 angle2; an SE(2) weighs angles with 0.5
            const Eigen::Matrix<double, 6, 1> expected(0.1, 0.2, 0.4, 0.5, 0.5 * 0.3, 0.5 * 0.6);
            EXPECT_TRUE(delta.isApprox(expected, 1e-12)) << delta.transpose();
        }

        TEST(StateChart, ALeafOfWeightZeroIsMeasuredUnscaled)
        {
            const auto space = test::weightlessRotationSpace();
            const StateChart chart(space);
            ob::ScopedState<> a(space);
            ob::ScopedState<> b(space);
            a[0] = a[1] = a[2] = b[0] = b[1] = 0.0;
            b[2] = 1.25;
            Eigen::VectorXd delta(3);
            chart.difference(a.get(), b.get(), delta);
            EXPECT_NEAR(delta[2], 1.25, 1e-12);
        }

        TEST(StateChart, ShortensADisplacementThatLeavesTheBoundsAndKeepsItsDirection)
        {
            const auto space = test::realVectorSpace(2, 0.0, 10.0);
            const StateChart chart(space);
            ob::ScopedState<> base(space);
            base[0] = 4.0;
            base[1] = 5.0;
            // x can grow by 6 of the requested 12, so y moves only half of the requested 4
            const Eigen::Vector2d delta(12.0, -4.0);
            EXPECT_DOUBLE_EQ(chart.reach(base.get(), delta), 0.5);
            ob::ScopedState<> state(space);
            chart.displace(base.get(), delta, state.get());
            EXPECT_DOUBLE_EQ(state[0], 10.0);
            EXPECT_DOUBLE_EQ(state[1], 3.0);
        }

        TEST(StateChart, ReachIsInfiniteWithoutBoundsAndZeroOnTheBound)
        {
            auto space = std::make_shared<ob::RealVectorStateSpace>(2);
            ob::RealVectorBounds bounds(2);
            bounds.setLow(0, -1.0);
            bounds.setHigh(0, 1.0);
            bounds.setLow(1, -std::numeric_limits<double>::infinity());
            bounds.setHigh(1, std::numeric_limits<double>::infinity());
            space->setBounds(bounds);
            const StateChart chart(space);
            ob::ScopedState<> base(space);
            base[0] = 1.0;
            base[1] = 5.0;
            EXPECT_EQ(chart.reach(base.get(), Eigen::Vector2d(0.0, 1.0)), std::numeric_limits<double>::infinity());
            EXPECT_EQ(chart.reach(base.get(), Eigen::Vector2d(1.0, 0.0)), 0.0);
            EXPECT_DOUBLE_EQ(chart.reach(base.get(), Eigen::Vector2d(-1.0, 0.0)), 2.0);
        }

        std::string refusalOf(const ob::StateSpacePtr &space)
        {
            try
            {
                const StateChart chart(space);
            }
            catch (const ompl::Exception &error)
            {
                return error.what();
            }
            return "accepted";
        }

        void expectRefused(const ob::StateSpacePtr &space, const std::string &named)
        {
            const std::string message = refusalOf(space);
            EXPECT_NE(message.find("'" + named + "'"), std::string::npos) << message;
            for (const char *supported : {"R^n", "SO(2)", "SO(3)", "SE(2)", "SE(3)", "Dubins", "Reeds-Shepp"})
            {
                EXPECT_NE(message.find(supported), std::string::npos) << message;
            }
        }

        TEST(StateChart, RefusesSpacesWithoutCoordinatesAndNamesThem)
        {
            auto gears = std::make_shared<ob::DiscreteStateSpace>(1, 5);
            gears->setName("gears");
            expectRefused(gears, "gears");
            auto clock = std::make_shared<ob::TimeStateSpace>();
            clock->setName("clock");
            expectRefused(test::compoundSpace({test::se2Space(), test::compoundSpace({clock}, {1.0})}, {1.0, 1.0}),
                          "clock");
        }

        class UnitCircle : public ob::Constraint
        {
        public:
            UnitCircle()
              : ob::Constraint(2, 1)
            {
            }

            void function(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> out) const override
            {
                out[0] = x.norm() - 1.0;
            }
        };

        TEST(StateChart, RefusesConstrainedSpaces)
        {
            auto circle =
                std::make_shared<ob::ProjectedStateSpace>(test::realVectorSpace(2), std::make_shared<UnitCircle>());
            circle->setName("circle");
            expectRefused(circle, "circle");
        }

        TEST(StateChart, ReadsTheBoundsAsTheyAre)
        {
            const auto space = test::realVectorSpace(2, 0.0, 10.0);
            const StateChart chart(space);
            EXPECT_EQ(chart.bounds(), (std::vector<double>{0.0, 0.0, 10.0, 10.0}));
            ob::ScopedState<> base(space);
            ob::ScopedState<> state(space);
            base[0] = base[1] = 5.0;
            EXPECT_DOUBLE_EQ(chart.reach(base.get(), Eigen::Vector2d(1.0, 0.0)), 5.0);
            test::bounded(std::static_pointer_cast<ob::RealVectorStateSpace>(space), 2, 4.0, 25.0);
            EXPECT_EQ(chart.bounds(), (std::vector<double>{4.0, 4.0, 25.0, 25.0}));
            EXPECT_DOUBLE_EQ(chart.reach(base.get(), Eigen::Vector2d(1.0, 0.0)), 20.0);
            chart.displace(base.get(), Eigen::Vector2d(15.0, -3.0), state.get());
            EXPECT_DOUBLE_EQ(state[0], 10.0);
            EXPECT_DOUBLE_EQ(state[1], 4.0);
            EXPECT_TRUE(chart.setPositions(Eigen::Vector2d(20.0, 20.0), state.get()));
            EXPECT_FALSE(chart.setPositions(Eigen::Vector2d(3.0, 20.0), state.get()));
            ompl::RNG rng(3);
            bool beyond = false;
            for (int i = 0; i < 100; ++i)
            {
                chart.sampleUniform(rng, state.get());
                ASSERT_TRUE(space->satisfiesBounds(state.get()));
                beyond = beyond || state[0] > 10.0;
            }
            EXPECT_TRUE(beyond);
        }

        TEST(StateChart, TheBoundsOfAllLeavesAreListedInTheOrderOfTheCoordinates)
        {
            EXPECT_EQ(StateChart(test::nestedSpace()).bounds(),
                      (std::vector<double>{-10.0, -10.0, 10.0, 10.0, -2.0, 4.0}));
            EXPECT_TRUE(StateChart(test::so3Space()).bounds().empty());
        }

        /* A coordinate vector within the reach of the rotations; positions that may leave the bounds. */
        Eigen::VectorXd anyCoordinates(const StateChart &chart, double size)
        {
            Eigen::VectorXd delta(chart.dimension());
            for (Eigen::Index i = 0; i < delta.size(); ++i)
            {
                delta[i] = size * 1e-6 * *rc::gen::inRange(-1000000, 1000001);
            }
            for (std::size_t leaf = 0; leaf < chart.leaves(); ++leaf)
            {
                const auto [offset, dimension] = chart.leafRange(leaf);
                if (offset < chart.positionDimension())
                {
                    continue;
                }
                // the logarithm is unique within a ball
                const double reach = chart.rotationReach()[offset - chart.positionDimension()];
                const double norm = delta.segment(offset, dimension).norm();
                if (norm >= reach)
                {
                    delta.segment(offset, dimension) *= (1.0 - 1e-9) * reach / norm;
                }
            }
            return delta;
        }

        /* A state anywhere, on the bounds and at the ends of the angles too, a quaternion of either sign. */
        void setAnyState(const StateChart &chart, ob::State *state)
        {
            const auto &space = chart.space();
            ompl::RNG rng(static_cast<std::uint_fast32_t>(*rc::gen::inRange(1, 1 << 30)));
            chart.sampleUniform(rng, state);
            if (*rc::gen::inRange(0, 4) == 0)
            {
                // as far as the bounds go
                const Eigen::VectorXd direction = 1e6 * Eigen::VectorXd::Ones(chart.dimension());
                chart.displace(state, rng.uniform01() < 0.5 ? direction : Eigen::VectorXd(-direction), state);
            }
            for (const auto &[name, substate] : space->getSubstateLocationsByName())
            {
                ob::State *part = space->getSubstateAtLocation(state, substate);
                if (dynamic_cast<const ob::SO2StateSpace *>(substate.space) != nullptr && *rc::gen::inRange(0, 4) == 0)
                {
                    part->as<ob::SO2StateSpace::StateType>()->value = rng.uniform01() < 0.5 ? PI - 1e-12 : -PI;
                }
                if (dynamic_cast<const ob::SO3StateSpace *>(substate.space) != nullptr && *rc::gen::inRange(0, 2) == 0)
                {
                    auto *q = part->as<ob::SO3StateSpace::StateType>();
                    q->x = -q->x;
                    q->y = -q->y;
                    q->z = -q->z;
                    q->w = -q->w;
                }
            }
        }

        TEST_P(StateChartOfEverySpace, DifferenceAndDisplacementAreInverse)
        {
            EXPECT_TRUE(rc::check(
                [this]
                {
                    ob::ScopedState<> base(space_);
                    ob::ScopedState<> state(space_);
                    ob::ScopedState<> back(space_);
                    setAnyState(chart_, base.get());
                    setAnyState(chart_, state.get());
                    Eigen::VectorXd delta(chart_.dimension());
                    Eigen::VectorXd again(chart_.dimension());
                    // the state at the coordinates of a state is that state
                    chart_.difference(base.get(), state.get(), delta);
                    chart_.displace(base.get(), delta, back.get());
                    RC_ASSERT(space_->satisfiesBounds(back.get()));
                    chart_.difference(state.get(), back.get(), again);
                    RC_ASSERT(again.norm() < 1e-7);
                    // the coordinates of the state at coordinates are these, as far as the bounds let the positions go
                    delta = anyCoordinates(chart_, 3.0);
                    chart_.displace(base.get(), delta, state.get());
                    RC_ASSERT(space_->satisfiesBounds(state.get()));
                    chart_.difference(base.get(), state.get(), again);
                    Eigen::VectorXd expected = delta;
                    expected.head(chart_.positionDimension()) *= std::min(1.0, chart_.reach(base.get(), delta));
                    for (Eigen::Index i = 0; i < expected.size(); ++i)
                    {
                        // half a turn to the left is half a turn to the right
                        const bool rotation = i >= chart_.positionDimension();
                        RC_ASSERT(std::abs(again[i] - expected[i]) < 1e-6 ||
                                  (rotation && std::abs(again[i] + expected[i]) < 1e-6));
                    }
                }));
        }
    }  // namespace
}  // namespace ompl_mfa::path
