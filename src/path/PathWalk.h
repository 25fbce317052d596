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

#ifndef OMPL_MFA_PATH_PATH_WALK_
#define OMPL_MFA_PATH_PATH_WALK_

#include <cstddef>

#include "path/Waypoints.h"

namespace ompl_mfa::path
{
    /** \brief Interpolates a path of at least two states at increasing distances from its beginning. */
    class PathWalk
    {
    public:
        /** \brief \e path must outlive the object. */
        explicit PathWalk(const Waypoints &path);

        /** \brief Computes the \e state at \e distance from the beginning, which must not be less than in the last
            call. */
        void stateAt(double distance, ompl::base::State *state);

        /** \brief Index of the vertex at the end of the motion on which the last state lies. */
        std::size_t next() const
        {
            return next_;
        }

    private:
        const Waypoints &path_;
        std::size_t next_{1};
        double behind_{0.0};  ///< length of the path before the motion to next_
        double motion_;       ///< length of that motion
    };

    /** \brief The \e count states at equal fractions k / (count + 1) of the length of \e path. */
    Waypoints statesAlong(const Waypoints &path, unsigned int count);
}  // namespace ompl_mfa::path

#endif
