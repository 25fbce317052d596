#ifndef OMPL_MFA_ENGINE_FIREFLIES_SLICE_GRAPH_
#define OMPL_MFA_ENGINE_FIREFLIES_SLICE_GRAPH_

#include <cstdint>
#include <vector>

#include "engine/fireflies/SliceFrame.h"
#include "engine/graph/LazyGraph.h"
#include "path/PathEvaluator.h"

namespace ompl_mfa
{
    /** \brief Recombination: all paths of one frame put their points on the same slices, so that any point of one slice
        may be joined to any of the next. N candidates on each of m - 1 slices make a layered graph of N^(m-1) paths,
        whose best valid one is found by a LazyGraph search. */
    class SliceGraph
    {
    public:
        /** \brief \e frame and \e evaluator outlive the object. */
        SliceGraph(const SliceFrame &frame, PathEvaluator &evaluator);

        /** \brief Removes all candidates. */
        void clear();

        /** \brief Adds \e state to the candidates of slice \e k. */
        void addCandidate(std::size_t k, const ompl::base::State *state);

        /** \brief Adds the points of \e path (slices + 2 states) to the candidates of each slice. */
        void addCandidates(const Waypoints &path);

        /** \brief Finds the best valid path through one candidate of each slice if it is better than \e bound
            (infinite: any), within about \e work units of PathEvaluator::work(). */
        bool search(double bound, std::uint64_t work, Waypoints &path);

    private:
        const SliceFrame &frame_;
        PathEvaluator &evaluator_;
        std::vector<Waypoints> candidates_;
        LazyGraph graph_;
    };
}  // namespace ompl_mfa

#endif
