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

#include "ompl_mfa/maps/ObstacleGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "maps/DistanceTransform.h"

namespace ompl_mfa::maps
{
    namespace
    {
        constexpr std::int64_t WORD = 64;
        /* Half a diagonal of a cell, rounded up. */
        constexpr double HALF_DIAGONAL = 0.70710679;
        constexpr double HALF_SIDE = 0.5;
        /* Bound of the rounding of distances, which are kept as floats of up to the size of the map. */
        constexpr double ROUNDING = 1e-6;

        std::int64_t cellOf(double coordinate, std::int64_t count)
        {
            return std::clamp(static_cast<std::int64_t>(std::floor(std::clamp(coordinate, -1.0, 1e9))),
                              std::int64_t{-1}, count - 2) +
                   1;
        }
    }  // namespace

    ObstacleGrid::ObstacleGrid(GridMap map, UnknownCells unknown, double farthest)
      : map_(std::move(map))
      , unknown_(unknown)
      , farthest_(std::max(1.0, farthest))
      , columns_(static_cast<std::int64_t>(map_.width()) + 2)
      , rows_(static_cast<std::int64_t>(map_.height()) + 2)
      , words_((columns_ + WORD - 1) / WORD)
      , bits_(static_cast<std::size_t>(words_ * rows_))
    {
        for (std::int64_t y = 0; y < rows_; ++y)
        {
            const bool isFrame = y == 0 || y == rows_ - 1;
            const Cell *cells = isFrame ? nullptr : &map_.cells()[static_cast<std::size_t>(y - 1) * map_.width()];
            std::uint64_t *words = &bits_[static_cast<std::size_t>(y * words_)];
            for (std::int64_t x = 0; x < columns_; ++x)
            {
                const bool isSet = isFrame || x == 0 || x == columns_ - 1 || isObstacle(cells[x - 1]);
                words[x / WORD] |= std::uint64_t{isSet} << (x % WORD);
            }
        }
        computeDistances({0, columns_ - 1, 0, rows_ - 1});
    }

    bool ObstacleGrid::isObstacle(Cell cell) const
    {
        return cell == Cell::Occupied || (cell == Cell::Unknown && unknown_ == UnknownCells::Occupied);
    }

    void ObstacleGrid::setBit(std::int64_t x, std::int64_t y, bool isObstacle)
    {
        std::uint64_t &word = bits_[static_cast<std::size_t>(y * words_ + x / WORD)];
        const std::uint64_t bit = std::uint64_t{1} << (x % WORD);
        word = isObstacle ? word | bit : word & ~bit;
    }

    ObstacleGrid::Window ObstacleGrid::grown(const Window &window, double distance) const
    {
        const auto cells = static_cast<std::int64_t>(std::ceil(std::min(distance, 1e9)));
        return {std::max(std::int64_t{0}, window.left - cells), std::min(columns_ - 1, window.right + cells),
                std::max(std::int64_t{0}, window.low - cells), std::min(rows_ - 1, window.high + cells)};
    }

    void ObstacleGrid::computeDistances(const Window &changed)
    {
        // distances up to the farthest are decided by obstacles as far from their cells
        const Window target = grown(changed, farthest_);
        const Window source = grown(target, farthest_);
        const std::int64_t width = source.right - source.left + 1;
        const std::int64_t height = source.high - source.low + 1;
        std::vector<std::uint8_t> occupied(static_cast<std::size_t>(width * height));
        for (std::int64_t y = 0; y < height; ++y)
        {
            const std::uint64_t *words = &bits_[static_cast<std::size_t>((y + source.low) * words_)];
            std::uint8_t *row = &occupied[static_cast<std::size_t>(y * width)];
            for (std::int64_t x = 0; x < width; ++x)
            {
                const std::int64_t column = x + source.left;
                row[x] = (words[column / WORD] >> (column % WORD)) & 1U;
            }
        }
        std::vector<float> distances =
            signedDistances(occupied, static_cast<std::size_t>(width), static_cast<std::size_t>(height));
        if (std::isinf(farthest_))
        {
            distances_ = std::move(distances);
            return;
        }
        distances_.resize(static_cast<std::size_t>(columns_ * rows_));
        const auto farthest = static_cast<float>(farthest_);
        for (std::int64_t y = target.low; y <= target.high; ++y)
        {
            const float *row = &distances[static_cast<std::size_t>((y - source.low) * width)];
            float *to = &distances_[static_cast<std::size_t>(y * columns_)];
            for (std::int64_t x = target.left; x <= target.right; ++x)
            {
                to[x] = std::clamp(row[x - source.left], -farthest, farthest);
            }
        }
    }

