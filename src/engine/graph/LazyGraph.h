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

#ifndef OMPL_MFA_ENGINE_GRAPH_LAZY_GRAPH_
#define OMPL_MFA_ENGINE_GRAPH_LAZY_GRAPH_

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/graph/CostQueue.h"
#include "engine/graph/CostsToGo.h"
#include "engine/graph/MotionGraph.h"
#include "path/PathEvaluator.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::graph
{
    /** \brief A directed graph of states whose validity, like that of its motions, is checked only when a search
       needs it; no motion is checked twice.

       A path begins at one of several starts and ends at one of several goals; it may pass through others. Its cost
       is that of PathEvaluator::cost, including initial and terminal cost. These are the costs of edges from a
       single source to all starts and from all goals to a single sink.

       A search for a path better than a bound begins with a backward search that takes unchecked motions to be valid
       and gives the exact cost-to-go under this assumption. A best-first forward search follows: the most promising
       motion is screened at some of its states, and the motions of the path found are checked in full. The backward
       search is repeated when a motion of that path is invalid, or when many other motions are and the forward
       search has taken as long as a backward search. An interrupted search is resumed if the graph is unchanged and
       the bound is no worse. */
    class LazyGraph
    {
    public:
        explicit LazyGraph(path::PathEvaluator &evaluator);
        LazyGraph(const LazyGraph &) = delete;
        LazyGraph &operator=(const LazyGraph &) = delete;

        /** \brief Removes all vertices and edges but keeps the memory. */
        void clear();

        /** \brief Adds a copy of \e state, not yet checked unless \e valid, and returns its index: 0, 1, ... */
        std::size_t addVertex(const ompl::base::State *state, bool valid);

        /** \brief Makes \e vertex a start, with the objective's initialCost. */
        void setStart(std::size_t vertex);

        /** \brief Makes \e vertex a goal, with the objective's terminalCost. */
        void setGoal(std::size_t vertex);

        /** \brief Adds the motion \e from -> \e to, not yet checked. With \e bothWays also the reverse, which is taken
           to have the same validity. False if the evaluator was interrupted; then nothing is added. */
        bool addEdge(std::size_t from, std::size_t to, bool bothWays);

        /** \brief Removes the vertices for which \e kept (one value each) is false, except starts and goals, with their
           edges, and all edges found invalid. The other vertices keep their order and what is known of them, and are
           renumbered from 0. False if the evaluator was interrupted; then nothing is removed. */
        bool retain(const std::vector<bool> &kept);

        /** \brief Takes all vertices and edges of \e other, a graph over the same space and objective, with what is
            known of them, but no starts and goals. \e other is then empty. */
        void take(LazyGraph &other);

        /** \brief Forgets what is known of the validity of states and motions, also of motions that retain() removed
            as invalid: these are edges again if both their vertices are left. */
        void forgetValidity();

        /** \brief Whether \e vertex was found valid. */
        bool isValid(std::size_t vertex) const
        {
            return graph_.vertices[vertex].validity == MotionGraph::Validity::Valid;
        }

        std::size_t size() const
        {
            return graph_.vertices.size();
        }

        /** \brief Number of directed edges. */
        std::size_t edges() const
        {
            return graph_.edges.size();
        }

        const ompl::base::State *state(std::size_t vertex) const
        {
            return graph_.states[vertex];
        }

        /** \brief Whether \e vertex is a start or a goal. */
        bool isEnd(std::size_t vertex) const
        {
            return graph_.isEnd(vertex);
        }

        /** \brief The start vertices. */
        std::vector<std::size_t> starts() const;

        /** \brief The goal vertices. */
        std::vector<std::size_t> goals() const;

        /** \brief The motions found valid, as pairs of vertices: from, to. */
        std::vector<std::pair<std::size_t, std::size_t>> validEdges() const;

        /** \brief Finds the best path from a start to a goal if it is better than \e bound (infinity: any), with a
            budget of about \e work units of PathEvaluator::work(), or until the evaluator is interrupted. Results of
            checks are kept. Returns true if there is one, then in \e path; it may be a single state.

            With a negative cycle no path is optimal; the result then still beats the bound. */
        bool search(double bound, std::uint64_t work, path::Waypoints &path);

        /** \brief Whether the last search ended because the graph has no better path. */
        bool exhausted() const
        {
            return exhausted_;
        }

        /** \brief Cost of the path returned by the last successful search, as the sum of its edges. */
        double cost() const
        {
            return cost_;
        }

    private:
        using Index = MotionGraph::Index;
        using Edge = MotionGraph::Edge;
        using Vertex = MotionGraph::Vertex;
        using End = MotionGraph::End;
        using Validity = MotionGraph::Validity;

        enum class Step : std::uint8_t
        {
            Begin,  ///< from the source to a start, an index into the starts
            Move,   ///< along an edge, an index into the edges
            Finish  ///< from a goal to the sink, an index into the goals
        };

        struct NextStep
        {
            Index index;
            Step step;
        };

        using Queue = CostQueue<NextStep>;

        enum class Outcome : std::uint8_t
        {
            Found,
            Exhausted,
            Stale,
            Stopped,
            Passed,  ///< the step was taken or is useless
            Blocked  ///< its motion is invalid
        };

        static std::vector<std::size_t> verticesOf(const std::vector<End> &ends);
        bool isWorse(double bound, double than) const;
        bool begin(double bound);
        Outcome forward(double bound, std::uint64_t limit);
        Outcome take(const Queue::Entry &entry, double bound, std::uint64_t limit);
        Outcome beginAt(const End &start, double bound);
        Outcome move(Index index, double bound);
        bool checkVertex(Index index);
        bool screenEdge(const Edge &edge);
        Outcome confirm(Index goal, std::uint64_t limit);
        void reach(Index index, Index parent, double costToCome, double bound);
        void extract(path::Waypoints &path) const;

        path::PathEvaluator &evaluator_;
        MotionGraph graph_;
        CostsToGo costsToGo_;
        Queue queue_;
        bool begun_{false};  ///< whether costs-to-go and queue match the present graph
        bool exhausted_{false};
        double bound_{0.0};  ///< bound of the last search
        double cost_{0.0};
        Index found_{0};           ///< goal of the last path found
        unsigned int invalid_{0};  ///< motions found invalid since the last backward search
        std::uint64_t forwardWork_{0};
    };
}  // namespace ompl_mfa::engine::graph

#endif
