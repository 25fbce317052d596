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

#include "planner/SearchLock.h"

namespace ompl_mfa::planner
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
        {
            return;
        }
        ++lock_.arrivals_;
        lock_.mutex_.lock();
    }

    SearchLock::Reader::~Reader()
    {
        if (!waits_)
        {
            return;
        }
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
        // departures_ may only be read with the mutex held
        if (searching_ != std::this_thread::get_id())
        {
            return;
        }
        const std::uint64_t arrivals = arrivals_.load(std::memory_order_relaxed);
        if (arrivals == departures_)
        {
            return;
        }
        const Release release(*this);
        std::unique_lock<std::mutex> lock(mutex_);
        served_.wait(lock, [&] { return departures_ >= arrivals; });
    }
}  // namespace ompl_mfa::planner
