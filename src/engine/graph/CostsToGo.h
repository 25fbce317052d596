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

#ifndef OMPL_MFA_ENGINE_GRAPH_COSTS_TO_GO_
#define OMPL_MFA_ENGINE_GRAPH_COSTS_TO_GO_

#include <cstdint>
#include <vector>

#include "engine/graph/CostQueue.h"
#include "engine/graph/MotionGraph.h"
#include "path/PathEvaluator.h"

namespace ompl_mfa::engine::graph
{
    /** \brief The backward search of a LazyGraph: the cost-to-go of every vertex from which a goal can be reached by
       motions not known to be invalid. */
    class CostsToGo
    {
    public:
        /** \brief \e graph and \e evaluator must outlive the object. */
        CostsToGo(MotionGraph &graph, path::PathEvaluator &evaluator);

        /** \brief Computes them in the vertices; with costs that cannot be negative, only where a path may be better
           than \e bound (infinity: any). Marks all vertices as not reached. False if interrupted. */
        bool compute(double bound);

        /** \brief Whether each cost-to-go is that of a path, so that pruning by it is safe. With a negative cycle it is
            not. */
        bool exact() const
        {
            return exact_;
        }

        /** \brief The work of the last successful computation. */
        std::uint64_t work() const
        {
            return work_;
        }

    private:
        using Index = MotionGraph::Index;
        using Edge = MotionGraph::Edge;
        using Vertex = MotionGraph::Vertex;
        using End = MotionGraph::End;
        using Validity = MotionGraph::Validity;

        double bestInitialCost() const;
        bool seedGoals();
        bool backwardInOrder();
        bool backwardBestFirst(double bound);
        bool backwardInSweeps();
        bool improvesInCycles();
        bool relax(Index index);

        MotionGraph &graph_;
        path::PathEvaluator &evaluator_;
        CostQueue<Index> queue_;  ///< of vertices
        std::vector<Index> walks_;
        bool exact_{true};
        std::uint64_t work_{0};
    };
}  // namespace ompl_mfa::engine::graph

#endif
