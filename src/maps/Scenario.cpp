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

#include "ompl_mfa/maps/Scenario.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "ompl_mfa/InputError.h"
#include "ompl_mfa/PlainText.h"
#include "text/NumberText.h"

namespace ompl_mfa::maps
{
    namespace
    {
        /* Reads the lines of one file. */
        class Reader
        {
        public:
            Reader(const std::filesystem::path &file, const GridMap &map, std::filesystem::path mapFile)
              : file_(file)
              , in_(file)
              , map_(map)
              , mapFile_(std::move(mapFile))
            {
                if (!in_ || std::filesystem::is_directory(file))
                {
                    throw InputError(file.string() + ": scenario not found or not readable");
                }
            }

            std::vector<ScenarioProblem> read()
            {
                std::vector<ScenarioProblem> problems;
                for (std::string line; std::getline(in_, line);)
                {
                    ++line_;
                    std::istringstream words(line);
                    words_.clear();
                    for (std::string word; words >> word;)
                    {
                        words_.push_back(word);
                    }
                    if (words_.empty() || (line_ == 1 && words_[0] == "version"))
                    {
                        continue;
                    }
                    problems.push_back(readProblem(problems.size()));
                }
                if (problems.empty())
                {
                    throw InputError(file_.string() + ": the scenario has no problem");
                }
                return problems;
            }

        private:
            std::string origin() const
            {
                return file_.string() + ":" + std::to_string(line_);
            }

            [[noreturn]] void fail(const std::string &fault) const
            {
                throw InputError(origin() + ": " + fault);
            }

            ScenarioProblem readProblem(std::size_t index) const
            {
                constexpr std::size_t COLUMNS = 9;
                if (words_.size() != COLUMNS)
                {
                    fail("the line has " + std::to_string(words_.size()) +
                         " columns; expected bucket, map, width, height, start x, start y, goal x, goal y and length");
                }
                const std::string name = std::filesystem::path(words_[1]).filename().string();
                if (name != mapFile_.filename().string())
                {
                    fail("the scenario is for the map '" + name + "', not for '" + mapFile_.filename().string() + "'");
                }
                if (whole(2, "width") != map_.width() || whole(3, "height") != map_.height())
                {
                    fail("the scenario is for a map of " + words_[2] + " x " + words_[3] + " cells; '" +
                         mapFile_.string() + "' has " + std::to_string(map_.width()) + " x " +
                         std::to_string(map_.height()));
                }
                double length = 0.0;
                if (!text::readNumber(words_[8], length) || !std::isfinite(length) || length < 0.0)
                {
                    fail("length " + words_[8] + ": expected a number of at least 0");
                }
                return {index, position(4, "start"), position(6, "goal"), length, origin()};
            }

            std::size_t whole(std::size_t column, const std::string &name) const
            {
                std::size_t value = 0;
                if (!text::readNumber(words_[column], value))
                {
                    fail(name + " " + words_[column] + ": expected a whole number");
                }
                return value;
            }

            /* Rows of the map are stored in the order of the file. */
            Eigen::Vector2d position(std::size_t column, const std::string &name) const
            {
                const std::size_t x = whole(column, name + " x");
                const std::size_t y = whole(column + 1, name + " y");
                if (x >= map_.width() || y >= map_.height())
                {
                    fail("the " + name + " (" + words_[column] + ", " + words_[column + 1] +
                         ") is outside of the map of " + std::to_string(map_.width()) + " x " +
                         std::to_string(map_.height()) + " cells");
                }
                const double row = static_cast<double>(map_.frame().yDown ? y : map_.height() - 1 - y);
                return map_.toWorld(Eigen::Vector2d(static_cast<double>(x) + 0.5, row + 0.5));
            }

            std::filesystem::path file_;
            std::ifstream in_;
            const GridMap &map_;
            std::filesystem::path mapFile_;
            std::size_t line_{0};
            std::vector<std::string> words_;
        };
    }  // namespace

    std::vector<ScenarioProblem> loadScenario(const std::filesystem::path &file, const GridMap &map,
                                              const std::filesystem::path &mapFile)
    {
        return Reader(file, map, mapFile).read();
    }
}  // namespace ompl_mfa::maps
