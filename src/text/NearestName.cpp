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

#include "text/NearestName.h"

#include <algorithm>
#include <numeric>

#include "ompl_mfa/InputError.h"

namespace ompl_mfa::text
{
    namespace
    {
        /** \brief Levenshtein distance. */
        std::size_t editDistance(const std::string &a, const std::string &b)
        {
            std::vector<std::size_t> row(b.size() + 1);
            std::iota(row.begin(), row.end(), std::size_t{0});
            for (std::size_t i = 0; i < a.size(); ++i)
            {
                std::size_t diagonal = row[0];
                row[0] = i + 1;
                for (std::size_t j = 0; j < b.size(); ++j)
                {
                    const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
                    diagonal = row[j + 1];
                    row[j + 1] = std::min({substituted, row[j] + 1, diagonal + 1});
                }
            }
            return row.back();
        }
    }  // namespace

    std::string nearestName(const std::string &name, const std::vector<std::string> &known)
    {
        std::string nearest;
        for (const auto &candidate : known)
        {
            if (!name.empty() && candidate.compare(0, name.size(), name) == 0 &&
                (nearest.empty() || candidate.size() < nearest.size()))
            {
                nearest = candidate;
            }
        }
        if (!nearest.empty())
        {
            return nearest;
        }
        // a more distant guess would only distract
        std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
        for (const auto &candidate : known)
        {
            const std::size_t distance = editDistance(name, candidate);
            if (distance < least)
            {
                least = distance;
                nearest = candidate;
            }
        }
        return nearest;
    }

    std::string suggestion(const std::string &name, const std::vector<std::string> &known)
    {
        constexpr std::size_t FEW = 10;
        const std::string nearest = nearestName(name, known);
        std::string text = nearest.empty() ? ";" : "; did you mean '" + nearest + "'?";
        if (!nearest.empty() && known.size() > FEW)
        {
            return text;
        }
        text += " accepted:";
        for (std::size_t i = 0; i < known.size(); ++i)
        {
            text += (i == 0 ? " " : ", ") + known[i];
        }
        return text;
    }

    std::string describeUnknown(const std::string &kind, const std::string &name,
                                const std::vector<std::string> &accepted)
    {
        return "unknown " + kind + " '" + name + "'" + suggestion(name, accepted);
    }

    void requireKnown(const std::string &kind, const std::string &name, const std::vector<std::string> &accepted)
    {
        if (std::find(accepted.begin(), accepted.end(), name) == accepted.end())
        {
            throw InputError(describeUnknown(kind, name, accepted));
        }
    }
}  // namespace ompl_mfa::text
