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

#ifndef OMPL_MFA_PLANNER_SOLUTION_PUBLISHER_
#define OMPL_MFA_PLANNER_SOLUTION_PUBLISHER_

#include <cstdint>
#include <string>

#include <ompl/base/Planner.h>

#include "engine/SearchContext.h"
#include "planner/PublishingSchedule.h"
#include "planner/SearchLock.h"

namespace ompl_mfa::planner
{
    /** \brief Adds the paths of a search to a problem definition. */
    class SolutionPublisher
    {
    public:
        /** \brief To be called at the beginning of each solve(): further paths are added to \e pdef, which may not
            contain the path published last. */
        void begin(const ompl::base::ProblemDefinitionPtr &pdef);

        /** \brief Publishes the answer of \e context if it is new and due. \e lock is released during the
            intermediate solution callback of \e planner's problem definition. */
        void publishIfDue(const engine::SearchContext &context, const ompl::base::Planner &planner, SearchLock &lock);

        /** \brief To be called at the end of a solve(): publishes the answer, or else the partial path, and returns
            the status. */
        ompl::base::PlannerStatus finish(const engine::SearchContext &context, const ompl::base::Planner &planner,
                                         SearchLock &lock);

    private:
        bool isPublished(const engine::SearchContext &context) const;
        void publish(const engine::SearchContext &context, const ompl::base::Planner &planner, SearchLock &lock);

        ompl::base::ProblemDefinitionPtr pdef_;
        PublishingSchedule schedule_;
        ompl::base::PathPtr published_;
        std::uint64_t improvement_{0};  ///< index of the last published improvement
    };
}  // namespace ompl_mfa::planner

#endif
