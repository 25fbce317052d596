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

#ifndef OMPL_MFA_PATH_WORKER_POOL_
#define OMPL_MFA_PATH_WORKER_POOL_

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace ompl_mfa::path
{
    /** \brief Threads that help the calling thread with many small tasks, and sleep in between. */
    class WorkerPool
    {
    public:
        /** \brief A task, called with the index of the executing thread (0 for the caller of run()) and the index of
            the task. Returns false if no further task is needed. */
        using Task = std::function<bool(std::size_t thread, std::size_t task)>;

        /** \brief A pool of \e threads >= 1 threads, including the calling one. */
        explicit WorkerPool(unsigned int threads);
        ~WorkerPool();
        WorkerPool(const WorkerPool &) = delete;
        WorkerPool &operator=(const WorkerPool &) = delete;

        std::size_t threads() const
        {
            return workers_.size() + 1;
        }

        /** \brief Calls \e task for 0 to \e count - 1, started in this order, until a call returns false, and waits for
            the calls that have begun. Returns whether none returned false. Rethrows the first exception of a task. */
        bool run(std::size_t count, const Task &task);

    private:
        void work(std::size_t thread);
        void takeTasks(std::size_t thread, const Task &task, std::size_t count);
        void end();

        std::mutex mutex_;
        std::condition_variable begun_;
        std::condition_variable left_;
        const Task *task_{nullptr};  ///< task of the run that workers may join
        std::size_t count_{0};
        std::size_t runs_{0};
        std::size_t active_{0};  ///< number of workers in the run
        bool ending_{false};
        std::exception_ptr error_;
        std::atomic<std::size_t> next_{0};
        std::atomic<bool> all_{true};
        std::vector<std::thread> workers_;
    };
}  // namespace ompl_mfa::path

#endif
