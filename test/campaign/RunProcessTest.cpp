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

#include "campaign/RunProcess.h"

#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::campaign
{
    namespace
    {
        /* Data of a run that survives its crash. */
        struct Notes : RunState
        {
            std::atomic<int> number{0};
            double values[1000]{};
        };

        using StateBody = std::function<std::string(RunState &)>;

        std::unique_ptr<RunProcess> runToEnd(const StateBody &body, const RunLimits &limits = RunLimits(),
                                             int core = RunProcess::ANY_CORE)
        {
            const auto state = makeShared<RunState>();
            auto process = std::make_unique<RunProcess>([body, state] { return body(*state); }, limits, state, core);
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
        EXPECT_EQ(process->termination(), RunTermination::Returned);
        EXPECT_EQ(process->result(), expected);
        EXPECT_EQ(process->signal(), 0);
    }

    TEST(RunProcess, SharesItsStateWhileAndAfterItRuns)
    {
        const auto notes = makeShared<Notes>();
        EXPECT_EQ(notes->phase, RunPhase::Preparing);
        EXPECT_EQ(notes->values[999], 0.0);
        RunProcess process(
            [notes]() -> std::string
            {
                notes->values[999] = 1.5;
                startSolving(*notes);
                notes->number = 42;
                signal(SIGABRT, SIG_DFL);
                std::abort();
            },
            RunLimits(), notes);
        process.wait();
        EXPECT_EQ(process.signal(), SIGABRT);
        EXPECT_EQ(notes->number, 42);
        EXPECT_EQ(notes->values[999], 1.5);
        EXPECT_EQ(process.state().phase, RunPhase::Solving);
        EXPECT_GT(process.state().residentAtStart, 0u);
        EXPECT_GT(process.state().solveStart, 0.0);
    }

    TEST(RunProcess, RecordsSignals)
    {
        for (const int number : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL})
        {
            const auto process = runToEnd(
                [number](RunState &) -> std::string
                {
                    // A signal handler, such as a sanitizer's, would turn the signal into an exit.
                    signal(number, SIG_DFL);
                    raise(number);
                    return "not reached";
                });
            EXPECT_EQ(process->termination(), RunTermination::Signal);
            EXPECT_EQ(process->signal(), number);
            EXPECT_EQ(process->result(), "");
        }
    }

    TEST(RunProcess, KeepsWhatAnExceptionSays)
    {
        const auto process = runToEnd([](RunState &) -> std::string { throw std::runtime_error("no path, no glory"); });
        EXPECT_EQ(process->termination(), RunTermination::Exception);
        EXPECT_EQ(process->console(), "no path, no glory");
        EXPECT_FALSE(process->refused());

        const auto input = runToEnd(
            [](RunState &) -> std::string
            {
                std::cerr << "first this\n";
                throw InputError("bad.cfg:1: no");
            });
        EXPECT_EQ(input->termination(), RunTermination::Exception);
        EXPECT_TRUE(input->refused());
        EXPECT_EQ(input->lastLine(), "bad.cfg:1: no");
    }

    TEST(RunProcess, TakesAnExitForWhatItIs)
    {
        const auto process = runToEnd([](RunState &) -> std::string { _exit(7); });
        EXPECT_EQ(process->termination(), RunTermination::Exited);
        EXPECT_EQ(process->exitStatus(), 7);
        const auto success = runToEnd([](RunState &) -> std::string { _exit(0); });
        EXPECT_EQ(success->termination(), RunTermination::Exited);
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
        EXPECT_EQ(process->termination(), RunTermination::Returned);
        EXPECT_LE(process->console().size(), 4096u);
        EXPECT_NE(process->console().find("the last words"), std::string::npos);
    }

    TEST(RunProcess, KillsWhatDoesNotReturn)
    {
        RunLimits limits;
        limits.solve = 0.3;
        const double start = monotonicSeconds();
        const auto process = runToEnd(
            [](RunState &state) -> std::string
            {
                startSolving(state);
                signal(SIGTERM, SIG_IGN);
                sleepForever();
            },
            limits);
        EXPECT_EQ(process->termination(), RunTermination::TimeLimit);
        EXPECT_EQ(process->signal(), SIGKILL);
        EXPECT_GE(monotonicSeconds() - start, 0.3);
        EXPECT_GE(process->phaseTime(), 0.3);
    }

    TEST(RunProcess, EachPhaseHasItsLimit)
    {
        RunLimits limits;
        limits.prepare = 0.2;
        const auto preparing = runToEnd([](RunState &) -> std::string { sleepForever(); }, limits);
        EXPECT_EQ(preparing->termination(), RunTermination::TimeLimit);

        limits.prepare = 100.0;
        limits.solve = 100.0;
        limits.finish = 0.2;
        const auto finishing = runToEnd(
            [](RunState &state) -> std::string
            {
                startSolving(state);
                state.phase = RunPhase::Finishing;
                sleepForever();
            },
            limits);
        EXPECT_EQ(finishing->termination(), RunTermination::TimeLimit);
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
        EXPECT_EQ(process->termination(), RunTermination::MemoryLimit);
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
        EXPECT_EQ(process->termination(), RunTermination::MemoryLimit);
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
        ASSERT_EQ(process->termination(), RunTermination::Returned);
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
                [&ends]() -> std::string
                {
                    const pid_t self = getpid();
                    if (write(ends[1], &self, sizeof(self)) < 0)
                    {
                        _exit(1);
                    }
                    sleepForever();
                },
                RunLimits(), makeShared<RunState>());
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
        const auto notes = makeShared<Notes>();
        {
            RunProcess process(
                [notes]() -> std::string
                {
                    notes->number = getpid();
                    sleepForever();
                },
                RunLimits(), notes);
            while (notes->number == 0)
            {
                EXPECT_FALSE(process.update());
            }
        }
        EXPECT_FALSE(isAlive(notes->number));
    }

    TEST(RunProcess, MayTakeSoMuchProcessorTimeOnceItSolves)
    {
        RunLimits limits;
        limits.processor = 0.2;
        limits.solve = 60.0;
        const auto burn = [](double seconds)
        {
            const auto end = static_cast<std::clock_t>(seconds * CLOCKS_PER_SEC) + std::clock();
            while (std::clock() < end)
            {
            }
        };
        const auto process = runToEnd(
            [&burn](RunState &state) -> std::string
            {
                burn(0.3);
                startSolving(state);
                burn(60.0);
                return "not reached";
            },
            limits);
        EXPECT_EQ(process->termination(), RunTermination::TimeLimit);
        EXPECT_EQ(process->state().phase, RunPhase::Solving);
        EXPECT_GE(process->state().processorAtStart, 0.3);

        const auto idle = runToEnd(
            [](RunState &state)
            {
                startSolving(state);
                std::this_thread::sleep_for(std::chrono::milliseconds(400));
                return std::string("slept");
            },
            limits);
        EXPECT_EQ(idle->termination(), RunTermination::Returned) << "time that passes is not processor time";
    }

    TEST(RunProcess, StaysOnItsCore)
    {
        const int core = sched_getcpu();
        const auto process = runToEnd(
            [](RunState &)
            {
                cpu_set_t cores;
                sched_getaffinity(0, sizeof(cores), &cores);
                return std::to_string(CPU_COUNT(&cores)) + " " + std::to_string(sched_getcpu());
            },
            RunLimits(), core);
        EXPECT_EQ(process->result(), "1 " + std::to_string(core));
    }

    TEST(DescribeTermination, HasWordsForEveryEnd)
    {
        EXPECT_EQ(describeTermination(RunTermination::Signal, SIGSEGV), "ended by signal 11 (Segmentation fault)");
        EXPECT_EQ(describeTermination(RunTermination::TimeLimit, SIGKILL), "killed at its time limit");
        EXPECT_EQ(describeTermination(RunTermination::Exception, 0), "threw an exception");
    }
}  // namespace ompl_mfa::campaign
