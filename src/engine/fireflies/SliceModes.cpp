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

#include "engine/fireflies/SliceModes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/constants/constants.hpp>

namespace ompl_mfa::engine::fireflies
{
    namespace
    {
        /* Multiplications that take about a tenth of a millisecond. */
        constexpr Eigen::Index MULTIPLICATIONS_AT_ONCE = 1 << 18;
    }  // namespace

    bool SliceModes::exist(const SliceFrame &frame)
    {
        for (std::size_t k = 0; k < frame.slices(); ++k)
        {
            if (frame.sliceRange(k).second != frame.sliceRange(0).second)
            {
                return false;
            }
        }
        return frame.dimension() > 0;
    }

    SliceModes::SliceModes(const SliceFrame &frame)
      : frame_(frame)
      , perSlice_(frame.sliceRange(0).second)
      , waves_(frame.slices(), frame.slices())
      , lower_(frame.dimension())
      , upper_(frame.dimension())
    {
        const Eigen::Index m = waves_.rows();
        const double pieces = static_cast<double>(m) + 1.0;
        const double norm = std::sqrt(2.0 / pieces);
        // all waves are sampled from one period of the first, as computing m^2 sines would take too long
        std::vector<double> period(2 * static_cast<std::size_t>(m) + 2);
        for (std::size_t i = 0; i < period.size(); ++i)
        {
            period[i] = norm * std::sin(boost::math::constants::pi<double>() * static_cast<double>(i) / pieces);
        }
        for (Eigen::Index k = 0; k < m; ++k)
        {
            std::size_t i = 0;
            for (Eigen::Index j = 0; j < m; ++j)
            {
                i += static_cast<std::size_t>(k) + 1;
                if (i >= period.size())
                {
                    i -= period.size();
                }
                waves_(j, k) = period[i];
            }
        }
        const Eigen::Map<const Eigen::MatrixXd> lowest(frame.lower().data(), perSlice_, m);
        const Eigen::Map<const Eigen::MatrixXd> highest(frame.upper().data(), perSlice_, m);
        const Eigen::VectorXd height = highest.rowwise().maxCoeff().cwiseMax(-lowest.rowwise().minCoeff());
        for (Eigen::Index k = 0; k < m; ++k)
        {
            upper_.segment(k * perSlice_, perSlice_) = height / (norm * static_cast<double>(k + 1));
        }
        lower_ = -upper_;
    }

    void SliceModes::toCoordinates(const Eigen::Ref<const Eigen::VectorXd> &amplitudes,
                                   Eigen::Ref<Eigen::VectorXd> x) const
    {
        toCoordinates(amplitudes, 0, frame_.slices(), x);
    }

    void SliceModes::toCoordinates(const Eigen::Ref<const Eigen::VectorXd> &amplitudes, std::size_t first,
                                   std::size_t count, Eigen::Ref<Eigen::VectorXd> x) const
    {
        const auto slice = static_cast<Eigen::Index>(first);
        const auto slices = static_cast<Eigen::Index>(count);
        const Eigen::Index offset = slice * perSlice_;
        const Eigen::Index size = slices * perSlice_;
        Eigen::Map<Eigen::MatrixXd>(x.data() + offset, perSlice_, slices).noalias() =
            Eigen::Map<const Eigen::MatrixXd>(amplitudes.data(), perSlice_, waves_.rows()) *
            waves_.middleCols(slice, slices);
        x.segment(offset, size) = x.segment(offset, size)
                                      .cwiseMax(frame_.lower().segment(offset, size))
                                      .cwiseMin(frame_.upper().segment(offset, size));
    }

    std::size_t SliceModes::slicesAtOnce() const
    {
        return static_cast<std::size_t>(
            std::max<Eigen::Index>(1, MULTIPLICATIONS_AT_ONCE / (perSlice_ * waves_.rows())));
    }

    void SliceModes::toAmplitudes(const Eigen::Ref<const Eigen::VectorXd> &x,
                                  Eigen::Ref<Eigen::VectorXd> amplitudes) const
    {
        const Eigen::Index m = waves_.rows();
        Eigen::Map<Eigen::MatrixXd>(amplitudes.data(), perSlice_, m).noalias() =
            Eigen::Map<const Eigen::MatrixXd>(x.data(), perSlice_, m) * waves_;
    }
}  // namespace ompl_mfa::engine::fireflies
