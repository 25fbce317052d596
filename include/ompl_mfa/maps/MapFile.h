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

#ifndef OMPL_MFA_MAPS_MAP_FILE_
#define OMPL_MFA_MAPS_MAP_FILE_

#include <filesystem>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/maps/GridMap.h"

namespace ompl_mfa::maps
{
    /** \brief Whether \e file is meant as a map: its extension is `.map`, or it is YAML (`.yaml`, `.yml`) and one of
       its lines begins with `image:`. False for a file that cannot be read. */
    OMPL_MFA_EXPORT bool isMapFile(const std::filesystem::path &file);

    /** \brief Reads a map of ROS's map_server (YAML and an image: PGM, PNG or BMP) or a MovingAI `.map`.

        A map_server map is read as by Nav2: brightness b of a pixel from 0 to 1 gives the occupancy p = 1 - b, or b
       with `negate`. In the modes `trinary` and `scale`, p >= occupied_thresh is occupied, p <= free_thresh is free,
       and what is not opaque is unknown; between the thresholds a cell is unknown in `trinary` and free in `scale`, as
       its occupancy is below 100. In the mode `raw` pixels from 0 to 255 are occupancies: 100 is occupied, 0 to 99
       free, others unknown. The first row of the image is the top one.

        In a MovingAI map `.`, `G` and `S` are free, `@`, `O`, `T` and `W` occupied; the centre of the cell in column x
        and row y, counted from the top, has the coordinates (x, y).

        Throws InputError for a file that is missing, invalid, or too large for the memory of the machine. */
    OMPL_MFA_EXPORT GridMap loadMap(const std::filesystem::path &file);
}  // namespace ompl_mfa::maps

#endif
