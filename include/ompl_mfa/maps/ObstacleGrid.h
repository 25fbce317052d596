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

#ifndef OMPL_MFA_MAPS_OBSTACLE_GRID_
#define OMPL_MFA_MAPS_OBSTACLE_GRID_

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/maps/GridMap.h"

namespace ompl_mfa::maps
{
    /** \brief Whether a robot may enter unknown cells. */
    enum class UnknownCells
    {
        Occupied,
        Free
    };

    /** \brief What a cell is from now on. */
    struct CellChange
    {
        std::size_t x;
        std::size_t y;
        Cell cell;
    };

    /** \brief The obstacles of a map, closed squares, and the distances to them. Everything outside of the map is an
        obstacle. Positions and distances are in cells, see GridMap::toGrid().

        Made in time linear in the number of cells; const functions are safe to call from several threads, but not
        during update(). */
    class OMPL_MFA_EXPORT ObstacleGrid
    {
    public:
        /** \param map the cells
            \param unknown whether unknown cells are obstacles
            \param farthest cells, at least 1: distances are computed up to this one, which bounds the work of update()
         */
        explicit ObstacleGrid(GridMap map, UnknownCells unknown = UnknownCells::Occupied,
                              double farthest = std::numeric_limits<double>::infinity());

        /** \brief Changes cells of the map. The distances are those of a new grid, to the bit; they are computed again
            within farthest() of obstacles that appear or disappear. Returns whether there is one.

            What was computed from the grid before, such as the validity of states, may change: call
            MFA::validityChanged(). */
        bool update(const std::vector<CellChange> &changes);

        /** \brief Cells: distances are computed up to this one; larger ones count as it. */
        double farthest() const
        {
            return farthest_;
        }

        const GridMap &map() const
        {
            return map_;
        }

        /** \brief Whether the cell in this column and row is an obstacle; true outside of the map. */
        bool isOccupied(std::int64_t x, std::int64_t y) const;

        /** \brief Whether any cell from column \e first to \e last of \e row is an obstacle. */
        bool isAnyOccupied(std::int64_t row, std::int64_t first, std::int64_t last) const;

        /** \brief Signed distance from \e position to the nearest obstacle, or minus that to the nearest free cell,
            interpolated between the centres of cells: continuous, and true to within a cell up to farthest(). */
        double distance(const Eigen::Vector2d &position) const;

        /** \brief A distance within which there is no obstacle around \e position; negative if this is not known of any
            distance. */
        double leastDistance(const Eigen::Vector2d &position) const;

        /** \brief A distance within which there surely is an obstacle around \e position; 0 within obstacles. */
        double largestDistance(const Eigen::Vector2d &position) const;

    private:
        /** \brief Distance between the centre of the cell and that of the nearest of the other kind, negative for
            obstacles. Cells are counted from the frame of obstacles around the map. */
        double between(std::int64_t x, std::int64_t y) const
        {
            return distances_[static_cast<std::size_t>(y * columns_ + x)];
        }

        /** \brief Cells from the first to the last column and row, both included, counted from the frame. */
        struct Window
        {
            std::int64_t left;
            std::int64_t right;
            std::int64_t low;
            std::int64_t high;
        };

        Window grown(const Window &window, double distance) const;
        bool isObstacle(Cell cell) const;
        void setBit(std::int64_t x, std::int64_t y, bool isObstacle);
        void computeDistances(const Window &changed);

        GridMap map_;
        UnknownCells unknown_;
        double farthest_;
        /** \brief Size of the map with a frame of one cell around it. */
        std::int64_t columns_;
        std::int64_t rows_;
        /** \brief Words of 64 cells in a row, and all rows of them; a bit is set for an obstacle. */
        std::int64_t words_;
        std::vector<std::uint64_t> bits_;
        std::vector<float> distances_;
    };
}  // namespace ompl_mfa::maps

#endif
