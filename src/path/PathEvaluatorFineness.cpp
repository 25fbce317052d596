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

/* The checks of PathEvaluator at a finer resolution than OMPL's. */

#include <algorithm>
#include <cstddef>

#include "path/FineChecks.h"
#include "path/PathEvaluator.h"

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    namespace
    {
        /* States that are checked between two evaluations of the stop condition. */
        constexpr unsigned int STATES_BETWEEN_STOPS = 64;
    }  // namespace

    bool PathEvaluator::checkFinely(const ob::State *from, const ob::State *to)
    {
        failed_ = 0;
        return !stopped() && guard_.allows(from, to) && (fineness_ == 1 || checkFineStates({from, to}));
    }

    bool PathEvaluator::isDiscrete() const
    {
        return hasDiscreteMotionChecks(*si_);
    }

    void PathEvaluator::setFineness(unsigned int fineness, bool endsOnly)
    {
        endsOnly_ = endsOnly;
        fineness_ = isDiscrete() ? fineness : 1;
    }

    /* The numbers of the states of a motion of \e segments segments that are checked at the finer resolution only:
       those within a step of OMPL's resolution of its ends, where a shortest path turns around an obstacle; then the
       others, in bisection order of OMPL's segments. */
    void PathEvaluator::orderFineStates(unsigned int segments)
    {
        const unsigned int coarse = segments / fineness_;
        fine_.clear();
        const auto addSegment = [this](unsigned int segment)
        {
            for (unsigned int j = 1; j < fineness_; ++j)
            {
                fine_.push_back(segment * fineness_ + j);
            }
        };
        addSegment(0);
        if (coarse > 1)
        {
            addSegment(coarse - 1);
        }
        if (endsOnly_)
        {
            return;
        }
        // the bits of a counter in reverse order visit every segment once, the middle ones first
        unsigned int bits = 0;
        while ((1U << bits) < coarse)
        {
            ++bits;
        }
        for (unsigned int k = 0; k < (1U << bits); ++k)
        {
            unsigned int segment = 0;
            for (unsigned int b = 0; b < bits; ++b)
            {
                segment |= ((k >> b) & 1U) << (bits - 1 - b);
            }
            if (segment > 0 && segment + 1 < coarse)
            {
                addSegment(segment);
            }
        }
    }

    /* Checks a motion that is valid at OMPL's resolution at the states between. */
    bool PathEvaluator::checkFineStates(const Motion &motion)
    {
        const unsigned int segments = checkedSegments(motion.from, motion.to);
        orderFineStates(segments);
        const auto isValid = [&](unsigned int number)
        {
            si_->getStateSpace()->interpolate(motion.from, motion.to, static_cast<double>(number) / segments, scratch_);
            return si_->isValid(scratch_);
        };
        for (std::size_t begin = 0; begin < fine_.size(); begin += STATES_BETWEEN_STOPS)
        {
            if (begin > 0 && stopped())
            {
                return false;
            }
            const std::size_t count = std::min<std::size_t>(STATES_BETWEEN_STOPS, fine_.size() - begin);
            if (parallel_ && parallel_->checkStates(motion, &fine_[begin], count, segments))
            {
                checks_ += count;
                continue;
            }
            // the first invalid state in this order, which other threads do not find for certain
            for (std::size_t i = begin; i < begin + count; ++i)
            {
                ++checks_;
                if (!isValid(fine_[i]))
                {
                    failed_ = fine_[i];
                    return false;
                }
            }
        }
        return true;
    }
}  // namespace ompl_mfa::path
