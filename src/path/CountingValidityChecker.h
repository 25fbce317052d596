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

#ifndef OMPL_MFA_PATH_COUNTING_VALIDITY_CHECKER_
#define OMPL_MFA_PATH_COUNTING_VALIDITY_CHECKER_

#include <atomic>
#include <cstdint>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::path
{
    /** \brief Counts the states that another validity checker is asked to check, and forwards all calls to it.
        Thread-safe if that checker is. */
    class OMPL_MFA_EXPORT CountingValidityChecker : public ompl::base::StateValidityChecker
    {
    public:
        /** \brief Uses a counter of its own. */
        CountingValidityChecker(const ompl::base::SpaceInformationPtr &si, ompl::base::StateValidityCheckerPtr checker);

        /** \brief Uses the counter \e count, which must outlive it and may lie in memory shared with other
            processes. */
        CountingValidityChecker(const ompl::base::SpaceInformationPtr &si, ompl::base::StateValidityCheckerPtr checker,
                                std::atomic<std::uint64_t> &count);

        bool isValid(const ompl::base::State *state) const override;
        bool isValid(const ompl::base::State *state, double &distance) const override;
        bool isValid(const ompl::base::State *state, double &distance, ompl::base::State *validState,
                     bool &validStateAvailable) const override;

        /** \brief Forwarded but not counted. */
        double clearance(const ompl::base::State *state) const override;
        double clearance(const ompl::base::State *state, ompl::base::State *validState,
                         bool &validStateAvailable) const override;

        /** \brief Number of states checked so far. */
        std::uint64_t checks() const;

    private:
        void count() const;

        ompl::base::StateValidityCheckerPtr checker_;
        std::atomic<std::uint64_t> own_{0};
        std::atomic<std::uint64_t> &count_;
    };
}  // namespace ompl_mfa::path

#endif
