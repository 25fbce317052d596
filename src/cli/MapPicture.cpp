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

#include "cli/MapPicture.h"

#include <algorithm>
#include <cmath>

namespace ompl_mfa::cli
{
    namespace
    {
        constexpr unsigned int OCCUPIED = 0x3b444b;
        constexpr unsigned int UNKNOWN = 0xb9bdc0;
        constexpr unsigned int TOO_CLOSE = 0xf0c4bb;
        constexpr unsigned int NEAR = 0xfdefc9;
        constexpr unsigned int FAR = 0xd6e9f5;
        /* More cells than this in a row or column are joined in blocks: a picture has fewer pixels. */
        constexpr std::size_t MOST_PIXELS = 1500;

        unsigned int mixed(unsigned int from, unsigned int to, double share)
        {
            unsigned int color = 0;
            for (const unsigned int shift : {16U, 8U, 0U})
            {
                const double first = (from >> shift) & 0xFF;
                const double second = (to >> shift) & 0xFF;
                color |= static_cast<unsigned int>(std::lround(first + share * (second - first))) << shift;
            }
            return color;
        }

        /* A block of cells. */
        struct Block
        {
            bool isOccupied{false};
            bool isUnknown{false};
            double distance{INFINITY};
        };

        Block blockOf(const maps::ObstacleGrid &grid, std::size_t size, std::size_t column, std::size_t row)
        {
            const maps::GridMap &map = grid.map();
            Block block;
            for (std::size_t y = row * size; y < std::min((row + 1) * size, map.height()); ++y)
            {
                for (std::size_t x = column * size; x < std::min((column + 1) * size, map.width()); ++x)
                {
                    const maps::Cell cell = map.cell(x, y);
                    const Eigen::Vector2d centre(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
                    block.isOccupied = block.isOccupied || cell == maps::Cell::Occupied;
                    block.isUnknown = block.isUnknown || cell == maps::Cell::Unknown;
                    block.distance = std::min(block.distance, grid.distance(centre));
                }
            }
            block.distance *= map.frame().resolution;
            return block;
        }
    }  // namespace

    Eigen::AlignedBox2d knownBox(const maps::GridMap &map)
    {
        constexpr double MARGIN = 0.03;
        Eigen::AlignedBox2d cells;
        for (std::size_t y = 0; y < map.height(); ++y)
        {
            for (std::size_t x = 0; x < map.width(); ++x)
            {
                if (map.cell(x, y) != maps::Cell::Unknown)
                {
                    const Eigen::Vector2d corner(static_cast<double>(x), static_cast<double>(y));
                    cells.extend(corner);
                    cells.extend(corner + Eigen::Vector2d(1.0, 1.0));
                }
            }
        }
        if (cells.isEmpty())
        {
            return map.bounds();
        }
        Eigen::AlignedBox2d box;
        for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                                  Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight})
        {
            box.extend(map.toWorld(cells.corner(corner)));
        }
        const Eigen::Vector2d margin = Eigen::Vector2d::Constant(MARGIN * box.sizes().maxCoeff());
        return Eigen::AlignedBox2d(box.min() - margin, box.max() + margin).intersection(map.bounds());
    }

    void addMap(Axes &axes, const maps::ObstacleGrid &grid, const maps::Footprint &footprint)
    {
        const maps::GridMap &map = grid.map();
        const std::size_t size = (std::max(map.width(), map.height()) + MOST_PIXELS - 1) / MOST_PIXELS;
        Raster raster;
        raster.width = (map.width() + size - 1) / size;
        raster.height = (map.height() + size - 1) / size;
        std::vector<Block> blocks;
        double farthest = 0.0;
        for (std::size_t row = 0; row < raster.height; ++row)
        {
            for (std::size_t column = 0; column < raster.width; ++column)
            {
                blocks.push_back(blockOf(grid, size, column, row));
                farthest = std::max(farthest, blocks.back().distance);
            }
        }
        const double inscribed = footprint.inscribedRadius();
        const double range = std::max(0.5 * (farthest - inscribed), map.frame().resolution);
        bool hasUnknown = false;
        for (const Block &block : blocks)
        {
            hasUnknown = hasUnknown || block.isUnknown;
            raster.colors.push_back(block.isOccupied  ? OCCUPIED
                                    : block.isUnknown ? UNKNOWN
                                    : block.distance < inscribed
                                        ? TOO_CLOSE
                                        : mixed(NEAR, FAR, std::min(1.0, (block.distance - inscribed) / range)));
        }
        const Eigen::Vector2d corner = map.toWorld({0.0, 0.0});
        raster.toAxes.matrix().col(0).head<2>() = (map.toWorld({1.0, 0.0}) - corner) * static_cast<double>(size);
        raster.toAxes.matrix().col(1).head<2>() = (map.toWorld({0.0, 1.0}) - corner) * static_cast<double>(size);
        raster.toAxes.matrix().col(2).head<2>() = corner;
        axes.addRaster(raster);

        const auto explain = [&axes](const std::string &words, unsigned int color) {
            axes.addLegendEntry({words, LegendEntry::Key::Patch, {0x5b6670, 0.6, color, 1.0}});
        };
        explain("occupied", OCCUPIED);
        if (hasUnknown)
        {
            explain("unknown", UNKNOWN);
        }
        if (inscribed > 0.0)
        {
            explain("within the inscribed radius", TOO_CLOSE);
        }
        explain("low clearance", NEAR);
        explain("high clearance", FAR);
    }
}  // namespace ompl_mfa::cli
