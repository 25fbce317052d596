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

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "anytime/World.h"

namespace ompl_mfa::anytime
{
    /** \brief Wall with a gap, double enclosure, dividing walls and random boxes in unit cubes of 2 to 16
        dimensions. */
    std::vector<World> boxWorlds();

    /** \brief A world of \e kind `wall_gap`, `double_enclosure` or `dividing_walls`, of at least 2 dimensions, or
        `random_boxes`, of 2, 4, 8 or 16. */
    World boxWorld(const std::string &kind, int dimension, std::uint64_t seed);

    /** \brief Unit squares full of discs whose shortest path squeezes through a gap that is easily missed. */
    std::vector<World> circleWorlds();

    /** \brief Length of the shortest path in the circle world of \e seed with a distance of at least \e margin to its
        discs. */
    double circleOptimum(std::uint64_t seed, double margin);

    /** \brief Whether that path grows by more than 2% when the discs grow by 0.004, as in circleWorlds(): it squeezes
        through a narrow gap. */
    bool hasNarrowCircles(std::uint64_t seed);

    World circleWorld(std::uint64_t seed);

    /** \brief Planar arms of 7 and 12 links that have to fold to get past discs. Angles in radians. */
    std::vector<World> armWorlds();

    /** \brief Such an arm of \e links links, 2 at least. */
    World armWorld(int links, std::uint64_t seed);

    /** \brief The families of worlds that are drawn from seeds, as generatedWorlds() takes them, with the numbers of
        dimensions or links that they have. */
    std::vector<std::string> generatedFamilies();

    /** \brief Worlds by their names `FAMILY_SEED`, such as `random_boxes_8d_101`, with any seed from 1 to 4294967295,
        whether the suite has them or not; a name that comes again counts once.

        Throws InputError for a name of another form, and for a world that is known not to be worth planning in: one
        whose straight motion from start to goal is free, or, where geometry gives the shortest path, that has no path,
        or whose discs leave no narrow gap. Whether random boxes of 4 dimensions or more and arms have a path only
        planners can tell. */
    std::vector<World> generatedWorlds(const std::vector<std::string> &names);

    /** \brief Every config of SE(2) or SE(3) in \e folder, named \e prefix and the file's stem; none where there is no
        such folder. Throws InputError for a config that cannot be read. */
    std::vector<World> configWorlds(const std::filesystem::path &folder, const std::string &prefix);

    /** \brief The config \e file, of any space with one start and one goal, with path length as its objective; named by
        the file's stem. Throws InputError for a config that cannot be read. */
    World configWorld(const std::filesystem::path &file);

    /** \brief Those of the five sample problems of OMPL.app found in \e folder. */
    std::vector<World> omplAppWorlds(const std::filesystem::path &folder);

    /** \brief All worlds in order: those of this project and, if found, the problems of OMPL.app (in
        $OMPL_MFA_OMPLAPP_DIR or ../shared/omplapp next to the project). */
    std::vector<World> allWorlds();

    /** \brief The worlds whose name contains a match of \e pattern. Throws InputError for an invalid regular expression
        or one that matches nothing. */
    std::vector<World> selectWorlds(const std::string &pattern);

    /** \brief generatedWorlds() of \e generated, the worlds of \e configs, and selectWorlds() of \e pattern unless that
        is empty and there are others; each world once. */
    std::vector<World> selectWorlds(const std::string &pattern, const std::vector<std::string> &generated,
                                    const std::vector<std::filesystem::path> &configs = {});

    /** \brief A pattern for the statistics: it matches the names that \e pattern matches, unless that is empty and
       there are other worlds, and those of \e generated and \e configs. */
    std::string namePattern(const std::string &pattern, const std::vector<std::string> &generated,
                            const std::vector<std::filesystem::path> &configs = {});
}  // namespace ompl_mfa::anytime

#endif
