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

#ifndef OMPL_MFA_ENGINE_GRAPH_MOTION_GRAPH_
#define OMPL_MFA_ENGINE_GRAPH_MOTION_GRAPH_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include <ompl/base/State.h>

#include "path/PathEvaluator.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::graph
{
    /** \brief The vertices and edges of a LazyGraph, what is known of their validity, and what its searches last found
       for each vertex. The searches write to them. */
    struct MotionGraph
    {
        enum class Validity : std::uint8_t
        {
            Unknown,
            Screened,  ///< some of its states were checked and are valid
            Valid,
            Invalid
        };

        using Index = std::uint32_t;

        static constexpr Index NONE = std::numeric_limits<Index>::max();
        /** \brief Edges processed for the price of one state check. */
        static constexpr std::uint64_t EDGES_PER_WORK = 2;
        /** \brief Vertices processed between two evaluations of the stop condition. */
        static constexpr std::size_t VERTICES_BETWEEN_STOPS = 64;

        /** \brief A motion. If the reverse motion exists, it shares the validity. */
        struct Edge
        {
            Index from;
            Index to;
            Index check;  ///< index into checks
            double cost;
        };

        struct Vertex
        {
            std::vector<Index> out;  ///< indices of outgoing edges
            std::vector<Index> in;
            double costToCome{0.0};
            double costToGo{0.0};
            Index parent{NONE};          ///< incoming edge on the path from the start, none at a start
            Index next{NONE};            ///< outgoing edge on the path to the goal, none where the path ends
            Index goal{NONE};            ///< index into goals, or none
            unsigned int expansions{0};  ///< how often the vertex was expanded in the backward search
            bool start{false};
            bool reached{false};
            bool reaches{false};  ///< whether costToGo is known
            Validity validity{Validity::Unknown};
        };

        /** \brief The edge from the source to a start or from a goal to the sink. */
        struct End
        {
            Index vertex;
            double cost;
        };

        /** \brief \e evaluator must outlive the object. */
        explicit MotionGraph(path::PathEvaluator &evaluator);

        /** \brief These are documented at LazyGraph. */
        void clear();
        void take(MotionGraph &other);
        void forgetValidity();
        std::size_t addVertex(const ompl::base::State *state, bool valid);
        void setStart(std::size_t vertex);
        void setGoal(std::size_t vertex);
        bool addEdge(std::size_t from, std::size_t to, bool bothWays);
        bool retain(const std::vector<bool> &kept);

        /** \brief Whether \e vertex is a start or a goal. */
        bool isEnd(std::size_t vertex) const
        {
            return vertices[vertex].start || vertices[vertex].goal != NONE;
        }

        path::Waypoints states;
        std::vector<Vertex> vertices;
        std::deque<Edge> edges;  ///< a vector would take milliseconds to copy when it grows
        std::vector<Validity> checks;
        std::vector<Edge> dropped;  ///< invalid edges removed by retain(), in case they become valid
        std::vector<End> starts;
        std::vector<End> goals;
        bool acyclic{true};  ///< whether every edge leads from an earlier vertex to a later one

    private:
        std::vector<Vertex> retainedVertices(const std::vector<bool> &kept, std::vector<Index> &numbers) const;
        bool retainEdges(const std::vector<Index> &numbers, std::vector<Vertex> &retained);
        void renumberStates(const std::vector<Index> &numbers, std::size_t size);

        path::PathEvaluator &evaluator_;
    };
}  // namespace ompl_mfa::engine::graph

#endif
