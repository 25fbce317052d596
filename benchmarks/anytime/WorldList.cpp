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

#include "anytime/WorldList.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <utility>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::anytime
{
    namespace
    {
        std::filesystem::path omplAppFolder()
        {
            const char *folder = std::getenv("OMPL_MFA_OMPLAPP_DIR");
            return folder != nullptr ? folder : std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "../shared/omplapp";
        }

        std::regex compile(const std::string &pattern)
        {
            try
            {
                return std::regex(pattern);
            }
            catch (const std::regex_error &error)
            {
                throw InputError("--worlds '" + pattern + "': expected a regular expression: " + error.what());
            }
        }
    }  // namespace

    std::vector<World> allWorlds()
    {
        std::vector<World> worlds = circleWorlds();
        const auto append = [&worlds](std::vector<World> more)
        { std::move(more.begin(), more.end(), std::back_inserter(worlds)); };
        append(boxWorlds());
        append(armWorlds());
        append(configWorlds(std::filesystem::path(OMPL_MFA_SOURCE_DIR) / "benchmarks/configs", "own_"));
        append(omplAppWorlds(omplAppFolder()));
        return worlds;
    }

    std::vector<World> selectWorlds(const std::string &pattern)
    {
        const std::regex expression = compile(pattern);
        std::vector<World> selected;
        for (auto &world : allWorlds())
        {
            if (std::regex_search(world.name, expression))
            {
                selected.push_back(std::move(world));
            }
        }
        if (selected.empty())
        {
            throw InputError("--worlds '" + pattern + "': no world has such a name; `ompl_mfa_anytime list` names all");
        }
        return selected;
    }

    std::vector<World> selectWorlds(const std::string &pattern, const std::vector<std::string> &generated,
                                    const std::vector<std::filesystem::path> &configs)
    {
        std::vector<World> worlds = generatedWorlds(generated);
        std::transform(configs.begin(), configs.end(), std::back_inserter(worlds), configWorld);
        if (pattern.empty() && !worlds.empty())
        {
            return worlds;
        }
        for (auto &world : selectWorlds(pattern))
        {
            const auto isSame = [&world](const World &other) { return other.name == world.name; };
            if (std::none_of(worlds.begin(), worlds.end(), isSame))
            {
                worlds.push_back(std::move(world));
            }
        }
        return worlds;
    }

    std::string namePattern(const std::string &pattern, const std::vector<std::string> &generated,
                            const std::vector<std::filesystem::path> &configs)
    {
        std::vector<std::string> names = generated;
        std::transform(configs.begin(), configs.end(), std::back_inserter(names),
                       [](const std::filesystem::path &file) { return file.stem().string(); });
        std::string both = pattern;
        for (const std::string &name : names)
        {
            both += (both.empty() ? "^" : "|^") + name + "$";
        }
        return both;
    }
}  // namespace ompl_mfa::anytime
