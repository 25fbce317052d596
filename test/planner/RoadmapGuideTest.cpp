#include "engine/guides/RoadmapPart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include "ompl_mfa/planner/MFA.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        /* A roadmap for the wall of PlanningProblem.h, with its query. */
        class RoadmapGuideTest : public ::testing::Test
        {
        protected:
            RoadmapGuideTest()
            {
                planner_.setProblemDefinition(problem_->pdef);
                inputs_.use(problem_->pdef);
                query_.reset(*problem_->pdef);
                query_.begin(inputs_, ob::plannerNonTerminatingCondition(), chart_, problem_->si, 1);
            }

            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
            MFA planner_{problem_->si};
            StateChartPtr chart_ = std::make_shared<const StateChart>(problem_->si->getStateSpace());
            PathEvaluator evaluator_{problem_->si, std::make_shared<ob::PathLengthOptimizationObjective>(problem_->si)};
            ob::PlannerInputStates inputs_;
            Query query_{problem_->si->getStateSpace()};
            Waypoints path_{problem_->si->getStateSpace()};
        };

        TEST_F(RoadmapGuideTest, FindsValidPathsAndBetterOnesAsItGrows)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            double best = std::numeric_limits<double>::infinity();
            int found = 0;
            for (int turn = 0; turn < 400 && found < 4; ++turn)
            {
                if (!roadmap.advance(query_, best, 5000, path_))
                    continue;
                ++found;
                EXPECT_TRUE(evaluator_.checkPath(path_));
                EXPECT_TRUE(problem_->si->equalStates(path_.front(), query_.starts()[0]));
                EXPECT_TRUE(problem_->si->equalStates(path_.back(), query_.goals()[0]));
                best = std::min(best, evaluator_.cost(path_).value());
            }
            EXPECT_EQ(found, 4);
        }

        TEST_F(RoadmapGuideTest, StopsWithTheCondition)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            evaluator_.setStopCondition([] { return true; });
            EXPECT_FALSE(roadmap.advance(query_, std::numeric_limits<double>::infinity(), 1000000, path_));
        }

        TEST_F(RoadmapGuideTest, TheSeedDecidesThePath)
        {
            const auto firstCost = [this](std::uint_fast32_t seed)
            {
                RoadmapGuide roadmap(&planner_, chart_, evaluator_, seed);
                while (!roadmap.advance(query_, std::numeric_limits<double>::infinity(), 5000, path_))
                {
                }
                return evaluator_.cost(path_).value();
            };
            EXPECT_EQ(firstCost(5), firstCost(5));
            EXPECT_NE(firstCost(5), firstCost(6));
        }

        TEST_F(RoadmapGuideTest, ExplainsItsStatesAndTheMotionsThatItFoundValid)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            while (!roadmap.advance(query_, std::numeric_limits<double>::infinity(), 5000, path_))
            {
            }
            SearchGraph graph(problem_->si->getStateSpace());
            graph.states.append(query_.starts()[0]);
            roadmap.explain(graph);
            EXPECT_GT(graph.states.size(), 50U);
            ASSERT_EQ(graph.starts.size(), 1U);
            ASSERT_EQ(graph.goals.size(), 1U);
            EXPECT_TRUE(problem_->si->equalStates(graph.states[graph.starts[0]], query_.starts()[0]));
            EXPECT_TRUE(problem_->si->equalStates(graph.states[graph.goals[0]], query_.goals()[0]));
            for (std::size_t v = 0; v < graph.states.size(); ++v)
                EXPECT_TRUE(problem_->si->isValid(graph.states[v]));
            for (const auto &[from, to] : graph.edges)
                EXPECT_TRUE(problem_->si->checkMotion(graph.states[from], graph.states[to]));
            for (std::size_t i = 1; i < path_.size(); ++i)
            {
                bool known = false;
                for (const auto &[from, to] : graph.edges)
                    known = known || (problem_->si->equalStates(graph.states[from], path_[i - 1]) &&
                                      problem_->si->equalStates(graph.states[to], path_[i]));
                EXPECT_TRUE(known) << i;
            }
        }

        /* What the roadmap has after so many turns with a bound that falls with its paths. */
        struct Growth
        {
            std::size_t largest{0};
            double best{std::numeric_limits<double>::infinity()};
            int improvements{0};
        };

        class RoadmapGrowthTest : public RoadmapGuideTest
        {
        protected:
            std::size_t size(const RoadmapGuide &roadmap) const
            {
                SearchGraph graph(problem_->si->getStateSpace());
                roadmap.explain(graph);
                return graph.states.size();
            }

            Growth grow(RoadmapGuide &roadmap, int turns)
            {
                Growth growth;
                for (int turn = 0; turn < turns; ++turn)
                {
                    if (roadmap.advance(query_, growth.best, 5000, path_))
                    {
                        EXPECT_TRUE(evaluator_.checkPath(path_));
                        const double cost = evaluator_.cost(path_).value();
                        growth.improvements += cost < growth.best ? 1 : 0;
                        growth.best = std::min(growth.best, cost);
                    }
                    if (turn % 4 == 0)
                        growth.largest = std::max(growth.largest, size(roadmap));
                }
                return growth;
            }
        };

        /* Of 10000 edges 600 states have all, k being 16 and more. */
        TEST_F(RoadmapGrowthTest, StaysWithinItsCapacityWhileThePathImproves)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5, 10000);
            const Growth first = grow(roadmap, 200);
            EXPECT_LT(first.largest, 700U);
            EXPECT_LT(first.best, 1.05 * test::wallOptimum());
            const Growth later = grow(roadmap, 800);
            // the capacity grows with the logarithm of the number of roadmaps
            EXPECT_LT(later.largest, 1100U);
            EXPECT_LT(std::min(first.best, later.best), 1.02 * test::wallOptimum());
        }

        /* States drawn before there was a bound, of which few are of use once it is near the optimum. */
        TEST_F(RoadmapGrowthTest, LosesWhatNoBetterPathCanLeadThrough)
        {
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            while (size(roadmap) < 1500)
                roadmap.advance(query_, std::numeric_limits<double>::infinity(), 5000, path_);
            const double bound = test::wallOptimum() / 1.15;
            for (int turn = 0; turn < 200; ++turn)
                roadmap.advance(query_, bound, 5000, path_);
            SearchGraph graph(problem_->si->getStateSpace());
            roadmap.explain(graph);
            const auto &space = *problem_->si->getStateSpace();
            int beyond = 0;
            for (std::size_t v = 0; v < graph.states.size(); ++v)
            {
                if (space.distance(query_.starts()[0], graph.states[v]) +
                        space.distance(graph.states[v], query_.goals()[0]) >
                    1.15 * bound)
                    ++beyond;
            }
            EXPECT_LT(4 * beyond, static_cast<int>(graph.states.size()) + 4);
        }

        /* A goal that is beaten keeps the states of another one: the informed sets of all pairs count. */
        TEST_F(RoadmapGrowthTest, KeepsWhatAnotherGoalNeeds)
        {
            const auto space = problem_->si->getStateSpace();
            problem_->pdef->clearStartStates();
            problem_->pdef->addStartState(problem_->state({1.0, 5.0}));
            const auto goals = std::make_shared<ob::GoalStates>(problem_->si);
            goals->addState(problem_->state({1.0, 9.5}));
            goals->addState(problem_->state({1.0, 0.5}));
            problem_->pdef->setGoal(goals);
            inputs_.clear();
            inputs_.use(problem_->pdef);
            query_.reset(*problem_->pdef);
            query_.begin(inputs_, ob::plannerNonTerminatingCondition(), chart_, problem_->si, 1);
            while (query_.goals().size() < 2)
                query_.poll(inputs_, ob::plannerNonTerminatingCondition());
            RoadmapGuide roadmap(&planner_, chart_, evaluator_, 5);
            while (size(roadmap) < 1000)
                roadmap.advance(query_, std::numeric_limits<double>::infinity(), 5000, path_);
            for (int turn = 0; turn < 200; ++turn)
                roadmap.advance(query_, 4.6, 5000, path_);
            SearchGraph graph(space);
            roadmap.explain(graph);
            std::vector<int> around(2, 0);
            for (std::size_t v = 0; v < graph.states.size(); ++v)
            {
                for (std::size_t j = 0; j < 2; ++j)
                    around[j] += space->distance(query_.starts()[0], graph.states[v]) +
                                             space->distance(graph.states[v], query_.goals()[j]) <
                                         4.6
                                     ? 1
                                     : 0;
            }
            EXPECT_GT(around[0], 20);
            EXPECT_GT(around[1], 20);
        }

        /* Motions that cross the middle of the square below the wall's gap cost more than any number. */
        class Forbidding : public ob::PathLengthOptimizationObjective
        {
        public:
            using PathLengthOptimizationObjective::PathLengthOptimizationObjective;

            ob::Cost motionCost(const ob::State *from, const ob::State *to) const override
            {
                const bool crosses = (test::coordinate(from, 0) < 5.0) != (test::coordinate(to, 0) < 5.0);
                const bool low = std::min(test::coordinate(from, 1), test::coordinate(to, 1)) < 8.0;
                return crosses && low ? infiniteCost() : PathLengthOptimizationObjective::motionCost(from, to);
            }
        };

        TEST_F(RoadmapGuideTest, GoesOnFromAPathOfInfiniteCostToAFiniteOne)
        {
            const auto objective = std::make_shared<Forbidding>(problem_->si);
            PathEvaluator evaluator(problem_->si, objective);
            RoadmapGuide roadmap(&planner_, chart_, evaluator, 5);
            double bound = std::numeric_limits<double>::infinity();
            double cost = bound;
            for (int turn = 0; turn < 400 && !std::isfinite(cost); ++turn)
            {
                if (!roadmap.advance(query_, bound, 5000, path_))
                    continue;
                cost = evaluator.cost(path_).value();
                bound = std::numeric_limits<double>::max();
            }
            EXPECT_TRUE(std::isfinite(cost));
            // also for a caller who asks for any path again and again
            RoadmapGuide another(&planner_, chart_, evaluator, 5);
            cost = std::numeric_limits<double>::infinity();
            for (int turn = 0; turn < 400 && !std::isfinite(cost); ++turn)
            {
                if (another.advance(query_, std::numeric_limits<double>::infinity(), 5000, path_))
                    cost = evaluator.cost(path_).value();
            }
            EXPECT_TRUE(std::isfinite(cost));
        }
    }  // namespace
}  // namespace ompl_mfa
