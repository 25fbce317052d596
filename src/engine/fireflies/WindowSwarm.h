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
    /** \brief Fireflies in a window of a path: they search for another path between two of its vertices,
        independently of the present segment.

        A window is a problem of the paper's kind, small enough for a few generations: there are fewer slices and
        paths are shorter. A new segment may cost more than the present one by a fraction of the whole path's cost,
        so that it can pass an obstacle on the other side before it is tightened. */
    class WindowSwarm
    {
    public:
        /** \brief Position of the slices: across the straight motion between the ends of the window, or across the path
            within it. */
        enum class Frame
        {
            Straight,
            Curved
        };

        /** \brief The segment between vertices \e first < \e last of a path of cost \e pathCost, which may be
            infinite. */
        struct Window
        {
            path::Waypoints path;
            std::size_t first;
            std::size_t last;
            double pathCost;
        };

        /** \brief Opens a window; null if the slices have no coordinates, as in one dimension. \e slices is the number
            of slices of a straight frame and the approximate number of a curved one. \e evaluator must outlive the
            swarm. */
        static std::unique_ptr<WindowSwarm> open(Window window, Frame frame, unsigned int slices,
                                                 const path::StateChartPtr &chart, path::PathEvaluator &evaluator,
                                                 const FireflyOptimizer::Settings &settings, std::uint64_t seed);

        /** \brief As Swarm::recombine; true if it improved found(). */
        bool recombine(std::uint64_t work);

        /** \brief Whether all generations are done. */
        bool exhausted() const;

        /** \brief The best valid segment found, between the first and the last vertex of the window; empty if there is
            none. */
        const path::Waypoints &found() const
        {
            return found_;
        }

        /** \brief The cost that a new segment has to be better than; finite even if the path's cost is not. */
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

        /** \brief found() as a replacement for segment(). */
        Detour detour(PartKind origin) const;

        /** \brief The whole path, with \e segment in place of segment(). */
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
        double foundCost_{0.0};  ///< cost of found_, if that is not empty
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
