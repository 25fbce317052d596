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
    /** \brief Time in s of computing a distance of the space within a nearest-neighbour query, on a machine of about
       2020: a fixed estimate, the same on all machines. */
    double distanceTime(const ompl::base::StateSpace &space);

    /** \brief Estimated number of distances that a nearest-neighbour query among \e states computes. OMPL's structures
        use random numbers that no seed fixes, so an actual count would differ from run to run. */
    std::uint64_t neighbourDistances(const ompl::base::StateSpace &space, std::size_t states);

    /** \brief Measures what a turn costs, in s: by a clock or, for repeatable runs, by counted work.

        The clock is the thread's processor time, which other programs do not distort. For a turn in which the thread
        blocked, waiting for worker threads or a validity checker, it is wall time. Counted work has three prices: of
        a state check, declared by the user; of a distance, which depends on the space; and of a unit of other
        bookkeeping. */
    class TurnMeter
    {
    public:
        /** \brief Uses the clock or, if \e stateCheckTime (s) is positive, the work of \e evaluator, which must outlive
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
