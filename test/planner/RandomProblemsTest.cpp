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

/* Two thousand random problems, each solved within a few milliseconds: every result must be correct. */

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>
#include <ompl/util/Console.h>

#include "path/StateChart.h"
#include "planner/DistanceGoal.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace ompl_mfa::planner
{
    namespace
    {
        constexpr unsigned int PROBLEMS_A_SPACE = 334;
        /* Seconds after the condition turned true. A motion check of these problems takes far less. */
        constexpr double LONGEST_OVERRUN = 0.01;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        constexpr double SLOWDOWN = 20.0;
#else
        constexpr double SLOWDOWN = 1.0;
#endif

        /* Processor seconds of this thread: other programs on a loaded machine do not count. */
        double processorTime()
        {
            timespec time{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        }

        /* Balls in the positions of a space. */
        class Balls : public ob::StateValidityChecker
        {
        public:
            Balls(const ob::SpaceInformationPtr &si, unsigned int count, ompl::RNG &rng)
              : StateValidityChecker(si)
              , chart_(si->getStateSpace())
              , centers_(chart_.positionDimension(), count)
              , positions_(chart_.positionDimension())
            {
                for (Eigen::Index i = 0; i < centers_.size(); ++i)
                {
                    centers_(i) = rng.uniformReal(-10.0, 10.0);
                }
                for (unsigned int i = 0; i < count; ++i)
                {
                    radii_.push_back(rng.uniformReal(0.5, 2.5) * std::sqrt(0.5 * static_cast<double>(centers_.rows())));
                }
            }

            bool isValid(const ob::State *state) const override
            {
                return clearance(state) > 0.0;
            }

            double clearance(const ob::State *state) const override
            {
                chart_.positions(state, positions_);
                double nearest = 20.0;
                for (Eigen::Index i = 0; i < centers_.cols(); ++i)
                {
                    nearest = std::min(nearest, (centers_.col(i) - positions_).norm() - radii_[i]);
                }
                return nearest;
            }

        private:
            path::StateChart chart_;
            Eigen::MatrixXd centers_;
            mutable Eigen::VectorXd positions_;
            std::vector<double> radii_;
        };

        /* Results for the problems of one space. */
        struct Tally
        {
            unsigned int exact{0};
            unsigned int approximate{0};
            unsigned int timeouts{0};
            unsigned int limited{0};   ///< solves that ended by the condition
            unsigned int compared{0};  ///< costs that were recomputed
            double longestOverrun{0.0};
        };

        class RandomProblem
        {
        public:
            RandomProblem(const ob::StateSpacePtr &space, unsigned int number)
              : rng_(1 + number)
              , number_(number)
              , si_(std::make_shared<ob::SpaceInformation>(space))
            {
                si_->setStateValidityChecker(std::make_shared<Balls>(si_, number % 12, rng_));
                si_->setup();
                pdef_ = std::make_shared<ob::ProblemDefinition>(si_);
            }

            /* False if no valid start and goal were found. */
            bool make()
            {
                const ob::StateSpacePtr &space = si_->getStateSpace();
                const path::StateChart chart(space);
                std::vector<ob::ScopedState<>> ends;
                for (int i = 0; i < 100 && ends.size() < 4; ++i)
                {
                    ob::ScopedState<> state(space);
                    chart.sampleUniform(rng_, state.get());
                    if (si_->isValid(state.get()))
                    {
                        ends.push_back(state);
                    }
                }
                if (ends.size() < 4)
                {
                    return false;
                }
                pdef_->addStartState(ends[0]);
                if (number_ % 5 == 1)
                {
                    pdef_->addStartState(ends[1]);
                }
                pdef_->setGoal(goal(ends[2].get(), ends[3].get()));
                pdef_->setOptimizationObjective(objective());
                return true;
            }

            void solve(Tally &tally)
            {
                const std::array<const char *, 4> sizes{"4", "10", "30", "100"};
                MFA planner(si_);
                test::set(planner, "population_size", sizes[number_ % sizes.size()]);
                test::set(planner, "slices", std::to_string(1 + number_ % 17));
                test::set(planner, "seed", std::to_string(1 + number_));
                if (number_ % 3 == 0)
                {
                    test::set(planner, "variant", number_ % 2 == 0 ? "fa" : "mfa");
                }
                planner.setProblemDefinition(pdef_);
                planner.setup();
                // some are solved in two calls
                for (unsigned int i = 0; i < 1 + number_ % 2; ++i)
                {
                    const ob::PlannerStatus status = timedSolve(planner, tally);
                    check(planner, status, tally);
                }
            }

        private:
            ob::GoalPtr goal(const ob::State *first, const ob::State *second)
            {
                if (number_ % 7 == 3)
                {
                    return std::make_shared<test::DistanceGoal>(si_, first,
                                                                0.05 * si_->getStateSpace()->getMaximumExtent());
                }
                auto goals = std::make_shared<ob::GoalStates>(si_);
                goals->addState(first);
                if (number_ % 7 == 5)
                {
                    goals->addState(second);
                }
                return goals;
            }

            ob::OptimizationObjectivePtr objective() const
            {
                switch (number_ % 11)
                {
                    case 3:
                        return std::make_shared<ob::MaximizeMinClearanceObjective>(si_);
                    case 5:
                        return std::make_shared<ob::StateCostIntegralObjective>(si_, true);
                    case 7:
                        return std::make_shared<ob::MechanicalWorkOptimizationObjective>(si_);
                    case 9:
                        return nullptr;
                    default:
                        return std::make_shared<ob::PathLengthOptimizationObjective>(si_);
                }
            }

            /* The overrun is the processor time since the condition was last false, which is an upper bound: the limit
               was somewhere in between. */
            ob::PlannerStatus timedSolve(MFA &planner, Tally &tally)
            {
                const double limit = processorTime() + SLOWDOWN * rng_.uniformReal(0.0, 0.03);
                double lastFalse = processorTime();
                const ob::PlannerTerminationCondition ptc(
                    [&]
                    {
                        const double now = processorTime();
                        if (now >= limit)
                        {
                            return true;
                        }
                        lastFalse = now;
                        return false;
                    });
                const ob::PlannerStatus status = planner.solve(ptc);
                if (processorTime() >= limit)
                {
                    const double overrun = processorTime() - std::max(lastFalse, limit);
                    EXPECT_LT(overrun, SLOWDOWN * LONGEST_OVERRUN) << "problem " << number_;
                    ++tally.limited;
                    tally.longestOverrun = std::max(tally.longestOverrun, overrun);
                }
                return status;
            }

            void check(const MFA &planner, const ob::PlannerStatus &status, Tally &tally) const
            {
                if (status == ob::PlannerStatus::TIMEOUT)
                {
                    ++tally.timeouts;
                    EXPECT_FALSE(pdef_->hasSolution()) << "problem " << number_;
                    return;
                }
                ASSERT_TRUE(status) << status.asString() << ", problem " << number_;
                auto &path = *pdef_->getSolutionPath()->as<og::PathGeometric>();
                EXPECT_TRUE(path.check()) << status.asString() << ", problem " << number_;
                const ob::State *last = path.getState(path.getStateCount() - 1);
                const auto &space = si_->getStateSpace();
                bool fromStart = false;
                for (unsigned int i = 0; i < pdef_->getStartStateCount(); ++i)
                {
                    fromStart = fromStart || space->equalStates(path.getState(0), pdef_->getStartState(i));
                }
                EXPECT_TRUE(fromStart) << "problem " << number_;
                double distance = 0.0;
                const bool reached = pdef_->getGoal()->isSatisfied(last, &distance);
                if (status == ob::PlannerStatus::EXACT_SOLUTION)
                {
                    ++tally.exact;
                    EXPECT_TRUE(reached) << "problem " << number_;
                    EXPECT_TRUE(pdef_->hasExactSolution()) << "problem " << number_;
                    if (const auto &objective = pdef_->getOptimizationObjective())
                    {
                        const double cost = path.cost(objective).value();
                        ++tally.compared;
                        EXPECT_NEAR(planner.bestCost(), cost, 1e-6 * std::abs(cost)) << "problem " << number_;
                    }
                }
                else
                {
                    ++tally.approximate;
                    EXPECT_EQ(pdef_->getSolutionDifference(), distance) << "problem " << number_;
                }
            }

            ompl::RNG rng_;
            unsigned int number_;
            ob::SpaceInformationPtr si_;
            ob::ProblemDefinitionPtr pdef_;
        };

        class RandomProblems : public ::testing::TestWithParam<test::NamedSpace>
        {
        };

        INSTANTIATE_TEST_SUITE_P(Planner, RandomProblems,
                                 ::testing::Values(test::NamedSpace{"R2", [] { return test::realVectorSpace(2); }},
                                                   test::NamedSpace{"R6", [] { return test::realVectorSpace(6); }},
                                                   test::NamedSpace{"SE2", [] { return test::se2Space(); }},
                                                   test::NamedSpace{"SE3", [] { return test::se3Space(); }},
                                                   test::NamedSpace{"TwoSE2", test::twoSe2Space},
                                                   test::NamedSpace{"ReedsShepp",
                                                                    [] { return test::reedsSheppSpace(); }}),
                                 test::SpaceName());

        TEST_P(RandomProblems, AreAnsweredTrulyAndInTime)
        {
            const auto level = ompl::msg::getLogLevel();
            ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
            Tally tally;
            unsigned int solved = 0;
            for (unsigned int number = 0; solved < PROBLEMS_A_SPACE; ++number)
            {
                RandomProblem problem(GetParam().make(), number);
                if (!problem.make())
                {
                    continue;
                }
                problem.solve(tally);
                ++solved;
            }
            ompl::msg::setLogLevel(level);
            std::cout << GetParam().name << ": " << solved << " problems, " << tally.exact << " exact, "
                      << tally.approximate << " approximate, " << tally.timeouts << " without a path; longest overrun "
                      << 1e3 * tally.longestOverrun << " ms\n";
            EXPECT_GT(tally.exact, solved / 2);
            EXPECT_GT(tally.limited, solved / 4);
            EXPECT_GT(tally.compared, solved / 4);
        }

        /* Data that grow with the search (a roadmap of a million motions here) must not take long to grow. */
        TEST(LongSearch, LooksAtTheConditionAllTheTime)
        {
            const auto space = test::realVectorSpace(2);
            const auto si = std::make_shared<ob::SpaceInformation>(space);
            ompl::RNG rng(3);
            si->setStateValidityChecker(std::make_shared<Balls>(si, 25, rng));
            si->setup();
            const auto pdef = std::make_shared<ob::ProblemDefinition>(si);
            ob::ScopedState<> start(space);
            ob::ScopedState<> goal(space);
            do
            {
                space->allocDefaultStateSampler()->sampleUniform(start.get());
                space->allocDefaultStateSampler()->sampleUniform(goal.get());
            } while (!si->isValid(start.get()) || !si->isValid(goal.get()) || si->checkMotion(start.get(), goal.get()));
            pdef->setStartAndGoalStates(start, goal);
            MFA planner(si);
            test::set(planner, "guide", "roadmap");
            test::set(planner, "seed", "3");
            planner.setProblemDefinition(pdef);
            const double limit = processorTime() + 4.0;
            double last = processorTime();
            double longest = 0.0;
            planner.solve(ob::PlannerTerminationCondition(
                [&]
                {
                    const double now = processorTime();
                    longest = std::max(longest, now - last);
                    last = now;
                    return now > limit;
                }));
            std::cout << "longest time between two looks at the condition: " << 1e3 * longest << " ms\n";
            EXPECT_LT(longest, SLOWDOWN * LONGEST_OVERRUN);
        }
    }  // namespace
}  // namespace ompl_mfa::planner
