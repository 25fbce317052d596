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

#include "engine/refinement/PathTightening.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <rapidcheck.h>

#include <boost/math/constants/constants.hpp>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "engine/refinement/RoomProblem.h"
#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* An integral that also depends on the direction, and counts its calls. */
        class Counted : public ob::StateCostIntegralObjective
        {
        public:
            using StateCostIntegralObjective::StateCostIntegralObjective;

            ob::Cost stateCost(const ob::State *state) const override
            {
                const auto *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return ob::Cost(1.0 + std::abs(values[1]));
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                ++asked;
                const double rise = to->as<ob::RealVectorStateSpace::StateType>()->values[1] -
                                    from->as<ob::RealVectorStateSpace::StateType>()->values[1];
                return ob::Cost(StateCostIntegralObjective::motionCost(from, to).value() + std::max(0.0, rise));
            }

            mutable std::uint64_t asked{0};
        };

        class PathTighteningTest : public ::testing::Test
        {
        protected:
            PathTighteningTest()
            {
                ob::ScopedState<> state(space_);
                ompl::RNG rng(3);
                for (int i = 0; i <= 20; ++i)
                {
                    state[0] = i - 10.0;
                    state[1] = 5.0 + rng.uniformReal(-3.0, 3.0);
                    path_.append(state.get());
                }
            }

            /* The plane without a disc below the path. */
            static bool outsideDisc(const ob::State *state)
            {
                const auto *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                return std::hypot(values[0], values[1]) > 1.9;
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, outsideDisc};
            std::shared_ptr<Counted> objective_ = std::make_shared<Counted>(problem_.si);
            path::PathEvaluator evaluator_{problem_.si, objective_};
            PathTightening tightening_{std::make_shared<const path::StateChart>(space_), evaluator_, 5};
            path::Waypoints path_{space_};
        };

        TEST_F(PathTighteningTest, KnowsTheCostOfItsPathAtAllTimes)
        {
            const double before = evaluator_.cost(path_).value();
            tightening_.begin(path_);
            EXPECT_EQ(tightening_.cost().value(), objective_->infiniteCost().value()) << "not computed yet";
            for (int i = 0; i < 60; ++i)
            {
                tightening_.advance(300);
                const double cost = evaluator_.cost(tightening_.path()).value();
                ASSERT_NEAR(tightening_.cost().value(), cost, 1e-9 * cost) << "turn " << i;
            }
            EXPECT_TRUE(evaluator_.checkPath(tightening_.path()));
            EXPECT_LT(tightening_.cost().value(), 0.6 * before);
        }

        TEST_F(PathTighteningTest, IsInterruptedBetweenAnyTwoCostsAndGoesOnFromThere)
        {
            tightening_.begin(path_);
            std::uint64_t limit = 0;
            evaluator_.setStopCondition([&] { return objective_->asked >= limit; });
            double cost = objective_->infiniteCost().value();
            for (int i = 0; i < 400; ++i)
            {
                limit = objective_->asked + 7;
                evaluator_.setStopCondition([&] { return objective_->asked >= limit; });
                tightening_.advance(100000);
                EXPECT_LE(objective_->asked, limit);
                EXPECT_LE(tightening_.cost().value(), cost);
                cost = tightening_.cost().value();
            }
            evaluator_.setStopCondition({});
            EXPECT_NEAR(cost, evaluator_.cost(tightening_.path()).value(), 1e-9 * cost);
        }

        class TighteningOfEverySpace : public ::testing::TestWithParam<test::NamedSpace>
        {
        protected:
            TighteningOfEverySpace()
              : space_(GetParam().make())
              , chart_(std::make_shared<const path::StateChart>(space_))
              , si_(std::make_shared<ob::SpaceInformation>(space_))
            {
                si_->setStateValidityChecker(std::make_shared<Room>(si_));
                si_->setup();
            }

            ob::StateSpacePtr space_;
            path::StateChartPtr chart_;
            ob::SpaceInformationPtr si_;
        };

        INSTANTIATE_TEST_SUITE_P(Path, TighteningOfEverySpace, ::testing::ValuesIn(test::supportedSpaces()),
                                 test::SpaceName());

        /* For every objective, and wherever interrupted: the ends stay, the path stays valid and does not get worse,
           and its cost is known. */
        TEST_P(TighteningOfEverySpace, EveryStepKeepsThePathValidAndNoneMakesItWorse)
        {
            unsigned int improved = 0;
            EXPECT_TRUE(rc::check(
                [&]
                {
                    const auto objective = OBJECTIVES[*rc::gen::inRange<std::size_t>(0, OBJECTIVES.size())](si_);
                    const auto seed = static_cast<std::uint_fast32_t>(*rc::gen::inRange(1, 1 << 30));
                    const auto states = *rc::gen::inRange<std::size_t>(2, 9);
                    const auto patience = *rc::gen::inRange(1, 400);
                    ompl::RNG rng(seed);
                    path::PathEvaluator evaluator(si_, objective);
                    path::PathEvaluator judge(si_, objective);
                    const path::Waypoints path = anyStrictPath(judge, *chart_, rng, states);
                    RC_PRE(path.size() >= 2);
                    PathTightening tightening(chart_, evaluator, seed);
                    tightening.begin(path);
                    ob::Cost cost = judge.cost(path);
                    const ob::Cost first = cost;
                    for (int turn = 0; turn < 6; ++turn)
                    {
                        int asked = 0;
                        evaluator.setStopCondition([&] { return turn % 2 == 0 && ++asked > patience; });
                        const bool better = tightening.advance(1200);
                        const path::Waypoints &now = tightening.path();
                        RC_ASSERT(now.size() >= 2);
                        RC_ASSERT(space_->equalStates(now.front(), path.front()));
                        RC_ASSERT(space_->equalStates(now.back(), path.back()));
                        for (std::size_t i = 0; i < now.size(); ++i)
                            RC_ASSERT(space_->satisfiesBounds(now[i]));
                        for (std::size_t i = 1; i < now.size(); ++i)
                            RC_ASSERT(judge.checkStrictly({{now[i - 1], now[i]}}));
                        const ob::Cost after = judge.cost(now);
                        const double rounding =
                            std::isfinite(after.value()) ? 1e-9 * (1.0 + std::abs(after.value())) : 0.0;
                        RC_ASSERT(!objective->isCostBetterThan(cost, ob::Cost(after.value() - rounding)) ||
                                  !objective->isCostBetterThan(cost, ob::Cost(after.value() + rounding)));
                        RC_ASSERT(!better || objective->isCostBetterThan(after, cost));
                        // not known before the cost of every motion was computed
                        const double known = tightening.cost().value();
                        RC_ASSERT(known == after.value() || std::abs(known - after.value()) <= rounding ||
                                  (turn == 0 && !objective->isFinite(tightening.cost())));
                        cost = after;
                    }
                    improved += objective->isCostBetterThan(cost, first) ? 1 : 0;
                }));
            EXPECT_GT(improved, 25U) << "of 100 paths";
        }

        /* With motions of infinite cost, differences of costs say nothing. */
        TEST_F(PathTighteningTest, APathOfInfiniteCostBecomesOneOfFiniteCost)
        {
            for (const bool single : {true, false})
            {
                for (std::uint_fast32_t seed = 1; seed <= 10; ++seed)
                {
                    const auto si = std::make_shared<ob::SpaceInformation>(space_);
                    si->setStateValidityChecker(std::make_shared<Room>(si));
                    si->setup();
                    path::PathEvaluator evaluator(si, std::make_shared<LethalBand>(si));
                    PathTightening tightening(std::make_shared<const path::StateChart>(space_), evaluator, seed);
                    // above the ball, through the band
                    const path::Waypoints path =
                        single
                            ? test::planarPath(space_, {{-6.0, 2.8}, {6.0, 2.8}})
                            : test::planarPath(space_, {{-6.0, 0.0}, {-5.0, 2.8}, {1.0, 2.8}, {5.0, 2.8}, {6.0, 0.0}});
                    ASSERT_TRUE(evaluator.checkPath(path));
                    ASSERT_TRUE(std::isinf(evaluator.cost(path).value()));
                    tightening.begin(path);
                    EXPECT_TRUE(tightening.advance(40000));
                    const double cost = tightening.cost().value();
                    ASSERT_TRUE(std::isfinite(cost)) << seed;
                    EXPECT_NEAR(cost, evaluator.cost(tightening.path()).value(), 1e-9 * cost);
                    EXPECT_TRUE(evaluator.checkPath(tightening.path()));
                    // and is refined like any other
                    tightening.advance(40000);
                    EXPECT_LT(tightening.cost().value(), cost);
                    EXPECT_LT(tightening.cost().value(), 20.0);
                }
            }
        }

        /* Few single vertices lead around it within the bounds: a motion that still crosses it in part is an
           intermediate step. */
        TEST(PathTightening, LeadsAMotionAroundALargeRegionOfInfiniteCost)
        {
            class LethalBall : public ob::StateCostIntegralObjective
            {
            public:
                explicit LethalBall(const ob::SpaceInformationPtr &si)
                  : StateCostIntegralObjective(si, true)
                {
                }

                ob::Cost stateCost(const ob::State *state) const override
                {
                    const auto *x = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    return std::hypot(x[0], x[1], x[2]) < 5.0 ? infiniteCost() : ob::Cost(1.0);
                }
            };
            const auto space = test::realVectorSpace(3);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            path::Waypoints path(space);
            ob::ScopedState<> state(space);
            state[1] = state[2] = 0.0;
            for (const double x : {-5.5, 5.5})
            {
                state[0] = x;
                path.append(state.get());
            }
            for (std::uint_fast32_t seed = 1; seed <= 20; ++seed)
            {
                path::PathEvaluator evaluator(si, std::make_shared<LethalBall>(si));
                PathTightening tightening(std::make_shared<const path::StateChart>(space), evaluator, seed);
                tightening.begin(path);
                EXPECT_TRUE(tightening.advance(20000));
                EXPECT_TRUE(std::isfinite(tightening.cost().value())) << seed;
            }
        }

        /* When maximising, infinity is the best cost and its negative the worst. */
        TEST_F(PathTighteningTest, APathWithoutClearanceIsLedAwayFromTheObstacle)
        {
            class NoClearanceNearby : public ob::MaximizeMinClearanceObjective
            {
            public:
                using MaximizeMinClearanceObjective::MaximizeMinClearanceObjective;

                ob::Cost stateCost(const ob::State *state) const override
                {
                    const double clearance = roomOf(si_).clearance(state);
                    return clearance < 1.0 ? infiniteCost() : ob::Cost(clearance);
                }
            };
            const auto si = std::make_shared<ob::SpaceInformation>(space_);
            si->setStateValidityChecker(std::make_shared<Room>(si));
            si->setup();
            const auto objective = std::make_shared<NoClearanceNearby>(si);
            path::PathEvaluator evaluator(si, objective);
            PathTightening tightening(std::make_shared<const path::StateChart>(space_), evaluator, 3);
            const path::Waypoints path = test::planarPath(space_, {{-8.0, 8.0}, {-2.0, 2.0}, {2.0, 2.0}, {8.0, 8.0}});
            ASSERT_FALSE(objective->isFinite(evaluator.cost(path)));
            tightening.begin(path);
            EXPECT_TRUE(tightening.advance(40000));
            EXPECT_TRUE(objective->isFinite(tightening.cost()));
            EXPECT_GE(tightening.cost().value(), 1.0);
            EXPECT_TRUE(evaluator.checkPath(tightening.path()));
        }

        /* Obstacles that OMPL's own checks at the resolution miss: walls thinner than a step, with gaps. */
        TEST_F(PathTighteningTest, EveryMotionStaysValidAtTwiceTheResolution)
        {
            const auto si = std::make_shared<ob::SpaceInformation>(space_);
            si->setStateValidityChecker(
                [](const ob::State *state)
                {
                    const double *x = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    const double wall = 1.5 * std::round(x[0] / 1.5);
                    return std::abs(x[0] - wall) > 0.06 || std::abs(x[1] - 3.0 * std::sin(2.0 * wall)) < 1.2;
                });
            si->setup();
            const auto chart = std::make_shared<const path::StateChart>(space_);
            unsigned int motions = 0;
            for (std::uint_fast32_t seed = 1; seed <= 60; ++seed)
            {
                path::PathEvaluator evaluator(si, std::make_shared<ob::PathLengthOptimizationObjective>(si));
                ompl::RNG rng(seed);
                const path::Waypoints path = anyStrictPath(evaluator, *chart, rng, 12);
                PathTightening tightening(chart, evaluator, seed);
                tightening.begin(path);
                ASSERT_TRUE(tightening.advance(6000));
                const path::Waypoints &now = tightening.path();
                for (std::size_t i = 1; i < now.size(); ++i)
                {
                    ++motions;
                    EXPECT_TRUE(evaluator.checkStrictly({{now[i - 1], now[i]}})) << "seed " << seed;
                }
            }
            EXPECT_GT(motions, 100U);
        }

        /* From one side of a ball of radius 3 to the other, starting with a long detour. */
        struct WayAroundABall
        {
            explicit WayAroundABall(unsigned int dimension)
              : space(test::realVectorSpace(dimension))
              , si(std::make_shared<ob::SpaceInformation>(space))
              , chart(std::make_shared<const path::StateChart>(space))
              , path(space)
            {
                si->setStateValidityChecker([dimension](const ob::State *state)
                                            { return distance(state, dimension) > RADIUS; });
                si->setup();
                ob::ScopedState<> state(space);
                for (const double x : {-8.0, -8.0, 8.0, 8.0})
                {
                    for (unsigned int i = 1; i < dimension; ++i)
                    {
                        state[i] = path.empty() || path.size() == 3 ? 0.0 : 7.0 - 0.5 * i;
                    }
                    state[0] = x;
                    path.append(state.get());
                }
            }

            static double distance(const ob::State *state, unsigned int dimension)
            {
                return Eigen::Map<const Eigen::VectorXd>(state->as<ob::RealVectorStateSpace::StateType>()->values,
                                                         dimension)
                    .norm();
            }

            static constexpr double RADIUS = 3.0;
            ob::StateSpacePtr space;
            ob::SpaceInformationPtr si;
            path::StateChartPtr chart;
            path::Waypoints path;
            /* Two tangents and the arc between them. */
            double optimum{2.0 * std::sqrt(64.0 - RADIUS * RADIUS) +
                           RADIUS * (boost::math::constants::pi<double>() - 2.0 * std::acos(RADIUS / 8.0))};
        };

        /* The mean cost of paths tightened with different seeds and so much work. */
        double meanCost(const WayAroundABall &problem, std::uint64_t work, unsigned int seeds)
        {
            double sum = 0.0;
            for (std::uint_fast32_t seed = 1; seed <= seeds; ++seed)
            {
                path::PathEvaluator evaluator(problem.si,
                                              std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
                PathTightening tightening(problem.chart, evaluator, seed);
                tightening.begin(problem.path);
                tightening.advance(work);
                sum += tightening.cost().value();
            }
            return sum / seeds;
        }

        /* Each kind of step is tried as often as it pays, and is never given up: with the shares fixed by the last
           step, or without a floor, the excess is at least twice as large, 0.1. */
        TEST(PathTightening, SharesItsWorkByWhatPays)
        {
            const WayAroundABall plane(2);
            EXPECT_LT(meanCost(plane, 6000, 100) - plane.optimum, 0.07);
        }

        TEST(PathTightening, IsConvergedCloseToTheOptimumAndComesToThat)
        {
            for (const unsigned int dimension : {2U, 6U})
            {
                const WayAroundABall problem(dimension);
                unsigned int converged = 0;
                double excess = 0.0;
                for (std::uint_fast32_t seed = 1; seed <= 30; ++seed)
                {
                    path::PathEvaluator evaluator(problem.si,
                                                  std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
                    PathTightening tightening(problem.chart, evaluator, seed);
                    tightening.begin(problem.path);
                    for (int turn = 0; turn < 400 && !tightening.converged(); ++turn)
                    {
                        tightening.advance(500);
                    }
                    converged += tightening.converged() ? 1 : 0;
                    excess += (tightening.cost().value() - problem.optimum) / problem.optimum;
                }
                EXPECT_GE(converged, 20U) << dimension << " dimensions";
                EXPECT_LT(excess / 30, 4e-4) << dimension << " dimensions";
            }
        }

        /* A shortest path touches the ball, but interpolated at four times the resolution it is usually still valid: 95
           of 100 motions, and 60 to 70 without the margin. */
        TEST(PathTightening, KeepsAMarginWhereAVertexWasBlocked)
        {
            const WayAroundABall problem(2);
            const auto start = test::planarPath(problem.space, {{-8, -0.5}, {-6, 4}, {0, 6}, {6, 4}, {8, -0.5}});
            ob::ScopedState<> state(problem.space);
            unsigned int motions = 0;
            unsigned int valid = 0;
            for (std::uint_fast32_t seed = 1; seed <= 60; ++seed)
            {
                path::PathEvaluator evaluator(problem.si,
                                              std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
                PathTightening tightening(problem.chart, evaluator, seed);
                tightening.begin(start);
                tightening.advance(8000);
                const path::Waypoints &path = tightening.path();
                for (std::size_t i = 1; i < path.size(); ++i)
                {
                    const unsigned int states = 4 * problem.space->validSegmentCount(path[i - 1], path[i]);
                    bool holds = true;
                    for (unsigned int k = 0; k < states; ++k)
                    {
                        problem.space->interpolate(path[i - 1], path[i], static_cast<double>(k) / states, state.get());
                        holds = holds && problem.si->isValid(state.get());
                    }
                    ++motions;
                    valid += holds ? 1 : 0;
                }
            }
            EXPECT_GT(motions, 200U);
            EXPECT_GT(valid, 85 * motions / 100);
        }
    }  // namespace
}  // namespace ompl_mfa::engine::refinement
