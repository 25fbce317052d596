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

#ifndef OMPL_MFA_ENGINE_PATH_HINTS_
#define OMPL_MFA_ENGINE_PATH_HINTS_

#include <cstddef>
#include <cstdint>
#include <deque>

#include "engine/SearchContext.h"
#include "engine/SearchPart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine
{
    /** \brief Paths from elsewhere that may help: of the user, or of an earlier search. Each is joined to a start and a
        goal of the query, made valid if it is not, and proposed. */
    class PathHints
    {
    public:
        static constexpr std::size_t CAPACITY = 40;

        /** \brief In the order in which they are tried. */
        enum class Source : unsigned char
        {
            BestPath,  ///< of an earlier search
            User,
            Population  ///< good paths of an earlier search
        };

        /** \brief Without \e mender (null) only paths that are valid as they are, ends included, are proposed. \e
           drafts is whether a path that only has to be compared with the best one may be proposed as a draft. \e
           context and \e mender must outlive the object. */
        PathHints(const SearchContext &context, PathMender *mender, bool drafts);

        /** \brief Adds a path of at least one state, finite but valid or not; it is brought within the bounds. If there
            are more than CAPACITY, the last one is dropped. */
        void add(path::Waypoints path, Source source);

        /** \brief Tries the next path, if it is time for it. Where the last one failed, the parts of the search first
            have as much work as that took. If interrupted, the path is tried again by the next call. */
        void advance(Findings &findings);

        std::size_t size() const
        {
            return hints_.size();
        }

        /** \brief The paths that have neither been proposed yet nor given up. */
        const path::Waypoints &path(std::size_t i) const
        {
            return hints_[i].path;
        }

        Source source(std::size_t i) const
        {
            return hints_[i].source;
        }

    private:
        struct Hint
        {
            path::Waypoints path;
            Source source;
            unsigned int effort;  ///< number of times that mending it has failed
        };

        /* A point of a path: at a fraction of the motion to a vertex. */
        struct Point
        {
            std::size_t vertex{0};
            double fraction{0.0};
            double distance{0.0};
        };

        bool isWorthwhile(const path::Waypoints &path) const;
        bool makeValid(path::Waypoints &path, unsigned int effort);
        void joinStart(path::Waypoints &path);
        void joinGoal(path::Waypoints &path);
        std::size_t nearestEnd(const path::Waypoints &path, const path::Waypoints &ends, bool isStart) const;
        Point nearestPoint(const path::Waypoints &path, const ompl::base::State *end, bool isStart,
                           unsigned int samples) const;

        const SearchContext &context_;
        PathMender *mender_;
        bool drafts_;
        std::deque<Hint> hints_;
        std::uint64_t due_{0};  ///< work from which on the next path is tried
        path::Waypoints scratch_;
    };
}  // namespace ompl_mfa::engine

#endif
