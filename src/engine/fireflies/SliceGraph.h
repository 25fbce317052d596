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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SLICE_GRAPH_
#define OMPL_MFA_ENGINE_FIREFLIES_SLICE_GRAPH_

#include <cstdint>
#include <vector>

#include "engine/fireflies/SliceFrame.h"
#include "engine/graph/LazyGraph.h"
#include "path/PathEvaluator.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief Recombination: as all paths of a frame have their points on the same slices, any point on one slice can
        be joined to any on the next. N candidates on each of m - 1 slices make a layered graph of N^(m-1) paths, whose
        best valid one is found by a LazyGraph search. */
    class SliceGraph
    {
    public:
        /** \brief \e frame and \e evaluator must outlive the object. */
        SliceGraph(const SliceFrame &frame, path::PathEvaluator &evaluator);

        /** \brief Removes all candidates. */
        void clear();

        /** \brief Adds \e state to the candidates of slice \e k. */
        void addCandidate(std::size_t k, const ompl::base::State *state);

        /** \brief Adds the points of \e path (slices + 2 states) to the candidates of each slice. */
        void addCandidates(const path::Waypoints &path);

        /** \brief Finds the best valid path through one candidate of each slice if it is better than \e bound
            (infinity: any), with a budget of about \e work units of PathEvaluator::work(). */
        bool search(double bound, std::uint64_t work, path::Waypoints &path);

    private:
        const SliceFrame &frame_;
        path::PathEvaluator &evaluator_;
        std::vector<path::Waypoints> candidates_;
        graph::LazyGraph graph_;
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
