#include "path/WorkerPool.h"

#include <algorithm>
#include <utility>

namespace ompl_mfa
{
    WorkerPool::WorkerPool(unsigned int threads)
    {
        try
        {
            for (std::size_t i = 1; i < threads; ++i)
                workers_.emplace_back([this, i] { work(i); });
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
            worker.join();
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
            begun_.notify_one();
        takeTasks(0, task, count);
        std::unique_lock<std::mutex> lock(mutex_);
        // a worker that has not woken up by now is not waited for
        task_ = nullptr;
        left_.wait(lock, [this] { return active_ == 0; });
        if (error_)
            std::rethrow_exception(std::exchange(error_, nullptr));
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
                error_ = std::current_exception();
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
                return;
            seen = runs_;
            ++active_;
            const Task &task = *task_;
            const std::size_t count = count_;
            lock.unlock();
            takeTasks(thread, task, count);
            lock.lock();
            if (--active_ == 0)
                left_.notify_one();
        }
    }
}  // namespace ompl_mfa
