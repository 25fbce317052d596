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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_PLANNER_RUN_
#define OMPL_MFA_BENCHMARKS_ANYTIME_PLANNER_RUN_

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "anytime/CostTrace.h"
#include "anytime/World.h"
#include "campaign/RunProcess.h"

namespace ompl_mfa::anytime
{
    /** \brief All planners' paths are checked at this many times the resolution; the default of MFA's parameter. */
    constexpr unsigned int STRICTNESS = 8;

    struct RunRequest
    {
        const World *world;
        /** \brief In the format of parsePlanner(). */
        std::string planner;
        /** \brief Above 0. */
        std::uint32_t seed;
        /** \brief Seconds on \e clock. */
        double timeLimit;
        Clock clock;
    };

    /** \brief Data of a run that survive a crash of its process. */
    struct RunMemory : campaign::RunState
    {
        ImprovementLog log;
    };

    /** \brief Result of a run. */
    struct RunResult
    {
        /** \brief Time of the planner on both clocks (seconds), and number of states checked. */
        double wall{0.0};
        double cpu{0.0};
        std::uint64_t checks{0};
        /** \brief Whether there is a path to the goal, and whether it passes PathGeometric::check() and leads from the
            start to the goal. */
        bool solved{false};
        bool valid{false};
        /** \brief Whether that path is also valid at STRICTNESS times the resolution at which it was planned. */
        bool strict{false};
        /** \brief Cost of the returned path; infinite if there is none. */
        double cost{std::numeric_limits<double>::infinity()};
        /** \brief The states of that path, each as the reals of its space. */
        std::vector<std::vector<double>> path;
        /** \brief Seconds to check the returned path once (minimum of several checks), and number of states checked for
            it. */
        double pathCheck{0.0};
        std::uint64_t pathChecks{0};
        /** \brief Longest time between two polls of the cost, in processor seconds. */
        double longestGap{0.0};
        /** \brief Number of polls. */
        std::uint64_t looks{0};
    };

    /** \brief Makes the problem and the planner and runs it. May be called once per process, as it sets OMPL's seed.
        Improvements are logged in \e memory. Passes on exceptions of the planner; throws InputError if the planner
        cannot be made. */
    RunResult runPlanner(const RunRequest &request, RunMemory &memory);
}  // namespace ompl_mfa::anytime

#endif
