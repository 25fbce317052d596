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

#include <fstream>
#include <string>
#include <vector>

#include "maps/MapImage.h"
#include "maps/MapReaders.h"
#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::maps
{
    namespace
    {
        const std::string FREE = ".GS";
        const std::string OCCUPIED = "@OTW";

        /* Reads one file, line by line. */
        class Reader
        {
        public:
            explicit Reader(const std::filesystem::path &file)
              : file_(file)
              , in_(file, std::ios::binary)
            {
                if (!in_)
                {
                    throw InputError(file.string() + ": not readable");
                }
            }

            GridMap read()
            {
                if (words(nextLine()) != std::vector<std::string>{"type", "octile"})
                {
                    fail("expected 'type octile', the first line of a MovingAI map");
                }
                std::size_t width = 0;
                std::size_t height = 0;
                std::string line = nextLine();
                for (; trimmed(line) != "map"; line = nextLine())
                {
                    readSize(line, width, height);
                }
                if (width == 0 || height == 0)
                {
                    fail("'map' is preceded by 'height N' and 'width N'");
                }
                requireMemory(width, height, file_.string());
                std::vector<Cell> cells;
                cells.reserve(width * height);
                for (std::size_t row = 0; row < height; ++row)
                {
                    readRow(row, width, height, cells);
                }
                requireEnd(height);
                MapFrame frame;
                frame.origin = Eigen::Vector2d(-0.5, -0.5);
                frame.yDown = true;
                return GridMap(width, height, std::move(cells), frame);
            }

        private:
            [[noreturn]] void fail(const std::string &fault) const
            {
                throw InputError(file_.string() + ":" + std::to_string(line_) + ": " + fault);
            }

            std::string nextLine()
            {
                std::string line;
                ++line_;
                if (!std::getline(in_, line))
                {
                    fail("the file ends before 'map'; expected 'type octile', 'height N', 'width N', 'map' and N rows");
                }
                return line;
            }

            static std::vector<std::string> words(const std::string &line)
            {
                const std::string text = trimmed(line);
                const std::size_t blank = text.find_first_of(" \t");
                return blank == std::string::npos
                           ? std::vector<std::string>{text}
                           : std::vector<std::string>{text.substr(0, blank), trimmed(text.substr(blank))};
            }

            void readSize(const std::string &line, std::size_t &width, std::size_t &height) const
            {
                constexpr std::size_t LARGEST = 1000000;
                const auto parts = words(line);
                if (parts.size() != 2 || (parts[0] != "width" && parts[0] != "height"))
                {
                    fail("'" + trimmed(line) + "': expected 'height N', 'width N' or 'map'");
                }
                std::size_t value = 0;
                if (!text::readNumber(parts[1], value) || value == 0 || value > LARGEST)
                {
                    fail(parts[0] + " " + parts[1] + ": expected a whole number from 1 to " + std::to_string(LARGEST));
                }
                (parts[0] == "width" ? width : height) = value;
            }

            void readRow(std::size_t row, std::size_t width, std::size_t height, std::vector<Cell> &cells)
            {
                std::string line;
                ++line_;
                if (!std::getline(in_, line))
                {
                    fail("the file ends after " + std::to_string(row) + " rows; 'height " + std::to_string(height) +
                         "' announces " + std::to_string(height));
                }
                if (!line.empty() && line.back() == '\r')
                {
                    line.pop_back();
                }
                if (line.size() != width)
                {
                    fail("the row has " + std::to_string(line.size()) + " cells; 'width " + std::to_string(width) +
                         "' announces " + std::to_string(width));
                }
                for (const char letter : line)
                {
                    const bool isFree = FREE.find(letter) != std::string::npos;
                    if (!isFree && OCCUPIED.find(letter) == std::string::npos)
                    {
                        fail(std::string("unknown cell '") + letter + "'; expected one of . G S (free), @ O T W");
                    }
                    cells.push_back(isFree ? Cell::Free : Cell::Occupied);
                }
            }

            void requireEnd(std::size_t height)
            {
                for (std::string line; std::getline(in_, line);)
                {
                    ++line_;
                    if (!trimmed(line).empty())
                    {
                        fail("a row beyond the " + std::to_string(height) + " that 'height " + std::to_string(height) +
                             "' announces");
                    }
                }
            }

            std::filesystem::path file_;
            std::ifstream in_;
            std::size_t line_{0};
        };
    }  // namespace

    GridMap loadMovingAiMap(const std::filesystem::path &file)
    {
        return Reader(file).read();
    }
}  // namespace ompl_mfa::maps
