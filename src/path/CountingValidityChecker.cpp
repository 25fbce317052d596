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

#include "path/CountingValidityChecker.h"

#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::path
{
    CountingValidityChecker::CountingValidityChecker(const ob::SpaceInformationPtr &si,
                                                     ob::StateValidityCheckerPtr checker)
      : CountingValidityChecker(si, std::move(checker), own_)
    {
    }

    CountingValidityChecker::CountingValidityChecker(const ob::SpaceInformationPtr &si,
                                                     ob::StateValidityCheckerPtr checker,
                                                     std::atomic<std::uint64_t> &count)
      : ob::StateValidityChecker(si)
      , checker_(std::move(checker))
      , count_(count)
    {
        specs_ = checker_->getSpecs();
    }

    bool CountingValidityChecker::isValid(const ob::State *state) const
    {
        count();
        return checker_->isValid(state);
    }

    bool CountingValidityChecker::isValid(const ob::State *state, double &distance) const
    {
        count();
        return checker_->isValid(state, distance);
    }

    bool CountingValidityChecker::isValid(const ob::State *state, double &distance, ob::State *validState,
                                          bool &validStateAvailable) const
    {
        count();
        return checker_->isValid(state, distance, validState, validStateAvailable);
    }

    double CountingValidityChecker::clearance(const ob::State *state) const
    {
        return checker_->clearance(state);
    }

    double CountingValidityChecker::clearance(const ob::State *state, ob::State *validState,
                                              bool &validStateAvailable) const
    {
        return checker_->clearance(state, validState, validStateAvailable);
    }

    std::uint64_t CountingValidityChecker::checks() const
    {
        return count_.load(std::memory_order_relaxed);
    }

    void CountingValidityChecker::count() const
    {
        count_.fetch_add(1, std::memory_order_relaxed);
    }
}  // namespace ompl_mfa::path
