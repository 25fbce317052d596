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

#ifndef OMPL_MFA_CLI_PROBLEM_PICTURE_
#define OMPL_MFA_CLI_PROBLEM_PICTURE_

#include <string>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorBounds.h>
#include <ompl/geometric/PathGeometric.h>

#include "ompl_mfa/benchmark/ProblemFactory.h"

namespace ompl_mfa::cli
{
    /** \brief Content of a picture of a planning result besides the problem. */
    struct PictureContent
    {
        std::string title;
        /** \brief Pairs of states: the ends of each slice. */
        std::vector<ompl::geometric::PathGeometric> slices;
        /** \brief Paths of the swarm, drawn faintly. */
        std::vector<ompl::geometric::PathGeometric> swarm;
        /** \brief The best path; empty for none. */
        std::vector<ompl::geometric::PathGeometric> best;
    };

    /** \brief The bounds of the positions in the space of a problem. */
    ompl::base::RealVectorBounds positionBounds(const ompl::base::StateSpace &space);

    /** \brief Draws the obstacles, the robot at start, at goal and along the path, and \e content.

        A planar problem is seen from above, with the section of the world at the robot's height; a spatial one from
        above and from the side, with the whole world. The extension of \e file determines its format. Throws InputError
        if it cannot be written, or as pictureFormat(). */
    void drawProblem(const benchmark::ProblemFactory &problem, const ompl::geometric::SimpleSetup &setup,
                     const PictureContent &content, const std::string &file);
}  // namespace ompl_mfa::cli

#endif
