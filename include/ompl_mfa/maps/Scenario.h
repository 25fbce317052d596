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

#ifndef OMPL_MFA_MAPS_SCENARIO_
#define OMPL_MFA_MAPS_SCENARIO_

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/maps/GridMap.h"

namespace ompl_mfa::maps
{
    /** \brief A problem of a MovingAI scenario. */
    struct ScenarioProblem
    {
        /** \brief Number of the problem in the file, from 0. */
        std::size_t index;
        /** \brief Centres of cells, in the frame of the map. */
        Eigen::Vector2d start;
        Eigen::Vector2d goal;
        /** \brief Length of the shortest path along rows, columns and diagonals of the grid, an upper bound of the
            shortest path of a point. */
        double octileLength;
        /** \brief "FILE:LINE", for errors. */
        std::string origin;
    };

    /** \brief Reads the `.scen` \e file of the map that was read from \e mapFile.

        A line is: bucket, map, width, height, x and y of the start, x and y of the goal, length on the octile grid; y
        is counted from the top. Throws InputError, naming file and line, for any other text, for a scenario of a map
        of another name or size, and for a start or goal outside of the map. */
    OMPL_MFA_EXPORT std::vector<ScenarioProblem> loadScenario(const std::filesystem::path &file, const GridMap &map,
                                                              const std::filesystem::path &mapFile);
}  // namespace ompl_mfa::maps

#endif
