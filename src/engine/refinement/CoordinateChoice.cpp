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

#include "engine/refinement/CoordinateChoice.h"

#include <cstddef>

namespace ompl_mfa::engine::refinement
{
    bool selectCoordinates(const path::StateChart &chart, ompl::RNG &rng, Eigen::VectorXd &mask)
    {
        const auto pick = [&rng](Eigen::Index size)
        { return static_cast<Eigen::Index>(rng.uniformInt(0, static_cast<int>(size) - 1)); };
        mask.setOnes(chart.dimension());
        switch (rng.uniformInt(chart.leaves() > 1 ? 0 : 1, 3))
        {
            case 0:
            {
                const auto [offset, dimension] =
                    chart.leafRange(static_cast<std::size_t>(pick(static_cast<Eigen::Index>(chart.leaves()))));
                mask.setZero();
                mask.segment(offset, dimension).setOnes();
                return true;
            }
            case 1:
                mask[pick(mask.size())] = 0.0;
                return true;
            case 2:
                for (Eigen::Index j = 0; j < mask.size(); ++j)
                {
                    mask[j] = rng.uniform01() < 0.5 ? 0.0 : 1.0;
                }
                return true;
            default:
                return false;
        }
    }
}  // namespace ompl_mfa::engine::refinement
