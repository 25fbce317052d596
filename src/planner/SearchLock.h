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

#ifndef OMPL_MFA_PLANNER_SEARCH_LOCK_
#define OMPL_MFA_PLANNER_SEARCH_LOCK_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace ompl_mfa::planner
{
    /** \brief Lets other threads read the state of a search between two of its steps.

        The searching thread holds the lock from the beginning of a Search to its end and calls letReadersIn()
        whenever the data for readers is complete. If no reader waits, a call costs one atomic read. A thread that
        makes a Reader waits for the next such call, not for the end of the search. */
    class SearchLock
    {
    public:
        SearchLock() = default;
        SearchLock(const SearchLock &) = delete;
        SearchLock &operator=(const SearchLock &) = delete;

        /** \brief Holds the lock for the searching thread. */
        class Search
        {
        public:
            explicit Search(SearchLock &lock);
            ~Search();
            Search(const Search &) = delete;
            Search &operator=(const Search &) = delete;

        private:
            SearchLock &lock_;
        };

        /** \brief Holds the lock for a reading thread. Does not wait in the searching thread itself, where callbacks of
            the user may read. */
        class Reader
        {
        public:
            explicit Reader(SearchLock &lock);
            ~Reader();
            Reader(const Reader &) = delete;
            Reader &operator=(const Reader &) = delete;

        private:
            SearchLock &lock_;
            bool waits_;
        };

        /** \brief Releases the lock while it exists, for a callback that may read or wait for a reader. For the
            searching thread only. */
        class Release
        {
        public:
            explicit Release(SearchLock &lock);
            ~Release();
            Release(const Release &) = delete;
            Release &operator=(const Release &) = delete;

        private:
            SearchLock &lock_;
        };

        /** \brief Waits until all waiting readers have read. Does nothing in threads other than the searching one. */
        void letReadersIn();

    private:
        std::mutex mutex_;
        std::condition_variable served_;
        std::atomic<std::uint64_t> arrivals_{0};  ///< number of readers that arrived so far
        std::uint64_t departures_{0};             ///< number of readers that have finished; guarded by mutex_
        std::atomic<std::thread::id> searching_{std::thread::id()};  ///< thread that holds the lock
    };
}  // namespace ompl_mfa::planner

#endif
