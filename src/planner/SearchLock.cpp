#include "planner/SearchLock.h"

namespace ompl_mfa
{
    SearchLock::Search::Search(SearchLock &lock)
      : lock_(lock)
    {
        lock_.mutex_.lock();
        lock_.searching_ = std::this_thread::get_id();
    }

    SearchLock::Search::~Search()
    {
        lock_.searching_ = std::thread::id();
        lock_.mutex_.unlock();
    }

    SearchLock::Reader::Reader(SearchLock &lock)
      : lock_(lock)
      , waits_(lock.searching_ != std::this_thread::get_id())
    {
        if (!waits_)
            return;
        ++lock_.arrivals_;
        lock_.mutex_.lock();
    }

    SearchLock::Reader::~Reader()
    {
        if (!waits_)
            return;
        ++lock_.departures_;
        lock_.mutex_.unlock();
        lock_.served_.notify_all();
    }

    SearchLock::Release::Release(SearchLock &lock)
      : lock_(lock)
    {
        lock_.searching_ = std::thread::id();
        lock_.mutex_.unlock();
    }

    SearchLock::Release::~Release()
    {
        lock_.mutex_.lock();
        lock_.searching_ = std::this_thread::get_id();
    }

    void SearchLock::letReadersIn()
    {
        // departures_ may only be read by the thread that holds the mutex
        if (searching_ != std::this_thread::get_id())
            return;
        const std::uint64_t arrivals = arrivals_.load(std::memory_order_relaxed);
        if (arrivals == departures_)
            return;
        const Release release(*this);
        std::unique_lock<std::mutex> lock(mutex_);
        served_.wait(lock, [&] { return departures_ >= arrivals; });
    }
}  // namespace ompl_mfa
