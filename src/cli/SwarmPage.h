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

#ifndef OMPL_MFA_CLI_SWARM_PAGE_
#define OMPL_MFA_CLI_SWARM_PAGE_

#include <string>
#include <vector>

#include "cli/SwarmRecording.h"

namespace ompl_mfa::cli
{
    /** \brief A page that shows \e recordings side by side, with buttons and a slider for the generation. \e command is
        the one that makes it. */
    std::string swarmPage(const PlanarProblem &problem, const std::vector<SwarmRecording> &recordings,
                          const std::string &command);

    /** \brief Upper limit in bytes of swarmPicture(). */
    constexpr std::size_t LARGEST_PICTURE = 1000000;

    /** \brief An SVG in which \e recordings play side by side, again and again, without scripts, so that it also plays
        as an image of another page. It has at most LARGEST_PICTURE bytes: with many fireflies it shows only some of
        them. A viewer without animations shows the last generation. */
    std::string swarmPicture(const PlanarProblem &problem, const std::vector<SwarmRecording> &recordings);
}  // namespace ompl_mfa::cli

#endif
