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

#ifndef OMPL_MFA_ENGINE_TURN_METER_
#define OMPL_MFA_ENGINE_TURN_METER_

#include <chrono>
#include <cstdint>

#include "path/PathEvaluator.h"

namespace ompl_mfa::engine
{
    /** \brief What it takes to compute a distance of the space and to use it in a search of nearest neighbours, in s,
       on a machine of 2020 or so: an estimate that is the same on all machines. */
    double distanceTime(const ompl::base::StateSpace &space);

    /** \brief An estimate of how many distances a search for nearest neighbours among \e states computes. OMPL's
        structures draw random numbers that no seed fixes, so that a count would differ from run to run. */
    std::uint64_t neighbourDistances(const ompl::base::StateSpace &space, std::size_t states);

    /** \brief Measures what a turn costs, in s: by a clock, or, where a run has to repeat, by counted work.

        The clock is that of the thread's processor time, which other programs do not distort, unless the thread had to
        wait: for threads that help it, or for the answer of a validity checker. Such a turn took the time of the wall's
        clock. Counted work has three prices: that of a state check, which the user declares, that of a distance, which
        depends on the space, and that of a unit of other bookkeeping. */
    class TurnMeter
    {
    public:
        /** \brief By the clock, or if \e stateCheckTime (s) is positive by the work of \e evaluator, which outlives
            the meter. */
        TurnMeter(const path::PathEvaluator &evaluator, double stateCheckTime);

        /** \brief Seconds since the meter was made; positive. */
        double spent() const;

    private:
        const path::PathEvaluator &evaluator_;
        double stateCheckTime_;
        double distanceTime_;
        std::uint64_t checks_;
        std::uint64_t distances_;
        std::uint64_t bookkeeping_;
        std::chrono::steady_clock::time_point begin_;
        double processorBegin_;
        long waits_;
    };
}  // namespace ompl_mfa::engine

#endif
