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

#include "path/WorkerPool.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace ompl_mfa::path
{
    namespace
    {
        /* Blocks the first thread until another one arrives, or for a minute. */
        class Meeting
        {
        public:
            bool await(unsigned int threads)
            {
                ++arrived_;
                const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
                while (arrived_ < threads && std::chrono::steady_clock::now() < end)
                {
                    std::this_thread::yield();
                }
                return arrived_ >= threads;
            }

        private:
            std::atomic<unsigned int> arrived_{0};
        };

        TEST(WorkerPool, TakesEveryTaskOnce)
        {
            WorkerPool pool(4);
            EXPECT_EQ(pool.threads(), 4U);
            std::vector<std::atomic<int>> taken(50);
            for (std::size_t count = 0; count <= taken.size(); ++count)
            {
                for (auto &task : taken)
                {
                    task = 0;
                }
                EXPECT_TRUE(pool.run(count,
                                     [&](std::size_t, std::size_t task)
                                     {
                                         ++taken[task];
                                         return true;
                                     }));
                for (std::size_t task = 0; task < taken.size(); ++task)
                {
                    EXPECT_EQ(taken[task], task < count ? 1 : 0) << task << " of " << count;
                }
            }
        }

        TEST(WorkerPool, AllThreadsWorkAtOnceEachUnderItsNumber)
        {
            WorkerPool pool(3);
            Meeting meeting;
            std::vector<std::atomic<int>> used(3);
            EXPECT_TRUE(pool.run(3,
                                 [&](std::size_t thread, std::size_t)
                                 {
                                     ++used[thread];
                                     return meeting.await(3);
                                 }));
            for (const auto &tasks : used)
            {
                EXPECT_EQ(tasks, 1);
            }
        }

        TEST(WorkerPool, OneThreadTakesTheTasksInOrder)
        {
            WorkerPool pool(1);
            std::vector<std::size_t> order;
            EXPECT_FALSE(pool.run(10,
                                  [&](std::size_t thread, std::size_t task)
                                  {
                                      EXPECT_EQ(thread, 0U);
                                      order.push_back(task);
                                      return task < 3;
                                  }));
            EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3}));
        }

        TEST(WorkerPool, NoTaskIsBegunLongAfterOneSaidEnough)
        {
            WorkerPool pool(2);
            std::atomic<std::size_t> taken{0};
            EXPECT_FALSE(pool.run(1000000, [&](std::size_t, std::size_t) { return ++taken < 10; }));
            EXPECT_LE(taken, 11U);
        }

        TEST(WorkerPool, AnExceptionOfAWorkerReachesTheCaller)
        {
            WorkerPool pool(2);
            for (int i = 0; i < 100; ++i)
            {
                Meeting meeting;
                const auto failing = [&](std::size_t thread, std::size_t) -> bool
                {
                    meeting.await(2);
                    if (thread != 0)
                    {
                        throw std::runtime_error("of a worker");
                    }
                    return true;
                };
                EXPECT_THROW(pool.run(2, failing), std::runtime_error);
                EXPECT_TRUE(pool.run(5, [](std::size_t, std::size_t) { return true; }));
            }
        }
    }  // namespace
}  // namespace ompl_mfa::path
