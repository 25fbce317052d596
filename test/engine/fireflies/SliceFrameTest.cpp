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

#include "engine/fireflies/SliceFrame.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        Eigen::VectorXd realValues(const ob::State *state, unsigned int n)
        {
            const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
            return Eigen::Map<const Eigen::VectorXd>(values, n);
        }

        /* Coordinates in [-1, 1], the same in every run of the tests. */
        Eigen::VectorXd randomUnit(ompl::RNG &rng, Eigen::Index n)
        {
            Eigen::VectorXd v(n);
            for (Eigen::Index i = 0; i < n; ++i)
            {
                v[i] = rng.uniformReal(-1.0, 1.0);
            }
            return v;
        }

        /* Random coordinates within the bounds of a frame, scaled by part. */
        Eigen::VectorXd randomCoordinates(const SliceFrame &frame, ompl::RNG &rng, double part)
        {
            Eigen::VectorXd x = randomUnit(rng, frame.dimension());
            for (Eigen::Index i = 0; i < x.size(); ++i)
            {
                x[i] *= part * (x[i] > 0.0 ? frame.upper()[i] : -frame.lower()[i]);
            }
            return x;
        }

        class SliceFrameInRn : public ::testing::TestWithParam<unsigned int>
        {
        protected:
            SliceFrameInRn()
            {
                // start and goal lie well inside, so that small offsets meet no bound
                const Eigen::VectorXd start = 3.0 * randomUnit(rng_, n_);
                const Eigen::VectorXd goal = 3.0 * randomUnit(rng_, n_);
                start_ = start;
                goal_ = goal;
                for (unsigned int i = 0; i < n_; ++i)
                {
                    startState_[i] = start[i];
                    goalState_[i] = goal[i];
                }
            }

            SliceFrame frame(unsigned int segments) const
            {
                return SliceFrame::straight(chart_, startState_.get(), goalState_.get(), segments);
            }

            const unsigned int n_ = GetParam();
            ob::StateSpacePtr space_ = test::realVectorSpace(n_);
            path::StateChartPtr chart_ = std::make_shared<const path::StateChart>(space_);
            ob::ScopedState<> startState_{space_};
            ob::ScopedState<> goalState_{space_};
            Eigen::VectorXd start_;
            Eigen::VectorXd goal_;
            Eigen::VectorXd scratch_;
            ompl::RNG rng_{17};
        };

        INSTANTIATE_TEST_SUITE_P(Path, SliceFrameInRn, ::testing::Range(1U, 17U));

        TEST_P(SliceFrameInRn, HasOneCoordinateLessThanTheSpaceOnEverySlice)
        {
            for (const unsigned int segments : {1U, 2U, 7U})
            {
                const SliceFrame f = frame(segments);
                EXPECT_EQ(f.slices(), segments - 1);
                EXPECT_EQ(f.dimension(), (segments - 1) * (n_ - 1));
                EXPECT_EQ(f.axis().size(), segments + 1);
                for (std::size_t k = 0; k < f.slices(); ++k)
                {
                    EXPECT_EQ(f.sliceRange(k).first, static_cast<Eigen::Index>(k * (n_ - 1)));
                    EXPECT_EQ(f.sliceRange(k).second, n_ - 1);
                }
            }
        }

        TEST_P(SliceFrameInRn, SlicesLieAtFixedAbscissaeAtRightAnglesToTheAxis)
        {
            const SliceFrame f = frame(6);
            const Eigen::VectorXd axis = goal_ - start_;
            ob::ScopedState<> state(space_);
            for (int repeat = 0; repeat < 20; ++repeat)
            {
                const Eigen::VectorXd x = randomUnit(rng_, f.dimension());
                for (std::size_t k = 0; k < f.slices(); ++k)
                {
                    f.toState(k, x, state.get(), scratch_);
                    const Eigen::VectorXd fromStart = realValues(state.get(), n_) - start_;
                    const double abscissa = fromStart.dot(axis) / axis.squaredNorm();
                    EXPECT_NEAR(abscissa, (k + 1) / 6.0, 1e-9);
                }
            }
        }

        TEST_P(SliceFrameInRn, TheLateralBasisIsOrthonormal)
        {
            const SliceFrame f = frame(3);
            ob::ScopedState<> state(space_);
            for (std::size_t k = 0; k < f.slices(); ++k)
            {
                const Eigen::VectorXd origin = realValues(f.axis()[k + 1], n_);
                Eigen::MatrixXd basis(n_, n_ - 1);
                for (Eigen::Index i = 0; i < basis.cols(); ++i)
                {
                    const auto x = Eigen::VectorXd::Unit(f.dimension(), f.sliceRange(k).first + i);
                    f.toState(k, x, state.get(), scratch_);
                    basis.col(i) = realValues(state.get(), n_) - origin;
                }
                const Eigen::MatrixXd gram = basis.transpose() * basis;
                EXPECT_LT((gram - Eigen::MatrixXd::Identity(n_ - 1, n_ - 1)).norm(), 1e-9);
            }
        }

        TEST_P(SliceFrameInRn, CoordinatesRoundTrip)
        {
            const SliceFrame f = frame(9);
            path::Waypoints path(space_);
            for (int repeat = 0; repeat < 20; ++repeat)
            {
                const Eigen::VectorXd x = randomUnit(rng_, f.dimension());
                f.toWaypoints(x, path, scratch_);
                ASSERT_EQ(path.size(), 10U);
                EXPECT_TRUE(space_->equalStates(path.front(), startState_.get()));
                EXPECT_TRUE(space_->equalStates(path.back(), goalState_.get()));
                Eigen::VectorXd back(f.dimension());
                f.toCoordinates(path, back);
                EXPECT_LT((back - x).norm(), 1e-9);
            }
        }

        TEST_P(SliceFrameInRn, EveryBoundIsWhereTheSpaceEnds)
        {
            const SliceFrame f = frame(4);
            ob::ScopedState<> state(space_);
            for (std::size_t k = 0; k < f.slices(); ++k)
            {
                for (Eigen::Index i = f.sliceRange(k).first; i < f.sliceRange(k).first + f.sliceRange(k).second; ++i)
                {
                    for (const double end : {f.lower()[i], f.upper()[i]})
                    {
                        Eigen::VectorXd x = Eigen::VectorXd::Zero(f.dimension());
                        x[i] = end;
                        f.toState(k, x, state.get(), scratch_);
                        EXPECT_NEAR(realValues(state.get(), n_).cwiseAbs().maxCoeff(), 10.0, 1e-9);
                    }
                    EXPECT_LT(f.lower()[i], 0.0);
                    EXPECT_GT(f.upper()[i], 0.0);
                }
            }
        }

        class SliceFrameOfEverySpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        protected:
            ob::StateSpacePtr space_ = GetParam().make();
            path::StateChartPtr chart_ = std::make_shared<const path::StateChart>(space_);
            Eigen::VectorXd scratch_;
            ompl::RNG rng_{23};
        };

        INSTANTIATE_TEST_SUITE_P(Path, SliceFrameOfEverySpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        TEST_P(SliceFrameOfEverySpace, EveryWaypointIsWithinTheBounds)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> start(space_);
            ob::ScopedState<> goal(space_);
            path::Waypoints path(space_);
            for (int repeat = 0; repeat < 40; ++repeat)
            {
                sampler->sampleUniform(start.get());
                sampler->sampleUniform(goal.get());
                const SliceFrame f = SliceFrame::straight(chart_, start.get(), goal.get(), 5);
                EXPECT_TRUE((f.lower().array() <= 0.0).all());
                EXPECT_TRUE((f.upper().array() >= 0.0).all());
                EXPECT_TRUE(f.lower().allFinite() && f.upper().allFinite());
                f.toWaypoints(randomCoordinates(f, rng_, 1.0), path, scratch_);
                for (const ob::State *state : path.pointers())
                {
                    EXPECT_TRUE(space_->satisfiesBounds(state));
                }
            }
        }

        TEST_P(SliceFrameOfEverySpace, CoordinatesRoundTripWhereNoBoundIsMet)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> center(space_);
            ob::ScopedState<> start(space_);
            ob::ScopedState<> goal(space_);
            path::Waypoints path(space_);
            Eigen::VectorXd zero = Eigen::VectorXd::Zero(chart_->positionDimension());
            for (int repeat = 0; repeat < 40; ++repeat)
            {
                sampler->sampleUniform(center.get());
                chart_->setPositions(zero, center.get());
                sampler->sampleUniformNear(start.get(), center.get(), 1.0);
                sampler->sampleUniformNear(goal.get(), center.get(), 1.0);
                const SliceFrame f = SliceFrame::straight(chart_, start.get(), goal.get(), 5);
                const Eigen::VectorXd x = 0.2 * randomUnit(rng_, f.dimension());
                f.toWaypoints(x, path, scratch_);
                Eigen::VectorXd back(f.dimension());
                f.toCoordinates(path, back);
                EXPECT_LT((back - x).norm(), 1e-6);
            }
        }

        TEST_P(SliceFrameOfEverySpace, OriginsDivideTheMotionEvenly)
        {
            const auto sampler = space_->allocDefaultStateSampler();
            ob::ScopedState<> start(space_);
            ob::ScopedState<> goal(space_);
            for (int repeat = 0; repeat < 40; ++repeat)
            {
                sampler->sampleUniform(start.get());
                sampler->sampleUniform(goal.get());
                const SliceFrame f = SliceFrame::straight(chart_, start.get(), goal.get(), 4);
                Eigen::VectorXd whole(chart_->dimension());
                Eigen::VectorXd part(chart_->dimension());
                chart_->difference(start.get(), goal.get(), whole);
                for (int k = 1; k < 4; ++k)
                {
                    chart_->difference(start.get(), f.axis()[k], part);
                    EXPECT_LT((part - 0.25 * k * whole).norm(), 1e-6);
                }
            }
        }

        TEST_P(SliceFrameOfEverySpace, SurvivesStartEqualToGoal)
        {
            ob::ScopedState<> state(space_);
            const auto sampler = space_->allocDefaultStateSampler();
            path::Waypoints path(space_);
            for (int repeat = 0; repeat < 20; ++repeat)
            {
                sampler->sampleUniform(state.get());
                const SliceFrame f = SliceFrame::straight(chart_, state.get(), state.get(), 3);
                EXPECT_EQ(f.dimension(), 2 * chart_->dimension());
                f.toWaypoints(randomCoordinates(f, rng_, 1.0), path, scratch_);
                for (const ob::State *waypoint : path.pointers())
                {
                    EXPECT_TRUE(space_->satisfiesBounds(waypoint));
                }
            }
        }

        SliceFrame straightFrame(const ob::StateSpacePtr &space, const std::vector<double> &start,
                                 const std::vector<double> &goal, unsigned int segments)
        {
            ob::ScopedState<> from(space);
            ob::ScopedState<> to(space);
            from = start;
            to = goal;
            return SliceFrame::straight(std::make_shared<const path::StateChart>(space), from.get(), to.get(),
                                        segments);
        }

        TEST(SliceFrame, APureRotationLeavesAllPositionsFree)
        {
            Eigen::VectorXd scratch;
            const auto space = test::se2Space();
            const SliceFrame f = straightFrame(space, {1.0, 2.0, -1.0}, {1.0, 2.0, 1.5}, 2);
            EXPECT_EQ(f.dimension(), 3);
            ob::ScopedState<ob::SE2StateSpace> state(space);
            // offsets along both positions, and an angle of weight 0.5
            f.toState(0, Eigen::Vector3d(0.5, -0.25, 0.2), state.get(), scratch);
            EXPECT_NEAR(state->getX(), 1.5, 1e-12);
            EXPECT_NEAR(state->getY(), 1.75, 1e-12);
            EXPECT_NEAR(state->getYaw(), 0.25 + 0.4, 1e-12);
        }

        TEST(SliceFrame, InThePlaneOffsetsAreAcrossTheAxisAndAnglesFollowTheInterpolatedRotation)
        {
            Eigen::VectorXd scratch;
            const auto space = test::se2Space();
            const SliceFrame f = straightFrame(space, {-4.0, 0.0, 0.0}, {4.0, 0.0, 1.0}, 4);
            EXPECT_EQ(f.dimension(), 6);
            ob::ScopedState<ob::SE2StateSpace> state(space);
            Eigen::VectorXd x = Eigen::VectorXd::Zero(6);
            x[4] = 3.0;
            x[5] = 0.25;
            f.toState(2, x, state.get(), scratch);
            EXPECT_NEAR(state->getX(), 2.0, 1e-12);
            EXPECT_NEAR(std::abs(state->getY()), 3.0, 1e-12);
            EXPECT_NEAR(state->getYaw(), 0.75 + 0.5, 1e-12);
        }

        TEST(SliceFrame, RotationsInSpaceMoveInTheTangentSpaceOfTheInterpolatedRotation)
        {
            Eigen::VectorXd scratch;
            const auto space = test::se3Space();
            const auto chart = std::make_shared<const path::StateChart>(space);
            ob::ScopedState<ob::SE3StateSpace> start(space);
            ob::ScopedState<ob::SE3StateSpace> goal(space);
            start->setXYZ(-1.0, 0.0, 0.0);
            start->rotation().setIdentity();
            goal->setXYZ(1.0, 1.0, 2.0);
            goal->rotation().setAxisAngle(0.0, 0.0, 1.0, 2.0);
            const SliceFrame f = SliceFrame::straight(chart, start.get(), goal.get(), 2);
            EXPECT_EQ(f.dimension(), 5);
            Eigen::VectorXd x = Eigen::VectorXd::Zero(5);
            ob::ScopedState<ob::SE3StateSpace> state(space);
            ob::ScopedState<ob::SE3StateSpace> middle(space);
            space->interpolate(start.get(), goal.get(), 0.5, middle.get());
            f.toState(0, x, state.get(), scratch);
            EXPECT_LT(space->distance(state.get(), middle.get()), 1e-9);
            // OMPL's distance of two rotations is half the angle between them, and so is the coordinate
            x.tail(3) << 0.3, 0.0, 0.4;
            f.toState(0, x, state.get(), scratch);
            EXPECT_NEAR(space->distance(state.get(), middle.get()), 0.5, 1e-9);
        }

        TEST(SliceFrame, TwoRobotsShareOneAxis)
        {
            Eigen::VectorXd scratch;
            const auto space = test::twoSe2Space();
            const SliceFrame f =
                straightFrame(space, {-3.0, 0.0, 0.0, 3.0, 1.0, 0.0}, {3.0, 0.0, 0.0, -3.0, 1.0, 1.0}, 3);
            EXPECT_EQ(f.dimension(), 2 * (3 + 2));
            ompl::RNG rng(3);
            ob::ScopedState<> state(space);
            for (int repeat = 0; repeat < 50; ++repeat)
            {
                f.toState(0, randomUnit(rng, f.dimension()), state.get(), scratch);
                // slices are orthogonal to the direction (1, 0, -1, 0): both robots have the same offset along x
                EXPECT_NEAR(state[0] - (-1.0), state[3] - 1.0, 1e-9);
            }
        }

        TEST(SliceFrame, AnAxisMayBend)
        {
            Eigen::VectorXd scratch;
            const auto space = test::realVectorSpace(2);
            path::Waypoints axis(space);
            ob::ScopedState<> state(space);
            for (const auto &[px, py] : std::vector<std::pair<double, double>>{{0, 0}, {4, 0}, {4, 4}})
            {
                state[0] = px;
                state[1] = py;
                axis.append(state.get());
            }
            const SliceFrame f(std::make_shared<const path::StateChart>(space), axis);
            ASSERT_EQ(f.dimension(), 1);
            f.toState(0, Eigen::VectorXd::Constant(1, std::sqrt(2.0)), state.get(), scratch);
            // at the corner the slice halves the angle: it runs along (1, -1)
            EXPECT_NEAR(std::abs(state[0] - 4.0), 1.0, 1e-12);
            EXPECT_NEAR((state[0] - 4.0) + state[1], 0.0, 1e-12);
        }

        TEST(SliceFrame, RefusesAnAxisOfOneState)
        {
            const auto space = test::realVectorSpace(2);
            path::Waypoints axis(space);
            axis.resize(1);
            EXPECT_THROW(SliceFrame(std::make_shared<const path::StateChart>(space), axis), std::invalid_argument);
        }

        TEST(SliceFrame, LaysAPathAcrossItsSlices)
        {
            const auto space = test::realVectorSpace(2);
            const SliceFrame f = straightFrame(space, {0.0, 0.0}, {8.0, 0.0}, 4);
            path::Waypoints zigzag(space);
            ob::ScopedState<> state(space);
            for (const auto &[px, py] : std::vector<std::pair<double, double>>{{0, 0}, {3, 3}, {5, -1}, {8, 0}})
            {
                state[0] = px;
                state[1] = py;
                zigzag.append(state.get());
            }
            path::Waypoints onSlices(space);
            ASSERT_TRUE(f.crossings(zigzag, onSlices));
            ASSERT_EQ(onSlices.size(), 5U);
            // where the polyline passes x = 2, 4, 6
            const double expected[] = {2.0, 1.0, -1.0 + 1.0 / 3.0};
            for (int k = 0; k < 3; ++k)
            {
                EXPECT_NEAR(realValues(onSlices[k + 1], 2)[0], 2.0 * (k + 1), 1e-9);
                EXPECT_NEAR(realValues(onSlices[k + 1], 2)[1], expected[k], 1e-9);
            }
            zigzag.erase(2, 4);
            EXPECT_FALSE(f.crossings(zigzag, onSlices));
        }

        TEST(SliceFrame, HasNoCrossingsWhereTheAxisStandsStill)
        {
            const auto space = test::se2Space();
            const SliceFrame f = straightFrame(space, {1.0, 2.0, -1.0}, {1.0, 2.0, 1.5}, 3);
            path::Waypoints onSlices(space);
            EXPECT_FALSE(f.crossings(f.axis(), onSlices));
        }
    }  // namespace
}  // namespace ompl_mfa::engine::fireflies
