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

/* MFA takes costs and their comparison from the objective alone. */

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/MinimaxObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        /* The cost of a state: 1 plus its distance from the line y = 2. */
        double height(const ob::State *state)
        {
            return 1.0 + std::abs(test::coordinate(state, 1) - 2.0);
        }

        class HeightIntegral : public ob::StateCostIntegralObjective
        {
        public:
            explicit HeightIntegral(const ob::SpaceInformationPtr &si)
              : StateCostIntegralObjective(si, true)
            {
            }

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(height(state));
            }
        };

        class Height : public ob::MinimaxObjective
        {
        public:
            using MinimaxObjective::MinimaxObjective;

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(height(state));
            }
        };

        class HeightWork : public ob::MechanicalWorkOptimizationObjective
        {
        public:
            using MechanicalWorkOptimizationObjective::MechanicalWorkOptimizationObjective;

            ob::Cost stateCost(const ob::State *state) const override
            {
                return ob::Cost(height(state));
            }
        };

        /* Costs that depend on the direction, and a terminal cost. */
        class Uphill : public ob::OptimizationObjective
        {
        public:
            using OptimizationObjective::OptimizationObjective;

            ob::Cost stateCost(const ob::State *) const override
            {
                return ob::Cost(0.0);
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const double rise = test::coordinate(to, 1) - test::coordinate(from, 1);
                return ob::Cost(si_->distance(from, to) + 3.0 * std::max(0.0, rise));
            }

            ob::Cost initialCost(const ob::State *) const override
            {
                return ob::Cost(2.0);
            }

            ob::Cost terminalCost(const ob::State *) const override
            {
                return ob::Cost(5.0);
            }
        };

        /* Costs are maximised and multiplied: nothing of path length is left. */
        class Reliability : public ob::OptimizationObjective
        {
        public:
            explicit Reliability(const ob::SpaceInformationPtr &si)
              : OptimizationObjective(si)
            {
                // any path would satisfy OMPL's default threshold of 0
                setCostThreshold(ob::Cost(2.0));
            }

            bool isCostBetterThan(ob::Cost a, ob::Cost b) const override
            {
                return a.value() > b.value();
            }

            ob::Cost combineCosts(ob::Cost a, ob::Cost b) const override
            {
                return ob::Cost(a.value() * b.value());
            }

            ob::Cost identityCost() const override
            {
                return ob::Cost(1.0);
            }

            ob::Cost infiniteCost() const override
            {
                return ob::Cost(0.0);
            }

            ob::Cost stateCost(const ob::State *) const override
            {
                return identityCost();
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(std::exp(-0.1 * si_->distance(from, to)));
            }
        };

        class WallDistance : public ob::StateValidityChecker
        {
        public:
            using StateValidityChecker::StateValidityChecker;

            bool isValid(const ob::State *state) const override
            {
                return clearance(state) > 0.0;
            }

            /* The distance from the wall 4.5 < x < 5.5, y < 6. */
            double clearance(const ob::State *state) const override
            {
                const double dx = std::max({0.0, 4.5 - test::coordinate(state, 0), test::coordinate(state, 0) - 5.5});
                return std::hypot(dx, std::max(0.0, test::coordinate(state, 1) - 6.0));
            }
        };

        struct NamedObjective
        {
            std::string name;
            std::function<ob::OptimizationObjectivePtr(const ob::SpaceInformationPtr &)> make;
        };

        std::ostream &operator<<(std::ostream &out, const NamedObjective &objective)
        {
            return out << objective.name;
        }

        template <typename Objective>
        NamedObjective named(const std::string &name)
        {
            return {name, [](const ob::SpaceInformationPtr &si) { return std::make_shared<Objective>(si); }};
        }

        ob::OptimizationObjectivePtr weightedSum(const ob::SpaceInformationPtr &si)
        {
            auto sum = std::make_shared<ob::MultiOptimizationObjective>(si);
            sum->addObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si), 2.0);
            sum->addObjective(std::make_shared<HeightIntegral>(si), 0.5);
            sum->lock();
            return sum;
        }

        using Case = std::tuple<NamedObjective, test::PlannerVariant>;

        class EveryObjective : public ::testing::TestWithParam<Case>
        {
        protected:
            EveryObjective()
            {
                problem_->si->setStateValidityChecker(std::make_shared<WallDistance>(problem_->si));
                problem_->si->setup();
                objective_ = std::get<0>(GetParam()).make(problem_->si);
                problem_->pdef->setOptimizationObjective(objective_);
                planner_ = problem_->planner(std::get<1>(GetParam()));
            }

            og::PathGeometric path() const
            {
                return *problem_->pdef->getSolutionPath()->as<og::PathGeometric>();
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            ob::OptimizationObjectivePtr objective_;
            std::shared_ptr<MFA> planner_;
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

        INSTANTIATE_TEST_SUITE_P(
            Planner, EveryObjective,
            ::testing::Combine(::testing::Values(named<ob::PathLengthOptimizationObjective>("PathLength"),
                                                 named<HeightIntegral>("StateCostIntegral"),
                                                 named<ob::MaximizeMinClearanceObjective>("MaximizeMinClearance"),
                                                 named<HeightWork>("MechanicalWork"),
                                                 NamedObjective{"WeightedSum", weightedSum}, named<Height>("Minimax"),
                                                 named<Uphill>("Asymmetric"), named<Reliability>("Product")),
                               ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper)),
            CaseName());

        TEST_P(EveryObjective, ImprovesMonotonicallyAndReportsItsCost)
        {
            std::vector<ob::Cost> costs;
            problem_->pdef->setIntermediateSolutionCallback(
                [&costs](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
                { costs.push_back(cost); });
            ASSERT_EQ(planner_->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(path().check());
            ASSERT_GE(costs.size(), 2U);
            for (std::size_t i = 1; i < costs.size(); ++i)
            {
                EXPECT_TRUE(objective_->isCostBetterThan(costs[i], costs[i - 1]));
            }
            const double cost = path().cost(objective_).value();
            EXPECT_NEAR(costs.back().value(), cost, 1e-9 * std::abs(cost));
            EXPECT_NEAR(planner_->bestCost(), cost, 1e-9 * std::abs(cost));
            EXPECT_NEAR(problem_->reportedCost(), cost, 1e-9 * std::abs(cost));
        }

        TEST_P(EveryObjective, GetsBetterThanTheShortestWayOrAsGood)
        {
            planner_->solve(test::afterCalls(20000));
            og::PathGeometric shortest(problem_->si);
            for (const auto &[x, y] :
                 std::vector<std::pair<double, double>>{{1, 1}, {4.45, 6.05}, {5.55, 6.05}, {9, 1}})
            {
                shortest.append(problem_->state({x, y}).get());
            }
            ASSERT_TRUE(shortest.check());
            const double known = shortest.cost(objective_).value();
            // by a swarm of 20 on 5 slices, without guide or tightening: close is enough
            const double close =
                objective_->isCostBetterThan(ob::Cost(1.0), ob::Cost(2.0)) ? 1.15 * known : known / 1.15;
            EXPECT_FALSE(objective_->isCostBetterThan(ob::Cost(close), ob::Cost(planner_->bestCost())))
                << planner_->bestCost() << " against " << known;
        }

        TEST_P(EveryObjective, StopsOnceTheThresholdIsMet)
        {
            ASSERT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            const double first = planner_->bestCost();
            // the threshold is slightly worse than the cost reached before
            objective_->setCostThreshold(
                ob::Cost(objective_->isCostBetterThan(ob::Cost(1.0), ob::Cost(2.0)) ? 1.01 * first : first / 1.01));
            planner_->clear();
            problem_->pdef->clearSolutionPaths();
            std::uint64_t calls = 0;
            const ob::PlannerTerminationCondition ptc([&calls] { return ++calls >= 1000000; });
            ASSERT_EQ(planner_->solve(ptc), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_TRUE(objective_->isSatisfied(ob::Cost(planner_->bestCost())));
            EXPECT_TRUE(problem_->pdef->hasOptimizedSolution());
            EXPECT_LT(calls, 900000U) << "it continued although the threshold was met";
        }

        TEST_P(EveryObjective, IsNotCalledOptimizedBelowTheThreshold)
        {
            const bool lessIsBetter = objective_->isCostBetterThan(ob::Cost(1.0), ob::Cost(2.0));
            objective_->setCostThreshold(ob::Cost(lessIsBetter ? 1e-9 : 1e9));
            ASSERT_EQ(planner_->solve(test::untilExact(problem_->pdef)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_FALSE(problem_->pdef->hasOptimizedSolution());
        }

        /* A user's objective with motions of negative cost, for which no bound of OMPL holds. */
        class Earning : public ob::OptimizationObjective
        {
        public:
            explicit Earning(const ob::SpaceInformationPtr &si)
              : OptimizationObjective(si)
            {
                // any path would satisfy OMPL's default threshold of 0
                setCostThreshold(ob::Cost(-1e9));
            }

            ob::Cost stateCost(const ob::State *) const override
            {
                return ob::Cost(0.0);
            }

            /* The higher, the more negative the cost. */
            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const double up = 0.5 * (test::coordinate(from, 1) + test::coordinate(to, 1));
                return ob::Cost(-up * std::abs(test::coordinate(to, 0) - test::coordinate(from, 0)));
            }
        };

        class Objectives : public ::testing::TestWithParam<test::PlannerVariant>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Objectives,
                                 ::testing::Values(test::PlannerVariant::Default, test::PlannerVariant::Paper),
                                 test::VariantName());

        TEST_P(Objectives, ABoundThatAPathBeatsIsNoBound)
        {
            const auto problem = test::freeProblem();
            problem->pdef->setOptimizationObjective(std::make_shared<Earning>(problem->si));
            const auto planner = problem->planner(GetParam());
            ASSERT_EQ(planner->solve(test::afterCalls(300000)), ob::PlannerStatus::EXACT_SOLUTION);
            // the straight motion costs -8; the identity cost, which is OMPL's heuristic, is 0
            EXPECT_LT(planner->bestCost(), -20.0);
        }

        /* Costs of both signs whose sum over a path is known: a descent gives back the cost of the climb, and length
           costs a little. The ground is lowest between start and goal, and the goal is lower than the start. */
        class Descent : public ob::OptimizationObjective
        {
        public:
            explicit Descent(const ob::SpaceInformationPtr &si)
              : OptimizationObjective(si)
            {
                setCostThreshold(ob::Cost(-1e9));
            }

            static double ground(const ob::State *state)
            {
                const double x = test::coordinate(state, 0);
                return 3.0 * std::abs(x - 6.0) - 2.0 * x;
            }

            static double optimum(const ob::State *start, const ob::State *goal, double length)
            {
                return ground(goal) - ground(start) + 0.5 * length;
            }

            ob::Cost stateCost(const ob::State *) const override
            {
                return ob::Cost(0.0);
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(ground(to) - ground(from) + 0.5 * si_->distance(from, to));
            }
        };

        /* The same with all signs changed, to be maximised. */
        class Gain : public Descent
        {
        public:
            explicit Gain(const ob::SpaceInformationPtr &si)
              : Descent(si)
            {
                setCostThreshold(ob::Cost(1e9));
            }

            bool isCostBetterThan(ob::Cost a, ob::Cost b) const override
            {
                return a.value() > b.value();
            }

            ob::Cost infiniteCost() const override
            {
                return ob::Cost(-std::numeric_limits<double>::infinity());
            }

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                return ob::Cost(-Descent::motionCost(from, to).value());
            }
        };

        /* The roadmap prunes by lower bounds. The fireflies have one slice, on which no path is within 5% of the
           shortest. */
        template <typename Objective>
        double costByTheRoadmapAlone(const std::unique_ptr<test::PlanningProblem> &problem)
        {
            problem->pdef->clearSolutionPaths();
            problem->pdef->setOptimizationObjective(std::make_shared<Objective>(problem->si));
            const auto planner = problem->planner(test::PlannerVariant::Paper);
            test::set(*planner, "guide", "roadmap");
            test::set(*planner, "slices", "1");
            EXPECT_EQ(planner->solve(test::afterCalls(300000)), ob::PlannerStatus::EXACT_SOLUTION);
            return planner->bestCost();
        }

        TEST(Roadmap, FindsTheOptimumOfCostsOfBothSigns)
        {
            const auto problem = test::wallProblem();
            const ob::State *start = problem->pdef->getStartState(0);
            const ob::State *goal = problem->pdef->getGoal()->as<ob::GoalState>()->getState();
            const double close = Descent::optimum(start, goal, 1.03 * test::wallOptimum());
            ASSERT_LT(close, 0.0);
            const double descent = costByTheRoadmapAlone<Descent>(problem);
            EXPECT_LT(descent, close);
            EXPECT_GT(descent, Descent::optimum(start, goal, test::wallOptimum()) - 0.1);
            EXPECT_GT(costByTheRoadmapAlone<Gain>(problem), -close);
        }

        /* The path through the middle is expensive. The inherited heuristic is the cost of the motion itself, and no
           lower bound: a detour is cheaper. */
        class DearMiddle : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                constexpr int PIECES = 50;
                ob::ScopedState<> state(si_->getStateSpace());
                double weight = 0.0;
                for (int i = 0; i < PIECES; ++i)
                {
                    si_->getStateSpace()->interpolate(from, to, (i + 0.5) / PIECES, state.get());
                    weight += std::hypot(state[0] - 5.0, state[1] - 1.0) < 1.5 ? 10.0 : 1.0;
                }
                return ob::Cost(weight / PIECES * si_->distance(from, to));
            }
        };

        TEST_P(Objectives, AnInheritedHeuristicThatIsNoBoundEndsNothing)
        {
            const auto problem = test::freeProblem();
            problem->pdef->setOptimizationObjective(std::make_shared<DearMiddle>(problem->si));
            const auto planner = problem->planner(GetParam());
            ASSERT_EQ(planner->solve(test::afterCalls(100000)), ob::PlannerStatus::EXACT_SOLUTION);
            // straight through the disc: 5 and 30 for its diameter; around it, two tangents and an arc
            const double around = 2.0 * std::sqrt(16.0 - 2.25) + 2.0 * 1.5 * std::asin(1.5 / 4.0);
            EXPECT_LT(planner->bestCost(), 1.1 * around);
        }

        /* Path length plus a terminal cost that depends on the side of the wall. */
        class PricedEnds : public ob::PathLengthOptimizationObjective
        {
        public:
            PricedEnds(const ob::SpaceInformationPtr &si, double here, double beyond)
              : PathLengthOptimizationObjective(si)
              , here_(here)
              , beyond_(beyond)
            {
                // any path with a negative terminal cost would satisfy OMPL's default threshold of 0
                setCostThreshold(ob::Cost(-1e9));
            }

            ob::Cost terminalCost(const ob::State *state) const override
            {
                return ob::Cost(test::coordinate(state, 0) < 5.0 ? here_ : beyond_);
            }

        private:
            double here_;
            double beyond_;
        };

        /* The better of two goals is the one beyond the wall, 13.2 away; the other one is visible from the start. */
        TEST(Goals, TheBestIsTheOneWithTheBestSumOfPathAndTerminalCost)
        {
            for (const auto &[here, beyond] : {std::pair{100.0, 0.0}, {0.0, -100.0}})
            {
                const auto problem = test::wallProblem();
                const auto goals = std::make_shared<ob::GoalStates>(problem->si);
                goals->addState(problem->state({3.0, 1.0}));
                goals->addState(problem->state({9.0, 1.0}));
                problem->pdef->setGoal(goals);
                problem->pdef->setOptimizationObjective(std::make_shared<PricedEnds>(problem->si, here, beyond));
                const auto planner = problem->planner(test::PlannerVariant::Default);
                ASSERT_EQ(planner->solve(test::afterCalls(60000)), ob::PlannerStatus::EXACT_SOLUTION);
                EXPECT_NEAR(planner->bestCost(), test::wallOptimum() + beyond, 0.1) << here << " and " << beyond;
            }
        }

        TEST_P(Objectives, WithoutOneThePathLengthIsTaken)
        {
            const auto problem = test::wallProblem();
            const auto planner = problem->planner(GetParam());
            ASSERT_EQ(planner->solve(test::afterCalls(20000)), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_NEAR(planner->bestCost(), problem->path().length(), 1e-9);
            EXPECT_GE(planner->bestCost(), test::wallOptimum() - 0.2);
            EXPECT_LE(planner->bestCost(), 1.1 * test::wallOptimum());
        }
    }  // namespace
}  // namespace ompl_mfa::planner
