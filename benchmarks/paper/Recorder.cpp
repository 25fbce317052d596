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

#include "paper/Recorder.h"

#include <limits>

namespace ompl_mfa::paper
{
    namespace
    {
        constexpr std::uint64_t TRACE_POINTS = 100;
    }

    Recorder::Recorder(ObjectiveFunction &objective, double target)
      : objective_(objective)
      , target_(target)
    {
        run_.trace.reserve(TRACE_POINTS);
    }

    Brightness Recorder::evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival)
    {
        const Brightness brightness = objective_.evaluate(x, rival);
        ++run_.evaluations;
        if (run_.x.size() == 0 || objective_.isBrighter(brightness, run_.best))
        {
            run_.best = brightness;
            run_.x = x;
        }
        if (run_.evaluationsToTarget == 0 && run_.best.isFeasible() && run_.best.cost <= target_)
        {
            run_.evaluationsToTarget = run_.evaluations;
            run_.secondsToTarget = secondsSinceStart();
        }
        if (run_.trace.size() < TRACE_POINTS && run_.evaluations * TRACE_POINTS >= BUDGET * (run_.trace.size() + 1))
        {
            run_.trace.push_back(run_.best.isFeasible() ? run_.best.cost : std::numeric_limits<double>::infinity());
        }
        return brightness;
    }

    bool Recorder::isBrighter(const Brightness &a, const Brightness &b) const
    {
        return objective_.isBrighter(a, b);
    }

    Run Recorder::finish()
    {
        run_.seconds = secondsSinceStart();
        run_.trace.resize(TRACE_POINTS,
                          run_.best.isFeasible() ? run_.best.cost : std::numeric_limits<double>::infinity());
        return run_;
    }

    double Recorder::secondsSinceStart() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
}  // namespace ompl_mfa::paper
