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
        Every state is joined to its k nearest, k growing with the logarithm of their number as PRM* has it.

        Its memory is bounded. When a better path has made a part of it useless, that part is removed. When it has
        reached its capacity, counted in edges, and holds no better path, it is dropped, and a new one is begun in the
        informed set as it then is; the capacity grows with the logarithm of how often that happened, without end, so
        that the best path through the roadmaps converges to the optimum almost surely; see docs/planner.md.

        S. Karaman and E. Frazzoli, Sampling-based algorithms for optimal motion planning, IJRR 30(7), 2011. */
    class RoadmapPart : public GuidePart
    {
    public:
        /** \brief Directed edges of the first roadmap; some 40 bytes each, with their share of the vertices. */
        static constexpr std::size_t CAPACITY = 400000;

        /** \brief \e afterTrees says whether trees should search for a first path before the roadmap does. \e capacity
            >= 1 is that of the first roadmap, in directed edges. */
        RoadmapPart(const SearchContext &context, bool afterTrees, std::size_t capacity = CAPACITY);
        ~RoadmapPart() override;
        RoadmapPart(const RoadmapPart &) = delete;
        RoadmapPart &operator=(const RoadmapPart &) = delete;

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        bool search(double bound, std::uint64_t work, path::Waypoints &path) override;

        /** \brief The roadmap as it is: all its states, and the motions that searches needed and found valid. */
        void explain(SearchGraph &graph) const override;

    private:
        /* What a path through a vertex costs at the least. Exact for so many starts and goals: for none it is that of
           the pair for which the state was drawn, and others may promise better. */
        struct Promise
        {
            double lowerBound;
            double to;    ///< the best over the starts
            double from;  ///< the best over the goals
            std::uint32_t starts;
            std::uint32_t goals;
        };

        bool addEnds();
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
        std::vector<Promise> promises_;  ///< of each vertex
        std::shared_ptr<ompl::NearestNeighbors<std::size_t>> nearest_;
        std::size_t indexed_{0};  ///< vertices in nearest_
        std::vector<std::size_t> neighbours_;
        std::size_t firstCapacity_;
        std::size_t renewals_{0};
        std::size_t starts_{0};  ///< how many of the query's states are in the graph
        std::size_t goals_{0};
        std::size_t endEdges_{0};  ///< edges that came with them, which do not count
        std::size_t batch_{0};
        std::size_t missing_{0};  ///< states of the current batch yet to be drawn
        bool exhausted_{false};   ///< whether the next batch is due
        bool found_{false};       ///< whether the graph has had a path
        double best_{0.0};        ///< cost of the best one
        double pruned_;           ///< bound with which the graph was last pruned
        ompl::base::State *sample_;
    };
}  // namespace ompl_mfa::engine::guides

#endif
