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
    /** \brief Keeps pairs of states from OMPL for which it cannot compute a Dubins curve.

        OMPL rounds an angle that is short of a full turn by less than 5e-7 to 0. Where that is the first turn of a
        curve, the straight piece after it misses its end by up to 5e-7 of its length, and an assertion of OMPL (which
        Debian's library has switched on) ends the process once that is 2e-6 turning radii. The headings of states that
        lie at random hardly ever meet this; the curves of shortest paths, which become tangent, do. OMPL 2.0 still
        rounds, and asserts for two of the six kinds of curves.

        A motion is refused where OMPL cannot compute it: where a curve would miss its end by more than 1e-6 radii. It
       is also refused where OMPL can, but not the motion from a state on its straight piece to its end, as one that
       ends in a turn by a few 1e-3 rad: so a path of motions that are not refused may be interpolated and measured.
       Knows all Dubins spaces within a space, through any nesting of compounds; costs nothing where there are none.
       Const functions may be called from several threads. */
    class DubinsGuard
    {
    public:
        explicit DubinsGuard(ompl::base::StateSpacePtr space);

        /** \brief Whether there are motions that allows() refuses: not in a space without Dubins curves. */
        bool refusesAny() const
        {
            return !curves_.empty();
        }

        /** \brief Whether OMPL can compute the motion \e from -> \e to: its distance, states on it and a check. */
        bool computes(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return curves_.empty() || allCurvesExist(from, to);
        }

        /** \brief Whether OMPL can compute the motion \e from -> \e to and the parts of it: what a path may have. */
        bool allows(const ompl::base::State *from, const ompl::base::State *to) const
        {
            return curves_.empty() || allPartsExist(from, to);
        }

        /** \brief The space's distance. Where OMPL cannot compute it, that of a motion whose ends have their headings
           turned by a few 1e-6 rad; infinite if there is none (ends more than 1e8 turning radii apart). */
        double distance(const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief The space's validSegmentCount; where OMPL cannot compute it, that of the turned motion, or 1. */
        unsigned int validSegmentCount(const ompl::base::State *from, const ompl::base::State *to) const;

        /** \brief The space's interpolate, on the turned motion where OMPL cannot compute \e from -> \e to: then the \e
           state for t = 0 may differ from \e from in its headings. */
        void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                         ompl::base::State *state) const;

    private:
        struct Curve
        {
            std::vector<std::size_t> chain;  ///< indices of the nested compounds, outermost first
            double radius;
            bool symmetric;  ///< whether OMPL computes the curve from the end to the beginning too
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
