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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_PATH_SHORTCUTS_
#define OMPL_MFA_ENGINE_REFINEMENT_PATH_SHORTCUTS_

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <ompl/base/Cost.h>
#include <ompl/util/RandomNumbers.h>

#include "engine/refinement/WorkingPath.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Random shortcuts of a path. One is made only if it is better and its motions are valid. */
    class PathShortcuts
    {
    public:
        /** \brief \e path and \e rng must outlive the object. */
        PathShortcuts(WorkingPath &path, ompl::RNG &rng);

        /** \brief Joins two points of the path (at least one motion), vertices or points on motions, by one motion.
            Returns whether the path is better than before. */
        bool shortcut();

        /** \brief Moves all vertices between two toward the chord of these, in some coordinates only. Returns whether
            the path is better than before.

            Steps of single vertices straighten a long section slowly, and shortcuts in all coordinates are often
            blocked. R. Geraerts and M. H. Overmars, Creating high-quality paths for motion planning, IJRR 26(8), 2007
            (partial shortcut). */
        bool partShortcut();

    private:
        /* A shortcut from the motion \e first to the motion \e last. */
        struct Bridge
        {
            std::size_t first;
            std::size_t last;
            bool fromVertex;  ///< whether it begins at the first state of its motion
            bool toVertex;    ///< whether it ends at the last state of its motion
        };

        bool drawBridge(Bridge &bridge);
        bool checkBridge(const Bridge &bridge);
        bool replaceSegment(std::size_t first);

        WorkingPath &path_;
        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        ompl::RNG &rng_;
        path::Waypoints segment_;
        std::vector<ompl::base::Cost> segmentCosts_;
        path::Waypoints ends_;  ///< of a shortcut
        Eigen::VectorXd delta_;
    };
}  // namespace ompl_mfa::engine::refinement

#endif
