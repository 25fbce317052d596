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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_GOAL_SEARCH_
#define OMPL_MFA_ENGINE_FIREFLIES_GOAL_SEARCH_

#include <cstdint>

#include <ompl/base/Goal.h>
#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief Finds states that satisfy a goal that only measures distances, by fireflies over the whole state space
        that are brighter the nearer they are to the goal. Every valid state that satisfies the goal is collected. After
        an epoch the swarm restarts with random fireflies. */
    class GoalSearch : private ObjectiveFunction
    {
    public:
        /** \brief The coordinates of the fireflies are relative to \e origin, any state of the space. */
        GoalSearch(const path::StateChartPtr &chart, const ompl::base::SpaceInformationPtr &si,
                   ompl::base::GoalPtr goal, const ompl::base::State *origin, std::uint64_t seed);
        ~GoalSearch() override;
        GoalSearch(const GoalSearch &) = delete;
        GoalSearch &operator=(const GoalSearch &) = delete;

        /** \brief Advances by one generation; appends at most one state to \e found and returns whether it did. */
        bool advance(const FireflyOptimizer::StopCondition &stop, path::Waypoints &found);

        /** \brief Number of states that were compared with the goal. */
        std::uint64_t evaluations() const
        {
            return earlierEvaluations_ + fireflies_.evaluations();
        }

    private:
        Brightness evaluate(const Eigen::Ref<const Eigen::VectorXd> &x, const Brightness *rival) override;

        path::StateChartPtr chart_;
        ompl::base::SpaceInformationPtr si_;
        ompl::base::GoalPtr goal_;
        path::Waypoints origin_;
        path::Waypoints satisfying_;
        ompl::base::State *state_;
        std::uint64_t seed_;
        std::uint64_t epoch_{0};
        std::uint64_t earlierEvaluations_{0};  ///< evaluations of earlier epochs
        FireflyOptimizer fireflies_;
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
