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

#include <algorithm>
#include <utility>

namespace ompl_mfa::path
{
    WorkerPool::WorkerPool(unsigned int threads)
    {
        try
        {
            for (std::size_t i = 1; i < threads; ++i)
            {
                workers_.emplace_back([this, i] { work(i); });
            }
        }
        catch (...)
        {
            end();
            throw;
        }
    }

    WorkerPool::~WorkerPool()
    {
        end();
    }

    void WorkerPool::end()
    {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            ending_ = true;
        }
        begun_.notify_all();
        for (auto &worker : workers_)
        {
            worker.join();
        }
    }

    bool WorkerPool::run(std::size_t count, const Task &task)
    {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            task_ = &task;
            count_ = count;
            ++runs_;
            error_ = nullptr;
            next_ = 0;
            all_ = true;
        }
        for (std::size_t i = 1; i < std::min(count, threads()); ++i)
        {
            begun_.notify_one();
        }
        takeTasks(0, task, count);
        std::unique_lock<std::mutex> lock(mutex_);
        // workers that have not woken up by now are not waited for
        task_ = nullptr;
        left_.wait(lock, [this] { return active_ == 0; });
        if (error_)
        {
            std::rethrow_exception(std::exchange(error_, nullptr));
        }
        return all_;
    }

    void WorkerPool::takeTasks(std::size_t thread, const Task &task, std::size_t count)
    {
        try
        {
            for (std::size_t i = next_++; i < count; i = next_++)
            {
                if (!task(thread, i))
                {
                    all_ = false;
                    next_ = count;
                }
            }
        }
        catch (...)
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!error_)
            {
                error_ = std::current_exception();
            }
            next_ = count;
        }
    }

    void WorkerPool::work(std::size_t thread)
    {
        std::size_t seen = 0;
        std::unique_lock<std::mutex> lock(mutex_);
        for (;;)
        {
            begun_.wait(lock, [&] { return ending_ || (task_ != nullptr && runs_ != seen); });
            if (ending_)
            {
                return;
            }
            seen = runs_;
            ++active_;
            const Task &task = *task_;
            const std::size_t count = count_;
            lock.unlock();
            takeTasks(thread, task, count);
            lock.lock();
            if (--active_ == 0)
            {
                left_.notify_one();
            }
        }
    }
}  // namespace ompl_mfa::path
