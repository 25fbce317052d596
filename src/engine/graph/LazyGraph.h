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

#include <cstdint>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "path/PathEvaluator.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::graph
{
    /** \brief A directed graph of states, whose states and motions are checked for collision only when a search comes
       to need them, and no motion twice.

        A path begins at one of several starts and ends at one of several goals; it may lead through others. Its cost is
        that of PathEvaluator::cost, with initial and terminal cost: a source before all starts and a sink behind all
        goals, with edges of these costs, make one start and one goal of them.

        A search for a path better than a bound makes one backward pass that ignores unchecked collisions, which gives
        an exact cost-to-go of what is known, and then goes forward best first; a motion is screened, by a part of its
        states, when it is the most promising one left, and checked when it is of the path that was found. When one of
        the path has turned out invalid, or many others and this has taken as long as a backward pass, the cost-to-go is
        computed again. A search that was cut short goes on where it was if the graph is as it was and the bound no
        worse. */
    class LazyGraph
    {
    public:
        explicit LazyGraph(path::PathEvaluator &evaluator);

        /** \brief Removes all vertices and edges; memory is kept. */
        void clear();

        /** \brief Adds a copy of \e state, not yet checked unless \e valid, and returns its number: 0, 1, ... */
        std::size_t addVertex(const ompl::base::State *state, bool valid);

        /** \brief Paths may begin at \e vertex, at the objective's initialCost. */
        void setStart(std::size_t vertex);

        /** \brief Paths may end at \e vertex, at the objective's terminalCost. */
        void setGoal(std::size_t vertex);

        /** \brief Adds the motion \e from -> \e to, not yet checked. With \e bothWays also the reverse, which is taken
           to have the same validity. False, without adding it, if the evaluator is interrupted. */
        bool addEdge(std::size_t from, std::size_t to, bool bothWays);

        /** \brief Removes the vertices for which \e kept (one for each) is false, other than starts and goals, with
           their edges, and all edges that were found invalid. The others keep their order and what is known of them,
           and are numbered 0, 1, ... again. False, with nothing removed, if the evaluator is interrupted. */
        bool retain(const std::vector<bool> &kept);

        std::size_t size() const
        {
            return vertices_.size();
        }

        /** \brief Directed edges: what a pass over all of the graph handles. */
        std::size_t edges() const
        {
            return edges_.size();
        }

        const ompl::base::State *state(std::size_t vertex) const
        {
            return states_[vertex];
        }

        /** \brief Whether paths may begin or end at \e vertex. */
        bool isEnd(std::size_t vertex) const
        {
            return vertices_[vertex].start || vertices_[vertex].goal != NONE;
        }

        /** \brief The vertices at which paths may begin. */
        std::vector<std::size_t> starts() const;

        /** \brief The vertices at which paths may end. */
        std::vector<std::size_t> goals() const;

        /** \brief From and to of the motions that were found valid. */
        std::vector<std::pair<std::size_t, std::size_t>> validEdges() const;

        /** \brief Finds the best path from a start to a goal if it is better than \e bound (infinite: any). Stops after
            about \e work units of PathEvaluator::work(), or when the evaluator is interrupted; what was checked is
            kept. Returns true with the path, which may be a single state, in \e path.

            Where a cycle makes a path better each time it is gone round, no path is the best: then the answer is the
            best of those that the search finds, and it still beats the bound. */
        bool search(double bound, std::uint64_t work, path::Waypoints &path);

        /** \brief Whether the last search ended because no better path is left in the graph. */
        bool exhausted() const
        {
            return exhausted_;
        }

        /** \brief Cost of the path that the last successful search returned, as added up from the edges. */
        double cost() const
        {
            return cost_;
        }

    private:
        enum class Validity : std::uint8_t
        {
            Unknown,
            Screened,  ///< some of its states are valid
            Valid,
            Invalid
        };

        using Index = std::uint32_t;

        static constexpr Index NONE = std::numeric_limits<Index>::max();

        /* A motion; its reverse, if the motion serves both ways, has the same check. */
        struct Edge
        {
            Index from;
            Index to;
            Index check;  ///< into checks_
            double cost;
        };

        struct Vertex
        {
            std::vector<Index> out;  ///< edges
            std::vector<Index> in;
            double costToCome{0.0};
            double costToGo{0.0};
            Index parent{NONE};          ///< edge by which it was reached, none at a start
            Index next{NONE};            ///< edge toward the goal, none where the path ends best
            Index goal{NONE};            ///< into goals_, or none
            unsigned int expansions{0};  ///< how often costToGo was handed on
            bool start{false};
            bool reached{false};
            bool reaches{false};  ///< whether costToGo is known
            Validity validity{Validity::Unknown};
        };

        /* An edge from the source to a start or from a goal to the sink. */
        struct End
        {
            Index vertex;
            double cost;
        };

        enum class Step : std::uint8_t
        {
            Begin,  ///< from the source, into starts_
            Move,   ///< into edges_
            Finish  ///< to the sink, into goals_
        };

        struct QueueEntry
        {
            double key;
            Index index;
            Step step;
        };

        enum class Outcome : std::uint8_t
        {
            Found,
            Exhausted,
            Stale,
            Stopped,
            Passed,  ///< the step was taken or is of no use
            Blocked  ///< its motion is invalid
        };

        static std::vector<std::size_t> verticesOf(const std::vector<End> &ends);
        bool better(double a, double b) const;
        double combine(double a, double b) const;
        bool canBeat(double cost, double bound) const;
        bool isWorse(double bound, double than) const;
        void push(const QueueEntry &entry);
        QueueEntry pop();
        bool begin(double bound);
        double bestInitialCost() const;
        bool seedGoals();
        bool backwardInOrder();
        bool backwardBestFirst(double bound);
        bool backwardInSweeps();
        bool improvesInCycles();
        bool relax(Index index);
        Outcome forward(double bound, std::uint64_t limit);
        Outcome take(const QueueEntry &entry, double bound, std::uint64_t limit);
        Outcome beginAt(const End &start, double bound);
        Outcome move(Index index, double bound);
        bool checkVertex(Index index);
        bool screenEdge(const Edge &edge);
        Outcome confirm(Index goal, std::uint64_t limit);
        void reach(Index index, Index parent, double costToCome, double bound);
        void extract(path::Waypoints &path) const;

        path::PathEvaluator &evaluator_;
        path::Waypoints states_;
        std::vector<Vertex> vertices_;
        std::deque<Edge> edges_;  ///< a vector would copy itself for milliseconds when it grows
        std::vector<Validity> checks_;
        std::vector<End> starts_;
        std::vector<End> goals_;
        std::vector<QueueEntry> queue_;
        std::vector<Index> walks_;
        bool acyclic_{true};  ///< whether every edge leads from an earlier vertex to a later one
        bool begun_{false};   ///< whether costs-to-go and queue are those of the graph as it is
        bool exact_{true};    ///< whether the costs-to-go are those of paths, so that none is missed
        bool exhausted_{false};
        double bound_{0.0};  ///< of the last search
        double cost_{0.0};
        Index found_{0};           ///< goal of the path found
        unsigned int invalid_{0};  ///< motions found invalid since it began
        std::uint64_t backwardWork_{0};
        std::uint64_t forwardWork_{0};
    };
}  // namespace ompl_mfa::engine::graph

#endif
