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

namespace ompl_mfa::test
{
    /* A planner whose solve() is a given function. Publishes the best cost 7 and values that are hard to parse. */
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
}  // namespace ompl_mfa::test

#endif
