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

#ifndef OMPL_MFA_PATH_DUBINS_GUARD_
#define OMPL_MFA_PATH_DUBINS_GUARD_

#include <cstddef>
#include <vector>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

namespace ompl_mfa::path
{
    /** \brief Detects motions whose Dubins curve OMPL cannot compute, so that OMPL is never asked for them.

        OMPL rounds an angle that is short of a full turn by less than 5e-7 to 0. If that is the first turn of a
        curve, the straight segment after it misses its end by up to 5e-7 of its length, and from 2e-6 turning radii
        on an assertion (enabled in Debian's library) aborts the process. Random states hardly ever cause this, but
        shortest paths, whose curves become tangent, do. OMPL 2.0 still rounds, and asserts for two of the six types
        of curves.

        A motion is refused if OMPL cannot compute it: if a curve would miss its end by more than 1e-6 radii. It is
        also refused if OMPL cannot compute the motion from a state on its straight segment to its end, as is the
        case for some motions that end in a turn by a few 1e-3 rad: so a path of accepted motions can be interpolated
        and measured safely. Covers all Dubins spaces within a space, in any nesting of compounds; costs nothing if
        there are none. Const functions may be called from several threads. */
    class DubinsGuard
    {
    public:
        explicit DubinsGuard(ompl::base::StateSpacePtr space);

        /** \brief Whether allows() may refuse a motion; false in a space without Dubins curves. */
        bool refusesAny() const
        {
            return !curves_.empty();
        }

        /** \brief Whether OMPL can compute the motion \e from -> \e to: its distance, interpolation and validity
            check. */
        bool computes(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return curves_.empty() || allCurvesExist(from, to);
        }

        /** \brief Whether OMPL can compute the motion \e from -> \e to and each segment of it, as required of the
            motions of a path. */
        bool allows(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return curves_.empty() || allPartsExist(from, to);
        }

        /** \brief The space's distance. If OMPL cannot compute it, the distance of a motion whose ends have their
           headings turned by a few 1e-6 rad; infinity if there is none (ends more than 1e8 turning radii apart). */
        double distance(const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief The space's validSegmentCount; if OMPL cannot compute it, that of the turned motion, or 1 if there is
            none. */
        unsigned int validSegmentCount(const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief The space's interpolate, or that of the turned motion if OMPL cannot compute \e from -> \e to; the \e
           state for t = 0 may then differ from \e from in its headings. */
        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                         ompl::base::State *state) const;

    private:
        struct Curve
        {
            std::vector<std::size_t> chain;  ///< indices of the nested compounds, outermost first
            double radius;
            bool symmetric;  ///< whether OMPL also computes the curve from the second state to the first
        };

        class TurnedMotion;

        void addCurves(const ompl::base::StateSpacePtr &space, std::vector<std::size_t> &chain);
        template <typename Property>
        bool allCurves(const ompl::base::State *from, const ompl::base::State *to, Property property) const;
        bool allCurvesExist(const ompl::base::State *from, const ompl::base::State *to) const;
        bool allPartsExist(const ompl::base::State *from, const ompl::base::State *to) const;

        ompl::base::StateSpacePtr space_;
        std::vector<Curve> curves_;
    };
}  // namespace ompl_mfa::path

#endif
