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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_WINDOW_SWARM_
#define OMPL_MFA_ENGINE_FIREFLIES_WINDOW_SWARM_

#include <cstddef>
#include <cstdint>
#include <memory>

#include <ompl/base/Cost.h>

#include "engine/SearchPart.h"
#include "engine/fireflies/Swarm.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief Fireflies in a window of a path: they look for another way between two of its vertices, and know nothing
        of the one that is there.

        A window is a problem of the paper's kind, small enough for a few generations: fewer slices, shorter paths, and
        a way that may be longer by a part of the whole path's cost, so that it can pass an obstacle on another side
        before it is tightened. */
    class WindowSwarm
    {
    public:
        /** \brief Where the slices lie: across the straight motion from end to end of the window, or across the path
            within it. */
        enum class Frame
        {
            Straight,
            Curved
        };

        /** \brief The vertices \e first < \e last of a path of cost \e pathCost, which may be infinite. */
        struct Window
        {
            path::Waypoints path;
            std::size_t first;
            std::size_t last;
            double pathCost;
        };

        /** \brief Null where the slices have no coordinates, as in one dimension. \e slices of a straight frame, and
            about as many of a curved one; \e evaluator outlives the swarm. */
        static std::unique_ptr<WindowSwarm> open(Window window, Frame frame, unsigned int slices,
                                                 const path::StateChartPtr &chart, path::PathEvaluator &evaluator,
                                                 const FireflyOptimizer::Settings &settings, std::uint64_t seed);

        /** \brief As Swarm::recombine; true if it found a better segment than found(), which that now is. */
        bool recombine(std::uint64_t work);

        /** \brief Whether all generations were made. */
        bool exhausted() const;

        /** \brief The best valid segment so far from the first vertex of the window to its last; empty before the
            first. */
        const path::Waypoints &found() const
        {
            return found_;
        }

        /** \brief What a segment has to cost less than: never infinite, whatever the path costs. */
        double bound() const
        {
            return bound_;
        }

        /** \brief The segment of the path within the window. */
        const path::Waypoints &segment() const
        {
            return segment_;
        }

        /** \brief Cost of segment(). */
        ompl::base::Cost cost() const
        {
            return cost_;
        }

        /** \brief What found() would replace. */
        Detour detour(PartKind origin) const;

        /** \brief The whole path, with \e segment instead of segment(). */
        path::Waypoints pathWith(const path::Waypoints &segment) const;

        Swarm &swarm()
        {
            return *swarm_;
        }

        const Swarm &swarm() const
        {
            return *swarm_;
        }

    private:
        WindowSwarm(Window window, path::PathEvaluator &evaluator);
        SliceFrame straightFrame(const path::StateChartPtr &chart, unsigned int slices) const;
        SliceFrame curvedFrame(const path::StateChartPtr &chart, unsigned int slices) const;
        double reach(double axis) const;
        double boundOf(ompl::base::Cost segment) const;
        bool take(const path::Waypoints &segment, double cost);

        Window window_;
        path::PathEvaluator &evaluator_;
        path::Waypoints segment_;
        ompl::base::Cost cost_;
        double bound_;
        std::unique_ptr<Swarm> swarm_;
        path::Waypoints found_;
        double foundCost_{0.0};  ///< of found_, unless that is empty
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
