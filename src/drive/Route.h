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

#ifndef OMPL_MFA_DRIVE_ROUTE_
#define OMPL_MFA_DRIVE_ROUTE_

#include <cstddef>
#include <vector>

#include <ompl/geometric/PathGeometric.h>

namespace ompl_mfa::drive
{
    /** \brief A path and how far a robot has driven on it. Distances are those of the path's space. */
    class Route
    {
    public:
        /** \brief At the first state of \e path, which has at least one. */
        explicit Route(const ompl::geometric::PathGeometric &path);

        const ompl::geometric::PathGeometric &path() const
        {
            return path_;
        }

        /** \brief Length of the whole path. */
        double length() const
        {
            return ends_.back();
        }

        double driven() const
        {
            return driven_;
        }

        /** \brief Sets the distance from the first state, at most length(). */
        void setDriven(double distance)
        {
            driven_ = distance;
        }

        /** \brief The state at \e distance from the first one. */
        void stateAt(double distance, ompl::base::State *state) const;

        /** \brief The path from where the robot is. */
        ompl::geometric::PathGeometric rest() const;

        /** \brief Where the motion ends that the robot is in, as a distance from the first state. */
        double endOfMotion() const;

    private:
        std::size_t motionAt(double distance) const;

        ompl::geometric::PathGeometric path_;
        /** \brief Distance of each state from the first one along the path. */
        std::vector<double> ends_;
        double driven_{0.0};
    };
}  // namespace ompl_mfa::drive

#endif
