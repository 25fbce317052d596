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

#ifndef OMPL_MFA_PYTHON_PYTHON_CALLS_
#define OMPL_MFA_PYTHON_PYTHON_CALLS_

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <utility>

#include <pybind11/pybind11.h>

namespace ompl_mfa::python
{
    /** \brief Calls Python from code that runs without the interpreter's lock, and stops that code if Python raises an
        exception or the user presses Ctrl-C. The exception is kept until rethrow(): it does not pass through the
        planner. */
    class PythonCalls
    {
    public:
        /** \brief The result of \e call, made with the interpreter's lock, or \e otherwise if it or an earlier call
            raised an exception. */
        template <class Result, class Call>
        Result call(const Call &call, Result otherwise)
        {
            if (failed_)
            {
                return otherwise;
            }
            const pybind11::gil_scoped_acquire lock;
            try
            {
                return call();
            }
            catch (...)
            {
                keep(std::current_exception());
                return otherwise;
            }
        }

        /** \brief Whether the run has to end: after an exception, or Ctrl-C, which is looked for every 20 ms. */
        bool mustStop()
        {
            const auto now = std::chrono::steady_clock::now();
            if (!failed_ && now - lastLook_.load() > std::chrono::milliseconds(20))
            {
                lastLook_ = now;
                call(
                    []
                    {
                        if (PyErr_CheckSignals() != 0)
                        {
                            throw pybind11::error_already_set();
                        }
                        return 0;
                    },
                    0);
            }
            return failed_;
        }

        /** \brief Raises the exception that was kept, if there is one. To be called with the interpreter's lock. */
        void rethrow()
        {
            if (exception_)
            {
                std::rethrow_exception(std::exchange(exception_, nullptr));
            }
        }

    private:
        void keep(std::exception_ptr exception)
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!failed_)
            {
                exception_ = std::move(exception);
                failed_ = true;
            }
        }

        std::mutex mutex_;
        std::exception_ptr exception_;
        std::atomic<bool> failed_{false};
        std::atomic<std::chrono::steady_clock::time_point> lastLook_{std::chrono::steady_clock::time_point()};
    };
}  // namespace ompl_mfa::python

#endif
