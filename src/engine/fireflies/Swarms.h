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
#include "engine/fireflies/WindowSwarm.h"
#include "ompl_mfa/optimizer/RandomSource.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief The swarms of a search: over the straight axes between starts and goals, and in windows of the best path
        or an alternative. One of them is active at a time. */
    class Swarms
    {
    public:
        /** \brief The swarms begin to improve a path after this many times the time that it took: where a first path
            is hard to find, another is too. */
        static constexpr double DELAY = 10.0;

        struct Options
        {
            Swarm::Coordinates coordinates{Swarm::Coordinates::Modes};  ///< of the swarms over straight axes
            bool windows{true};  ///< whether swarms fly in windows once there is a path
            bool guided{false};  ///< whether guides should search for a first path before the fireflies do
            bool bounded{true};  ///< whether fireflies that cannot become the best path are not checked for validity
            FireflyOptimizer::Settings fireflies;
        };

        /** \brief \e context outlives the object. */
        Swarms(const SearchContext &context, const Options &options);

        const Options &options() const
        {
            return options_;
        }

        /** \brief Whether there is a swarm, or can be one. */
        bool any() const;

        /** \brief Whether guides should still search alone: where a first path is not found yet, the first turn of a
            swarm takes thousands of state checks. */
        bool waitForGuides() const;

        /** \brief The active swarm, chosen now if that is due: those over straight axes take turns by generations; once
            there is a path, windows have every other turn, or all of them where there is only one axis (the whole path
            is a window too). Null where there is none. */
        Swarm *active();

        /** \brief Whether the next call of active() chooses. */
        bool mustChoose() const
        {
            return windowServed_ || active_ == nullptr;
        }

        /** \brief The active swarm, or the last one before the next is chosen; null where none was. */
        const Swarm *current() const
        {
            return active_;
        }

        /** \brief The window in which the active swarm flies, or null. */
        const WindowSwarm *window() const;
        WindowSwarm *window();

        /** \brief Advances the active swarm, which there is, by about \e work; true if a generation was completed. */
        bool fly(std::uint64_t work);

        /** \brief To be called after a generation or recombination: what the window has found becomes a detour, and
            another swarm is chosen. */
        void endGeneration(Findings &findings);

        /** \brief The best valid firefly over a straight axis since the last call, with its cost; none if empty. */
        std::optional<Proposal> takeFirefly();

        /** \brief The paths of the current swarm, brightest first. */
        std::vector<path::Waypoints> currentPaths() const;

        /** \brief Adds all fireflies that are valid. */
        void explain(SearchGraph &graph) const;

    private:
        bool flyInWindow() const;
        void choose();
        void layStraight();
        void openWindow();
        bool pursueWindow(Findings &findings);
        void keepFirefly(const path::Waypoints &path, double cost);

        const SearchContext &context_;
        Options options_;
        EndPairs pairs_;
        std::size_t laid_{0};  ///< pairs that were returned by pairs_
        std::vector<std::unique_ptr<Swarm>> straight_;
        std::unique_ptr<WindowSwarm> window_;
        Swarm *active_{nullptr};    ///< the window's, or one of straight_
        bool windowServed_{false};  ///< whether window_ is kept only to be shown
        std::size_t chosen_{0};     ///< how often, where windows and straight axes alternate
        std::size_t windows_{0};    ///< opened so far
        RandomSource windowRandom_;
        Proposal firefly_;
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
