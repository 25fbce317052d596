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

#ifndef OMPL_MFA_TEST_PATH_SLOW_PROBLEM_
#define OMPL_MFA_TEST_PATH_SLOW_PROBLEM_

/* A problem with state checks slow enough for several threads to pay. Reports how many threads were in the checker at
   once. */

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

#include "path/CountingValidityChecker.h"

namespace ompl_mfa::test
{
    /** \brief Checks whole motions, from their beginning, as a user's validator may. */
    class WholeMotionValidator : public ompl::base::MotionValidator
    {
    public:
        explicit WholeMotionValidator(const ompl::base::SpaceInformationPtr &si)
          : MotionValidator(si)
        {
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to) const override
        {
            ompl::base::ScopedState<> state(si_->getStateSpace());
            std::pair<ompl::base::State *, double> lastValid(state.get(), 0.0);
            return checkMotion(from, to, lastValid);
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to,
                         std::pair<ompl::base::State *, double> &lastValid) const override
        {
            const auto &space = si_->getStateSpace();
            const unsigned int count = std::max(1U, space->validSegmentCount(from, to));
            // released when a checker throws, too
            ompl::base::ScopedState<> state(si_->getStateSpace());
            bool valid = true;
            for (unsigned int i = 1; i <= count && valid; ++i)
            {
                space->interpolate(from, to, static_cast<double>(i) / count, state.get());
                valid = si_->isValid(state.get());
                if (valid)
                {
                    lastValid.second = static_cast<double>(i) / count;
                }
            }
            if (!valid && lastValid.first != nullptr)
            {
                space->interpolate(from, to, lastValid.second, lastValid.first);
            }
            return valid;
        }
    };

    struct SlowProblem
    {
        std::atomic<unsigned int> inside{0};
        std::atomic<unsigned int> mostInside{0};
        std::atomic<std::uint64_t> states{0};
        ompl::base::SpaceInformationPtr si;

        /** \brief Each state takes \e duration. \e wholeMotions: with a WholeMotionValidator, else with OMPL's own. */
        SlowProblem(const ompl::base::StateSpacePtr &space, bool wholeMotions, std::chrono::microseconds duration,
                    const std::function<bool(const ompl::base::State *)> &isValid)
          : si(std::make_shared<ompl::base::SpaceInformation>(space))
        {
            si->setStateValidityChecker(
                [this, isValid, duration](const ompl::base::State *state)
                {
                    const unsigned int now = ++inside;
                    for (unsigned int most = mostInside; now > most && !mostInside.compare_exchange_weak(most, now);)
                    {
                    }
                    const auto end = std::chrono::steady_clock::now() + duration;
                    while (std::chrono::steady_clock::now() < end)
                    {
                    }
                    --inside;
                    return isValid(state);
                });
            si->setStateValidityChecker(
                std::make_shared<path::CountingValidityChecker>(si, si->getStateValidityChecker(), states));
            if (wholeMotions)
            {
                si->setMotionValidator(std::make_shared<WholeMotionValidator>(si));
            }
            si->setup();
        }
    };
}  // namespace ompl_mfa::test

#endif
