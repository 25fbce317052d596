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

#ifndef OMPL_MFA_BENCHMARK_CONFIG_KEYS_
#define OMPL_MFA_BENCHMARK_CONFIG_KEYS_

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ompl_mfa/Export.h"
#include "ompl_mfa/benchmark/ConfigFile.h"

namespace ompl_mfa::benchmark
{
    /** \brief Keys of a config with a common description: accepted values, default, meaning, and setter.
        docs/configs.md has the same rows, and a test compares them. */
    template <typename Config>
    struct ConfigRow
    {
        /** \brief Names within their section, in lower case. */
        std::vector<std::string> keys;
        /** \brief Type, range or keywords, as used in an error after "expected". */
        std::string accepted;
        /** \brief The default; "required" if there is none. */
        std::string fallback;
        /** \brief One line, with the unit of the value. */
        std::string meaning;
        /** \brief Reads the value of the key with this index in `keys`. Throws InputError, naming what is accepted. */
        std::function<void(Config &, std::size_t, const ConfigEntry &)> set;
    };

    /** \brief The rows of [problem] that planners cannot override. */
    OMPL_MFA_EXPORT const std::vector<ConfigRow<ProblemConfig>> &problemRows();

    /** \brief The rows of [problem] that a planner may override, as `problem.KEY` in [planner]. */
    OMPL_MFA_EXPORT const std::vector<ConfigRow<ContextConfig>> &contextRows();

    /** \brief The rows of [benchmark]. */
    OMPL_MFA_EXPORT const std::vector<ConfigRow<CampaignConfig>> &campaignRows();

    /** \brief The keyword of \e sampler in configs. */
    OMPL_MFA_EXPORT std::string samplerName(SamplerKind sampler);

    /** \brief All keys of \e rows, in their order. */
    template <typename Config>
    std::vector<std::string> keysOf(const std::vector<ConfigRow<Config>> &rows)
    {
        std::vector<std::string> keys;
        for (const auto &row : rows)
        {
            keys.insert(keys.end(), row.keys.begin(), row.keys.end());
        }
        return keys;
    }

    /** \brief Sets the value of \e key in \e config from \e entry; false if no row has \e key. */
    template <typename Config>
    bool setValue(const std::vector<ConfigRow<Config>> &rows, const std::string &key, const ConfigEntry &entry,
                  Config &config)
    {
        for (const auto &row : rows)
        {
            const auto place = std::find(row.keys.begin(), row.keys.end(), key);
            if (place == row.keys.end())
            {
                continue;
            }
            row.set(config, static_cast<std::size_t>(place - row.keys.begin()), entry);
            return true;
        }
        return false;
    }
}  // namespace ompl_mfa::benchmark

#endif
