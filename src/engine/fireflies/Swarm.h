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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SWARM_
#define OMPL_MFA_ENGINE_FIREFLIES_SWARM_

#include <cstdint>
#include <memory>

#include "engine/fireflies/SliceFrame.h"
#include "engine/fireflies/SliceGraph.h"
#include "engine/fireflies/SliceModes.h"
#include "engine/fireflies/SliceObjective.h"
#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/optimizer/RandomSource.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief A swarm of fireflies over the slices of one frame, for any number of epochs. */
    class Swarm
    {
    public:
        /** \brief The coordinates of a firefly: the offsets on each slice, as in the paper, or the amplitudes of
            SliceModes (offsets where the frame has no modes). */
        enum class Coordinates
        {
            Offsets,
            Modes
        };

        /** \brief \e frame must have at least one coordinate, and \e evaluator must outlive the swarm. */
        Swarm(SliceFrame frame, Coordinates coordinates, path::PathEvaluator &evaluator,
              const FireflyOptimizer::Settings &settings, std::uint64_t seed, SliceObjective::ValidPathEvent validPath);
        Swarm(const Swarm &) = delete;
        Swarm &operator=(const Swarm &) = delete;

        /** \brief Adds \e path (one state on each slice between start and goal) to the swarm before its first
            generation. */
        void inject(const path::Waypoints &path);

        /** \brief As SliceObjective::setBound; reorders the fireflies. */
        void setBound(double bound);

        /** \brief The path (as SliceFrame::toWaypoints) of firefly \e i, a column of the population. Allocates, so not
            for use in the search. */
        void pathOf(Eigen::Index i, path::Waypoints &path) const;

        /** \brief Advances by one generation as FireflyOptimizer::step does, with its operations counted as work of the
            evaluator. After the last generation of an epoch the next begins with the brightest fifth of the old swarm
            among new random fireflies. */
        bool step(const FireflyOptimizer::StopCondition &stop);

        /** \brief Recombination: searches the graph of the fireflies' points, of \e path (one state on each slice; may
           be empty) and of fresh states on the slices for a path better than \e bound, with a budget of about \e work
           units of PathEvaluator::work(). True if there is one, then in \e found. */
        bool recombine(const path::Waypoints &path, double bound, std::uint64_t work, path::Waypoints &found);

        const SliceFrame &frame() const
        {
            return frame_;
        }

        const FireflyOptimizer &fireflies() const
        {
            return *fireflies_;
        }

        /** \brief Completed epochs. */
        unsigned int epoch() const
        {
            return epoch_;
        }

        /** \brief Path evaluations in all epochs. */
        std::uint64_t evaluations() const
        {
            return earlierEvaluations_ + fireflies_->evaluations();
        }

    private:
        void beginEpoch();
        std::unique_ptr<FireflyOptimizer> makeFireflies(const FireflyOptimizer::Settings &settings,
                                                        std::uint64_t seed) const;
        void countOperations();
        bool addCandidates();

        SliceFrame frame_;
        path::PathEvaluator &evaluator_;
        std::unique_ptr<SliceModes> modes_;
        SliceObjective objective_;
        SliceGraph graph_;
        RandomSource random_;
        path::Waypoints point_;
        Eigen::VectorXd coordinates_;  ///< coordinates of the frame
        Eigen::VectorXd scratch_;
        std::uint64_t seed_;
        std::unique_ptr<FireflyOptimizer> fireflies_;
        unsigned int epoch_{0};
        std::uint64_t earlierEvaluations_{0};
        std::uint64_t countedOperations_{0};  ///< operations of fireflies_ already counted as work
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
