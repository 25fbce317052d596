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

#include "path/ParallelChecks.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include <ompl/base/DiscreteMotionValidator.h>

#include "path/ExactType.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        /* Time in s of waking up another thread: shorter checks are done sooner by the calling one. */
        constexpr double WAKE_UP = 30e-6;
        /* Number of inner states of a motion that the calling thread checks before others help: they show how long the
           rest will take, and reveal most invalid motions. */
        constexpr std::size_t ALONE = 1;

        class Stopwatch
        {
        public:
            double seconds() const
            {
                return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
            }

        private:
            std::chrono::steady_clock::time_point begin_{std::chrono::steady_clock::now()};
        };
    }  // namespace

    ParallelChecks::ParallelChecks(ob::SpaceInformationPtr si, unsigned int threads)
      : si_(std::move(si))
      , pool_(threads)
      , scratch_(si_->getStateSpace())
    {
        scratch_.resize(threads);
    }

    bool ParallelChecks::splitsMotions() const
    {
        return isExactly<ob::DiscreteMotionValidator>(*si_->getMotionValidator());
    }

    bool ParallelChecks::isValidAt(std::size_t thread, const Motion &motion, unsigned int state, unsigned int count)
    {
        si_->getStateSpace()->interpolate(motion.from, motion.to, static_cast<double>(state) / count, scratch_[thread]);
        return si_->isValid(scratch_[thread]);
    }

    bool ParallelChecks::checkMotion(const Motion &motion)
    {
        if (splitsMotions())
        {
            return checkDiscretely(motion);
        }
        const Stopwatch watch;
        const bool valid = si_->checkMotion(motion.from, motion.to);
        motionTime_ = watch.seconds();
        return valid;
    }

    std::size_t ParallelChecks::checkMotions(const Motion *motions, std::size_t count, unsigned char *valid)
    {
        count = std::min(count, motionsAtOnce());
        if (count == 1 || motionTime_ < WAKE_UP)
        {
            *valid = checkMotion(*motions) ? 1 : 0;
            return 1;
        }
        pool_.run(count,
                  [&](std::size_t thread, std::size_t i)
                  {
                      const Stopwatch watch;
                      valid[i] = si_->checkMotion(motions[i].from, motions[i].to) ? 1 : 0;
                      if (thread == 0)
                      {
                          motionTime_ = watch.seconds();
                      }
                      return true;
                  });
        return count;
    }

    /* Checks the states that DiscreteMotionValidator checks, in the same order. */
    bool ParallelChecks::checkDiscretely(const Motion &motion)
    {
        return si_->isValid(motion.to) &&
               checkInside(motion, si_->getStateSpace()->validSegmentCount(motion.from, motion.to));
    }

    bool ParallelChecks::checkInside(const Motion &motion, unsigned int count)
    {
        bisect(count);
        return checkStates(motion, order_.data(), order_.size(), count);
    }

    bool ParallelChecks::checkStates(const Motion &motion, const unsigned int *numbers, std::size_t count,
                                     unsigned int segments)
    {
        const Stopwatch watch;
        const std::size_t alone = std::min(ALONE, count);
        for (std::size_t i = 0; i < alone; ++i)
        {
            if (!isValidAt(0, motion, numbers[i], segments))
            {
                return false;
            }
        }
        const std::size_t left = count - alone;
        if (left * watch.seconds() < ALONE * WAKE_UP)
        {
            return std::all_of(numbers + alone, numbers + count,
                               [&](unsigned int state) { return isValidAt(0, motion, state, segments); });
        }
        return pool_.run(left, [&](std::size_t thread, std::size_t i)
                         { return isValidAt(thread, motion, numbers[alone + i], segments); });
    }

    /* The numbers 1 to \e count - 1 in bisection order: the middle first, then those of the halves, and so on. */
    void ParallelChecks::bisect(unsigned int count)
    {
        order_.clear();
        intervals_.clear();
        if (count >= 2)
        {
            intervals_.emplace_back(1, count - 1);
        }
        for (std::size_t i = 0; i < intervals_.size(); ++i)
        {
            const auto [first, last] = intervals_[i];
            const unsigned int middle = (first + last) / 2;
            order_.push_back(middle);
            if (first < middle)
            {
                intervals_.emplace_back(first, middle - 1);
            }
            if (last > middle)
            {
                intervals_.emplace_back(middle + 1, last);
            }
        }
    }

    unsigned int ParallelChecks::countInvalid(const Motion &motion, unsigned int count)
    {
        std::atomic<unsigned int> invalid{0};
        const auto check = [&](std::size_t thread, std::size_t i)
        {
            if (!isValidAt(thread, motion, static_cast<unsigned int>(i) + 1, count))
            {
                ++invalid;
            }
            return true;
        };
        const Stopwatch watch;
        check(0, 0);
        if ((count - 1) * watch.seconds() < WAKE_UP)
        {
            for (std::size_t i = 1; i < count; ++i)
            {
                check(0, i);
            }
        }
        else
        {
            pool_.run(count - 1, [&](std::size_t thread, std::size_t i) { return check(thread, i + 1); });
        }
        return invalid;
    }
}  // namespace ompl_mfa::path
