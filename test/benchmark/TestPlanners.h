#ifndef OMPL_MFA_TEST_BENCHMARK_TEST_PLANNERS_
#define OMPL_MFA_TEST_BENCHMARK_TEST_PLANNERS_

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <ompl/base/Planner.h>

namespace ompl_mfa_test
{
    /* A planner whose solve() is a function. It publishes the best cost 7 and a series of values that break parsers. */
    class TestPlanner : public ompl::base::Planner
    {
    public:
        using Solve = std::function<ompl::base::PlannerStatus(const ompl::base::PlannerTerminationCondition &)>;

        TestPlanner(const ompl::base::SpaceInformationPtr &si, const std::string &name, Solve solve)
          : ompl::base::Planner(si, name)
          , solve_(std::move(solve))
        {
            addPlannerProgressProperty("best cost REAL", [] { return "7"; });
            addPlannerProgressProperty("odd value REAL", [] { return "-nan"; });
        }

        ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override
        {
            return solve_(ptc);
        }

    private:
        Solve solve_;
    };

    inline ompl::base::PlannerAllocator testPlanner(const std::string &name, const TestPlanner::Solve &solve)
    {
        return [name, solve](const ompl::base::SpaceInformationPtr &si)
        { return std::make_shared<TestPlanner>(si, name, solve); };
    }

    inline ompl::base::PlannerAllocator crashingPlanner()
    {
        return testPlanner("Crashing",
                           [](const ompl::base::PlannerTerminationCondition &) -> ompl::base::PlannerStatus
                           {
                               signal(SIGSEGV, SIG_DFL);
                               raise(SIGSEGV);
                               return ompl::base::PlannerStatus::UNKNOWN;
                           });
    }

    inline ompl::base::PlannerAllocator abortingPlanner()
    {
        return testPlanner("Aborting",
                           [](const ompl::base::PlannerTerminationCondition &) -> ompl::base::PlannerStatus
                           {
                               signal(SIGABRT, SIG_DFL);
                               std::abort();
                           });
    }

    inline ompl::base::PlannerAllocator hangingPlanner()
    {
        return testPlanner("Hanging",
                           [](const ompl::base::PlannerTerminationCondition &) -> ompl::base::PlannerStatus
                           {
                               while (true)
                               {
                                   pause();
                               }
                           });
    }

    inline ompl::base::PlannerAllocator allocatingPlanner()
    {
        return testPlanner("Allocating",
                           [](const ompl::base::PlannerTerminationCondition &) -> ompl::base::PlannerStatus
                           {
                               std::vector<std::unique_ptr<char[]>> blocks;
                               while (true)
                               {
                                   blocks.push_back(std::make_unique<char[]>(1 << 20));
                                   std::memset(blocks.back().get(), 1, 1 << 20);
                               }
                           });
    }

    inline ompl::base::PlannerAllocator throwingPlanner()
    {
        return testPlanner("Throwing",
                           [](const ompl::base::PlannerTerminationCondition &) -> ompl::base::PlannerStatus
                           { throw std::runtime_error("this planner throws"); });
    }

    inline ompl::base::PlannerAllocator exitingPlanner()
    {
        return testPlanner(
            "Exiting", [](const ompl::base::PlannerTerminationCondition &) -> ompl::base::PlannerStatus { _exit(3); });
    }
}  // namespace ompl_mfa_test

#endif
