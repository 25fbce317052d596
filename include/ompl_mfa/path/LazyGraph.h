#ifndef OMPL_MFA_PATH_LAZY_GRAPH_
#define OMPL_MFA_PATH_LAZY_GRAPH_

#include <cstdint>
#include <deque>
#include <vector>

#include "ompl_mfa/path/PathEvaluator.h"
#include "ompl_mfa/path/Waypoints.h"

namespace ompl_mfa
{
    /** \brief A directed graph of states, whose states and motions are checked for collision only when a search comes
       to need them, and no motion twice.

        A search for a path better than a bound makes one backward pass that ignores unchecked collisions, which gives
        an exact cost-to-go of what is known, and then goes forward best first; a motion is screened, by a part of its
        states, when it is the most promising one left, and checked when it is of the path that was found. When one of
        the path has turned out invalid, or many others and this has taken as long as a backward pass, the cost-to-go is
        computed anew. */
    class LazyGraph
    {
    public:
        explicit LazyGraph(PathEvaluator &evaluator);

        /** \brief Removes all vertices and edges; memory is kept. */
        void clear();

        /** \brief Adds a copy of \e state, not yet checked unless \e valid, and returns its number: 0, 1, ... */
        std::size_t addVertex(const ompl::base::State *state, bool valid);

        void setStart(std::size_t vertex);
        void setGoal(std::size_t vertex);

        /** \brief Adds the motion \e from -> \e to, not yet checked. With \e bothWays also the reverse, which is taken
           to have the same validity. False, without adding it, if the evaluator is interrupted. */
        bool addEdge(std::size_t from, std::size_t to, bool bothWays);

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

        /** \brief Finds the best path from a start to a goal if it is better than \e bound (infinite: any). Stops after
            about \e work units of PathEvaluator::work(), or when the evaluator is interrupted; what was checked is
           kept. Returns true with the path in \e path. */
        bool search(double bound, std::uint64_t work, Waypoints &path);

        /** \brief Whether the last search ended because no better path is left in the graph. */
        bool exhausted() const
        {
            return exhausted_;
        }

    private:
        enum class Validity : std::uint8_t
        {
            Unknown,
            Screened,  ///< some of its states are valid
            Valid,
            Invalid
        };

        /* A motion; its reverse, if the motion serves both ways, has the same check. */
        struct Edge
        {
            std::size_t from;
            std::size_t to;
            std::size_t check;  ///< into checks_
            double cost;
        };

        struct Vertex
        {
            std::vector<std::size_t> out;  ///< edges
            std::vector<std::size_t> in;
            double costToCome;
            double costToGo;
            std::size_t parent;       ///< edge
            unsigned int expansions;  ///< how often costToGo was handed on
            bool reached;
            bool reaches;  ///< whether costToGo is known
            bool goal;
            Validity validity;
        };

        struct QueueEntry
        {
            double key;
            std::size_t index;
        };

        enum class Outcome
        {
            Found,
            Exhausted,
            Stale,
            Stopped
        };

        bool better(double a, double b) const;
        double combine(double a, double b) const;
        bool canBeat(double cost, double bound) const;
        void push(std::vector<QueueEntry> &queue, QueueEntry entry) const;
        QueueEntry pop(std::vector<QueueEntry> &queue) const;
        bool backward(double bound);
        bool backwardInOrder();
        bool backwardBestFirst(bool monotone, double bound);
        bool relax(const Edge &edge);
        Outcome forward(double bound, std::uint64_t limit, std::uint64_t renewal, std::size_t &goal);
        bool screenEdge(const Edge &edge);
        Outcome confirm(std::size_t goal, std::uint64_t limit);
        void expand(std::size_t vertex, double bound);
        void extract(std::size_t goal, Waypoints &path) const;

        PathEvaluator &evaluator_;
        Waypoints states_;
        std::vector<Vertex> vertices_;
        std::deque<Edge> edges_;  ///< a vector would copy itself for milliseconds when it grows
        std::vector<Validity> checks_;
        std::vector<std::size_t> starts_;
        std::vector<std::size_t> goals_;
        std::vector<QueueEntry> queue_;
        bool acyclic_{true};  ///< whether every edge leads from an earlier vertex to a later one
        bool exhausted_{false};
    };
}  // namespace ompl_mfa

#endif
