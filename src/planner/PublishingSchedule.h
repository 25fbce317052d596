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

#ifndef OMPL_MFA_PLANNER_PUBLISHING_SCHEDULE_
#define OMPL_MFA_PLANNER_PUBLISHING_SCHEDULE_

#include <cstdint>

namespace ompl_mfa::planner
{
    /** \brief Decides when a better path is added to the problem definition, so that the number of solutions stays
        bounded in long searches.

        The first path is due immediately, and so is each path that is better than the last published one by 1 % of
        its cost (at most 1000 of these per query). Smaller improvements are due once the work has grown by 5 % since
        the last publication: at most log(n) / log(1.05) of them in n units of work. */
    class PublishingSchedule
    {
    public:
        /** \brief Resets the schedule for a new query. */
        void reset();

        /** \brief Whether a path of cost \e cost, better than all published ones, is due after \e work units of
            work. */
        bool due(double cost, std::uint64_t work) const;

        /** \brief Records that a path of cost \e cost was published after \e work units of work. */
        void published(double cost, std::uint64_t work);

    private:
        bool notable(double cost) const;

        bool any_{false};
        double cost_{0.0};
        std::uint64_t work_{0};
        unsigned int notables_{0};
    };
}  // namespace ompl_mfa::planner

#endif
