/* A swarm that rests, read by several threads at once. */

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "engine/fireflies/Swarm.h"
#include "planner/PlanningProblem.h"

namespace ob = ompl::base;

namespace ompl_mfa
{
    namespace
    {
        TEST(SwarmThreads, PathsAreThoseOfTheirFireflies)
        {
            constexpr Eigen::Index SIZE = 8;
            const auto problem = test::freeProblem();
            const auto &space = problem->si->getStateSpace();
            PathEvaluator evaluator(problem->si, std::make_shared<ob::PathLengthOptimizationObjective>(problem->si));
            FireflyOptimizer::Settings settings;
            settings.populationSize = SIZE;
            Swarm swarm(SliceFrame::straight(std::make_shared<const StateChart>(space),
                                             problem->state({1.0, 1.0}).get(), problem->state({9.0, 1.0}).get(), 13),
                        Swarm::Coordinates::Modes, evaluator, settings, 3,
                        [](const Waypoints &, const Brightness &) {});
            swarm.step([] { return false; });
            std::vector<Waypoints> alone(SIZE, Waypoints(space));
            for (Eigen::Index i = 0; i < SIZE; ++i)
                swarm.pathOf(i, alone[static_cast<std::size_t>(i)]);
            std::atomic<unsigned int> wrong{0};
            std::vector<std::thread> threads;
            for (int thread = 0; thread < 4; ++thread)
            {
                threads.emplace_back(
                    [&, thread]
                    {
                        Waypoints path(space);
                        for (Eigen::Index n = thread; n < 8000; ++n)
                        {
                            swarm.pathOf(n % SIZE, path);
                            const Waypoints &expected = alone[static_cast<std::size_t>(n % SIZE)];
                            for (std::size_t k = 0; k < path.size(); ++k)
                            {
                                if (!space->equalStates(path[k], expected[k]))
                                    ++wrong;
                            }
                        }
                    });
            }
            for (auto &thread : threads)
                thread.join();
            EXPECT_EQ(wrong, 0U);
        }
    }  // namespace
}  // namespace ompl_mfa
