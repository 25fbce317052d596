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

#ifndef OMPL_MFA_ENGINE_REFINEMENT_PATH_TIGHTENING_
#define OMPL_MFA_ENGINE_REFINEMENT_PATH_TIGHTENING_

#include <array>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include <ompl/util/RandomNumbers.h>

#include "engine/refinement/PathShortcuts.h"
#include "engine/refinement/VertexMoves.h"
#include "engine/refinement/WorkingPath.h"
#include "path/PathEvaluator.h"
#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::refinement
{
    /** \brief Local refinement of a valid path, for any objective: shortcuts, removal of vertices, pulling a vertex
       toward the chord of its neighbours, random steps of a vertex, cutting of corners.

       Each step replaces a few consecutive motions by others of better combined cost; cost is computed first, and
       validity checked only for an improvement. A motion of infinite cost is bent, until the path's cost is finite.
       Every motion of the resulting path was checked as such. The steps of a vertex adapt their size to their
       success. */
    class PathTightening
    {
    public:
        /** \brief \e evaluator must outlive the object. */
        PathTightening(path::StateChartPtr chart, path::PathEvaluator &evaluator, std::uint_fast32_t seed);
        PathTightening(const PathTightening &) = delete;
        PathTightening &operator=(const PathTightening &) = delete;

        /** \brief Starts with a copy of \e path, whose motions must all be valid. */
        void begin(const path::Waypoints &path);

        /** \brief Refines with a budget of about \e work units of PathEvaluator::work(), until interrupted, or until
            the path is one motion of finite cost. Returns whether the path is better than before. */
        bool advance(std::uint64_t work);

        const path::Waypoints &path() const
        {
            return path_.states();
        }

        /** \brief The cost of path(), added up from known motion costs; infinite until advance() has computed them. */
        ompl::base::Cost cost() const
        {
            return path_.cost();
        }

        /** \brief Whether the last rounds gained almost nothing. Further rounds may still gain, but rarely. */
        bool converged() const
        {
            return converged_;
        }

    private:
        /* The kinds of steps, which index payoffs_. */
        enum StepKind : std::size_t
        {
            Shortcut,
            PartShortcut,
            Pull,
            PullPart,
            Perturb,
            StepKinds
        };

        struct Payoff
        {
            double gain{0.0};
            double work{0.0};

            double rate() const
            {
                return work > 0.0 ? gain / work : 0.0;
            }
        };

        void round();
        StepKind chooseStep();
        bool makeStep(StepKind kind, std::size_t i);
        static double gain(double before, double after);
        bool canImprove() const;
        void bendInfiniteMotions();
        bool bend(std::size_t i);
        void removeVertices();
        bool remove(std::size_t i);
        bool refineWorstCorner();
        bool cutCorner(std::size_t i);

        path::StateChartPtr chart_;
        path::PathEvaluator &evaluator_;
        ompl::RNG rng_;
        WorkingPath path_;
        PathShortcuts shortcuts_;
        VertexMoves moves_;
        double total_{0.0};  ///< cost of path_ during a round
        std::array<Payoff, StepKinds> payoffs_{};
        path::Waypoints scratch_;
        Eigen::VectorXd delta_;
        std::uint64_t workLimit_{0};
        bool converged_{true};
        unsigned int idleRounds_{0};
    };
}  // namespace ompl_mfa::engine::refinement

#endif
