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

#include "engine/fireflies/SliceMove.h"

#include <cmath>

#include <boost/math/constants/constants.hpp>

namespace ompl_mfa::engine::fireflies
{
    Eigen::VectorXd SliceMove::displacement(const Coordinates &coordinates, double phase) const
    {
        Eigen::VectorXd x(mask.size());
        switch (equation)
        {
            case Equation::Attraction:
                // Eq. (16). The random step is half a wave along the window: a jagged path would be tightened away.
                x = beta * coordinates(brighter) +
                    step * std::sin(boost::math::constants::pi<double>() * phase) * direction;
                break;
            case Equation::Worst:
                // Eq. (12).
                x = lambda[0] * coordinates(worst) + lambda[1] * (coordinates(best) - coordinates(worst));
                break;
            default:
                // Eq. (6); the two lambda are drawn separately, or the sum would telescope.
                x = coordinates(others[0]) + lambda[0] * (coordinates(others[1]) - coordinates(others[2])) +
                    lambda[1] * (coordinates(others[2]) - coordinates(others[3]));
                break;
        }
        if (equation == Equation::BestMutation)
        {
            // Eq. (7).
            x += lambda[2] * (coordinates(best) - coordinates(worst));
        }
        // Eqs. (8) to (11): the trial keeps the other coordinates of the firefly.
        return x.cwiseProduct(mask);
    }
}  // namespace ompl_mfa::engine::fireflies
