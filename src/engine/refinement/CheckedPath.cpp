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

#include "engine/refinement/CheckedPath.h"

#include <algorithm>
#include <utility>

namespace ob = ompl::base;

namespace ompl_mfa::engine::refinement
{
    namespace
    {
        /* States that a repair may have inserted into one motion. */
        constexpr std::size_t MAX_INSERTED = 16;
    }  // namespace

    CheckedPath::CheckedPath(ob::SpaceInformationPtr si)
      : si_(std::move(si))
      , path_(si_->getStateSpace())
    {
    }

    void CheckedPath::insertRepairs(path::Waypoints &path)
    {
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const std::size_t from = find(path_, hint_, path[i - 1]);
            std::size_t to = from + 1;
            while (to < path_.size() && !original_[to] && to <= from + MAX_INSERTED)
            {
                ++to;
            }
            if (to >= path_.size() || !si_->equalStates(path_[to], path[i]))
            {
                continue;
            }
            for (std::size_t k = from + 1; k < to; ++k, ++i)
            {
                path.insert(i, path_[k]);
            }
        }
    }

    bool CheckedPath::isMotionOf(const path::Waypoints &path, std::size_t &hint, const ob::State *from,
                                 const ob::State *to) const
    {
        const std::size_t i = find(path, hint, from);
        return i + 1 < path.size() && si_->equalStates(path[i + 1], to);
    }

    CheckLevel CheckedPath::levelOf(const ob::State *from, const ob::State *to)
    {
        return isMotionOf(path_, hint_, from, to) ? levels_[hint_ + 1] : CheckLevel::Nowhere;
    }

    void CheckedPath::set(const path::Waypoints &path, CheckLevel level, const path::Waypoints &original)
    {
        std::vector<CheckLevel> levels{level};
        std::vector<bool> isOriginal;
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            levels.push_back(std::max(level, levelOf(path[i - 1], path[i])));
        }
        for (std::size_t i = 0, next = 0; i < path.size(); ++i)
        {
            const bool same = next < original.size() && si_->equalStates(path[i], original[next]);
            next += same ? 1 : 0;
            isOriginal.push_back(same);
        }
        path_ = path;
        levels_ = std::move(levels);
        original_ = std::move(isOriginal);
    }

    /* The index of \e state in \e path, its size if it is not there. The search begins at \e hint, where the last one
       ended. */
    std::size_t CheckedPath::find(const path::Waypoints &path, std::size_t &hint, const ob::State *state) const
    {
        for (std::size_t k = 0; k < path.size(); ++k)
        {
            const std::size_t i = (hint + k) % path.size();
            if (si_->equalStates(path[i], state))
            {
                hint = i;
                return i;
            }
        }
        return path.size();
    }
}  // namespace ompl_mfa::engine::refinement
