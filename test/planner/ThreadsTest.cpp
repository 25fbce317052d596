/* Several threads: two planners on one space information, and a planner that is watched while it plans. */

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <ompl/base/PlannerData.h>

#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        class Threads : public ::testing::TestWithParam<test::Engine>
        {
        protected:
            std::unique_ptr<test::PlanningProblem> problem_ = test::wallProblem();
        };

        INSTANTIATE_TEST_SUITE_P(Planner, Threads, ::testing::Values(test::Engine::Default, test::Engine::Paper),
                                 test::EngineName());

        TEST_P(Threads, TwoPlannersShareOneSpaceInformation)
        {
            std::vector<std::thread> threads;
            std::atomic<int> solved{0};
            for (unsigned int i = 0; i < 2; ++i)
            {
                threads.emplace_back(
                    [this, i, &solved]
                    {
                        const auto pdef = std::make_shared<ob::ProblemDefinition>(problem_->si);
                        pdef->setStartAndGoalStates(problem_->state({1.0, 1.0 + i}), problem_->state({9.0, 1.0}));
                        for (unsigned int run = 0; run < 3; ++run)
                        {
                            const auto planner = test::makePlanner(problem_->si, GetParam(), 10 * i + run + 1);
                            planner->setProblemDefinition(pdef);
                            planner->solve(test::afterCalls(2000));
                            pdef->clearSolutionPaths();
                            if (planner->solve(test::untilExact(pdef)) == ob::PlannerStatus::EXACT_SOLUTION &&
                                pdef->getSolutionPath()->check())
                                ++solved;
                            pdef->clearSolutionPaths();
                        }
                    });
            }
            for (auto &thread : threads)
                thread.join();
            EXPECT_EQ(solved, 6);
        }

        TEST_P(Threads, ProgressMayBeWatchedWhileItPlans)
        {
            const auto planner = problem_->planner(GetParam());
            planner->setup();
            std::atomic<bool> done{false};
            std::atomic<unsigned int> watched{0};
            std::thread watcher(
                [&]
                {
                    double best = std::numeric_limits<double>::infinity();
                    while (!done)
                    {
                        for (const auto &[name, property] : planner->getPlannerProgressProperties())
                            EXPECT_FALSE(property().empty()) << name;
                        const double cost = planner->bestCost();
                        EXPECT_LE(cost, best);
                        best = cost;
                        ++watched;
                    }
                });
            planner->solve(ob::PlannerTerminationCondition([&watched, ptc = test::afterCalls(3000)]
                                                           { return ptc() && watched > 10; }));
            done = true;
            watcher.join();
        }

        TEST_P(Threads, PlannerDataMayBeAskedForWhileItPlans)
        {
            const auto planner = problem_->planner(GetParam());
            planner->setup();
            std::atomic<bool> done{false};
            std::atomic<unsigned int> asked{0};
            std::thread watcher(
                [&]
                {
                    while (!done)
                    {
                        ob::PlannerData data(problem_->si);
                        planner->getPlannerData(data);
                        data.decoupleFromPlanner();
                        for (unsigned int i = 0; i < data.numVertices(); ++i)
                            EXPECT_TRUE(problem_->si->satisfiesBounds(data.getVertex(i).getState()));
                        planner->getSwarmPaths();
                        planner->getSlicePaths();
                        if (data.numVertices() > 0)
                            ++asked;
                    }
                });
            // answered while the search runs, not only at its end
            const auto enough = ob::PlannerTerminationCondition([&asked] { return asked >= 3; });
            planner->solve(ob::plannerOrTerminationCondition(enough, ob::timedPlannerTerminationCondition(60.0)));
            EXPECT_GE(asked, 3U);
            done = true;
            watcher.join();
        }
    }  // namespace
}  // namespace ompl_mfa
