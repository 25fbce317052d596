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

#include "anytime/RunProcess.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <sched.h>

#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"

namespace anytime = ompl_mfa::anytime;
using anytime::RunRequest;
using anytime::RunResult;

namespace
{
    int someCore()
    {
        return sched_getcpu();
    }

    const anytime::World &world()
    {
        static const anytime::World WORLD = anytime::selectWorlds("^wall_gap_2d_1$").front();
        return WORLD;
    }

    RunRequest request(const std::string &planner = "rrtconnect", double limit = 0.2)
    {
        return {&world(), planner, 1, limit, anytime::Clock::CPU};
    }

    void finish(anytime::RunProcess &run)
    {
        while (!run.finished())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    std::string statusOf(const anytime::RunBody &body)
    {
        anytime::RunProcess run(request(), someCore(), body);
        finish(run);
        return run.status();
    }
}  // namespace

TEST(RunProcess, APlannerRunsAndItsPathComesBack)
{
    anytime::RunProcess run(request("rrtconnect", 10.0), someCore());
    finish(run);
    const RunResult &result = run.result();
    EXPECT_EQ(run.status(), "returned") << run.note();
    EXPECT_TRUE(result.solved);
    EXPECT_TRUE(result.valid);
    EXPECT_GE(result.cost, world().optimum() * (1.0 - 1e-3));
    ASSERT_GE(result.states, 2U);
    EXPECT_EQ(result.reals, 2 * result.states);
    EXPECT_DOUBLE_EQ(result.path[0], 0.1);
    EXPECT_DOUBLE_EQ(result.path[result.reals - 2], 0.9);
    EXPECT_GT(result.checks, result.pathChecks);
    EXPECT_GT(result.pathCheck, 0.0);
}

TEST(RunProcess, SurvivesASegmentationFaultAndKeepsWhatWasLogged)
{
    anytime::RunProcess run(request(), someCore(),
                            [](const RunRequest &, RunResult &result)
                            {
                                result.log.entries[0].cost = 7.0;
                                result.log.count = 1;
                                std::signal(SIGSEGV, SIG_DFL);
                                std::raise(SIGSEGV);
                            });
    finish(run);
    EXPECT_EQ(run.status(), "signal SEGV");
    ASSERT_EQ(run.result().log.count, 1U);
    EXPECT_EQ(run.result().log.entries[0].cost, 7.0);
}

TEST(RunProcess, TellsWhatAnAbortingPlannerSaid)
{
    anytime::RunProcess run(request(), someCore(),
                            [](const RunRequest &, RunResult &)
                            {
                                std::fputs("first\nassertion failed\n", stderr);
                                std::signal(SIGABRT, SIG_DFL);
                                std::raise(SIGABRT);
                            });
    finish(run);
    EXPECT_EQ(run.status(), "signal ABRT");
    EXPECT_EQ(run.note(), "assertion failed");
}

TEST(RunProcess, KillsWhatNeverReturns)
{
    EXPECT_EQ(statusOf(
                  [](const RunRequest &, RunResult &result)
                  {
                      result.stage = anytime::Stage::SOLVING;
                      while (result.stage == anytime::Stage::SOLVING)
                          ;
                  }),
              "killed");
}

TEST(RunProcess, StopsWhatAllocatesWithoutEnd)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "addresses cannot be limited under a sanitizer";
#endif
    EXPECT_EQ(statusOf(
                  [](const RunRequest &, RunResult &)
                  {
                      std::vector<std::vector<char>> all;
                      while (true)
                      {
                          all.emplace_back();
                          all.back().reserve(std::size_t{1} << 30);
                      }
                  }),
              "out of memory");
}

TEST(RunProcess, TellsExceptionsOfPlannersFromBadRequests)
{
    EXPECT_EQ(statusOf([](const RunRequest &, RunResult &) { throw std::logic_error("no"); }), "exception");
    EXPECT_EQ(statusOf([](const RunRequest &, RunResult &) { throw ompl_mfa::InputError("no"); }), "bad request");
    anytime::RunProcess run(request("rrtconnect:no_such_parameter=1"), someCore());
    finish(run);
    EXPECT_EQ(run.status(), "bad request");
    EXPECT_NE(run.note().find("no_such_parameter"), std::string::npos);
}

TEST(RunProcess, BindsARunToItsCore)
{
    const int core = someCore();
    anytime::RunProcess run(request(), core,
                            [](const RunRequest &, RunResult &result)
                            {
                                cpu_set_t cores;
                                sched_getaffinity(0, sizeof(cores), &cores);
                                result.checks = CPU_COUNT(&cores);
                                result.states = static_cast<std::size_t>(sched_getcpu());
                            });
    finish(run);
    EXPECT_EQ(run.result().checks, 1U);
    EXPECT_EQ(run.result().states, static_cast<std::size_t>(core));
}
