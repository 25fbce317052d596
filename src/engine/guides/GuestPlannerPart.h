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

#ifndef OMPL_MFA_ENGINE_GUIDES_GUEST_PLANNER_PART_
#define OMPL_MFA_ENGINE_GUIDES_GUEST_PLANNER_PART_

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/goals/GoalStates.h>

#include "engine/guides/GuidePart.h"
#include "path/PathEvaluator.h"

namespace ompl_mfa::engine::guides
{
    /** \brief Any other planner as a guide: in each turn it resumes its search, on its own problem definition with
       the query's starts, goals and objective. A planner that returns before its turn is over, as those do that end
       with their first path, is cleared and restarted. Until it has a path its turns become longer, for planners
       that cannot resume.

       Its work is counted in state checks, by its own space information that forwards to the evaluator's, and in
       evaluations of its termination condition. */
    class GuestPlannerPart : public GuidePart
    {
    public:
        /** \brief Throws ompl::Exception if \e allocator returns no planner. */
        GuestPlannerPart(const SearchContext &context, const ompl::base::PlannerAllocator &allocator);

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;

        /** \brief Idle once the planner has rejected the present query. */
        Readiness readiness() const override;

        /** \brief As in GuidePart. Paths that the evaluator finds invalid, or that do not solve the query, are
            ignored. */
        bool search(double bound, std::uint64_t work, path::Waypoints &path) override;

    private:
        void addEnds();
        ompl::base::PlannerStatus run(std::uint64_t work);
        void restart();
        bool takePath(path::Waypoints &path);
        bool holds(const path::Waypoints &path);

        path::PathEvaluator &evaluator_;
        std::shared_ptr<std::atomic<std::uint64_t>> checked_;  ///< states checked by the planner in this turn
        std::mutex stopMutex_;  ///< held while the planner evaluates its termination condition
        ompl::base::SpaceInformationPtr si_;
        std::shared_ptr<ompl::base::GoalStates> goals_;
        ompl::base::ProblemDefinitionPtr pdef_;
        ompl::base::PlannerPtr planner_;
        bool fresh_{true};                       ///< whether the planner had no turn since it was made or cleared
        bool returnedEarly_{false};              ///< whether it returned early in its last turn
        std::uint64_t fruitless_{0};             ///< work since its last path
        std::optional<ompl::base::Cost> taken_;  ///< cost of its best path since it was last cleared
        std::size_t refusedStarts_{0};           ///< number of starts when it rejected the query
        std::size_t refusedGoals_{0};
    };
}  // namespace ompl_mfa::engine::guides

#endif
