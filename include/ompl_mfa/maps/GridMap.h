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

#ifndef OMPL_MFA_MAPS_GRID_MAP_
#define OMPL_MFA_MAPS_GRID_MAP_

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "ompl_mfa/Export.h"

namespace ompl_mfa::maps
{
    /** \brief What is known of a cell. */
    enum class Cell : std::uint8_t
    {
        Free,
        Occupied,
        Unknown
    };

    /** \brief Where the cells of a map are in the world. */
    struct MapFrame
    {
        /** \brief Side of a cell in world units, above 0. */
        double resolution{1.0};
        /** \brief The corner of cell (0, 0) that no other cell touches. */
        Eigen::Vector2d origin{0.0, 0.0};
        /** \brief Rotation of the map about its origin, radians. */
        double yaw{0.0};
        /** \brief Whether y points down in pictures of the map, as in MovingAI maps, whose rows are counted from the
            top. */
        bool yDown{false};
    };

    /** \brief An occupancy grid: square cells in rows along x, and their frame. What is outside of it is not part of
        the map. */
    class OMPL_MFA_EXPORT GridMap
    {
    public:
        /** \brief The cells row by row, the row at y = 0 first. Throws std::invalid_argument if their number is not
            width times height, if there is none, or if the resolution is not above 0. */
        GridMap(std::size_t width, std::size_t height, std::vector<Cell> cells, const MapFrame &frame);

        std::size_t width() const
        {
            return width_;
        }

        std::size_t height() const
        {
            return height_;
        }

        /** \brief The cell in column x < width() and row y < height(). */
        Cell cell(std::size_t x, std::size_t y) const
        {
            return cells_[y * width_ + x];
        }

        /** \brief Sets the cell in column x < width() and row y < height(). */
        void setCell(std::size_t x, std::size_t y, Cell cell)
        {
            cells_[y * width_ + x] = cell;
        }

        const std::vector<Cell> &cells() const
        {
            return cells_;
        }

        const MapFrame &frame() const
        {
            return frame_;
        }

        /** \brief Position in cells: cell (i, j) is the square from (i, j) to (i + 1, j + 1). */
        Eigen::Vector2d toGrid(const Eigen::Vector2d &world) const
        {
            return rotation_.transpose() * (world - frame_.origin) / frame_.resolution;
        }

        /** \brief Inverse of toGrid(). */
        Eigen::Vector2d toWorld(const Eigen::Vector2d &grid) const
        {
            return frame_.origin + frame_.resolution * (rotation_ * grid);
        }

        /** \brief The smallest box in the world that holds all cells. */
        Eigen::AlignedBox2d bounds() const;

    private:
        std::size_t width_;
        std::size_t height_;
        std::vector<Cell> cells_;
        MapFrame frame_;
        Eigen::Matrix2d rotation_;
    };
}  // namespace ompl_mfa::maps

#endif
