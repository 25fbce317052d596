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

/* MFA in every state space that it supports, and the rejection of others. */

#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/ConstrainedSpaceInformation.h>
#include <ompl/base/Constraint.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/base/spaces/TimeStateSpace.h>
#include <ompl/base/spaces/constraint/AtlasStateSpace.h>
#include <ompl/base/spaces/constraint/ProjectedStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Exception.h>

#include "path/StateChart.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        /* Each position in a state must stay out of a ball around the middle of the space; without positions, the first
           rotation out of an interval. */
        class Obstacle
        {
        public:
            explicit Obstacle(const ob::StateSpacePtr &space)
              : space_(space)
              , chart_(space)
            {
            }

            bool isValid(const ob::State *state) const
            {
                Eigen::VectorXd positions(chart_.positionDimension());
                chart_.positions(state, positions);
                if (positions.size() > 1)
                {
                    return positions.norm() > 2.0;
                }
                return true;
            }

        private:
            ob::StateSpacePtr space_;
            path::StateChart chart_;
        };

        using Case = std::tuple<test::NamedSpace, test::PlannerVariant>;

        class EverySpace : public ::testing::TestWithParam<Case>
        {
        protected:
            EverySpace()
              : space_(std::get<0>(GetParam()).make())
            {
                const auto obstacle = std::make_shared<Obstacle>(space_);
                si_ = std::make_shared<ob::SpaceInformation>(space_);
                si_->setStateValidityChecker([obstacle](const ob::State *state) { return obstacle->isValid(state); });
                si_->setup();
            }

            /* On opposite sides of the obstacle and at random rotations. */
            ob::ProblemDefinitionPtr problem(unsigned int number) const
            {
                ompl::RNG rng(100 + number);
                const path::StateChart chart(space_);
                auto pdef = std::make_shared<ob::ProblemDefinition>(si_);
                ob::ScopedState<> start(space_);
                ob::ScopedState<> goal(space_);
                chart.sampleUniform(rng, start.get());
                chart.sampleUniform(rng, goal.get());
                const Eigen::Index n = chart.positionDimension();
                // the nested space has a coordinate that ends at -2 (scaled by its weight: -3)
                chart.setPositions(Eigen::VectorXd::Constant(n, n == 1 ? -3.0 : -2.5), start.get());
                chart.setPositions(Eigen::VectorXd::Constant(n, 2.5), goal.get());
                pdef->setStartAndGoalStates(start, goal);
                return pdef;
            }

            ob::StateSpacePtr space_;
            ob::SpaceInformationPtr si_;
        };

        struct CaseName
        {
            template <typename Info>
            std::string operator()(const Info &info) const
            {
                return std::get<0>(info.param).name +
                       (std::get<1>(info.param) == test::PlannerVariant::Paper ? "Paper" : "Default");
            }
        };

        INSTANTIATE_TEST_SUITE_P(Planner, EverySpace,
                                 ::testing::Combine(::testing::ValuesIn(test::supportedSpaces()),
                                                    ::testing::Values(test::PlannerVariant::Default,
                                                                      test::PlannerVariant::Paper)),
                                 CaseName());

        TEST_P(EverySpace, IsSolvedWithAPathThatPassesItsCheck)
        {
            for (unsigned int number = 0; number < 3; ++number)
            {
                const auto pdef = problem(number);
                const auto planner = test::makePlanner(si_, std::get<1>(GetParam()));
                planner->setProblemDefinition(pdef);
                ASSERT_EQ(planner->solve(test::untilExact(pdef)), ob::PlannerStatus::EXACT_SOLUTION);
                auto &path = *pdef->getSolutionPath()->as<og::PathGeometric>();
                EXPECT_TRUE(path.check());
                EXPECT_TRUE(space_->equalStates(path.getState(0), pdef->getStartState(0)));
                EXPECT_TRUE(pdef->getGoal()->isSatisfied(path.getState(path.getStateCount() - 1)));
                for (const ob::State *state : path.getStates())
                {
                    EXPECT_TRUE(space_->satisfiesBounds(state));
                }
                const ob::PathLengthOptimizationObjective length(si_);
                EXPECT_NEAR(planner->bestCost(), path.length(), 1e-9);
                EXPECT_FALSE(length.isCostBetterThan(
                    ob::Cost(planner->bestCost()),
                    length.motionCostHeuristic(pdef->getStartState(0), path.getState(path.getStateCount() - 1))))
                    << "shorter than the distance";
            }
        }

        class Refusal : public ::testing::Test
        {
        protected:
            static std::string of(const ob::StateSpacePtr &space)
            {
                return of(std::make_shared<ob::SpaceInformation>(space));
            }

            static std::string of(const ob::SpaceInformationPtr &si)
            {
                si->setStateValidityChecker([](const ob::State *) { return true; });
                si->setup();
                MFA planner(si);
                try
                {
                    planner.setup();
                }
                catch (const ompl::Exception &error)
                {
                    return error.what();
                }
                return "accepted";
            }
        };

        TEST_F(Refusal, ComesFromSetupAndNamesTheSubspace)
        {
            const auto gears = std::make_shared<ob::DiscreteStateSpace>(1, 5);
            gears->setName("gears");
            for (const auto &space : {ob::StateSpacePtr(gears), test::compoundSpace({test::se2Space(), gears}, {1, 1})})
            {
                const std::string message = of(space);
                EXPECT_NE(message.find("'gears'"), std::string::npos) << message;
                EXPECT_NE(message.find("SE(2)"), std::string::npos) << message;
            }
        }

        TEST_F(Refusal, ComesFromEachSolve)
        {
            const auto si = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::DiscreteStateSpace>(1, 5));
            si->setStateValidityChecker([](const ob::State *) { return true; });
            const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<ob::DiscreteStateSpace> gear(si->getStateSpace());
            gear->value = 2;
            pdef->setStartAndGoalStates(gear, gear);
            MFA planner(si);
            planner.setProblemDefinition(pdef);
            for (int i = 0; i < 2; ++i)
            {
                EXPECT_THROW(planner.solve(test::afterCalls(100)), ompl::Exception) << i;
            }
        }

        class UnitSphere : public ob::Constraint
        {
        public:
            UnitSphere()
              : ob::Constraint(3, 1)
            {
            }

            void function(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> out) const override
            {
                out[0] = x.norm() - 1.0;
            }
        };

        TEST_F(Refusal, OfTimeConstrainedAndAtlasSpacesNamesThemToo)
        {
            const auto clock = std::make_shared<ob::TimeStateSpace>();
            const auto sphere = std::make_shared<UnitSphere>();
            const auto projected = std::make_shared<ob::ProjectedStateSpace>(test::realVectorSpace(3), sphere);
            const auto atlas = std::make_shared<ob::AtlasStateSpace>(test::realVectorSpace(3), sphere);
            clock->setName("clock");
            projected->setName("projected");
            atlas->setName("atlas");
            const auto si = std::make_shared<ob::ConstrainedSpaceInformation>(projected);
            const auto atlasSi = std::make_shared<ob::ConstrainedSpaceInformation>(atlas);
            for (const auto &[name, message] :
                 {std::pair<std::string, std::string>{"'clock'",
                                                      of(test::compoundSpace({test::se2Space(), clock}, {1, 1}))},
                  {"'projected'", of(si)},
                  {"'atlas'", of(atlasSi)}})
            {
                EXPECT_NE(message.find(name), std::string::npos) << message;
            }
        }

        /* Start and goal differ in rotation alone, and the direct rotation is blocked: the positions have to change. */
        class PureRotation : public ::testing::TestWithParam<Case>
        {
        };

        INSTANTIATE_TEST_SUITE_P(
            Planner, PureRotation,
            ::testing::Combine(::testing::Values(test::NamedSpace{"SE2", [] { return test::se2Space(); }},
                                                 test::NamedSpace{"SE3", [] { return test::se3Space(); }}),
                               ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper)),
            CaseName());

        TEST_P(PureRotation, IsSolvedWhereItHasToLeaveItsPlace)
        {
            const auto space = std::get<0>(GetParam()).make();
            const path::StateChart chart(space);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            ob::ScopedState<> start(space);
            ob::ScopedState<> goal(space);
            ompl::RNG rng(5);
            chart.sampleUniform(rng, start.get());
            chart.sampleUniform(rng, goal.get());
            const Eigen::VectorXd origin = Eigen::VectorXd::Zero(chart.positionDimension());
            chart.setPositions(origin, start.get());
            chart.setPositions(origin, goal.get());
            while (space->distance(start.get(), goal.get()) < 1.2)
            {
                chart.sampleRotations(rng, goal.get());
            }
            // near the position of start and goal only rotations close to theirs are free
            si->setStateValidityChecker(
                [&](const ob::State *state)
                {
                    Eigen::VectorXd positions(chart.positionDimension());
                    chart.positions(state, positions);
                    return positions.norm() > 0.5 || space->distance(state, start.get()) < 0.4 ||
                           space->distance(state, goal.get()) < 0.4;
                });
            si->setup();
            const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
            pdef->setStartAndGoalStates(start, goal);
            const auto planner = test::makePlanner(si, std::get<1>(GetParam()));
            planner->setProblemDefinition(pdef);
            ASSERT_FALSE(si->checkMotion(start.get(), goal.get()));
            ASSERT_EQ(planner->solve(test::untilExact(pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(pdef->getSolutionPath()->check());
            EXPECT_GT(planner->bestCost(), space->distance(start.get(), goal.get()));
        }

        TEST(SimpleSetup, TakesThePlannerWithoutAnythingElse)
        {
            og::SimpleSetup setup(test::realVectorSpace(2, 0.0, 10.0));
            setup.setStateValidityChecker(
                [](const ob::State *state)
                {
                    const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
                    return std::hypot(values[0] - 5.0, values[1] - 5.0) > 2.0;
                });
            ob::ScopedState<> start(setup.getStateSpace());
            ob::ScopedState<> goal(setup.getStateSpace());
            start[0] = start[1] = 1.0;
            goal[0] = goal[1] = 9.0;
            setup.setStartAndGoalStates(start, goal);
            setup.setPlanner(std::make_shared<MFA>(setup.getSpaceInformation()));
            EXPECT_EQ(setup.solve(0.3), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(setup.haveExactSolutionPath());
            setup.simplifySolution();
            EXPECT_TRUE(setup.getSolutionPath().check());
            EXPECT_EQ(setup.getSolutionPlannerName(), "MFA");
        }

        TEST(CurvedSpaces, CostsAndWaypointsAreTheSpacesOwn)
        {
            // a car that cannot reverse has to turn around: far longer than the distance of the positions
            const auto space = test::dubinsSpace(false);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            si->setStateValidityChecker([](const ob::State *) { return true; });
            si->setup();
            const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<> start(space);
            ob::ScopedState<> goal(space);
            start[0] = 2.0;
            goal[0] = -2.0;
            start[1] = goal[1] = start[2] = goal[2] = 0.0;
            pdef->setStartAndGoalStates(start, goal);
            const auto planner = test::makePlanner(si, test::PlannerVariant::Default);
            planner->setProblemDefinition(pdef);
            ASSERT_EQ(planner->solve(test::afterCalls(3000)), ob::PlannerStatus::EXACT_SOLUTION);
            // with no obstacle the optimum is the Dubins curve itself
            EXPECT_NEAR(planner->bestCost(), space->distance(start.get(), goal.get()), 1e-6);
            EXPECT_GT(planner->bestCost(), 4.0 + 3.14);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
