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

#ifndef OMPL_MFA_DRIVE_REPLANNER_
#define OMPL_MFA_DRIVE_REPLANNER_

#include <limits>
#include <optional>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>

#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ompl_mfa::drive
{
    /** \brief What a planner answers within its time. */
    struct Answer
    {
        /** \brief Empty if there is no path to the goal. */
        std::optional<ompl::geometric::PathGeometric> path;
        /** \brief Seconds until the first path; infinite without one. */
        double firstTime{std::numeric_limits<double>::infinity()};
        /** \brief Seconds until the answer. */
        double time{0.0};
    };

    /** \brief A planner that is asked again and again, for other starts and in a world that changes. MFA keeps what it
        knows; any other planner starts from scratch each time. Paths of planners that do not optimize are simplified in
       what is left of the time. */
    class Replanner
    {
    public:
        /** \brief Makes the problem of \e factory and the planner of \e spec. Throws InputError as they do. */
        Replanner(const benchmark::ProblemFactory &factory, const benchmark::PlannerSpec &spec);

        const ompl::base::SpaceInformationPtr &spaceInformation() const
        {
            return setup_->getSpaceInformation();
        }

        const ompl::base::State *start() const
        {
            return setup_->getProblemDefinition()->getStartState(0);
        }

        const ompl::base::State *goal() const;

        /** \brief Plans from \e start for \e seconds. \e worldChanged: whether validity has changed since the last
            call. */
        Answer plan(const ompl::base::State *start, bool worldChanged, double seconds);

        /** \brief Cost of \e path by the problem's objective, or its length. */
        double cost(const ompl::geometric::PathGeometric &path) const;

        /** \brief At most \e most of the planner's fireflies, the brightest first; none of other planners. */
        std::vector<ompl::geometric::PathGeometric> swarm(std::size_t most) const;

    private:
        void prepare(const ompl::base::State *start, bool worldChanged);

        ompl::geometric::SimpleSetupPtr setup_;
        bool isFirst_{true};
    };
}  // namespace ompl_mfa::drive

#endif
