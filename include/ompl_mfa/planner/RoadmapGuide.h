#ifndef OMPL_MFA_PLANNER_ROADMAP_GUIDE_
#define OMPL_MFA_PLANNER_ROADMAP_GUIDE_

#include <memory>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/datastructures/NearestNeighbors.h>

#include "ompl_mfa/path/LazyGraph.h"
#include "ompl_mfa/path/PathEvaluator.h"
#include "ompl_mfa/path/StateChart.h"
#include "ompl_mfa/planner/Guide.h"
#include "ompl_mfa/planner/InformedSampler.h"

namespace ompl_mfa
{
    /** \brief A roadmap that keeps growing within the informed set, batch by batch, and is searched lazily after each
        batch. Every state is joined to its k nearest, k growing with the logarithm of their number as PRM* has it, so
        that the best path through it converges to the optimum almost surely; see docs/planner.md.

        S. Karaman and E. Frazzoli, Sampling-based algorithms for optimal motion planning, IJRR 30(7), 2011. */
    class RoadmapGuide : public Guide
    {
    public:
        /** \brief \e planner tells which nearest-neighbour structure suits the space. \e evaluator outlives it. */
        RoadmapGuide(const ompl::base::Planner *planner, StateChartPtr chart, PathEvaluator &evaluator,
                     std::uint_fast32_t seed);
        ~RoadmapGuide() override;
        RoadmapGuide(const RoadmapGuide &) = delete;
        RoadmapGuide &operator=(const RoadmapGuide &) = delete;

        bool advance(const Query &query, double bound, std::uint64_t work, Waypoints &path) override;

    private:
        void addEnds(const Query &query);
        void addBatch(const Query &query, double bound, std::uint64_t limit);
        std::size_t add(const ompl::base::State *state);

        StateChartPtr chart_;
        PathEvaluator &evaluator_;
        InformedSampler sampler_;
        LazyGraph graph_;
        std::shared_ptr<ompl::NearestNeighbors<std::size_t>> nearest_;
        std::vector<std::size_t> neighbours_;
        std::size_t starts_{0};  ///< how many of the query's states are in the graph
        std::size_t goals_{0};
        std::size_t batch_{50};
        std::size_t missing_{0};  ///< states of the current batch yet to be drawn
        double best_;             ///< cost of the best path of the graph
        ompl::base::State *sample_;
    };
}  // namespace ompl_mfa

#endif
