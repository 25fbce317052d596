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

#ifndef OMPL_MFA_DRIVE_DRIVE_SET_
#define OMPL_MFA_DRIVE_DRIVE_SET_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "drive/Drive.h"

namespace ompl_mfa::drive
{
    /** \brief Start and goal, and the length of the path that MFA found between them on the true map; infinite if it
        found none. */
    struct DriveProblem
    {
        benchmark::ConfigPose start;
        benchmark::ConfigPose goal;
        double optimum;
    };

    /** \brief Random starts and goals on the map of \e factory, valid, at least a fifth of the bounds' diagonal apart,
        with a path between them.
        \param factory the map and the robot
        \param count how many
        \param seed of the random numbers, which are independent of OMPL's
        \param seconds for MFA to find and to shorten a path on the true map; without one another pair is drawn
        \throw InputError if ten times as many pairs do not suffice. */
    std::vector<DriveProblem> randomProblems(const benchmark::ProblemFactory &factory, std::size_t count,
                                             std::uint32_t seed, double seconds);

    /** \brief The drives of one planner. Values of no drive are NaN. */
    struct DriveSummary
    {
        explicit DriveSummary(std::string planner)
          : name(std::move(planner))
        {
        }

        void add(const DriveResult &result, double optimum);

        std::string name;
        std::size_t drives{0};
        std::size_t arrived{0};
        std::size_t collisions{0};
        std::size_t blockages{0};
        /** \brief Driven length relative to the optimum, of drives that arrived, if it is known. */
        std::vector<double> ratios;
        std::vector<double> repairTimes;
    };

    /** \brief The least of \e values that \e part of them, in (0, 1], do not exceed; NaN if there are none. */
    double quantile(std::vector<double> values, double part);
}  // namespace ompl_mfa::drive

#endif
