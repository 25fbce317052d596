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

#ifndef OMPL_MFA_ENGINE_GUIDES_TREE_PART_
#define OMPL_MFA_ENGINE_GUIDES_TREE_PART_

#include <memory>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/datastructures/NearestNeighbors.h>

#include "engine/guides/GuidePart.h"
#include "engine/guides/InformedSampler.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"

namespace ompl_mfa::engine::guides
{
    /** \brief Two trees, from the starts and from the goals, that grow toward each other (RRT-Connect); once they
        have met, they restart within the informed set, where they may find other homotopy classes. Starts and goals
        that cannot be on a better path are then no longer roots.

        J. J. Kuffner and S. M. LaValle, RRT-Connect: An efficient approach to single-query path planning, ICRA 2000.
        OMPL's planner is not used because states have to be drawn from the seed of the run, the search has to stop
        between two motion checks, and its work has to be counted. */
    class TreePart : public GuidePart
    {
    public:
        explicit TreePart(const SearchContext &context);
        ~TreePart() override;
        TreePart(const TreePart &) = delete;
        TreePart &operator=(const TreePart &) = delete;

        Share firstShare() const override;
        Share improvementShare(double seconds) const override;
        Readiness readiness() const override;
        bool search(double bound, std::uint64_t work, path::Waypoints &path) override;

        /** \brief Appends both trees; after they have met, and until the next turn, with the motion that joins them. */
        void explain(SearchGraph &graph) const override;

    private:
        struct Vertex
        {
            ompl::base::State *state;
            const Vertex *parent;
            std::size_t number;  ///< index in its tree
        };

        struct Tree
        {
            std::shared_ptr<ompl::NearestNeighbors<Vertex *>> nearest;
            std::vector<std::unique_ptr<Vertex>> vertices;
            std::size_t offered{0};  ///< number of the query's states already considered as roots
        };

        enum class Extension
        {
            Trapped,
            Advanced,
            Reached
        };

        void restart();
        void freeVertices(Tree &tree);
        Vertex *addVertex(Tree &tree, const ompl::base::State *state, const Vertex *parent);
        void addRoots(double bound);
        Vertex *nearest(Tree &tree, const ompl::base::State *state, bool fromStart);
        Extension extend(Tree &tree, bool fromStart, const ompl::base::State *target, Vertex *&added);
        bool iterate(double bound, path::Waypoints &path);
        void join(const Vertex *fromStart, const Vertex *fromGoal, path::Waypoints &path) const;

        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        InformedSampler sampler_;
        Tree startTree_;
        Tree goalTree_;
        const Vertex *metFromStart_{nullptr};  ///< where the trees met: the same state in both
        const Vertex *metFromGoal_{nullptr};
        bool startsTurn_{true};
        double range_;
        ompl::base::State *sample_;
        ompl::base::State *step_;
        Vertex probe_;
    };
}  // namespace ompl_mfa::engine::guides

#endif
