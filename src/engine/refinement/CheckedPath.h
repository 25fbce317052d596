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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_CHECKED_PATH_
#define OMPL_MFA_ENGINE_REFINEMENT_CHECKED_PATH_

#include <cstddef>
#include <vector>

#include <ompl/base/SpaceInformation.h>

#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Where a path or a motion was checked at a finer resolution than OMPL's. */
    enum class CheckLevel : unsigned char
    {
        Nowhere,
        Corners,
        Everywhere
    };

    /** \brief The last path that was valid at a finer resolution, so that the motions which the next one shares with it
        are not checked again. */
    class CheckedPath
    {
    public:
        explicit CheckedPath(ompl::base::SpaceInformationPtr si);

        /** \brief Keeps \e path, which was checked at \e level and made from \e original by insertions. */
        void set(const path::Waypoints &path, CheckLevel level, const path::Waypoints &original);

        /** \brief Repairs motions of \e path as they were repaired before. */
        void insertRepairs(path::Waypoints &path);

        /** \brief Where a motion was checked. */
        CheckLevel levelOf(const ompl::base::State *from, const ompl::base::State *to);

        /** \brief Whether \e path has that motion. The search begins at vertex \e hint and sets it. */
        bool isMotionOf(const path::Waypoints &path, std::size_t &hint, const ompl::base::State *from,
                        const ompl::base::State *to) const;

    private:
        std::size_t find(const path::Waypoints &path, std::size_t &hint, const ompl::base::State *state) const;

        ompl::base::SpaceInformationPtr si_;
        path::Waypoints path_;
        std::vector<CheckLevel> levels_;  ///< of the motion to each state of path_
        std::vector<bool> original_;      ///< whether a state of path_ is one of the path that it was made from
        std::size_t hint_{0};             ///< where a state was found last
    };
}  // namespace ompl_mfa::engine::refinement

#endif
