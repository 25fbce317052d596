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

#include "ompl_mfa/benchmark/RunProcess.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

using ompl_mfa::RunLimits;
using ompl_mfa::RunPhase;
using ompl_mfa::RunProcess;
using ompl_mfa::RunState;
using ompl_mfa::RunTermination;

namespace
{
    void startSolving(RunState &state)
    {
        state.residentAtStart = ompl_mfa::residentMemory(getpid());
        state.solveStart = ompl_mfa::monotonicSeconds();
        state.phase = RunPhase::SOLVING;
    }

    std::unique_ptr<RunProcess> runToEnd(const RunProcess::Body &body, const RunLimits &limits = RunLimits())
    {
        auto process = std::make_unique<RunProcess>(body, limits);
        process->wait();
        return process;
    }

    [[noreturn]] void sleepForever()
    {
        while (true)
        {
            pause();
        }
    }

    bool isAlive(pid_t pid)
    {
        return kill(pid, 0) == 0;
    }

    void waitUntilDead(pid_t pid)
    {
        for (int i = 0; i < 1000 && isAlive(pid); ++i)
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }
}  // namespace

TEST(RunProcess, HandsBackTextOfAnyLength)
{
    const std::string expected(3000000, 'x');
    const auto process = runToEnd([&expected](RunState &) { return expected; });
    EXPECT_EQ(process->termination(), RunTermination::RETURNED);
    EXPECT_EQ(process->result(), expected);
    EXPECT_EQ(process->signal(), 0);
}

TEST(RunProcess, SharesItsStateWhileAndAfterItRuns)
{
    const auto process = runToEnd(
        [](RunState &state) -> std::string
        {
            state.collisionChecks = 42;
            state.bestCost = 1.5;
            std::abort();
        });
    EXPECT_EQ(process->state().collisionChecks, 42u);
    EXPECT_EQ(process->state().bestCost, 1.5);
}

TEST(RunProcess, RecordsSignals)
{
    for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL})
    {
        const auto process = runToEnd(
            [number](RunState &) -> std::string
            {
                // A handler, such as a sanitizer's, would turn the signal into an exit.
                signal(number, SIG_DFL);
                raise(number);
                return "not reached";
            });
        EXPECT_EQ(process->termination(), RunTermination::SIGNAL);
        EXPECT_EQ(process->signal(), number);
        EXPECT_EQ(process->result(), "");
    }
}

TEST(RunProcess, KeepsWhatAnExceptionSays)
{
    const auto process = runToEnd([](RunState &) -> std::string { throw std::runtime_error("no path, no glory"); });
    EXPECT_EQ(process->termination(), RunTermination::EXCEPTION);
    EXPECT_EQ(process->console(), "no path, no glory");

    const auto input = runToEnd([](RunState &) -> std::string { throw ompl_mfa::InputError("bad.cfg:1: no"); });
    EXPECT_EQ(input->termination(), RunTermination::EXCEPTION);
    EXPECT_EQ(input->exitStatus(), RunProcess::INPUT_ERROR_STATUS);
    EXPECT_EQ(input->console(), "bad.cfg:1: no");
}

TEST(RunProcess, TakesAnExitForWhatItIs)
{
    const auto process = runToEnd([](RunState &) -> std::string { _exit(7); });
    EXPECT_EQ(process->termination(), RunTermination::EXITED);
    EXPECT_EQ(process->exitStatus(), 7);
    const auto success = runToEnd([](RunState &) -> std::string { _exit(0); });
    EXPECT_EQ(success->termination(), RunTermination::EXITED);
}

TEST(RunProcess, KeepsTheEndOfWhatIsPrinted)
{
    const auto process = runToEnd(
        [](RunState &)
        {
            for (int i = 0; i < 100000; ++i)
            {
                std::cout << "line " << i << "\n";
            }
            std::cerr << "the last words" << std::endl;
            return std::string("done");
        });
    EXPECT_EQ(process->termination(), RunTermination::RETURNED);
    EXPECT_LE(process->console().size(), 4096u);
    EXPECT_NE(process->console().find("the last words"), std::string::npos);
}

