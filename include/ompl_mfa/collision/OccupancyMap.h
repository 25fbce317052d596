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

#ifndef OMPL_MFA_COLLISION_OCCUPANCY_MAP_
#define OMPL_MFA_COLLISION_OCCUPANCY_MAP_

#include <filesystem>
#include <memory>
#include <string>

#include <fcl/geometry/octree/octree.h>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::collision
{
    /** \brief Read an OctoMap: .bt (binary) or .ot (full) of an `OcTree`. Cells whose occupancy is at least the map's
        threshold are obstacles; free and unknown cells are not.
        \throw InputError naming the file and the error: missing, not an OctoMap, an unsupported version or kind of
        tree, truncated, or without any occupied cell. */
    OMPL_MFA_EXPORT std::shared_ptr<fcl::OcTree<double>> loadOccupancyMap(const std::filesystem::path &file);

    /** \brief Make an occupancy map from the `data` of an `octomap_msgs/Octomap` message: the content of an OctoMap
        file without its header.
        \param nodes the bytes of `data`
        \param binary as in the message: whether nodes are just free or occupied (as in .bt) or hold occupancies
        \param resolution edge length of the smallest cell, in world units
        \return null if no cell is occupied.
        \throw std::invalid_argument if the nodes are truncated, corrupt or followed by other bytes, or the resolution
        is not positive and finite. */
    OMPL_MFA_EXPORT std::shared_ptr<fcl::OcTree<double>> makeOccupancyMap(const std::string &nodes, bool binary,
                                                                          double resolution);
}  // namespace ompl_mfa::collision

#endif
