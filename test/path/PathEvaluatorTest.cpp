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

#include "path/PathEvaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/geometric/PathGeometric.h>

#include "path/CountingProblem.h"
#include "path/StateSpaces.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::path
{
    namespace
    {
        double coordinate(const ob::State *state, int i)
        {
            return state->as<ob::RealVectorStateSpace::StateType>()->values[i];
        }

        using Points = std::vector<std::pair<double, double>>;

        /* The plane [-10, 10]^2 with a wall 4 < x < 6 that ends at y = 5. */
        class PathEvaluatorTest : public ::testing::Test
        {
        protected:
            PathEvaluatorTest()
            {
                problem_.si->setStateValidityCheckingResolution(0.001);
                problem_.si->setup();
            }

            Waypoints path(const Points &points) const
            {
                return test::planarPath(space_, points);
            }

            static bool outsideWall(const ob::State *state)
            {
                const double x = coordinate(state, 0);
                return coordinate(state, 1) > 5.0 || x <= 4.0 || x >= 6.0;
            }

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, outsideWall};
            PathEvaluator evaluator_{problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
        };

        const Points THROUGH_THE_WALL{{0, 0}, {3, 0}, {7, 0}, {9, 0}};
        const Points OVER_THE_WALL{{0, 0}, {3, 6}, {7, 6}, {9, 0}};

        TEST_F(PathEvaluatorTest, CostsAreThoseOfOmpl)
        {
            const Waypoints zigzag = path({{0, 0}, {3, 4}, {3, 8}, {-9, 3}});
            og::PathGeometric theirs(problem_.si);
            for (const ob::State *state : zigzag.pointers())
            {
                theirs.append(state);
            }
            const std::vector<ob::OptimizationObjectivePtr> objectives{
                std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si),
                std::make_shared<ob::MaximizeMinClearanceObjective>(problem_.si),
                std::make_shared<ob::StateCostIntegralObjective>(problem_.si, true),
                std::make_shared<ob::MechanicalWorkOptimizationObjective>(problem_.si)};
            for (const auto &objective : objectives)
            {
                PathEvaluator evaluator(problem_.si, objective);
                EXPECT_DOUBLE_EQ(evaluator.cost(zigzag).value(), theirs.cost(objective).value());
            }
            EXPECT_DOUBLE_EQ(evaluator_.cost(zigzag).value(), 5.0 + 4.0 + 13.0);
        }

        TEST_F(PathEvaluatorTest, AValidPathHasItsCostAndNoViolation)
        {
            const Brightness brightness = evaluator_.evaluate(path(OVER_THE_WALL), nullptr);
            EXPECT_TRUE(brightness.isFeasible());
            EXPECT_DOUBLE_EQ(brightness.cost, std::hypot(3.0, 6.0) + 4.0 + std::hypot(2.0, 6.0));
            EXPECT_EQ(problem_.motions, 3U);
        }

        TEST_F(PathEvaluatorTest, TheViolationIsTheLengthOfTheInvalidPart)
        {
            // the wall is 2 wide; the states checked on the motion of length 4 are at most this far apart
            const double resolution = 0.001 * space_->getMaximumExtent();
            const Brightness straight = evaluator_.evaluate(path(THROUGH_THE_WALL), nullptr);
            EXPECT_NEAR(straight.violation, 2.0, 2.0 * resolution);
            EXPECT_DOUBLE_EQ(straight.cost, 9.0);
            // across, back and across again: every passage counts
            const Brightness thrice = evaluator_.evaluate(path({{3, 0}, {7, 0}, {3, 0}, {7, 0}}), nullptr);
            EXPECT_NEAR(thrice.violation, 6.0, 6.0 * resolution);
            // two waypoints inside the wall: of lengths 2 + 1 + 2, invalid are 1 + 1 + 1
            const Brightness inside = evaluator_.evaluate(path({{3, 0}, {5, 0}, {5, 1}, {7, 1}}), nullptr);
            EXPECT_NEAR(inside.violation, 3.0, 6.0 * resolution);
        }

        TEST_F(PathEvaluatorTest, WhatOnlyTheMotionValidatorFindsInvalidIsAViolationToo)
        {
            class Refusing : public ob::MotionValidator
            {
            public:
                using MotionValidator::MotionValidator;
                bool checkMotion(const ob::State * /*from*/, const ob::State * /*to*/) const override
                {
                    return false;
                }
                bool checkMotion(const ob::State * /*from*/, const ob::State * /*to*/,
                                 std::pair<ob::State *, double> & /*lastValid*/) const override
                {
                    return false;
                }
            };
            problem_.si->setMotionValidator(std::make_shared<Refusing>(problem_.si));
            const Brightness brightness = evaluator_.evaluate(path({{0, 0}, {1, 0}}), nullptr);
            EXPECT_FALSE(brightness.isFeasible());
            EXPECT_GT(brightness.violation, 0.0);
        }

        TEST_F(PathEvaluatorTest, ACandidateThatCannotWinOnCostIsNeverChecked)
        {
            const Brightness rival = evaluator_.evaluate(path(OVER_THE_WALL), nullptr);
            problem_.forget();
            const Brightness longer = evaluator_.evaluate(path({{0, 0}, {3, 8}, {7, 8}, {9, 0}}), &rival);
            EXPECT_EQ(problem_.motions, 0U);
            EXPECT_EQ(problem_.states, 0U);
            EXPECT_FALSE(longer.isFeasible());
            EXPECT_FALSE(evaluator_.isBrighter(longer, rival));
            // a tie is not better either
            evaluator_.evaluate(path(OVER_THE_WALL), &rival);
            EXPECT_EQ(problem_.motions, 0U);
            EXPECT_EQ(problem_.states, 0U);
        }

        TEST_F(PathEvaluatorTest, ACandidateThatWinsIsCheckedWhole)
        {
            const Brightness rival = evaluator_.evaluate(path({{0, 0}, {3, 8}, {7, 8}, {9, 0}}), nullptr);
            problem_.forget();
            const Brightness shorter = evaluator_.evaluate(path(OVER_THE_WALL), &rival);
            EXPECT_TRUE(shorter.isFeasible());
            EXPECT_TRUE(evaluator_.isBrighter(shorter, rival));
            EXPECT_EQ(problem_.motions, 3U);
        }

        TEST_F(PathEvaluatorTest, AnInvalidCandidateLosesAgainstAValidRivalAtItsFirstInvalidMotion)
        {
            const Brightness rival = evaluator_.evaluate(path(OVER_THE_WALL), nullptr);
            problem_.forget();
            EXPECT_FALSE(evaluator_.evaluate(path(THROUGH_THE_WALL), &rival).isFeasible());
            EXPECT_EQ(problem_.motions, 2U);
            // the motion at which the last one failed is checked first
            problem_.forget();
            EXPECT_FALSE(evaluator_.evaluate(path(THROUGH_THE_WALL), &rival).isFeasible());
            EXPECT_EQ(problem_.motions, 1U);
            // and all others are still checked
            problem_.forget();
            EXPECT_TRUE(evaluator_.evaluate(path({{0, 0}, {3, 5.5}, {7, 5.5}, {9, 0}}), &rival).isFeasible());
            EXPECT_EQ(problem_.motions, 3U);
        }

        TEST_F(PathEvaluatorTest, OfTwoInvalidCandidatesTheOneWithLessInvalidLengthIsBrighter)
        {
            const Brightness once = evaluator_.evaluate(path(THROUGH_THE_WALL), nullptr);
            const Brightness thrice = evaluator_.evaluate(path({{3, 0}, {7, 0}, {3, 0}, {7, 0}}), &once);
            EXPECT_TRUE(evaluator_.isBrighter(once, thrice));
            EXPECT_EQ(thrice.violation, std::numeric_limits<double>::infinity());
            // a longer path may be brighter: violation comes first
            const Brightness corner = evaluator_.evaluate(path({{0, 0}, {3.5, 4.5}, {7, 5.5}, {9, 0}}), &once);
            EXPECT_GT(corner.cost, once.cost);
            EXPECT_TRUE(evaluator_.isBrighter(corner, once));
        }

        TEST_F(PathEvaluatorTest, TheObjectiveOrdersBrightness)
        {
            const auto clearance = std::make_shared<ob::MaximizeMinClearanceObjective>(problem_.si);
            PathEvaluator evaluator(problem_.si, clearance);
            EXPECT_TRUE(evaluator.isBrighter({0.0, 2.0}, {0.0, 1.0}));
            EXPECT_FALSE(evaluator.isBrighter({0.0, 1.0}, {0.0, 2.0}));
            EXPECT_FALSE(evaluator.isBrighter({0.5, 2.0}, {0.0, 1.0}));
            EXPECT_TRUE(evaluator_.isBrighter({0.0, 1.0}, {0.0, 2.0}));
            EXPECT_TRUE(evaluator_.isBrighter({0.0, 1.0}, {}));
        }

        TEST_F(PathEvaluatorTest, TheStopConditionIsAskedBeforeEveryMotion)
        {
            int asked = 0;
            evaluator_.setStopCondition([&asked] { return ++asked > 1; });
            EXPECT_FALSE(evaluator_.evaluate(path(OVER_THE_WALL), nullptr).isFeasible());
            EXPECT_TRUE(evaluator_.interrupted());
            EXPECT_EQ(problem_.motions, 1U);
            EXPECT_FALSE(evaluator_.checkPath(path(OVER_THE_WALL)));
            EXPECT_EQ(problem_.motions, 1U);
            evaluator_.setStopCondition({});
            EXPECT_FALSE(evaluator_.interrupted());
            EXPECT_TRUE(evaluator_.checkPath(path(OVER_THE_WALL)));
        }

        TEST_F(PathEvaluatorTest, ReportsHowFarAnInvalidPathIsValid)
        {
            std::size_t reported = 99;
            double x = 0.0;
            evaluator_.setPartialPathEvent(
                [&](const Waypoints &, std::size_t motion, const ob::State *lastValid)
                {
                    reported = motion;
                    x = coordinate(lastValid, 0);
                });
            evaluator_.evaluate(path(THROUGH_THE_WALL), nullptr);
            EXPECT_EQ(reported, 1U);
            EXPECT_NEAR(x, 4.0, 0.001 * space_->getMaximumExtent());
            EXPECT_LE(x, 4.0);
        }

        TEST_F(PathEvaluatorTest, CountsTheStatesItChecks)
        {
            const Waypoints valid = path(OVER_THE_WALL);
            problem_.forget();
            const auto before = evaluator_.work();
            evaluator_.checkPath(valid);
            EXPECT_EQ(evaluator_.work() - before, problem_.states);
        }

        TEST_F(PathEvaluatorTest, AsymmetricMotionsCostWhatTheyCostInTheirDirection)
        {
            const auto space = test::dubinsSpace(false);
            const test::CountingProblem problem(space, [](const ob::State *) { return true; });
            PathEvaluator evaluator(problem.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
            Waypoints there(space);
            ob::ScopedState<> state(space);
            state[0] = state[1] = state[2] = 0.0;
            there.append(state.get());
            state[0] = 4.0;
            there.append(state.get());
            Waypoints back = there;
            back.reverse();
            EXPECT_NEAR(evaluator.cost(there).value(), 4.0, 1e-9);
            EXPECT_GT(evaluator.cost(back).value(), 4.0 + 3.14);
        }

        /* The plane [-10, 10]^2 with a disc of radius 2 in its middle and a wall 5.1 < x < 5.2, thicker than the
           distance between two states of a motion and much thinner than that of a draft. */
        class DraftTest : public ::testing::Test
        {
        protected:
            DraftTest()
            {
                problem_.si->setStateValidityCheckingResolution(0.001);
                problem_.si->setup();
            }

            Waypoints path(const Points &points) const
            {
                return test::planarPath(space_, points);
            }

            static bool outside(const ob::State *state)
            {
                const double x = coordinate(state, 0);
                return std::hypot(x, coordinate(state, 1)) > 2.0 && (x < 5.1 || x > 5.2);
            }

            static constexpr unsigned int STRIDE = 8;

            ob::StateSpacePtr space_ = test::realVectorSpace(2);
            test::CountingProblem problem_{space_, outside};
            PathEvaluator evaluator_{problem_.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_.si)};
            Waypoints through_ = path({{0, 4}, {9, 4}});
            Waypoints aside_ = path({{-9, 4}, {0, 4}, {4, 3}});
        };

        TEST_F(DraftTest, AThinObstaclePassesADraftAndFailsInFull)
        {
            EXPECT_FALSE(evaluator_.checkMotion(through_[0], through_[1]));
            evaluator_.setStride(STRIDE);
            EXPECT_TRUE(evaluator_.checkMotion(through_[0], through_[1]));
            EXPECT_TRUE(evaluator_.checkPath(through_));
            EXPECT_TRUE(evaluator_.checkMotions({{through_[0], through_[1]}}));
            EXPECT_TRUE(evaluator_.checkStrictly({{through_[0], through_[1]}}));
            EXPECT_TRUE(evaluator_.evaluate(through_, nullptr).isFeasible());
            evaluator_.setStride(1);
            EXPECT_FALSE(evaluator_.checkPath(through_));
        }

        TEST_F(DraftTest, AThickObstacleFailsADraft)
        {
            evaluator_.setStride(STRIDE);
            const Waypoints across = path({{-9, 1}, {4, 1}});
            EXPECT_FALSE(evaluator_.checkMotion(across[0], across[1]));
            EXPECT_FALSE(evaluator_.checkPath(path({{-9, 4}, {-9, 1}, {4, 1}})));
            EXPECT_FALSE(evaluator_.evaluate(across, nullptr).isFeasible());
        }

        TEST_F(DraftTest, AnInvalidEndFailsADraft)
        {
            evaluator_.setStride(1000);
            const Waypoints ends = path({{-9, 4}, {5.15, 4}, {20, 4}});
            EXPECT_FALSE(evaluator_.checkMotion(ends[0], ends[1]));
            EXPECT_FALSE(evaluator_.checkMotion(ends[0], ends[2])) << "out of bounds";
        }

        TEST_F(DraftTest, ValidMotionsPassADraft)
        {
            const auto sampler = space_->allocStateSampler();
            Waypoints motion = path({{0, 4}, {0, 4}});
            unsigned int valid = 0;
            unsigned int found = 0;
            unsigned int invalid = 0;
            for (int i = 0; i < 2000; ++i)
            {
                sampler->sampleUniform(motion[0]);
                sampler->sampleUniform(motion[1]);
                if (!outside(motion[0]))
                {
                    continue;
                }
                // all states of the segment are valid, not only those that are checked
                const double x = coordinate(motion[0], 0);
                const double y = coordinate(motion[0], 1);
                const double dx = coordinate(motion[1], 0) - x;
                const double dy = coordinate(motion[1], 1) - y;
                const double t = std::clamp(-(x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
                const bool isValid =
                    std::hypot(x + t * dx, y + t * dy) > 2.0 && outside(motion[1]) && (x < 5.15) == (x + dx < 5.15);
                for (const unsigned int stride : {2U, 3U, STRIDE})
                {
                    evaluator_.setStride(stride);
                    const bool passes = evaluator_.checkMotion(motion[0], motion[1]);
                    EXPECT_TRUE(passes || !isValid) << "motion " << i << ", stride " << stride;
                    found += !passes && !isValid ? 1 : 0;
                }
                ++(isValid ? valid : invalid);
            }
            EXPECT_GT(valid, 500U);
            EXPECT_GT(invalid, 500U);
            EXPECT_GT(found, 2 * invalid) << "of three drafts of each invalid motion";
        }

        TEST_F(DraftTest, ChecksOneStateInSoManyAndCountsIt)
        {
            evaluator_.checkPath(aside_);
            const auto full = problem_.states.load();
            for (const unsigned int stride : {2U, 3U, 5U, STRIDE})
            {
                evaluator_.setStride(stride);
                problem_.forget();
                const auto before = evaluator_.work();
                EXPECT_TRUE(evaluator_.checkPath(aside_));
                const auto states = static_cast<double>(problem_.states);
                EXPECT_EQ(evaluator_.work() - before, problem_.states);
                EXPECT_EQ(problem_.motions, 0U) << "the motion validator checks all states";
                // powers of two
                EXPECT_LT(states, 1.4 * static_cast<double>(full) / stride + 2.0);
                EXPECT_GT(states, 0.6 * static_cast<double>(full) / stride);
                EXPECT_NEAR(static_cast<double>(evaluator_.checkWork(aside_)), states, 0.5 * states);
            }
        }

        TEST_F(DraftTest, AnInvalidDraftCountsNoMoreThanAValidOne)
        {
            evaluator_.setStride(STRIDE);
            const Waypoints across = path({{-9, 1}, {4, 1}});
            const auto before = evaluator_.work();
            EXPECT_FALSE(evaluator_.checkMotion(across[0], across[1]));
            EXPECT_GT(evaluator_.work(), before);
            EXPECT_LT(evaluator_.work() - before, evaluator_.checkWork(across));
        }

        TEST_F(DraftTest, TheWorkOfAPathIsThatOfCheckingIt)
        {
            const auto before = evaluator_.work();
            evaluator_.checkPath(aside_);
            const auto work = static_cast<double>(evaluator_.work() - before);
            EXPECT_NEAR(static_cast<double>(evaluator_.checkWork(aside_)), work, 0.02 * work);
            EXPECT_EQ(evaluator_.checkedSegments(aside_[0], aside_[1]),
                      space_->validSegmentCount(aside_[0], aside_[1]));
            EXPECT_EQ(evaluator_.checkedSegments(aside_[0], aside_[0]), 1U);
            evaluator_.setStride(STRIDE);
            EXPECT_EQ(evaluator_.checkedSegments(aside_[0], aside_[1]),
                      space_->validSegmentCount(aside_[0], aside_[1]) / STRIDE);
            evaluator_.setStride(1000000);
            EXPECT_EQ(evaluator_.checkedSegments(aside_[0], aside_[1]), 1U);
        }

        TEST_F(DraftTest, IsNotCheckedStrictly)
        {
            problem_.forget();
            EXPECT_TRUE(evaluator_.checkBetween({{aside_[0], aside_[1]}}));
            EXPECT_GT(problem_.states, 0U);
            evaluator_.setStride(STRIDE);
            problem_.forget();
            const auto before = evaluator_.work();
            EXPECT_TRUE(evaluator_.checkBetween({{aside_[0], aside_[1]}}));
            EXPECT_EQ(problem_.states, 0U);
            EXPECT_EQ(evaluator_.work(), before);
            EXPECT_TRUE(evaluator_.checkMotions({{aside_[0], aside_[1]}}));
            const auto once = problem_.states.load();
            EXPECT_TRUE(evaluator_.checkStrictly({{aside_[0], aside_[1]}}));
            EXPECT_EQ(problem_.states, 2 * once);
        }

        TEST_F(DraftTest, TheStopConditionIsAskedBeforeEveryMotion)
        {
            int asked = 0;
            evaluator_.setStride(STRIDE);
            evaluator_.setStopCondition([&asked] { return ++asked > 1; });
            problem_.forget();
            EXPECT_TRUE(evaluator_.checkMotion(aside_[0], aside_[1]));
            const auto once = problem_.states.load();
            EXPECT_FALSE(evaluator_.checkMotion(aside_[0], aside_[1]));
            EXPECT_TRUE(evaluator_.interrupted());
            EXPECT_EQ(problem_.states, once);
        }

        TEST_F(DraftTest, TheStrideIsResetAfterwards)
        {
            {
                const StrideScope outer(evaluator_, 3);
                EXPECT_EQ(evaluator_.stride(), 3U);
                {
                    const StrideScope inner(evaluator_, 1);
                    EXPECT_EQ(evaluator_.stride(), 1U);
                    EXPECT_FALSE(evaluator_.checkPath(through_));
                }
                EXPECT_EQ(evaluator_.stride(), 3U);
            }
            EXPECT_EQ(evaluator_.stride(), 1U);
        }

        /* A line 14 radii ahead and a turn by 1 rad after it, off by 3e-7 rad. */
        TEST(Drafts, MotionsThatOmplCannotComputeAreInvalid)
        {
            constexpr double RADIUS = 0.5;
            const auto space = test::dubinsSpace(false, RADIUS);
            const test::CountingProblem problem(space, [](const ob::State *) { return true; });
            PathEvaluator evaluator(problem.si, std::make_shared<ob::PathLengthOptimizationObjective>(problem.si));
            ob::ScopedState<ob::DubinsStateSpace> from(space);
            ob::ScopedState<ob::DubinsStateSpace> to(space);
            from->setXY(-3.0, 0.0);
            to->setXY(4.0 + RADIUS * std::sin(1.0), RADIUS * (1.0 - std::cos(1.0)));
            to->setYaw(1.0);
            evaluator.setStride(4);
            for (const double off : {-3e-7, 0.0, 3e-7})
            {
                from->setYaw(off);
                Waypoints path(space);
                path.append(from.get());
                path.append(to.get());
                EXPECT_EQ(evaluator.checkMotion(path[0], path[1]), off == 0.0);
                EXPECT_EQ(evaluator.checkMotions({{path[0], path[1]}}), off == 0.0);
                EXPECT_EQ(evaluator.checkPath(path), off == 0.0);
                EXPECT_EQ(evaluator.evaluate(path, nullptr).isFeasible(), off == 0.0);
                EXPECT_GT(evaluator.checkWork(path), 1U);
            }
        }
    }  // namespace
}  // namespace ompl_mfa::path
