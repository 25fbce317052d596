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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_VERTEX_MOVES_
#define OMPL_MFA_ENGINE_REFINEMENT_VERTEX_MOVES_

#include <cstddef>

#include <Eigen/Core>

#include <ompl/base/Cost.h>
#include <ompl/base/State.h>
#include <ompl/util/RandomNumbers.h>

#include "engine/refinement/WorkingPath.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Moves of single inner vertices of a path. One is made only if it is better and its motions are valid;
        each function returns whether it was. The steps of a vertex adapt their size to their success. */
    class VertexMoves
    {
    public:
        /** \brief \e path and \e rng must outlive the object. */
        VertexMoves(WorkingPath &path, ompl::RNG &rng);

        /** \brief Pulls the vertex \e i toward the chord of its neighbours. */
        bool pull(std::size_t i);

        /** \brief The same in some coordinates or directions only, which are kept as long as they lead to better
            paths. */
        bool pullPart(std::size_t i);

        /** \brief Makes a random step. */
        bool perturb(std::size_t i);

    private:
        bool improves(std::size_t i, const ompl::base::State *state, ompl::base::Cost &before, ompl::base::Cost &after);
        bool moveVertex(std::size_t i, const ompl::base::State *state, ompl::base::Cost before, ompl::base::Cost after);
        bool hasMargin(std::size_t i, const ompl::base::State *state);
        bool replaceVertex(std::size_t i, const ompl::base::State *state);
        void selectPart(VertexStep &step);

        WorkingPath &path_;
        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        ompl::RNG &rng_;
        path::Waypoints scratch_;
        Eigen::VectorXd delta_;
        Eigen::VectorXd beyondDelta_;
    };
}  // namespace ompl_mfa::engine::refinement

#endif
