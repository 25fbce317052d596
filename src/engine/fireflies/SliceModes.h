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

#ifndef OMPL_MFA_ENGINE_FIREFLIES_SLICE_MODES_
#define OMPL_MFA_ENGINE_FIREFLIES_SLICE_MODES_

#include <cstddef>

#include <Eigen/Core>

#include "engine/fireflies/SliceFrame.h"

namespace ompl_mfa::engine::fireflies
{
    /** \brief Smooth coordinates of the paths over a SliceFrame: the amplitudes of sine waves along the axis, which
       vanish at start and goal, instead of an offset on each slice. The k-th wave may be 1/k as high as the first, so
       that a random point of this box is a smooth path, where a random point of the frame's own box is a jagged one
       that is far too long to be of use.

        The transform is orthonormal (the discrete sine transform of the first kind) and is its own inverse. */
    class SliceModes
    {
    public:
        /** \brief Whether all slices of \e frame have the same number of coordinates, at least one, which modes
            require. */
        static bool exist(const SliceFrame &frame);

        /** \brief \e frame must outlive the object and satisfy exist(). */
        explicit SliceModes(const SliceFrame &frame);

        /** \brief Smallest amplitudes (d, as the frame's dimension). */
        const Eigen::VectorXd &lower() const
        {
            return lower_;
        }

        /** \brief Largest amplitudes (d). */
        const Eigen::VectorXd &upper() const
        {
            return upper_;
        }

        /** \brief The frame's coordinates \e x (d) at \e amplitudes (d); clamped to the frame's box. */
        void toCoordinates(const Eigen::Ref<const Eigen::VectorXd> &amplitudes, Eigen::Ref<Eigen::VectorXd> x) const;

        /** \brief The same for \e count slices beginning with \e first: only their coordinates in \e x are written. */
        void toCoordinates(const Eigen::Ref<const Eigen::VectorXd> &amplitudes, std::size_t first, std::size_t count,
                           Eigen::Ref<Eigen::VectorXd> x) const;

        /** \brief Number of slices, at least one, that toCoordinates() handles in a fraction of a millisecond. */
        std::size_t slicesAtOnce() const;

        /** \brief The amplitudes (d) at the frame's coordinates \e x (d). */
        void toAmplitudes(const Eigen::Ref<const Eigen::VectorXd> &x, Eigen::Ref<Eigen::VectorXd> amplitudes) const;

    private:
        const SliceFrame &frame_;
        Eigen::Index perSlice_;
        Eigen::MatrixXd waves_;  ///< slices x slices
        Eigen::VectorXd lower_;
        Eigen::VectorXd upper_;
    };
}  // namespace ompl_mfa::engine::fireflies

#endif
