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

#ifndef OMPL_MFA_BENCHMARKS_ANYTIME_WORLD_LIST_
#define OMPL_MFA_BENCHMARKS_ANYTIME_WORLD_LIST_

#include <filesystem>
#include <string>
#include <vector>

#include "anytime/World.h"

namespace ompl_mfa::anytime
{
    /** \brief Wall with a gap, double enclosure, dividing walls and random boxes in unit cubes of 2 to 16
        dimensions. */
    std::vector<World> boxWorlds();

    /** \brief Unit squares full of discs, whose shortest path passes through a narrow gap. */
    std::vector<World> circleWorlds();

    /** \brief Length of the shortest path in the circle world of \e seed with a distance of at least \e margin to its
        discs. */
    double circleOptimum(std::uint64_t seed, double margin);

    /** \brief Planar arms of 7 and 12 links that have to fold to pass discs. Angles in radians. */
    std::vector<World> armWorlds();

    /** \brief All configs of SE(2) or SE(3) in \e folder, named by \e prefix and the file's stem; none if there is no
        such folder. Throws InputError for an invalid config. */
    std::vector<World> configWorlds(const std::filesystem::path &folder, const std::string &prefix);

    /** \brief Those of the five sample problems of OMPL.app found in \e folder. */
    std::vector<World> omplAppWorlds(const std::filesystem::path &folder);

    /** \brief All worlds in order: those of this project and, if found, the problems of OMPL.app (in
        $OMPL_MFA_OMPLAPP_DIR or ../shared/omplapp next to the project). */
    std::vector<World> allWorlds();

    /** \brief The worlds whose name contains a match of \e pattern. Throws InputError for an invalid regular expression
        or one that matches nothing. */
    std::vector<World> selectWorlds(const std::string &pattern);
}  // namespace ompl_mfa::anytime

#endif
