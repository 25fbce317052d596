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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SWARMS_
#define OMPL_MFA_ENGINE_FIREFLIES_SWARMS_

#include <memory>
#include <optional>
#include <vector>

#include "engine/EndPairs.h"
#include "engine/SearchPart.h"
#include "engine/fireflies/Swarm.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief The swarms over the straight axes between starts and goals. Only one of them is active at a time. */
    class Swarms
    {
    public:
        /** \brief The swarms begin to improve the first path after this many times the time that it took: where a first
            path is hard to find, so is another. */
        static constexpr double DELAY = 10.0;

        struct Options
        {
            Swarm::Coordinates coordinates{
                Swarm::Coordinates::Modes};  ///< coordinates of the swarms over straight axes
            bool pool{true};                 ///< whether PathSwarm takes over once there is a path of finite cost
            bool guided{false};              ///< whether guides search for a first path before the fireflies do
            bool bounded{true};  ///< whether fireflies that cannot become the best path skip the validity check
            FireflyOptimizer::Settings fireflies;
        };

        /** \brief \e context must outlive the object. */
        Swarms(const SearchContext &context, const Options &options);

        const Options &options() const
        {
            return options_;
        }

        /** \brief Whether there is a swarm, or one can be made. */
        bool any() const;

        /** \brief Whether the swarms over straight axes rest because PathSwarm improves the best path. If that is a
            straight motion, which another objective than length may improve, the pool is empty and they fly on. */
        bool resting() const;

        /** \brief Whether the guides should still search alone: without a path, the first turn of a swarm takes
            thousands of state checks. */
        bool waitForGuides() const;

        /** \brief The active swarm, or the first one; they alternate by generations. Null if there is none. */
        Swarm *active();

        /** \brief The active swarm; null before the first. */
        const Swarm *current() const
        {
            return active_;
        }

        /** \brief Advances the active swarm, which must exist, by about \e work; true if a generation was completed. */
        bool fly(std::uint64_t work);

        /** \brief To be called after a generation: the next swarm becomes active. */
        void chooseNext();

        /** \brief The best valid firefly over a straight axis since the last call, with its cost, or nothing. */
        std::optional<Proposal> takeFirefly();

        /** \brief Takes over the brightest fifth of the current swarm of \e predecessor as fireflies for new swarms. */
        void inherit(const Swarms &predecessor);

        /** \brief The paths of the current swarm, which is the pool while resting(), brightest first. */
        std::vector<path::Waypoints> currentPaths() const;

        /** \brief Adds all fireflies that are valid. */
        void explain(SearchGraph &graph) const;

    private:
        void layStraight();
        void placeFirst(Swarm &swarm) const;
        void keepFirefly(const path::Waypoints &path, double cost);

        const SearchContext &context_;
        Options options_;
        EndPairs pairs_;
        std::size_t laid_{0};  ///< pairs taken from pairs_
        std::vector<std::unique_ptr<Swarm>> straight_;
        Swarm *active_{nullptr};  ///< one of straight_
        Proposal firefly_;
        std::vector<path::Waypoints> first_;  ///< fireflies of an earlier search for swarms not begun yet
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
