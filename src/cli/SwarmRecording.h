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

#ifndef OMPL_MFA_CLI_SWARM_RECORDING_
#define OMPL_MFA_CLI_SWARM_RECORDING_

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/benchmark/ConfigFile.h"
#include "ompl_mfa/benchmark/ProblemFactory.h"
#include "ompl_mfa/collision/PlanarOutline.h"

namespace ompl_mfa::cli
{
    /** \brief The path of a firefly, in the plane. */
    struct SwarmPath
    {
        collision::Polygon points;
        bool valid{false};
        double cost{0.0};
    };

    /** \brief The swarm after a generation. */
    struct SwarmFrame
    {
        std::uint64_t generation{0};
        /** \brief A path has the place of the nearest one in the frame before, so that it can be followed. */
        std::vector<SwarmPath> paths;
        /** \brief The best valid path so far; empty if there is none. */
        SwarmPath best;
    };

    /** \brief A run of a planner, generation by generation. */
    struct SwarmRecording
    {
        std::string planner;
        std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> slices;
        std::vector<SwarmFrame> frames;
    };

    /** \brief A planar problem seen from above, with the section of the world at the robot's height. */
    struct PlanarProblem
    {
        std::string name;
        Eigen::Vector2d lower;
        Eigen::Vector2d upper;
        std::vector<collision::Polygon> obstacles;
        std::vector<collision::Polygon> start;
        std::vector<collision::Polygon> goal;
    };

    /** \brief The problem of \e factory. Throws InputError if it is not planar. */
    PlanarProblem planarProblem(const benchmark::ProblemFactory &factory);

    /** \brief Runs planner \e spec with \e seed for \e generations generations, or fewer if it ends before or they
        take longer than a minute. Apart from that the same arguments yield the same recording. Throws InputError if the
        planner has no swarm, or shows none. */
    SwarmRecording recordSwarm(const benchmark::ProblemFactory &factory, const benchmark::PlannerSpec &spec,
                               std::uint32_t seed, std::uint64_t generations);
}  // namespace ompl_mfa::cli

#endif
