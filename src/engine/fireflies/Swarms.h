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
        or an alternative. Only one of them is active at a time. */
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
            bool windows{true};              ///< whether swarms fly in windows once there is a path
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

        /** \brief Whether the guides should still search alone: without a path, the first turn of a swarm takes
            thousands of state checks. */
        bool waitForGuides() const;

        /** \brief The active swarm, chosen now if a choice is due. Swarms over straight axes alternate by generations.
            Once there is a path, windows get every other turn, or all turns if there is only one axis (as the whole
            path can be a window, too). Null if there is none. */
        Swarm *active();

        /** \brief Whether the next call of active() makes a choice. */
        bool mustChoose() const
        {
            return windowServed_ || active_ == nullptr;
        }

        /** \brief The active swarm, or the previous one until the next is chosen; null before the first. */
        const Swarm *current() const
        {
            return active_;
        }

        /** \brief The window of the active swarm, or null. */
        const WindowSwarm *window() const;
        WindowSwarm *window();

        /** \brief Advances the active swarm, which must exist, by about \e work; true if a generation was completed. */
        bool fly(std::uint64_t work);

        /** \brief To be called after a generation or recombination: makes what the window has found a detour, and has
            another swarm chosen. */
        void endGeneration(Findings &findings);

        /** \brief The best valid firefly over a straight axis since the last call, with its cost, or nothing. */
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
        std::size_t laid_{0};  ///< pairs taken from pairs_
        std::vector<std::unique_ptr<Swarm>> straight_;
        std::unique_ptr<WindowSwarm> window_;
        Swarm *active_{nullptr};    ///< that of the window, or one of straight_
        bool windowServed_{false};  ///< whether window_ is finished and only kept for display
        std::size_t chosen_{0};     ///< number of choices between windows and straight axes
        std::size_t windows_{0};    ///< number of windows opened so far
        RandomSource windowRandom_;
        Proposal firefly_;
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
