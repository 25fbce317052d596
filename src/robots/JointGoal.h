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

#ifndef OMPL_MFA_ROBOTS_JOINT_GOAL_
#define OMPL_MFA_ROBOTS_JOINT_GOAL_

#include <vector>

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/util/RandomNumbers.h>

#include "ompl_mfa/robots/JointSpace.h"

namespace ompl_mfa::robots
{
    /** \brief An interval of values for each joint of a group. */
    struct JointBox
    {
        std::vector<double> preferred;
        std::vector<double> lower;
        std::vector<double> upper;

        /** \brief Whether it holds a single state. */
        bool isPoint() const
        {
            return lower == upper;
        }
    };

    /** \brief A goal of several boxes in joint space. The preferred states are sampled first, then states within. */
    class JointGoal : public ompl::base::GoalSampleableRegion
    {
    public:
        /** \param boxes at least one. */
        JointGoal(const ompl::base::SpaceInformationPtr &si, JointSpace joints, std::vector<JointBox> boxes);

        void sampleGoal(ompl::base::State *state) const override;
        unsigned int maxSampleCount() const override;

        /** \brief Distance in joint space from the nearest box, without weights. */
        double distanceGoal(const ompl::base::State *state) const override;

    private:
        JointSpace joints_;
        std::vector<JointBox> boxes_;
        mutable std::size_t samples_{0};
        mutable ompl::RNG random_;
    };
}  // namespace ompl_mfa::robots

#endif
