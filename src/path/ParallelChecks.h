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

#ifndef OMPL_MFA_PATH_PARALLEL_CHECKS_
#define OMPL_MFA_PATH_PARALLEL_CHECKS_

#include <cstddef>
#include <utility>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "path/Motion.h"
#include "path/Waypoints.h"
#include "path/WorkerPool.h"

namespace ompl_mfa::path
{
    /** \brief Validity checks by several threads, for thread-safe validity checkers and motion validators.

        The results are the same as with one thread. With OMPL's own DiscreteMotionValidator the states of a motion
        are distributed among the threads; any other validator checks whole motions, and several that are needed next
        are checked at the same time. Threads are woken only for checks that take longer than the waking. */
    class ParallelChecks
    {
    public:
        ParallelChecks(ompl::base::SpaceInformationPtr si, unsigned int threads);

        /** \brief Whether the motion is valid; its first state is assumed to be. */
        bool checkMotion(const Motion &motion);

        /** \brief Whether the states that divide the motion into \e count equal segments are valid. */
        bool checkInside(const Motion &motion, unsigned int count);

        /** \brief Whether \e count states of the motion are valid, given by their \e numbers, with \e segments for its
            end. */
        bool checkStates(const Motion &motion, const unsigned int *numbers, std::size_t count, unsigned int segments);

        /** \brief Number of motions that checkMotions() can check at the same time. */
        std::size_t motionsAtOnce() const
        {
            return splitsMotions() ? 1 : pool_.threads();
        }

        /** \brief Checks the first few of \e count > 0 \e motions, at least one, and sets \e valid for each of them.
            Returns how many. */
        std::size_t checkMotions(const Motion *motions, std::size_t count, unsigned char *valid);

        /** \brief How many of the states at 1/\e count, 2/\e count, ..., 1 of the motion are invalid. */
        unsigned int countInvalid(const Motion &motion, unsigned int count);

    private:
        bool splitsMotions() const;
        bool isValidAt(std::size_t thread, const Motion &motion, unsigned int state, unsigned int count);
        bool checkDiscretely(const Motion &motion);
        void bisect(unsigned int count);

        ompl::base::SpaceInformationPtr si_;
        WorkerPool pool_;
        Waypoints scratch_;  ///< one state per thread
        std::vector<unsigned int> order_;
        std::vector<std::pair<unsigned int, unsigned int>> intervals_;
        double motionTime_{0.0};  ///< duration in s of the last check of a whole motion
    };
}  // namespace ompl_mfa::path

#endif
