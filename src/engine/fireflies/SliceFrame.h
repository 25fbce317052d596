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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SLICE_FRAME_
#define OMPL_MFA_ENGINE_FIREFLIES_SLICE_FRAME_

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "path/StateChart.h"
#include "path/Waypoints.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief The fixed-slice parameterisation of a path: m - 1 slices across an axis from start to goal, and a path
        as one point on each of them (section III.C of the paper, in any space that has a StateChart).

        In R^n a slice is a hyperplane at right angles to the axis and its coordinates are the n - 1 offsets in an
        orthonormal basis. In general a slice has its origin on the axis; its coordinates are the offsets of the
        positions perpendicular to the axis there (for all positions of a compound together), followed by the
        rotations in the tangent space of the origin's rotation. Where the position is constant along the axis, all
        position offsets are free.

        A straight frame divides the motion from start to goal evenly; a curved one has its origins on a given path. */
    class SliceFrame
    {
    public:
        /** \brief A straight frame with \e segments >= 1 segments, that is segments - 1 slices. */
        static SliceFrame straight(const path::StateChartPtr &chart, const ompl::base::State *start,
                                   const ompl::base::State *goal, unsigned int segments);

        /** \brief A frame along \e axis: its first and last state are start and goal, the states in between are the
            origins of the slices. Throws std::invalid_argument if there
            are fewer than two states. */
        SliceFrame(path::StateChartPtr chart, path::Waypoints axis);

        /** \brief m - 1: the number of slices. */
        std::size_t slices() const
        {
            return slices_.size();
        }

        /** \brief d: the total number of coordinates of all slices. */
        Eigen::Index dimension() const
        {
            return lower_.size();
        }

        /** \brief Index of the first coordinate and number of coordinates of slice \e k, 0 <= k < slices(). */
        std::pair<Eigen::Index, Eigen::Index> sliceRange(std::size_t k) const
        {
            return {slices_[k].offset, slices_[k].dimension};
        }

        /** \brief A pair of states for each lateral coordinate: the two ends of the slice. Allocates, so not for use in
            the search. */
        std::vector<path::Waypoints> sliceEnds() const;

        /** \brief Smallest coordinates (d): from the bounds of the space. */
        const Eigen::VectorXd &lower() const
        {
            return lower_;
        }

        /** \brief Largest coordinates (d). */
        const Eigen::VectorXd &upper() const
        {
            return upper_;
        }

        /** \brief The states start, origins of the slices, and goal. */
        const path::Waypoints &axis() const
        {
            return axis_;
        }

        const path::StateChartPtr &chart() const
        {
            return chart_;
        }

        /** \brief The state at coordinates \e x (d, of all slices) on slice \e k; always within the space's bounds. \e
            scratch is a buffer of any size and content; reusing it saves allocations. */
        void toState(std::size_t k, const Eigen::Ref<const Eigen::VectorXd> &x, ompl::base::State *state,
                     Eigen::VectorXd &scratch) const;

        /** \brief The path (slices() + 2 states, with start and goal) at coordinates \e x (d); \e scratch as in
            toState. */
        void toWaypoints(const Eigen::Ref<const Eigen::VectorXd> &x, path::Waypoints &path,
                         Eigen::VectorXd &scratch) const;

        /** \brief The coordinates \e x (d) of \e path (slices() + 2 states, one on each slice between start and goal);
            components along the axis are lost. Inverse of toWaypoints for states on the slices. */
        void toCoordinates(const path::Waypoints &path, Eigen::Ref<Eigen::VectorXd> x) const;

        /** \brief Intersects a path of any number of states with the slices of a straight frame: for each slice the
            first point of \e path on it. False if the path misses a slice or the axis is constant in position. */
        bool crossings(const path::Waypoints &path, path::Waypoints &onSlices) const;

    private:
        struct Slice
        {
            Eigen::Index offset;
            Eigen::Index dimension;
            Eigen::MatrixXd basis;  ///< positions x lateral offsets, orthonormal columns
            Eigen::VectorXd along;  ///< positions; unit direction of the axis, zero if it is constant in position
        };

        Slice makeSlice(std::size_t k, Eigen::Index offset) const;
        void setBounds(std::size_t k);

        path::StateChartPtr chart_;
        path::Waypoints axis_;
        std::vector<Slice> slices_;
        Eigen::VectorXd lower_;
        Eigen::VectorXd upper_;
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
