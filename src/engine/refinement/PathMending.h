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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_PATH_MENDING_
#define OMPL_MFA_ENGINE_REFINEMENT_PATH_MENDING_

#include <cstddef>
#include <cstdint>

#include "engine/SearchPart.h"
#include "engine/refinement/LocalTrees.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Makes any path between two valid states valid. Each colliding section, however long, is replaced by small
        trees between the valid states before and behind it. What is valid stays as it is. */
    class PathMending : public PathMender
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        PathMending(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed);

        bool mend(path::Waypoints &path, unsigned int effort) override;

    private:
        /* A state on a path: \e number + 1 of \e segments steps along the motion to \e vertex. */
        struct Walk
        {
            std::size_t vertex;
            unsigned int number;
            unsigned int segments;
        };

        bool bridge(const path::Waypoints &path, std::size_t &next, unsigned int effort);
        bool findGap(const path::Waypoints &path, std::size_t &next, double margin);
        void advance(const path::Waypoints &path, Walk &walk) const;
        void stateOn(const ompl::base::State *from, const ompl::base::State *to, const Walk &walk);
        void retreat(double margin);
        void append(const ompl::base::State *state);

        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        LocalTrees trees_;
        path::Waypoints mended_;   ///< the valid path so far
        path::Waypoints detour_;   ///< connection over a gap
        path::Waypoints scratch_;  ///< ends of the gap and states in between
        double length_{0.0};       ///< of the path, in the unit of the space's distance
    };
}  // namespace ompl_mfa::engine::refinement

#endif
