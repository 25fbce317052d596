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

#include "anytime/PlannerRun.h"

#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "anytime/Campaign.h"
#include "anytime/WorldList.h"
#include "ompl_mfa/InputError.h"

using ompl_mfa::campaign::Json;
using ompl_mfa::campaign::RunProcess;

namespace ompl_mfa::anytime
{
    namespace
    {
        const World &world()
        {
            static const World WORLD = selectWorlds("^wall_gap_2d_1$").front();
            return WORLD;
        }

        RunRequest request(const std::string &planner = "rrtconnect", double limit = 0.2)
        {
            return {&world(), planner, 1, limit, Clock::CPU};
        }

        std::unique_ptr<RunProcess> runToEnd(const campaign::Work &work)
        {
            auto process = std::make_unique<RunProcess>(work.body, work.limits, work.state);
            process->wait();
            return process;
        }

        Json recordOf(const campaign::Work &work)
        {
            return work.report(*runToEnd(work)).record;
        }

        Json recordOf(const RunBody &body)
        {
            return recordOf(makeWork(request(), body));
        }
    }  // namespace

    TEST(PlannerRun, FindsAPathThatComesBack)
    {
        const auto work = makeWork(request("rrtconnect", 10.0));
        const auto report = work.report(*runToEnd(work));
        EXPECT_FALSE(report.failed);
        EXPECT_EQ(report.text.rfind("returned, cost ", 0), 0U) << report.text;
        const Json &run = report.record;
        EXPECT_EQ(run["family"], "wall_gap_2d");
        EXPECT_EQ(run["status"], "returned");
        EXPECT_EQ(run["note"], "");
        EXPECT_EQ(run["solved"], true);
        EXPECT_EQ(run["valid"], true);
        EXPECT_TRUE(run["strict"].is_boolean());
        EXPECT_GE(run["cost"], world().optimum() * (1.0 - 1e-3));
        ASSERT_GE(run["path"].size(), 2U);
        EXPECT_EQ(run["path"].front(), (Json{0.1, 0.5}));
        EXPECT_EQ(run["path"].back(), (Json{0.9, 0.5}));
        EXPECT_GT(run["checks"], run["path_checks"]);
        EXPECT_GT(run["path_check"], 0.0);
        EXPECT_GT(run["wall"], 0.0);
        EXPECT_GT(run["cpu"], 0.0);
        EXPECT_TRUE(run.contains("looks") && run.contains("longest_gap"));
    }

    TEST(PlannerRun, TellsWhetherThePathHoldsAtAFinerResolution)
    {
        // the shortest path touches the wall's corners
        for (const unsigned int strictness : {1U, STRICTNESS})
        {
            const Json run = recordOf(makeWork(request("mfa:seed=3,strictness=" + std::to_string(strictness))));
            EXPECT_EQ(run["valid"], true);
            EXPECT_EQ(run["strict"], strictness > 1) << strictness;
        }
    }

    TEST(PlannerRun, KeepsWhatWasLoggedBeforeASegmentationFault)
    {
        const Json run = recordOf(
            [](const RunRequest &, RunMemory &memory) -> RunResult
            {
                memory.log.entries[0] = {0.5, 0.25, 7.0, 100};
                memory.log.count = 1;
                std::signal(SIGSEGV, SIG_DFL);
                std::raise(SIGSEGV);
                return {};
            });
        EXPECT_EQ(run["status"], "signal SEGV");
        EXPECT_EQ(run["solved"], false);
        EXPECT_TRUE(run["cost"].is_null());
        EXPECT_EQ(run["improvements"], (Json{{0.5, 0.25, 7.0, 100}}));
    }

    TEST(PlannerRun, TellsWhatAnAbortingPlannerSaid)
    {
        const Json run = recordOf(
            [](const RunRequest &, RunMemory &) -> RunResult
            {
                std::fputs("first\nassertion failed\n", stderr);
                std::signal(SIGABRT, SIG_DFL);
                std::raise(SIGABRT);
                return {};
            });
        EXPECT_EQ(run["status"], "signal ABRT");
        EXPECT_EQ(run["note"], "assertion failed");
    }

    TEST(PlannerRun, IsKilledWhenItNeverReturns)
    {
        const Json run = recordOf(
            [](const RunRequest &, RunMemory &memory) -> RunResult
            {
                campaign::startSolving(memory);
                while (memory.phase == campaign::RunPhase::Solving)
                {
                    ;
                }
                return {};
            });
        EXPECT_EQ(run["status"], "killed");
    }

    TEST(PlannerRun, IsStoppedWhenItAllocatesWithoutEnd)
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "the sanitizer ends the process itself when an allocation fails";
#endif
        const Json run = recordOf(
            [](const RunRequest &, RunMemory &) -> RunResult
            {
                std::vector<std::vector<char>> all;
                while (true)
                {
                    all.emplace_back();
                    all.back().reserve(std::size_t{1} << 30);
                }
            });
        EXPECT_EQ(run["status"], "out of memory");
    }

    TEST(PlannerRun, TellsExceptionsOfPlannersFromBadRequests)
    {
        const Json run = recordOf([](const RunRequest &, RunMemory &) -> RunResult { throw std::logic_error("no"); });
        EXPECT_EQ(run["status"], "exception");
        EXPECT_EQ(run["note"], "no");
        const auto process = runToEnd(makeWork(request("rrtconnect:no_such_parameter=1")));
        EXPECT_TRUE(process->refused());
        EXPECT_NE(process->lastLine().find("no_such_parameter"), std::string::npos) << process->lastLine();
    }
}  // namespace ompl_mfa::anytime
