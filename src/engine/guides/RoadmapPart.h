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

#ifndef OMPL_MFA_ENGINE_GUIDES_ROADMAP_PART_
#define OMPL_MFA_ENGINE_GUIDES_ROADMAP_PART_

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/datastructures/NearestNeighbors.h>

#include "engine/graph/LazyGraph.h"
#include "engine/guides/GuidePart.h"
#include "engine/guides/InformedSampler.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"

namespace ompl_mfa::engine::guides
{
    /** \brief A roadmap that grows within the informed set, batch by batch, and is searched lazily after each batch.
        Each state is joined to its k nearest neighbours, with k growing with the logarithm of the number of states
        as in PRM*.

        Its memory is bounded. States that a better path has made useless are pruned. A roadmap that has reached its
        capacity, counted in edges, and contains no better path is replaced by a new one in the present informed set.
        The capacity grows with the logarithm of the number of renewals, without limit, so that the best path through
        the roadmaps converges to the optimum almost surely; see docs/planner.md.

        S. Karaman and E. Frazzoli, Sampling-based algorithms for optimal motion planning, IJRR 30(7), 2011. */
    class RoadmapPart : public GuidePart
    {
    public:
        /** \brief Capacity of the first roadmap in directed edges; each takes some 40 bytes, with its share of the
            vertices. */
        static constexpr std::size_t CAPACITY = 400000;

        /** \brief \e afterTrees is whether the trees search for a first path before the roadmap does. \e capacity >= 1
            is the first roadmap's, in directed edges. */
        RoadmapPart(const SearchContext &context, bool afterTrees, std::size_t capacity = CAPACITY);
        ~RoadmapPart() override;
        RoadmapPart(const RoadmapPart &) = delete;
        RoadmapPart &operator=(const RoadmapPart &) = delete;

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        bool search(double bound, std::uint64_t work, path::Waypoints &path) override;

        /** \brief Takes over the roadmap: as it is, without its validity, or, if costs have changed, its states only,
            which are then added again before new ones are drawn. */
        void inherit(SearchPart &predecessor, const Heritage &heritage) override;

        /** \brief Appends all states of the roadmap, and the motions that searches found valid. */
        void explain(SearchGraph &graph) const override;

    private:
        /* Lower bound of the cost of paths through a vertex. It covers the given numbers of starts and goals; if these
           are 0, only the pair for which the state was drawn. */
        struct Promise
        {
            double lowerBound;
            double to;    ///< best bound over the starts
            double from;  ///< best bound over the goals
            std::uint32_t starts;
            std::uint32_t goals;
        };

        /* What is left to do with the roadmap of an earlier search. */
        struct Inheritance
        {
            path::Waypoints states;         ///< to be added again, the last one first
            std::vector<std::size_t> ends;  ///< vertices that were starts or goals
            bool any{false};                ///< whether there was one
        };

        bool addEnds();
        std::size_t addEnd(const ompl::base::State *state);
        bool drawState(double bound, double &lowerBound);
        void addBatch(double bound, std::uint64_t limit);
        std::size_t add(const ompl::base::State *state, double lowerBound);
        double searchBound(double bound) const;
        bool isFull() const;
        bool makeRoom(double bound);
        bool prune(double bound);
        bool isUseful(std::size_t vertex, double bound);
        bool indexVertices();
        void renew();

        bool afterTrees_;
        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        InformedSampler sampler_;
        graph::LazyGraph graph_;
        std::shared_ptr<const graph::LazyGraph *> measured_;  ///< the graph whose states nearest_ measures
        std::vector<Promise> promises_;                       ///< for each vertex
        std::shared_ptr<ompl::NearestNeighbors<std::size_t>> nearest_;
        Inheritance inherited_;
        std::size_t indexed_{0};  ///< number of vertices in nearest_
        std::vector<std::size_t> neighbours_;
        std::size_t firstCapacity_;
        std::size_t renewals_{0};
        std::size_t starts_{0};  ///< number of the query's starts in the graph
        std::size_t goals_{0};
        std::size_t endEdges_{0};  ///< edges added with starts and goals, which do not count toward the capacity
        std::size_t batch_{0};
        std::size_t missing_{0};  ///< states of the current batch still to be drawn
        bool exhausted_{false};   ///< whether the next batch is due
        bool found_{false};       ///< whether a path was found in the graph
        double best_{0.0};        ///< cost of the best path in the graph
        double pruned_;           ///< bound at the last pruning
        ompl::base::State *sample_;
    };
}  // namespace ompl_mfa::engine::guides

#endif
