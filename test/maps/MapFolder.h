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

#ifndef OMPL_MFA_TEST_MAPS_MAP_FOLDER_
#define OMPL_MFA_TEST_MAPS_MAP_FOLDER_

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "ompl_mfa/maps/GridMap.h"

namespace ompl_mfa::maps::test
{
    /** \brief A temporary folder for the files of a test. */
    class MapFolder
    {
    public:
        MapFolder()
        {
            std::string pattern = (std::filesystem::temp_directory_path() / "ompl_mfa_maps_XXXXXX").string();
            folder_ = mkdtemp(pattern.data());
        }

        ~MapFolder()
        {
            std::filesystem::remove_all(folder_);
        }

        MapFolder(const MapFolder &) = delete;
        MapFolder &operator=(const MapFolder &) = delete;

        std::filesystem::path write(const std::string &name, const std::string &content) const
        {
            std::ofstream(folder_ / name, std::ios::binary) << content;
            return folder_ / name;
        }

        const std::filesystem::path &path() const
        {
            return folder_;
        }

    private:
        std::filesystem::path folder_;
    };

    /** \brief A map from rows of letters, the top one first: `.` is free, `?` unknown, anything else occupied. */
    inline GridMap mapOf(const std::vector<std::string> &rows, const MapFrame &frame = {})
    {
        std::vector<Cell> cells;
        for (auto row = rows.rbegin(); row != rows.rend(); ++row)
        {
            for (const char letter : *row)
            {
                cells.push_back(letter == '.' ? Cell::Free : letter == '?' ? Cell::Unknown : Cell::Occupied);
            }
        }
        return GridMap(rows.front().size(), rows.size(), cells, frame);
    }

    /** \brief The rows that mapOf() makes \e map from, `#` for occupied cells. */
    inline std::vector<std::string> rowsOf(const GridMap &map)
    {
        std::vector<std::string> rows;
        for (std::size_t y = map.height(); y-- > 0;)
        {
            std::string row;
            for (std::size_t x = 0; x < map.width(); ++x)
            {
                row += ".#?"[static_cast<std::size_t>(map.cell(x, y))];
            }
            rows.push_back(row);
        }
        return rows;
    }

    /** \brief The folder of maps that are not part of the project; empty if there is none. */
    inline std::filesystem::path sharedMaps()
    {
        const char *named = std::getenv("OMPL_MFA_MAPS_DIR");
        const std::filesystem::path folder =
            named != nullptr ? named : std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "../shared/maps";
        return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
    }
}  // namespace ompl_mfa::maps::test

#endif
