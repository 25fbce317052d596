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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_PATH_SWARM_
#define OMPL_MFA_ENGINE_FIREFLIES_PATH_SWARM_

#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include <ompl/util/RandomNumbers.h>

#include "engine/SearchPart.h"
#include "engine/fireflies/SliceMove.h"
#include "engine/refinement/LocalTrees.h"
#include "engine/refinement/PathTightening.h"
#include "ompl_mfa/optimizer/FireflyOptimizer.h"
#include "ompl_mfa/optimizer/RandomSource.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief The swarm that improves the best path: its fireflies are the whole, tight and different paths of the
        pool.

        A firefly moves in a window of its path, a few consecutive slices, by an equation of the Modified Firefly
        Algorithm or, as the brightest firefly does, at random. What collides in the window is bridged by small trees;
        then the new segment and the whole path are tightened: brightness is the cost of a tight path, as in a memetic
        algorithm. All of this is done with drafts (see PathEvaluator::setStride). */
    class PathSwarm
    {
    public:
        /** \brief \e context must outlive the object. */
        PathSwarm(const SearchContext &context, const FireflyOptimizer::Settings &settings);

        /** \brief Whether there is a path to improve. */
        bool ready() const;

        /** \brief Tries segments with a budget of about \e work, or until one of them makes a path that promises to
            become the best; that is proposed as a draft. */
        void advance(std::uint64_t work, Findings &findings);

    private:
        enum class Move : unsigned char
        {
            Detour,        ///< a random connection between the ends of the window
            Attraction,    ///< eq. (16)
            Mutation,      ///< eq. (6)
            BestMutation,  ///< eq. (7)
            Worst          ///< eq. (12)
        };

        /* The firefly that moves and the window of its path that does. */
        struct Window
        {
            explicit Window(const ompl::base::StateSpacePtr &space)
              : path(space)
              , slices(space)
              , segment(space)
            {
            }

            path::Waypoints path;
            path::Waypoints slices;
            double cost{0.0};
            std::size_t member{0};    ///< index in the pool
            path::Waypoints segment;  ///< the section of the path in the window
            double segmentCost{0.0};
            std::size_t first{0};  ///< number of vertices before the window
            std::size_t last{0};   ///< index of the first vertex behind it
            unsigned int firstSlice{0};
            unsigned int lastSlice{0};  ///< one past the last slice that moves
        };

        bool trial(Findings &findings);
        void countTrial();
        Move chooseMove();
        bool open(Move move);
        void cut(double from, double to);
        bool detour(path::Waypoints &found);
        bool fly(Move move, path::Waypoints &found);
        SliceMove drawMove(Move kind);
        void displace(const SliceMove &move, path::Waypoints &moved) const;
        bool bridge(const path::Waypoints &moved, path::Waypoints &found);
        bool tightenSegment(path::Waypoints &found);
        void judge(const path::Waypoints &segment, Findings &findings);
        double progress() const;
        double alpha() const;
        double attraction(std::size_t member) const;
        double slack(double fraction) const;
        std::size_t brighter(std::size_t member);
        std::uint64_t treeWork() const;

        const SearchContext &context_;
        FireflyOptimizer::Settings settings_;
        RandomSource random_;
        ompl::RNG rng_;
        refinement::PathTightening tightening_;
        refinement::LocalTrees trees_;
        Window window_;
        std::size_t trials_{0};  ///< of this generation
        std::uint64_t generation_{0};
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