TEST(RunProcess, KillsWhatDoesNotReturn)
{
    RunLimits limits;
    limits.solve = 0.3;
    const double start = ompl_mfa::monotonicSeconds();
    const auto process = runToEnd(
        [](RunState &state) -> std::string
        {
            startSolving(state);
            signal(SIGTERM, SIG_IGN);
            sleepForever();
        },
        limits);
    EXPECT_EQ(process->termination(), RunTermination::TIME_LIMIT);
    EXPECT_EQ(process->signal(), SIGKILL);
    EXPECT_GE(ompl_mfa::monotonicSeconds() - start, 0.3);
    EXPECT_GE(process->phaseTime(), 0.3);
}

TEST(RunProcess, EachPhaseHasItsLimit)
{
    RunLimits limits;
    limits.prepare = 0.2;
    const auto preparing = runToEnd([](RunState &) -> std::string { sleepForever(); }, limits);
    EXPECT_EQ(preparing->termination(), RunTermination::TIME_LIMIT);

    limits.prepare = 100.0;
    limits.solve = 100.0;
    limits.finish = 0.2;
    const auto finishing = runToEnd(
        [](RunState &state) -> std::string
        {
            startSolving(state);
            state.phase = RunPhase::FINISHING;
            sleepForever();
        },
        limits);
    EXPECT_EQ(finishing->termination(), RunTermination::TIME_LIMIT);
}

TEST(RunProcess, EndsWhatAllocatesWithoutEnd)
{
    RunLimits limits;
    limits.memory = 50.0;
    limits.solve = 60.0;
    const auto process = runToEnd(
        [](RunState &state) -> std::string
        {
            startSolving(state);
            std::vector<std::unique_ptr<char[]>> blocks;
            while (true)
            {
                blocks.push_back(std::make_unique<char[]>(1 << 20));
                std::memset(blocks.back().get(), 1, 1 << 20);
            }
        },
        limits);
    EXPECT_EQ(process->termination(), RunTermination::MEMORY_LIMIT);
}

TEST(RunProcess, EndsWhatReservesWithoutTouching)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the sanitizer ends the process itself when an allocation fails";
#else
    RunLimits limits;
    limits.memory = 50.0;
    limits.solve = 60.0;
    const auto process = runToEnd(
        [](RunState &state) -> std::string
        {
            startSolving(state);
            std::vector<std::unique_ptr<char[]>> blocks;
            while (true)
            {
                blocks.emplace_back(new char[1 << 28]);
            }
        },
        limits);
    EXPECT_EQ(process->termination(), RunTermination::MEMORY_LIMIT);
#endif
}

TEST(RunProcess, LeavesNoProcessBehind)
{
    const auto process = runToEnd(
        [](RunState &)
        {
            const pid_t left = fork();
            if (left == 0)
            {
                sleepForever();
            }
            return std::to_string(left);
        });
    ASSERT_EQ(process->termination(), RunTermination::RETURNED);
    const pid_t left = std::stoi(process->result());
    waitUntilDead(left);
    EXPECT_FALSE(isAlive(left));
}

TEST(RunProcess, DiesWithItsParent)
{
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t parent = fork();
    if (parent == 0)
    {
        const RunProcess process(
            [&ends](RunState &) -> std::string
            {
                const pid_t self = getpid();
                if (write(ends[1], &self, sizeof(self)) < 0)
                {
                    _exit(1);
                }
                sleepForever();
            },
            RunLimits());
        sleepForever();
    }
    pid_t child = 0;
    ASSERT_EQ(read(ends[0], &child, sizeof(child)), static_cast<ssize_t>(sizeof(child)));
    ASSERT_TRUE(isAlive(child));
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    waitUntilDead(child);
    EXPECT_FALSE(isAlive(child));
    close(ends[0]);
    close(ends[1]);
}

TEST(RunProcess, IsKilledWhenNobodyWantsItAnyMore)
{
    pid_t child = 0;
    {
        RunProcess process(
            [](RunState &state) -> std::string
            {
                state.collisionChecks = static_cast<std::uint64_t>(getpid());
                sleepForever();
            },
            RunLimits());
        while (process.state().collisionChecks == 0)
        {
            EXPECT_FALSE(process.update());
        }
        child = static_cast<pid_t>(process.state().collisionChecks);
    }
    EXPECT_FALSE(isAlive(child));
}
