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

#include "anytime/RunFile.h"

#include <cmath>
#include <iterator>

#include <nlohmann/json.hpp>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        using Json = nlohmann::ordered_json;

        /* JSON has no infinity. */
        Json finiteOrNull(double value)
        {
            return std::isfinite(value) ? Json(value) : Json(nullptr);
        }

        /* One entry an improvement: wall seconds, processor seconds, cost, states checked. */
        Json toJson(const ImprovementLog &log)
        {
            Json improvements = Json::array();
            for (std::uint32_t i = 0; i < log.count; ++i)
            {
                const Improvement &entry = log.entries[i];
                improvements.push_back({entry.wall, entry.cpu, entry.cost, entry.checks});
            }
            return improvements;
        }

        /* One entry a state. */
        Json pathOf(const RunResult &result)
        {
            Json path = Json::array();
            const std::size_t width = result.states > 0 ? result.reals / result.states : 0;
            for (std::size_t i = 0; width * result.states == result.reals && i < result.states; ++i)
                path.push_back(std::vector<double>(result.path + i * width, result.path + (i + 1) * width));
            return path;
        }

        Json toJson(const RunProcess &run)
        {
            const RunRequest &request = run.request();
            const RunResult &result = run.result();
            return {{"world", request.world->name},
                    {"family", request.world->family},
                    {"planner", request.planner},
                    {"seed", request.seed},
                    {"time_limit", request.timeLimit},
                    {"clock", clockName(request.clock)},
                    {"status", run.status()},
                    {"note", run.note()},
                    {"solved", result.solved},
                    {"valid", result.valid},
                    {"cost", finiteOrNull(result.solved ? result.cost : INFINITY)},
                    {"wall", result.wall},
                    {"cpu", result.cpu},
                    {"checks", result.checks},
                    {"path_check", result.pathCheck},
                    {"path_checks", result.pathChecks},
                    {"looks", result.looks},
                    {"longest_gap", result.longestGap},
                    {"path", pathOf(result)},
                    {"improvements", toJson(result.log)}};
        }

        std::string readAll(const std::filesystem::path &file)
        {
            std::ifstream in(file, std::ios::binary);
            return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        }
    }  // namespace

    RunFile::RunFile(const std::filesystem::path &file)
    {
        if (std::filesystem::exists(file))
        {
            const std::string text = readAll(file);
            const std::size_t end = text.rfind('\n');
            std::filesystem::resize_file(file, end == std::string::npos ? 0 : end + 1);
            readKeys(file);
        }
        out_.open(file, std::ios::app);
        if (!out_)
            throw InputError(file.string() + ": cannot be written");
    }

    void RunFile::readKeys(const std::filesystem::path &file)
    {
        std::ifstream in(file);
        std::string line;
        for (std::size_t number = 1; std::getline(in, line); ++number)
        {
            try
            {
                const Json run = Json::parse(line);
                keys_.emplace(run.at("world"), run.at("planner"), run.at("seed"), run.at("time_limit"),
                              run.at("clock"));
            }
            catch (const Json::exception &error)
            {
                throw InputError(file.string() + ":" + std::to_string(number) + ": not a run: " + error.what());
            }
        }
    }

    RunFile::Key RunFile::keyOf(const RunRequest &request)
    {
        return {request.world->name, request.planner, request.seed, request.timeLimit, clockName(request.clock)};
    }

    bool RunFile::has(const RunRequest &request) const
    {
        return keys_.count(keyOf(request)) > 0;
    }

    void RunFile::append(const RunProcess &run)
    {
        out_ << toJson(run).dump() << '\n' << std::flush;
        keys_.insert(keyOf(run.request()));
    }
}  // namespace ompl_mfa::anytime
