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

#ifndef OMPL_MFA_TEST_PATH_COUNTING_PROBLEM_
#define OMPL_MFA_TEST_PATH_COUNTING_PROBLEM_

/* A space information that counts checks and motions. */

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include <ompl/base/DiscreteMotionValidator.h>
#include <ompl/base/SpaceInformation.h>

#include "path/CountingValidityChecker.h"

namespace ompl_mfa::test
{
    class CountingMotionValidator : public ompl::base::DiscreteMotionValidator
    {
    public:
        CountingMotionValidator(const ompl::base::SpaceInformationPtr &si, std::atomic<std::uint64_t> &count)
          : DiscreteMotionValidator(si)
          , count_(count)
        {
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to) const override
        {
            ++count_;
            return DiscreteMotionValidator::checkMotion(from, to);
        }

        bool checkMotion(const ompl::base::State *from, const ompl::base::State *to,
                         std::pair<ompl::base::State *, double> &lastValid) const override
        {
            ++count_;
            return DiscreteMotionValidator::checkMotion(from, to, lastValid);
        }

    private:
        std::atomic<std::uint64_t> &count_;
    };

    struct CountingProblem
    {
        std::atomic<std::uint64_t> states{0};
        std::atomic<std::uint64_t> motions{0};
        ompl::base::SpaceInformationPtr si;

        CountingProblem(const ompl::base::StateSpacePtr &space,
                        const std::function<bool(const ompl::base::State *)> &isValid)
          : si(std::make_shared<ompl::base::SpaceInformation>(space))
        {
            si->setStateValidityChecker(isValid);
            si->setStateValidityChecker(
                std::make_shared<path::CountingValidityChecker>(si, si->getStateValidityChecker(), states));
            si->setMotionValidator(std::make_shared<CountingMotionValidator>(si, motions));
            si->setup();
        }

        void forget()
        {
            states = 0;
            motions = 0;
        }
    };
}  // namespace ompl_mfa::test

#endif