    bool ObstacleGrid::update(const std::vector<CellChange> &changes)
    {
        // Changes that are far apart, such as the ends of a lidar's rays, are cheaper in separate windows.
        constexpr std::int64_t BLOCK = 64;
        std::map<std::pair<std::int64_t, std::int64_t>, Window> windows;
        const auto extend = [](Window &window, std::int64_t x, std::int64_t y) {
            window = {std::min(window.left, x), std::max(window.right, x), std::min(window.low, y),
                      std::max(window.high, y)};
        };
        for (const CellChange &change : changes)
        {
            const bool before = isObstacle(map_.cell(change.x, change.y));
            map_.setCell(change.x, change.y, change.cell);
            if (before == isObstacle(change.cell))
            {
                continue;
            }
            const auto x = static_cast<std::int64_t>(change.x) + 1;
            const auto y = static_cast<std::int64_t>(change.y) + 1;
            setBit(x, y, !before);
            extend(windows.emplace(std::make_pair(x / BLOCK, y / BLOCK), Window{x, x, y, y}).first->second, x, y);
        }
        if (windows.empty())
        {
            return false;
        }
        Window all = windows.begin()->second;
        double separate = 0.0;
        const auto work = [this](const Window &changed)
        {
            const Window source = grown(changed, 2.0 * farthest_);
            return static_cast<double>((source.right - source.left + 1) * (source.high - source.low + 1));
        };
        for (const auto &[block, window] : windows)
        {
            extend(all, window.left, window.low);
            extend(all, window.right, window.high);
            separate += work(window);
        }
        if (work(all) <= separate)
        {
            computeDistances(all);
            return true;
        }
        for (const auto &[block, window] : windows)
        {
            computeDistances(window);
        }
        return true;
    }

    bool ObstacleGrid::isOccupied(std::int64_t x, std::int64_t y) const
    {
        return isAnyOccupied(y, x, x);
    }

    bool ObstacleGrid::isAnyOccupied(std::int64_t row, std::int64_t first, std::int64_t last) const
    {
        if (row < 0 || row >= rows_ - 2 || first < 0 || last >= columns_ - 2)
        {
            return first <= last;
        }
        const std::uint64_t *words = &bits_[static_cast<std::size_t>((row + 1) * words_)];
        const std::int64_t begin = first + 1;
        const std::int64_t end = last + 1;
        for (std::int64_t word = begin / WORD; word <= end / WORD; ++word)
        {
            std::uint64_t mask = ~std::uint64_t{0};
            if (word == begin / WORD)
            {
                mask <<= begin % WORD;
            }
            if (word == end / WORD)
            {
                mask &= ~std::uint64_t{0} >> (WORD - 1 - end % WORD);
            }
            if ((words[word] & mask) != 0)
            {
                return begin <= end;
            }
        }
        return false;
    }

    double ObstacleGrid::distance(const Eigen::Vector2d &position) const
    {
        // centres of the cells of the frame have the coordinates -0.5 and width + 0.5
        const Eigen::Vector2d inside(std::clamp(position.x(), -HALF_SIDE, static_cast<double>(columns_) - 1.5),
                                     std::clamp(position.y(), -HALF_SIDE, static_cast<double>(rows_) - 1.5));
        const std::int64_t x = std::min(static_cast<std::int64_t>(inside.x() + HALF_SIDE), columns_ - 2);
        const std::int64_t y = std::min(static_cast<std::int64_t>(inside.y() + HALF_SIDE), rows_ - 2);
        const double right = inside.x() + HALF_SIDE - static_cast<double>(x);
        const double up = inside.y() + HALF_SIDE - static_cast<double>(y);
        // from centre to centre, less half a side of the obstacle or of the free cell
        const auto value = [this](std::int64_t column, std::int64_t row)
        {
            const double centres = between(column, row);
            return centres > 0.0 ? centres - HALF_SIDE : centres + HALF_SIDE;
        };
        const double lower = (1.0 - right) * value(x, y) + right * value(x + 1, y);
        const double upper = (1.0 - right) * value(x, y + 1) + right * value(x + 1, y + 1);
        return (1.0 - up) * lower + up * upper - (position - inside).norm();
    }

    double ObstacleGrid::leastDistance(const Eigen::Vector2d &position) const
    {
        const std::int64_t x = cellOf(position.x(), columns_);
        const std::int64_t y = cellOf(position.y(), rows_);
        const Eigen::Vector2d centre(static_cast<double>(x) - HALF_SIDE, static_cast<double>(y) - HALF_SIDE);
        return between(x, y) * (1.0 - ROUNDING) - HALF_DIAGONAL - (position - centre).norm();
    }

    double ObstacleGrid::largestDistance(const Eigen::Vector2d &position) const
    {
        const std::int64_t x = cellOf(position.x(), columns_);
        const std::int64_t y = cellOf(position.y(), rows_);
        const Eigen::Vector2d centre(static_cast<double>(x) - HALF_SIDE, static_cast<double>(y) - HALF_SIDE);
        const double centres = between(x, y);
        if (centres >= farthest_)
        {
            return static_cast<double>(columns_ + rows_) + (position - centre).norm();
        }
        return centres > 0.0 ? centres * (1.0 + ROUNDING) - HALF_SIDE + (position - centre).norm() : 0.0;
    }
}  // namespace ompl_mfa::maps
