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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_WORKING_PATH_
#define OMPL_MFA_ENGINE_REFINEMENT_WORKING_PATH_

#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <ompl/base/Cost.h>
#include <ompl/base/State.h>

#include "engine/refinement/VertexSearch.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Parameters of a vertex's next steps. */
    struct VertexStep
    {
        explicit VertexStep(VertexSearch randomSteps)
          : search(std::move(randomSteps))
        {
        }

        VertexSearch search;
        double pull{0.5};          ///< fraction of the distance to the chord
        double partPull{1.0};      ///< the same if only some coordinates move
        unsigned int caution{0};   ///< moves that still have to keep the margin
        bool partWorked{false};    ///< whether mask and normal led to a better path last time
        Eigen::VectorXd mask{};    ///< 1 for each coordinate that moves
        Eigen::VectorXd normal{};  ///< direction that is left out, or zero
    };

    /** \brief A path during its refinement, with the costs of its motions and what each vertex's steps have learnt. All
        changes keep the three together; none checks validity. */
    class WorkingPath
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        WorkingPath(path::StateChartPtr chart, path::PathEvaluator &evaluator);

        /** \brief Starts with a copy of \e path; the costs of its motions are not known yet. */
        void begin(const path::Waypoints &path);

        const path::StateChartPtr &chart() const
        {
            return chart_;
        }

        path::PathEvaluator &evaluator() const
        {
            return evaluator_;
        }

        const path::Waypoints &states() const
        {
            return path_;
        }

        std::size_t size() const
        {
            return path_.size();
        }

        const ompl::base::State *operator[](std::size_t i) const
        {
            return path_[i];
        }

        /** \brief Whether the path has as many vertices as are worth their work. */
        bool full() const;

        /** \brief Computes the costs that are not known; false if interrupted. */
        bool completeCosts();

        /** \brief The cost of the path, added up from those of its motions; infinite if one is not known. */
        ompl::base::Cost cost() const;

        /** \brief The cost of the motion from vertex \e i, which must be known. */
        ompl::base::Cost motionCost(std::size_t i) const
        {
            return costs_[i];
        }

        /** \brief The combined cost of the motions to and from the inner vertex \e i. */
        ompl::base::Cost cornerCost(std::size_t i) const;

        /** \brief Number of motions known to have infinite cost. */
        std::size_t infiniteMotions() const;

        VertexStep &step(std::size_t i)
        {
            return steps_[i];
        }

        /** \brief Forgets what the steps of vertex \e i have learnt. */
        void restartSteps(std::size_t i);

        /** \brief Steps shorter than this are not worth their work. */
        double smallestStep() const;

        /** \brief Moves the inner vertex \e i; its motions then cost \e before and \e after. */
        void move(std::size_t i, const ompl::base::State *state, ompl::base::Cost before, ompl::base::Cost after);

        /** \brief Inserts a vertex with index \e i and replaces the motion that passes it by two, which cost \e before
            and \e after. */
        void insert(std::size_t i, const ompl::base::State *state, ompl::base::Cost before, ompl::base::Cost after);

        /** \brief Erases the inner vertices from \e first to before \e last and replaces their motions by one, which
            costs \e joined. */
        void erase(std::size_t first, std::size_t last, ompl::base::Cost joined);

    private:
        VertexStep firstStep(std::size_t i) const;

        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        path::Waypoints path_;
        std::vector<ompl::base::Cost> costs_;  ///< costs of the motions, as far as they are computed
        std::vector<VertexStep> steps_;
    };
}  // namespace ompl_mfa::engine::refinement

#endif
