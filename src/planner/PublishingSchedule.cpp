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

#include "planner/PublishingSchedule.h"

#include <cmath>

namespace ompl_mfa::planner
{
    namespace
    {
        /* An improvement by this fraction of the cost is published immediately. */
        constexpr double NOTABLE = 0.01;
        constexpr unsigned int MAX_NOTABLES = 1000;
        /* Factor of growth of the work after which a smaller improvement is published. */
        constexpr double GROWTH = 1.05;
    }  // namespace

    void PublishingSchedule::reset()
    {
        *this = PublishingSchedule();
    }

    bool PublishingSchedule::notable(double cost) const
    {
        // from an infinite cost to a finite one, or to minus infinity
        if (!std::isfinite(cost_) || !std::isfinite(cost))
        {
            return true;
        }
        return std::abs(cost_ - cost) >= NOTABLE * std::abs(cost_);
    }

    bool PublishingSchedule::due(double cost, std::uint64_t work) const
    {
        if (!any_ || (notables_ < MAX_NOTABLES && notable(cost)))
        {
            return true;
        }
        return static_cast<double>(work) >= GROWTH * static_cast<double>(work_);
    }

    void PublishingSchedule::published(double cost, std::uint64_t work)
    {
        if (any_ && notable(cost))
        {
            ++notables_;
        }
        any_ = true;
        cost_ = cost;
        work_ = work;
    }
}  // namespace ompl_mfa::planner
