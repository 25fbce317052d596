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

#include "benchmark/ConfigKeys.h"

#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <boost/algorithm/string.hpp>

#include "benchmark/InputErrorOf.h"

namespace ompl_mfa::benchmark
{
    namespace
    {
        using Cells = std::vector<std::string>;

        template <typename Config>
        void append(std::vector<Cells> &table, const std::vector<ConfigRow<Config>> &rows)
        {
            for (const auto &row : rows)
            {
                table.push_back({boost::algorithm::join(row.keys, ", "), row.accepted, row.fallback, row.meaning});
            }
        }

        /* A cell as the program prints it: without markup, and without the mark of keys that OMPL.app does not have. */
        std::string plain(const std::string &cell)
        {
            static const std::regex LINK(R"(\[([^\]]*)\]\([^)]*\))");
            std::string text = std::regex_replace(cell, LINK, "$1");
            boost::erase_all(text, "**new:** ");
            boost::erase_all(text, "`");
            return boost::trim_copy(text);
        }

        /* The rows of the first table after \e heading, without markup and without the header row. */
        std::vector<Cells> documented(const std::string &heading)
        {
            std::ifstream in(std::string(OMPL_MFA_SOURCE_DIR) + "/docs/configs.md");
            std::vector<Cells> table;
            std::string line;
            while (std::getline(in, line) && line != heading)
            {
            }
            while (std::getline(in, line) && (table.empty() || !line.empty()))
            {
                if (line.empty() || line.front() != '|')
                {
                    continue;
                }
                const std::string inner = line.substr(1, line.size() - 2);
                Cells cells;
                boost::split(cells, inner, boost::is_any_of("|"));
                std::transform(cells.begin(), cells.end(), cells.begin(), plain);
                table.push_back(cells);
            }
            if (table.size() < 2)
            {
                return {};
            }
            EXPECT_EQ(table[0], (Cells{"key", "accepted", "default", "meaning"}));
            return {table.begin() + 2, table.end()};
        }

        void expectEqual(const std::vector<Cells> &inDocs, const std::vector<Cells> &inCode)
        {
            ASSERT_EQ(inDocs.size(), inCode.size());
            for (std::size_t i = 0; i < inDocs.size(); ++i)
            {
                EXPECT_EQ(inDocs[i], inCode[i]) << "row " << i + 1;
            }
        }

        TEST(ConfigKeys, TheTableOfProblemIsTheDocumentedOne)
        {
            std::vector<Cells> table;
            append(table, problemRows());
            append(table, contextRows());
            expectEqual(documented("## `[problem]`"), table);
        }

        TEST(ConfigKeys, TheTableOfBenchmarkIsTheDocumentedOne)
        {
            std::vector<Cells> table;
            append(table, campaignRows());
            expectEqual(documented("## `[benchmark]`"), table);
        }

        template <typename Config>
        void expectRefusals(const std::vector<ConfigRow<Config>> &rows)
        {
            // files and names in them are checked when they are read, and the message for a folder is another one
            const std::set<std::string> paths = {"world",       "robot",          "output",        "robot.semantics",
                                                 "robot.group", "robot.packages", "robot.request", "start",
                                                 "goal",        "scenario",       "known_map"};
            for (const auto &row : rows)
            {
                for (std::size_t i = 0; i < row.keys.size(); ++i)
                {
                    if (paths.count(row.keys[i]) > 0)
                    {
                        continue;
                    }
                    Config config;
                    const std::string error = test::inputErrorOf(
                        [&] {
                            row.set(config, i, {row.keys[i], "no/such value", "a.cfg:3"});
                        });
                    EXPECT_EQ(error.find("a.cfg:3: " + row.keys[i] + " = no/such value: "), 0u) << error;
                    EXPECT_NE(error.find("expected " + row.accepted), std::string::npos) << error;
                }
            }
        }

        TEST(ConfigKeys, ErrorsSayWhatTheTableAccepts)
        {
            expectRefusals(problemRows());
            expectRefusals(contextRows());
            expectRefusals(campaignRows());
        }

        TEST(ConfigKeys, EachKeyHasAPlaceOfItsOwn)
        {
            ProblemConfig problem;
            double value = 1.0;
            for (const auto *key : {"start.x",      "start.y",      "start.z",      "start.axis.x", "start.axis.y",
                                    "start.axis.z", "start.theta",  "goal.x",       "goal.y",       "goal.z",
                                    "goal.axis.x",  "goal.axis.y",  "goal.axis.z",  "goal.theta",   "volume.min.x",
                                    "volume.min.y", "volume.min.z", "volume.max.x", "volume.max.y", "volume.max.z"})
            {
                EXPECT_TRUE(setValue(problemRows(), key, {key, std::to_string(value), "a.cfg:3"}, problem));
                ++value;
            }
            value = 1.0;
            for (const auto *pose : {&problem.start, &problem.goal})
            {
                for (const double place :
                     {pose->x, pose->y, pose->z, pose->axis[0], pose->axis[1], pose->axis[2], pose->theta})
                {
                    EXPECT_EQ(place, value++);
                }
            }
            ASSERT_TRUE(problem.volume);
            for (const auto *end : {problem.volume->min, problem.volume->max})
            {
                for (int axis = 0; axis < 3; ++axis)
                {
                    EXPECT_EQ(end[axis], value++);
                }
            }
            EXPECT_FALSE(setValue(problemRows(), "start.w", {"start.w", "1", "a.cfg:3"}, problem));
        }
    }  // namespace
}  // namespace ompl_mfa::benchmark
