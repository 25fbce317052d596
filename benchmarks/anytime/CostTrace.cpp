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

#include "anytime/CostTrace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

#include <sys/prctl.h>

#include "OmplCompatibility.h"
#include "text/NumberText.h"

namespace ob = ompl::base;

namespace ompl_mfa::anytime
{
    namespace
    {
        constexpr double INTERVAL = 0.0002;

        double seconds(clockid_t clock)
        {
            timespec time{};
            clock_gettime(clock, &time);
            return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
        }

        ob::Planner::PlannerProgressProperty bestCostProperty(const ob::Planner &planner)
        {
            // REAL or, in some planners, DOUBLE
            for (const auto &[name, property] : planner.getPlannerProgressProperties())
            {
                if (name.rfind("best cost ", 0) == 0)
                {
                    return property;
                }
            }
#ifdef OMPL_MFA_HAS_AORRTC
            if (const auto *aorrtc = dynamic_cast<const ompl::geometric::AORRTC *>(&planner))
                return [aorrtc] { return text::numberText(aorrtc->bestCost().value()); };
#endif
            return {};
        }
    }  // namespace

    std::string clockName(Clock clock)
    {
        return clock == Clock::CPU ? "cpu" : "wall";
    }

    double wallTime()
    {
        return seconds(CLOCK_MONOTONIC);
    }

    double cpuTime()
    {
        return seconds(CLOCK_PROCESS_CPUTIME_ID);
    }

    CostTrace::CostTrace(const Problem &problem, const ob::Planner &planner, Clock clock, double limit,
                         ImprovementLog &log)
      : problem_(problem)
      , clock_(clock)
      , limit_(limit)
      , log_(log)
      , best_(std::numeric_limits<double>::infinity())
    {
        bestCost_ = bestCostProperty(planner);
        problem.pdef->setIntermediateSolutionCallback(
            [this](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
            { offer(cost.value()); });
        watcher_ = std::thread([this] { watch(); });
        while (!watching_)
        {
            std::this_thread::yield();
        }
        wallStart_ = wallTime();
        cpuStart_ = cpuTime();
        started_ = true;
    }

    CostTrace::~CostTrace()
    {
        stop();
        problem_.pdef->setIntermediateSolutionCallback({});
    }

    void CostTrace::stop()
    {
        stopped_ = true;
        if (watcher_.joinable())
        {
            watcher_.join();
        }
    }

    void CostTrace::watch()
    {
        // the default of 0.05 ms would extend every sleep
        prctl(PR_SET_TIMERSLACK, 1);
        watching_ = true;
        while (!stopped_)
        {
            std::this_thread::sleep_for(std::chrono::duration<double>(INTERVAL));
            if (started_)
            {
                look();
            }
        }
    }

    bool CostTrace::expired()
    {
        if (!expired_.load(std::memory_order_relaxed) && wallTime() >= nextLook_.load(std::memory_order_relaxed))
        {
            look();
        }
        return expired_.load(std::memory_order_relaxed);
    }

    void CostTrace::look()
    {
        const std::unique_lock<std::mutex> lock(lookMutex_, std::try_to_lock);
        if (!lock.owns_lock())
        {
            return;
        }
        nextLook_ = wallTime() + INTERVAL;
        readBestCost();
        readClocks();
    }

    void CostTrace::readClocks()
    {
        const double cpu = cpuTime() - cpuStart_;
        longestGap_ = std::max(longestGap_, cpu - lastLook_);
        lastLook_ = cpu;
        ++looks_;
        if ((clock_ == Clock::CPU ? cpu : wallTime() - wallStart_) >= limit_)
        {
            expired_ = true;
        }
    }

    void CostTrace::readBestCost()
    {
        if (!bestCost_)
        {
            return;
        }
        double cost = 0.0;
        // some planners call their cost 0 before they have a path
        if (text::readNumber(bestCost_(), cost) && cost > 0.0)
        {
            offer(cost);
        }
    }

    void CostTrace::offer(double cost)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        // properties are printed with six decimals, so the same cost may be read again, rounded
        if (!(cost < best_ * (1.0 - 1e-9)) || !std::isfinite(cost))
        {
            return;
        }
        best_ = cost;
        const std::uint32_t count = log_.count;
        const std::uint32_t index = std::min(count, ImprovementLog::CAPACITY - 1);
        log_.entries[index] = {wallTime() - wallStart_, cpuTime() - cpuStart_, cost, problem_.checker->checks()};
        log_.count = index + 1;
    }
}  // namespace ompl_mfa::anytime
